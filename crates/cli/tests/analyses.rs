//! The analyses in the terminal: their tables, and the questions that they refuse.

mod program;

use program::{Folder, err, out, precess, refused, rows};

#[test]
fn a_section_is_a_table_of_times_and_states() {
    // x = cos t rises through zero at 3 pi / 2 and every turn later, with velocity 1.
    let arguments = ["poincare", "harmonic_oscillator", "--section", "x = 0", "--direction", "rising"];
    let found = precess(&[&arguments[..], &["--until", "20", "--rtol", "1e-12", "--atol", "1e-12"]].concat());
    assert!(found.status.success(), "{}", err(&found));
    let csv = out(&found);
    assert!(csv.starts_with("t,x,x_dot\n"), "{csv}");
    let rows = rows(&csv);
    assert_eq!(rows.len(), 3);
    for (k, row) in rows.iter().enumerate() {
        let t = std::f64::consts::TAU * (k as f64 + 0.75);
        assert!((row[0] - t).abs() < 1e-9 && row[1].abs() < 1e-9 && (row[2] - 1.0).abs() < 1e-9, "{row:?}");
    }
}

#[test]
fn a_spectrum_is_a_table_of_exponents_and_errors() {
    let folder = Folder::new("spectrum");
    let (npz, svg) = (folder.file("a.npz"), folder.file("a.svg"));
    let found = precess(&["lyapunov", "planar_oscillator", "-p", "r=0.3", "--until", "200", "-o", "-"]);
    assert!(found.status.success(), "{}", err(&found));
    let csv = out(&found);
    assert!(csv.starts_with("index,exponent,error\n1,"), "{csv}");
    let rows = rows(&csv);
    // Both directions are damped oscillators with exponents -r / 2.
    assert_eq!(rows.len(), 4);
    assert!((rows.iter().map(|r| r[1]).sum::<f64>() + 0.6).abs() < 1e-9, "{rows:?}");
    assert!(rows.iter().all(|r| (r[1] + 0.15).abs() < 0.01 && r[2] > 0.0 && r[2] < 0.05), "{rows:?}");
    let quiet = precess(&["lyapunov", "pendulum", "--quiet", "--until", "20", "-o", &npz, "--plot", &svg]);
    assert!(quiet.status.success() && out(&quiet).is_empty() && err(&quiet).is_empty());
    assert_eq!(folder.names(), ["a.npz", "a.svg"]);
}

#[test]
fn a_horizon_is_told_and_drawn() {
    let folder = Folder::new("trust");
    let (csv, svg) = (folder.file("a.csv"), folder.file("a.svg"));
    let run =
        ["trust", "lorenz", "--method", "rk4", "--dt", "0.01", "--until", "25", "--every", "0.1", "-o", &csv];
    let found = precess(&[&run[..], &["--plot", &svg]].concat());
    assert!(found.status.success() && err(&found).contains("trusted up to t = "), "{}", err(&found));
    let rows = rows(&std::fs::read_to_string(&csv).expect("a table"));
    let last = rows.iter().rposition(|row| row[2] == 1.0).expect("trusted at first");
    assert!(rows[last][1] <= 1e-3 && rows[last + 1][1] > 1e-3, "{:?}", &rows[last..last + 2]);
    let picture = std::fs::read_to_string(&svg).expect("a picture");
    assert!(picture.contains("not trusted") && picture.contains("shadow"));
}

#[test]
fn a_wrong_question_is_answered_with_a_sentence() {
    let cases: [(&[&str], &str); 22] = [
        (&["trust", "noria"], "events"),
        (&["trust", "pendulum", "--within", "0"], "above zero"),
        (&["trust", "pendulum", "--within", "1 s"], "--within"),
        (&["trust", "cluster", "-p", "rings=[[300; 300; 5; 2.4]]"], "1000 numbers"),
        (&["portrait", "driven_oscillator"], "without a clock"),
        (&["portrait", "pendulum", "--window", "thet=-1:1"], "theta"),
        (&["portrait", "pendulum", "--window", "theta=1:-1"], "not below"),
        (&["response", "pendulum", "--sweep", "l=1:2:3"], "periodic drive"),
        (&["response", "duffing", "--sweep", "omga=1:2:3"], "omega"),
        (&["response", "duffing", "--sweep", "omega=1:2"], "NAME=LOW:HIGH:N"),
        (&["bifurcation", "duffing", "--sweep", "gamma=0:1:1"], "between 2 and"),
        (&["floquet", "pendulum"], "periodic drive"),
        (&["frenet", "pendulum", "--x", "theta", "--y", "theta_dot"], "one plane"),
        (&["frenet", "lorenz", "--x", "x"], "both x and y"),
        (&["lyapunov", "pendulum", "--method", "taylor"], "dop853"),
        (&["gallery", "no-such-figure", "-o", "never-made"], "scenario"),
        (&["lyapunov", "noria"], "events"),
        (&["lyapunov", "pendulum", "--until", "-1"], "above zero"),
        (&["poincare", "pendulum", "--section", "thta = 0"], "theta"),
        (&["poincare", "pendulum", "--section", "theta"], "theta = 0"),
        (&["poincare", "pendulum", "--section", "theta = 0 mod 0"], "above zero"),
        (&["poincare", "pendulum", "--section", "t = 0 mod period"], "drive"),
    ];
    for (arguments, word) in cases {
        refused(arguments, word);
    }
}

