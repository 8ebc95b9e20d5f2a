//! Large ensembles: members that are right, chunks that are resumed, inputs that make no sense.

use precess::scalar::Isa;
use precess::survey::{Checkpoint, Survey};
use precess::value::Value;
use precess::{Plan, Scenario, Workers, run};
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};

const ONE: Workers = Workers { isa: Isa::Scalar, threads: 1 };

fn scenario(text: &str) -> Scenario {
    Scenario::parse(&format!("precess = 1\n{text}")).expect("a scenario")
}

fn survey(text: &str) -> Survey {
    Survey::new(&scenario(text), Path::new(".")).expect("a survey")
}

fn go_on(_: usize) -> ControlFlow<()> {
    ControlFlow::Continue(())
}

/// All rows, and their hash.
fn rows(survey: &Survey, workers: Workers) -> (Vec<Vec<f64>>, String) {
    let mut checkpoint = Checkpoint::in_memory();
    assert!(survey.run(&mut checkpoint, workers, &mut go_on).expect("runs"));
    let mut rows = vec![];
    survey.rows(&mut checkpoint, &mut |row| rows.push(row.to_vec())).expect("in memory");
    (rows, survey.hash(&mut checkpoint).expect("in memory"))
}

/// A file of its own that goes away.
struct Scratch(PathBuf);
impl Scratch {
    fn new(name: &str) -> Self {
        let path = std::env::temp_dir().join(format!("precess-{}-{name}", std::process::id()));
        let _ = std::fs::remove_file(&path);
        Self(path)
    }
}
impl Drop for Scratch {
    fn drop(&mut self) {
        let _ = std::fs::remove_file(&self.0);
    }
}

const RANDOM: &str = "[system]\nid = \"pendulum\"\n[run]\nmethod = \"tsit5\"\nrtol = 1e-6\natol = 1e-6\nuntil = 2\n\
    [ensemble]\nrandom = { theta = \"-3:3\", theta_dot = \"-1:1\" }\nmembers = 3000\nseed = 7\n";

#[test]
fn a_member_is_the_run_that_it_would_be_alone() {
    let text = "[system]\nid = \"pendulum\"\n[run]\nuntil = 3\nevery = 3\n[ensemble]\n\
        list = { theta = [0.1, \"90 deg\", 3], b = [0.1, 0.1, 0.2] }\n";
    let survey = survey(text);
    assert_eq!(survey.columns, ["start_theta", "start_b", "theta", "theta_dot", "status"]);
    let (rows, _) = rows(&survey, ONE);
    for (row, (theta, b)) in rows.iter().zip([(0.1, 0.1), (std::f64::consts::FRAC_PI_2, 0.1), (3.0, 0.2)]) {
        let mut alone = scenario(text);
        alone.start = vec![("theta".into(), Value::number(theta))];
        alone.parameters = vec![("b".into(), Value::number(b))];
        let outcome = run(&Plan::new(&alone).expect("a plan"), &mut |_| ControlFlow::Continue(()));
        let end = outcome.trajectory.rows().last().expect("an end");
        assert_eq!(row[..2], [theta, b]);
        assert_eq!(row[2..4], end[1..3]);
        assert_eq!(row[4], 0.0);
    }
}

#[test]
fn lanes_and_threads_change_no_bit() {
    let survey = survey(RANDOM);
    let (members, hash) = rows(&survey, ONE);
    assert_eq!(members.len(), 3000);
    for isa in Isa::available() {
        for threads in [1, 2, 3] {
            assert_eq!(rows(&survey, Workers { isa, threads }).1, hash, "{isa:?}, {threads} threads");
        }
    }
    // Evenly distributed: the mean of 3000 angles from -3 to 3 is within four of its standard errors.
    let mean = members.iter().map(|row| row[0]).sum::<f64>() / 3000.0;
    assert!(mean.abs() < 4.0 * 3.0 / (3.0_f64 * 3000.0).sqrt(), "{mean}");
    assert!(members.iter().all(|row| row[0].abs() <= 3.0 && row[1].abs() <= 1.0));
    let other =
        Survey::new(&scenario(&RANDOM.replace("seed = 7", "seed = 8")), Path::new(".")).expect("a survey");
    assert_ne!(rows(&other, ONE).1, hash);
}

