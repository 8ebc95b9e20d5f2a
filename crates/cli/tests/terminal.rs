//! The program as a user meets it: results, hashes, files, and every way of being wrong.

mod program;

use program::{Folder, err, out, precess, refused};
use std::path::Path;
use std::process::{Command, Stdio};

/// The cone of T 6.1, computed apart from this program, at whole seconds: psi, theta, phi. At 1 and 2 by a Taylor
/// method with 25 digits on T's printed equations (mpmath); at 10 by another form, the axis as a unit vector with
/// psi and phi by quadrature (`SciPy`'s DOP853 at 3e-14).
const CONE: [(f64, [f64; 3]); 3] = [
    (1.0, [6.370_670_712_251_813_8, 2.035_321_539_895_329_1, 64.325_578_936_895_228]),
    (2.0, [10.159_434_279_329_857, 0.893_826_690_812_350_73, 126.343_719_339_331_74]),
    (10.0, [53.824_596_103_43, 0.544_015_613_943, 634.099_924_711_67]),
];

#[test]
fn the_cone_is_right_to_ten_digits() {
    let run = precess(&[
        "run",
        "gyroscope",
        "--until",
        "10",
        "--every",
        "1",
        "--method",
        "dop853",
        "--rtol",
        "1e-13",
        "--atol",
        "1e-13",
        "-o",
        "-",
    ]);
    assert!(run.status.success(), "{}", err(&run));
    let csv = out(&run);
    let mut lines = csv.lines();
    let header = lines.next().expect("a header");
    assert!(header.starts_with("t,psi,theta,phi,psi_dot,theta_dot,phi_dot,energy,L_A3,L_Az"), "{header}");
    let rows: Vec<Vec<f64>> =
        lines.map(|l| l.split(',').map(|x| x.parse().expect("a number")).collect()).collect();
    assert_eq!(rows.len(), 11);
    for (t, angles) in CONE {
        let row = &rows[t as usize];
        assert_eq!(row[0], t);
        for (found, exact) in row[1..4].iter().zip(angles) {
            assert!((found - exact).abs() < 1e-10 * exact.abs(), "at t = {t}: {found} {exact}");
        }
    }
    // energy, L_A3, L_Az
    for k in 7..10 {
        for row in &rows {
            assert!(((row[k] - rows[0][k]) / rows[0][k]).abs() < 1e-11, "column {k} at t = {}", row[0]);
        }
    }
}

#[test]
fn numbers_in_csv_read_back_to_the_same_bits_and_give_the_hash() {
    let folder = Folder::new("bits");
    let csv = folder.file("run.csv");
    let arguments =
        ["run", "double_pendulum", "--until", "5", "--every", "0.5", "--quiet", "--hash", "-o", &csv];
    let first = precess(&arguments);
    let second = precess(&arguments);
    assert!(first.status.success(), "{}", err(&first));
    assert_eq!(out(&first), out(&second), "the same run twice");
    assert_eq!(out(&first).trim().len(), 64);
    let text = std::fs::read_to_string(&csv).expect("the file is there");
    for number in text.lines().skip(1).flat_map(|l| l.split(',')) {
        let x: f64 = number.parse().expect("a number");
        assert_eq!(precess::value::shortest(x), number);
    }
}

#[test]
fn the_golden_hashes_hold_in_the_terminal() {
    let golden = include_str!("../../../golden/hashes.txt");
    for line in golden.lines().skip(1) {
        let words: Vec<&str> = line.split(' ').collect();
        let [system, method, step, until, every, hash] = words[..] else { panic!("{line}") };
        let card = precess::catalogue::method(method).expect("a method").card();
        let adaptive = card.kind == precess::integrate::Kind::Adaptive;
        let mut arguments = vec!["run", system, "--method", method, "--until", until, "--every", every];
        arguments.extend(if adaptive { vec!["--rtol", step, "--atol", step] } else { vec!["--dt", step] });
        arguments.extend(["--quiet", "--hash"]);
        let run = precess(&arguments);
        assert_eq!(out(&run).trim(), hash, "{line}: {}", err(&run));
    }
}

#[test]
fn a_saved_scenario_runs_the_same() {
    let folder = Folder::new("save");
    let saved = folder.file("saved.toml");
    let first = precess(&[
        "run",
        "n_body",
        "-p",
        "masses=[45; 1; 0.01]",
        "-i",
        "x2=1.2",
        "--until",
        "2",
        "--quiet",
        "--hash",
        "--save",
        &saved,
    ]);
    assert!(first.status.success(), "{}", err(&first));
    let second = precess(&["run", &saved, "--quiet", "--hash"]);
    assert_eq!(out(&first), out(&second), "{}", err(&second));
}