#[test]
fn a_portrait_finds_and_names_the_fixed_points() {
    let folder = Folder::new("portrait");
    let svg = folder.file("a.svg");
    let found = precess(&["portrait", "pendulum", "-p", "g=4", "-o", "-", "--plot", &svg]);
    assert!(found.status.success(), "{}", err(&found));
    let csv = out(&found);
    assert!(csv.starts_with("theta,theta_dot,re1,im1,re2,im2,kind,stable\n"), "{csv}");
    let rows = rows(&csv);
    // Two turns: the bottom three times, the top twice; the frequency there is 2.
    let pi = std::f64::consts::PI;
    let places = [(-2.0, 0.0), (-1.0, 1.0), (0.0, 0.0), (1.0, 1.0), (2.0, 0.0)];
    assert_eq!(rows.len(), places.len());
    for (row, (turns, kind)) in rows.iter().zip(places) {
        assert!((row[0] - turns * pi).abs() < 1e-12 && row[1] == 0.0 && row[6] == kind, "{row:?}");
        let (re, im) = if kind == 1.0 { (2.0, 0.0) } else { (0.0, 2.0) };
        assert!((row[2] - re).abs() < 1e-12 && (row[3] - im).abs() < 1e-12, "{row:?}");
    }
    assert!(err(&found).contains("saddle at theta = 3.141593"), "{}", err(&found));
    assert!(std::fs::read_to_string(&svg).expect("a picture").contains("phase portrait"));
}

/// The platform's functions are a second opinion here.
#[allow(clippy::disallowed_methods)]
#[test]
fn a_linear_response_is_the_exact_one() {
    let arguments =
        ["response", "driven_oscillator", "-p", "p=0.3", "--sweep", "frequency=0.5:2:7", "-o", "-"];
    let found = precess(&[&arguments[..], &["--rtol", "1e-12", "--atol", "1e-12"]].concat());
    assert!(found.status.success(), "{}", err(&found));
    let rows = rows(&out(&found));
    assert_eq!(rows.len(), 7);
    for row in rows {
        let f = row[0];
        let (real, imaginary) = (1.0 - f * f, 0.3 * f);
        let amplitude = 1.0 / real.hypot(imaginary);
        let lag = imaginary.atan2(real);
        assert!((row[2] - amplitude).abs() < 1e-8 && (row[3] - lag).abs() < 1e-8, "{row:?}");
        assert!((row[5] - amplitude).abs() < 1e-12 && (row[6] - lag).abs() < 1e-12, "{row:?}");
    }
}

#[test]
fn a_bifurcation_diagram_and_multipliers_are_tables() {
    // Below the first period doubling there is one point for each value.
    let arguments = ["bifurcation", "driven_pendulum", "--sweep", "f=0.9:1:3", "--until", "600", "-o", "-"];
    let found = precess(&arguments);
    assert!(found.status.success(), "{}", err(&found));
    let csv = out(&found);
    assert!(csv.starts_with("f,theta\n") && csv.lines().count() > 60, "{csv}");
    // A quarter of the frequency's square below the tongue at alpha = 2: unstable there, stable beside it.
    let of = |alpha: &str| {
        let found = precess(&["floquet", "parametric_oscillator", "-p", "h=0.2", "-p", alpha, "-o", "-"]);
        assert!(found.status.success(), "{}", err(&found));
        rows(&out(&found))
    };
    let (inside, outside) = (of("alpha=2"), of("alpha=2.2"));
    assert!(inside[0][3] > 1.1 && (inside[0][3] * inside[1][3] - 1.0).abs() < 1e-8, "{inside:?}");
    assert!(outside.iter().all(|row| (row[3] - 1.0).abs() < 1e-8), "{outside:?}");
}