#[test]
fn what_was_killed_ends_with_the_same_bits() {
    let survey = survey(RANDOM);
    let (_, hash) = rows(&survey, ONE);
    let scratch = Scratch::new("killed");
    let mut left = 0;
    // Ended after two chunks; then cut off at ten places, as if killed while it wrote.
    let mut two =
        |members: usize| if members > 600 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) };
    let mut checkpoint = Checkpoint::open(&scratch.0, &survey.text()).expect("a new file");
    assert!(!survey.run(&mut checkpoint, ONE, &mut two).expect("runs"));
    drop(checkpoint);
    let whole = std::fs::read(&scratch.0).expect("a checkpoint");
    let head = whole.len() - 2 * (512 * 5 * 8 + 48);
    for cut in (0..10).map(|k| head + (whole.len() - head) * k / 10) {
        let mut part = whole[..cut].to_vec();
        if cut % 2 == 0 && cut > head + 100 {
            // What is there may be damaged, too.
            part[cut - 50] ^= 1;
        }
        std::fs::write(&scratch.0, &part).expect("written");
        let mut checkpoint = Checkpoint::open(&scratch.0, &survey.text()).expect("taken up");
        let mut first = None;
        let mut watch = |members: usize| {
            first.get_or_insert(members);
            ControlFlow::Continue(())
        };
        assert!(
            survey.run(&mut checkpoint, Workers { isa: Isa::best(), threads: 2 }, &mut watch).expect("runs")
        );
        assert_eq!(survey.hash(&mut checkpoint).expect("read"), hash, "cut at {cut}");
        left += usize::from(first.is_some_and(|members| members > 512));
    }
    assert!(left > 2, "a chunk that was whole is not done again: {left}");
}

#[test]
fn a_checkpoint_of_something_else_is_refused_with_the_difference() {
    let scratch = Scratch::new("other");
    let first = survey(RANDOM);
    drop(Checkpoint::open(&scratch.0, &first.text()).expect("a new file"));
    for (from, to, word) in
        [("until = 2", "until = 2.5", "until = 2.5"), ("seed = 7", "seed = 9", "seed = 9")]
    {
        let other = survey(&RANDOM.replace(from, to));
        let refusal = Checkpoint::open(&scratch.0, &other.text()).err().expect("refused").to_string();
        assert!(refusal.contains(word), "{refusal}");
    }
    let newer = first.text().replacen("version = \"", "version = \"9.", 1);
    let refusal = Checkpoint::open(&scratch.0, &newer).err().expect("refused").to_string();
    assert!(refusal.contains("version = \"9."), "{refusal}");
    std::fs::write(&scratch.0, "something else").expect("written");
    let refusal = Checkpoint::open(&scratch.0, &first.text()).err().expect("refused").to_string();
    assert!(refusal.contains("no checkpoint"), "{refusal}");
}

const OSCILLATOR: &str =
    "[system]\nid = \"harmonic_oscillator\"\n[run]\nrtol = 1e-12\natol = 1e-12\nuntil = 10\nevery = 0.01\n";