#[test]
fn values_are_written_as_people_write_them() {
    let hash = |start: &str| {
        let run = precess(&["run", "pendulum", "-i", start, "--until", "1", "--quiet", "--hash"]);
        assert!(run.status.success(), "{start}: {}", err(&run));
        out(&run)
    };
    assert_eq!(hash("theta=pi/6"), hash("theta=30 deg"));
    assert_eq!(hash("theta=0.5"), hash("theta=0,5"));
    assert_ne!(hash("theta=0.5"), hash("theta=0.50000000000001"));
}

/// Each wrong command, and a word that its one sentence must hold.
#[test]
fn what_is_wrong_is_said_in_one_sentence_with_the_nearest_name() {
    let folder = Folder::new("wrong");
    let nowhere = folder.file("no/such/folder/out.csv");
    let directory = folder.0.join("folder.csv");
    std::fs::create_dir_all(&directory).expect("a folder");
    let directory = directory.to_string_lossy().into_owned();
    let scenario = folder.file("bad.toml");
    std::fs::write(&scenario, "precess = 1\n[system]\nid = \"pendulum\"\n[strat]\n").expect("a file");
    let crowd = folder.file("crowd.toml");
    let masses = "1,".repeat(1_000_000);
    std::fs::write(
        &crowd,
        format!("precess = 1\n[system]\nid = \"n_body\"\nparameters = {{ masses = [{masses}] }}\n"),
    )
    .expect("a file");
    let noise = folder.file("noise.toml");
    std::fs::write(&noise, [0xff, 0xfe, 0x00]).expect("a file");
    let cases: Vec<(Vec<&str>, &str)> = vec![
        (vec!["run", "pendulm"], "'pendulum'"),
        (vec!["run", "pendulum", "--method", "dop835"], "'dop853'"),
        (vec!["run", "pendulum", "-p", "lenght=1"], "pendulum"),
        (vec!["run", "gyroscope", "-i", "thetadot=1"], "'theta_dot'"),
        (vec!["run", "pendulum", "-i", "theta"], "NAME=VALUE"),
        (vec!["run", "pendulum", "-i", "theta=one"], "number"),
        (vec!["run", "pendulum", "-i", "theta=1 kg"], "rad"),
        (vec!["run", "pendulum", "-i", "theta=nan"], "theta"),
        (vec!["run", "pendulum", "-i", "theta=1e999"], "finite"),
        (vec!["run", "pendulum", "-p", "l=0"], "above 0"),
        (vec!["run", "pendulum", "-p", "m=-1"], "above 0"),
        (vec!["run", "pendulum", "--method", "rk4", "--dt", "0"], "dt"),
        (vec!["run", "pendulum", "--method", "rk4", "--dt", "-1"], "dt"),
        (vec!["run", "pendulum", "--method", "rk4", "--dt", "1e-300"], "steps"),
        (vec!["run", "pendulum", "--dt", "0.1"], "rtol"),
        (vec!["run", "pendulum", "--method", "rk4", "--rtol", "1e-3"], "dt"),
        (vec!["run", "pendulum", "--rtol", "-1"], "rtol"),
        (vec!["run", "pendulum", "--until", "inf"], "until"),
        (vec!["run", "pendulum", "--until", "1", "--every", "2"], "every"),
        (vec!["run", "pendulum", "--every", "0"], "every"),
        (vec!["run", "pendulum", "--every", "1e-15"], "samples"),
        (vec!["run", "pendulum", "-p", "b=0.1", "--method", "verlet"], "velocity"),
        (vec!["run", "noria", "--method", "verlet"], "events"),
        (vec!["run", "free_body", "--method", "verlet"], "first order"),
        (vec!["run", "free_body", "-p", "i3=10"], "inertia"),
        (vec!["run", "n_body", "-p", "masses=[1; 1; 1]", "-i", "x2=1"], "same place"),
        (vec!["run", "n_body", "-p", "masses=[]"], "empty"),
        (vec!["run", "n_body", "-p", "masses=3"], "list"),
        (vec!["run", "magnetic_pendulum", "-p", "magnets=[[1; 2]]"], "3 numbers"),
        (vec!["run", "pendulum", "--option", "alpha=1"], "alpha"),
        (vec!["run", "pendulum", "-o", "out.txt"], "csv"),
        (vec!["run", "pendulum", "--plot", "out.jpeg"], "svg"),
        (vec!["run", "pendulum", "-o", &nowhere], "no such file"),
        (vec!["run", "pendulum", "-o", &directory], "directory"),
        (vec!["run", "pendulum", "-o", "-", "--hash"], "--hash"),
        (vec!["run", "no-such-file.toml"], "no-such-file.toml"),
        (vec!["run", &scenario], "'start'"),
        (vec!["run", &noise], "text"),
        (vec!["run", &crowd], "at most 2000"),
        (vec!["show", "gyrscope"], "'gyroscope'"),
        (vec!["compare", "pendulum", "--methods", "rk4,rk5"], "'rk4'"),
        (vec!["compare", "pendulum"], "--methods"),
        (vec!["list", "sytems"], "systems"),
        (vec!["ruun", "pendulum"], "run"),
        (vec!["run", "pendulum", "--untl", "1"], "--until"),
    ];
    for (arguments, word) in cases {
        let run = precess(&arguments);
        let message = err(&run);
        assert_eq!(run.status.code(), Some(2), "{arguments:?}: {message}");
        assert!(message.contains(word), "{arguments:?} should say {word}: {message}");
        assert!(!message.contains("panicked"), "{message}");
        assert!(out(&run).is_empty(), "{arguments:?}");
        let own = message.starts_with("precess: ");
        assert!(!own || message.trim_end().lines().count() == 1, "one sentence: {message}");
    }
    assert_eq!(
        folder.names(),
        ["bad.toml", "crowd.toml", "folder.csv", "noise.toml"],
        "nothing half-written stays"
    );
}