#[test]
fn the_frames_along_a_path_have_the_accelerations_of_the_forces() {
    // An ellipse of half axes 1 and 1/2 begins at its sharp end: curvature a / b^2, acceleration c towards the centre.
    let found = precess(&["frenet", "planar_oscillator", "-p", "c=4", "--until", "2", "-o", "-"]);
    assert!(found.status.success(), "{}", err(&found));
    let csv = out(&found);
    assert!(
        csv.starts_with("t,x,y,speed,tangential,normal,curvature,centre_x,centre_y,radial,transverse\n"),
        "{csv}"
    );
    let first = &rows(&csv)[0];
    let wanted = [0.0, 1.0, 0.0, 1.0, 0.0, 4.0, 4.0, 0.75, 0.0, -4.0, 0.0];
    assert!(first.iter().zip(wanted).all(|(a, b)| (a - b).abs() < 1e-12), "{first:?}");
    // P 9.2: on a spring the radial acceleration is g cos theta - (k / m)(l - l0); px and py are observables.
    let found = precess(&["frenet", "elastic_pendulum", "--until", "30", "-o", "-"]);
    assert!(found.status.success(), "{}", err(&found));
    for row in rows(&out(&found)) {
        let length = (row[1] * row[1] + row[2] * row[2]).sqrt();
        let (radial, transverse) =
            (-0.098 * row[2] / length - 0.5 * (length - 1.0), -0.098 * row[1] / length);
        assert!((row[9] - radial).abs() < 1e-12 && (row[10] - transverse).abs() < 1e-12, "{row:?}");
    }
}

#[test]
fn basins_are_a_table_of_labels() {
    let folder = Folder::new("basins");
    let (npz, svg) = (folder.file("a.npz"), folder.file("a.svg"));
    let arguments = ["basins", "potential_well", "-p", "u=[0; 0; -0.5; 0; 0.25]", "-p", "b=0.5"];
    let grid = ["--grid", "x=-1.5:1.5:4", "--grid", "x_dot=-0.1:0.1:3"];
    let found = precess(&[&arguments[..], &grid, &["-o", "-", "--plot", &svg]].concat());
    assert!(found.status.success(), "{}", err(&found));
    let csv = out(&found);
    assert!(csv.starts_with("x,x_dot,label\n-1.5,-0.1,0\n-0.5,-0.1,0\n0.5,-0.1,1\n1.5,-0.1,"), "{csv}");
    assert_eq!(rows(&csv).len(), 12);
    assert!(err(&found).contains("fixed point at x = -1.0000"), "{}", err(&found));
    assert!(std::fs::read_to_string(&svg).expect("a picture").contains("basins of attraction"));
    let found = precess(&[&arguments[..], &grid, &["-o", &npz, "--quiet"]].concat());
    assert!(found.status.success() && err(&found).is_empty(), "{}", err(&found));
    let mut archive = npyz::npz::NpzArchive::open(&npz).expect("an archive");
    for (name, shape) in [("x", &[4][..]), ("x_dot", &[3]), ("time", &[3, 4]), ("attractors", &[2, 2])] {
        assert_eq!(archive.by_name(name).expect("readable").expect(name).shape(), shape, "{name}");
    }
    let labels = archive.by_name("label").expect("readable").expect("labels");
    assert_eq!(labels.shape(), [3, 4]);
    let labels: Vec<i32> = labels.into_vec().expect("whole numbers");
    assert_eq!(labels, rows(&csv).iter().map(|row| row[2] as i32).collect::<Vec<_>>());
}

#[test]
fn basins_that_make_no_sense_are_refused_in_a_sentence() {
    let cases: [(&[&str], &str); 5] = [
        (&["basins", "pendulum", "--grid", "theta=-1:1:3"], "friction"),
        (&["basins", "pendulum", "-p", "b=1", "--grid", "thta=-1:1:3"], "'theta'"),
        (&["basins", "pendulum", "-p", "b=1", "--grid", "theta=-1:1:0"], "no points"),
        (&["basins", "pendulum", "-p", "b=1", "--grid", "theta=-1:1"], "LOW:HIGH:N"),
        (
            &["basins", "pendulum", "-p", "b=1", "--grid", "theta=-1:1:9000", "--grid", "theta_dot=0:1:9000"],
            "--yes",
        ),
    ];
    for (arguments, word) in cases {
        refused(arguments, word);
    }
}