#[test]
fn passages_sections_and_extremes_are_those_of_the_cosine() {
    // x = A cos(omega t): it falls through zero at pi / (2 omega), and every turn later.
    let event = "[[event]]\nwhen = \"x = 0\"\ndirection = \"falling\"\n";
    let members = "[ensemble]\ngrid = { x = \"1:3:3\", omega = \"1:2:2\" }\n";
    let (passages, _) = rows(&survey(&format!("{OSCILLATOR}{event}{members}keep = \"passage\"\n")), ONE);
    assert_eq!(passages.len(), 6);
    for row in &passages {
        let [amplitude, omega, t, x, x_dot, status] = row[..] else { panic!("{row:?}") };
        assert!((t - std::f64::consts::FRAC_PI_2 / omega).abs() < 1e-9, "{row:?}");
        assert!(x.abs() < 1e-9 && (x_dot + amplitude * omega).abs() < 1e-9 && status == 0.0, "{row:?}");
    }
    let (section, _) = rows(&survey(&format!("{OSCILLATOR}{event}{members}keep = \"section\"\n")), ONE);
    // Up to t = 10: two passages at omega = 1, three at omega = 2.
    let of = |member: f64| section.iter().filter(|row| row[2] == member).count();
    assert_eq!((0..6).map(|k| of(f64::from(k))).collect::<Vec<_>>(), [2, 2, 2, 3, 3, 3]);
    let extremes = survey(&format!("{OSCILLATOR}{members}keep = \"extremes\"\n"));
    assert_eq!(extremes.columns[2..4], ["x_min", "x_max"]);
    for row in rows(&extremes, ONE).0 {
        assert!((row[2] + row[0]).abs() < 1e-3 && row[3] == row[0], "{row:?}");
    }
}

#[test]
fn a_member_that_is_lost_has_a_status_and_harms_no_other() {
    let text = "[system]\nid = \"harmonic_oscillator\"\n[run]\nmethod = \"euler\"\ndt = 1000\nuntil = 3e5\nevery = 1e5\n\
        [ensemble]\ngrid = { x = \"0:1:11\" }\n";
    let survey = survey(text);
    let (rows, _) = rows(&survey, ONE);
    assert_eq!(rows.iter().map(|row| row[3]).collect::<Vec<_>>(), [&[0.0][..], &[-3.0; 10]].concat());
    assert_eq!(rows[0], [0.0; 4]);
}

#[test]
fn what_makes_no_sense_is_one_sentence() {
    let file = Scratch::new("rows.csv");
    std::fs::write(&file.0, "theta,theta_dot\n1,2\n0.5,NaN\n").expect("written");
    let name = file.0.file_name().expect("a name").to_string_lossy().into_owned();
    let from_file = format!("file = \"{name}\"");
    let cases = [
        (from_file.as_str(), "row 3, column theta_dot: 'NaN'"),
        ("file = \"nowhere.csv\"", "nowhere.csv"),
        ("grid = { thta = \"0:1:2\" }", "'theta'"),
        ("grid = { theta = \"0:1\" }", "LOW:HIGH:N"),
        ("grid = { theta = \"0:1:0\" }", "no members"),
        ("random = { theta = \"0:1:2\" }\nmembers = 2", "LOW:HIGH"),
        ("random = { theta = \"0:1\" }", "number of members"),
        ("list = { theta = [1, 2], b = [1] }", "b has 1 values, theta has 2"),
        ("list = { l = [1, -2] }", "value 2"),
        ("grid = { theta = \"0:1:2\" }\nseed = 1", "seed"),
        ("grid = { theta = \"0:1:2\" }\nlist = { b = [1] }", "one of grid, list, random and file"),
        ("grid = { theta = \"0:1:2\" }\nkeep = \"lst\"", "'last'"),
        ("grid = { theta = \"0:1:2\" }\nkeep = \"passage\"", "[[event]]"),
    ];
    for (text, word) in cases {
        let text = format!("precess = 1\n[system]\nid = \"pendulum\"\n[ensemble]\n{text}\n");
        let refusal = match Scenario::parse(&text) {
            Err(error) => error.to_string(),
            Ok(scenario) => Survey::new(&scenario, &std::env::temp_dir()).err().expect("refused").to_string(),
        };
        assert!(refusal.contains(word) && refusal.lines().count() == 1, "{text}: {refusal}");
    }
    let none = Survey::new(&Scenario::of("pendulum"), Path::new(".")).err().expect("refused").to_string();
    assert!(none.contains("[ensemble]"));
}