#[test]
fn a_run_that_diverges_keeps_its_samples_and_says_when() {
    let folder = Folder::new("diverges");
    let csv = folder.file("run.csv");
    // Euler-Cromer on the cone with a step this long blows up.
    let run =
        precess(&["run", "gyroscope", "--method", "euler", "--dt", "0.05", "--until", "100", "-o", &csv]);
    assert_eq!(run.status.code(), Some(1), "{}", err(&run));
    assert!(err(&run).contains("t = "), "{}", err(&run));
    let text = std::fs::read_to_string(&csv).expect("the samples are kept");
    assert!(text.lines().count() > 1);
}

#[test]
fn newmark_that_does_not_converge_says_what_to_try() {
    let run = precess(&[
        "run",
        "harmonic_oscillator",
        "--method",
        "newmark",
        "--dt",
        "3",
        "--until",
        "30",
        "--every",
        "30",
    ]);
    assert_eq!(run.status.code(), Some(1));
    assert!(err(&run).contains("smaller dt"), "{}", err(&run));
}

#[test]
fn an_old_file_stays_whole_where_a_run_is_refused() {
    let folder = Folder::new("old");
    let csv = folder.file("run.csv");
    std::fs::write(&csv, "old").expect("a file");
    assert_eq!(precess(&["run", "pendulum", "-p", "l=-1", "-o", &csv]).status.code(), Some(2));
    assert_eq!(std::fs::read_to_string(&csv).expect("a file"), "old");
    assert!(precess(&["run", "pendulum", "--until", "1", "-o", &csv, "-q"]).status.success());
    assert!(std::fs::read_to_string(&csv).expect("a file").starts_with("t,theta"));
    assert_eq!(folder.names(), ["run.csv"]);
}

#[test]
fn a_reader_that_leaves_early_is_no_failure() {
    let mut child = Command::new(env!("CARGO_BIN_EXE_precess"))
        .args(["run", "pendulum", "--until", "100", "--every", "0.001", "-o", "-", "-q"])
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("the program starts");
    drop(child.stdout.take());
    let output = child.wait_with_output().expect("the program ends");
    assert!(output.status.success(), "{}", err(&output));
    assert!(err(&output).is_empty());
}

#[test]
fn pictures_and_npz_carry_their_scenario() {
    let folder = Folder::new("pictures");
    let (svg, png, npz) = (folder.file("a.svg"), folder.file("a.png"), folder.file("a.npz"));
    for (option, file) in [("--plot", &svg), ("--plot", &png), ("-o", &npz)] {
        let run = precess(&["run", "pendulum", "--until", "1", option, file, "-q"]);
        assert!(run.status.success(), "{}", err(&run));
        let bytes = std::fs::read(Path::new(file)).expect("the file is there");
        let holds = |text: &[u8]| bytes.windows(text.len()).any(|w| w == text);
        // The archive is compressed: there the name of the entry tells.
        assert!(holds(b"precess = 1") || holds(b"scenario.npy"), "{file}");
    }
}

#[test]
fn lists_and_cards_are_complete() {
    let list = out(&precess(&["list", "--json"]));
    for word in ["\"gyroscope\"", "\"dop853\"", "\"cone.toml\"", "Toupie chinoise", "\\\\ddot{\\\\theta}"] {
        assert!(list.contains(word), "{word}");
    }
    let show = out(&precess(&["show", "pendulum"]));
    for word in ["theta'' = ", "9.81", "m/s^2", "energy", "P, sections 1-3"] {
        assert!(show.contains(word), "{word} in {show}");
    }
}