/// The tops of a map: upright is stable below sqrt(m g R^3 I3 alpha) (1 - alpha)^2 / sqrt(I1/I3 - 1 + alpha), upside down
/// above the threshold of physics (`models/tests/thresholds.rs`); each is met from both sides, under two frictions.
#[test]
fn tippe_tops_are_sorted_by_how_they_end() {
    let text = "[system]\nid = \"tippe_top\"\nparameters = { epsilon = 0.05 }\n[start]\ntheta = 0.1\nomega1 = 0\n\
        [run]\nmethod = \"rk4\"\ndt = 1e-3\nuntil = 40\n[ensemble]\n\
        list = { mu = [0.2, 0.2, 0.2, 0.2, 0.4, 0.4, 0.4, 0.4], omega3 = [24.9, 33, 69, 85, 24.9, 33, 69, 85] }\n\
        classes = { of = \"theta\", at = [\"15 deg\", \"150 deg\"] }\n";
    let survey = survey(text);
    assert_eq!(survey.columns.last().map(String::as_str), Some("class"));
    let (rows, hash) = rows(&survey, ONE);
    let found: Vec<f64> = rows.iter().map(|row| row[row.len() - 1]).collect();
    assert_eq!(found, [0.0, 1.0, 1.0, 2.0, 0.0, 1.0, 1.0, 2.0]);
    for isa in Isa::available() {
        assert_eq!(self::rows(&survey, Workers { isa, threads: 2 }).1, hash, "{isa:?}");
    }
}

/// A map has the grid's axes, the first name running fastest, and classes named after their borders.
#[test]
fn an_ensemble_of_a_grid_has_a_map() {
    let text = "[system]\nid = \"pendulum\"\nparameters = { g = 1 }\n[run]\nuntil = 8\n\
        [[event]]\nwhen = \"theta = 0\"\n[ensemble]\nkeep = \"passage\"\n\
        grid = { theta = \"0.5:2.5:3\", theta_dot = \"-1:1:2\" }\nclasses = { of = \"t\", at = [1, \"3 s\"] }\n";
    let survey = survey(text);
    let mut checkpoint = Checkpoint::in_memory();
    assert!(survey.run(&mut checkpoint, ONE, &mut go_on).expect("runs"));
    let figure = survey.figure(&mut checkpoint).expect("a map");
    let map = figure.panels[0].map.as_ref().expect("a map");
    assert_eq!(map.names, ["below 1 s", "1 to 3 s", "above 3 s"]);
    assert_eq!((map.columns, map.x, map.y), (3, (0.5, 2.5), (-1.0, 1.0)));
    let mut times = vec![];
    survey.rows(&mut checkpoint, &mut |row| times.push(row[2])).expect("in memory");
    let classes: Vec<i32> = times
        .iter()
        .map(|t| if t.is_nan() { -1 } else { i32::from(*t >= 1.0) + i32::from(*t >= 3.0) })
        .collect();
    assert_eq!(map.classes, classes);
    // Thrown inwards the steepest is soonest; thrown outwards from 2.5 it goes over the top and never passes theta = 0.
    assert_eq!((classes[0], classes[5]), (0, -1));
    assert!(Scenario::parse(&figure.scenario).expect("a scenario").ensemble.is_some());
}

#[test]
fn classes_that_make_no_sense_are_refused_in_a_sentence() {
    let with = |classes: &str| {
        let text = format!(
            "precess = 1\n[system]\nid = \"pendulum\"\n[ensemble]\ngrid = {{ theta = \"0:1:2\" }}\n{classes}\n"
        );
        let survey = Scenario::parse(&text).and_then(|s| Survey::new(&s, Path::new(".")));
        survey.and_then(|s| s.has_map()).expect_err(classes).to_string()
    };
    for (classes, why) in [
        ("classes = { of = \"thta\", at = [1] }", "did you mean 'theta'"),
        ("classes = { of = \"theta\", at = [2, 1] }", "must rise"),
        ("classes = { of = \"theta\", at = [1], names = [\"a\"] }", "2 classes, not 1"),
        ("classes = { of = \"theta\", at = [\"1 kg\"] }", "rad"),
        ("classes = { of = \"theta\" }", "classes are written as"),
        ("classes = { of = \"theta\", at = [1] }", "a grid of two names"),
        ("", "a map needs classes"),
    ] {
        let sentence = with(classes);
        assert!(sentence.contains(why) && sentence.lines().count() == 1, "{sentence}");
    }
}