#[test]
fn compare_puts_methods_side_by_side() {
    let run = precess(&["compare", "pendulum", "--methods", "euler,rk4,dop853", "--until", "5", "-o", "-"]);
    assert!(run.status.success(), "{}", err(&run));
    let csv = out(&run);
    let errors: Vec<f64> = csv
        .lines()
        .skip(1)
        .map(|line| line.split(',').nth(1).and_then(|x| x.parse().ok()).expect("an error"))
        .collect();
    assert_eq!(errors.len(), 3);
    assert!(errors[0] > 1e-3 && errors[1] < 1e-9 && errors[2] < 1e-8, "{errors:?}");
}

/// Friction that all but jumps where the slip turns: an adaptive method must say so instead of going on for days.
#[test]
fn a_motion_that_an_adaptive_method_cannot_follow_ends_with_a_sentence() {
    let run = precess(&["run", "tippe_top", "-p", "epsilon=1e-12"]);
    assert_eq!(run.status.code(), Some(1), "{}", err(&run));
    assert!(err(&run).contains("fixed-step method"), "{}", err(&run));
}

#[cfg(unix)]
#[test]
fn a_link_is_followed_and_permissions_stay() {
    use std::os::unix::fs::{PermissionsExt, symlink};
    let folder = Folder::new("link");
    let (file, link) = (folder.file("file.csv"), folder.file("link.csv"));
    std::fs::write(&file, "old").expect("a file");
    std::fs::set_permissions(&file, std::fs::Permissions::from_mode(0o640)).expect("permissions");
    symlink(&file, &link).expect("a link");
    assert!(precess(&["run", "pendulum", "--until", "1", "-q", "-o", &link]).status.success());
    assert!(std::fs::read_to_string(&file).expect("a file").starts_with("t,theta"));
    assert_eq!(std::fs::metadata(&file).expect("a file").permissions().mode() & 0o777, 0o640);
    assert!(std::fs::symlink_metadata(&link).expect("a link").is_symlink());
}

#[test]
fn a_gallery_has_pictures_notes_and_both_languages() {
    let folder = Folder::new("gallery");
    let place = folder.file("pages");
    let made = precess(&["gallery", "p-fig-6", "p-ex-11", "-o", &place]);
    assert!(made.status.success(), "{}", err(&made));
    let read = |name: &str| std::fs::read_to_string(Path::new(&place).join(name)).expect("a file");
    let (english, french) = (read("index.html"), read("index.fr.html"));
    assert!(english.contains("src=\"p-fig-6.svg\"") && english.contains("Source: P, ex. 11"), "{english}");
    assert!(english.find("p-fig-6") < english.find("p-ex-11"));
    assert!(french.contains("une bille dans une parabole") && french.contains("lang=\"fr\""), "{french}");
    assert!(read("p-fig-6.svg").contains("<svg") && read("p-ex-11.toml").contains("precess = 1"));
}

#[test]
fn bodies_are_worked_out() {
    let cone = precess(&["body", "cone", "density=100", "height=15 cm", "radius=5 cm"]);
    assert!(out(&cone).contains("mass     0.0392699081698724") && cone.status.success(), "{}", out(&cone));
    assert!(out(&cone).contains("precess run gyroscope -p m=0.03926990816987"), "{}", out(&cone));
    let sum = ["body", "sphere", "mass=1", "radius=0.1", "+", "sphere", "mass=1", "radius=0.1", "x=1"];
    let sum = precess(&[&sum[..], &["--about", "[0; 0; 0]", "--json"]].concat());
    let json: serde_json::Value = serde_json::from_str(&out(&sum)).expect("JSON");
    assert_eq!((json["mass"].as_f64(), json["centre"][0].as_f64()), (Some(2.0), Some(0.5)));
    assert!((json["inertia"][1][1].as_f64().expect("a number") - 0.508).abs() < 1e-15);
    for (words, why) in [
        (&["cube"][..], "did you mean 'cone'"),
        (&["cone", "heigth=1"], "did you mean 'height'"),
        (&["cone", "height=1", "radius=1", "mass=0"], "above zero"),
        (&["sphere", "radius=1 kg", "mass=1"], "a value in m"),
        (&["sphere", "radius=1", "mass=1", "--about", "[0; 1]"], "three coordinates"),
        (&["+"], "a shape is missing"),
    ] {
        refused(&[&["body"], words].concat(), why);
    }
}
