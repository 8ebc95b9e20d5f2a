//! The parsers of values and scenarios: what they understand, what they refuse, and that nothing panics.

mod fuzz_body;

use precess::value::{Value, parse};
use precess::{Plan, Scenario, scenarios};
use proptest::prelude::*;

fn number(text: &str, unit: &str) -> f64 {
    parse(text).and_then(|v| v.in_unit(unit)).unwrap_or_else(|e| panic!("{e}"))
}

#[test]
fn numbers_are_read_as_people_write_them() {
    let pi = std::f64::consts::PI;
    let cases = [
        ("0.1", 0.1),
        ("0,1", 0.1),
        (".5", 0.5),
        ("5.", 5.0),
        ("1e-3", 0.001),
        ("1E3", 1000.0),
        ("49*pi/50", 49.0 * pi / 50.0),
        ("pi/6", pi / 6.0),
        ("π", pi),
        ("PI", pi),
        ("0.4/4.7", 0.4 / 4.7),
        ("2^-10", 1.0 / 1024.0),
        ("-2^2", -4.0),
        ("2^3^2", 512.0),
        ("(1+2)*3", 9.0),
        ("1 - 2 - 3", -4.0),
        ("8/4/2", 1.0),
        ("--1", 1.0),
        ("+3", 3.0),
        ("-6/45 + 2.5", -6.0 / 45.0 + 2.5),
        ("−1", -1.0),
    ];
    for (text, value) in cases {
        assert_eq!(number(text, ""), value, "{text}");
    }
}

#[test]
fn units_are_converted_and_checked() {
    assert_eq!(number("30 deg", "rad"), 30.0 * (std::f64::consts::PI / 180.0));
    assert_eq!(number("2 min", "s"), 120.0);
    assert_eq!(number("1,5 dm", "m"), 1.5 * 0.1);
    assert_eq!(number("9.81 m/s^2", "m/s^2"), 9.81);
    assert_eq!(number("600 rpm", "rad/s"), 600.0 * (std::f64::consts::TAU / 60.0));
    for (text, unit) in [("1 kg", "m"), ("1 s", ""), ("3 m/s", "m/s^2")] {
        assert!(parse(text).and_then(|v| v.in_unit(unit)).is_err(), "{text} for [{unit}]");
    }
}

#[test]
fn lists_stand_in_brackets() {
    let of = |xs: &[f64]| Value::List(xs.iter().map(|x| Value::number(*x)).collect());
    assert_eq!(parse("[10; 1]"), Ok(of(&[10.0, 1.0])));
    assert_eq!(parse("[10, 1]"), Ok(of(&[10.0, 1.0])));
    assert_eq!(parse("[[1; 2]; [3; 4]]"), Ok(Value::List(vec![of(&[1.0, 2.0]), of(&[3.0, 4.0])])));
    assert!(parse("[0,5; 1]").is_err(), "a decimal comma inside brackets is ambiguous");
}

#[test]
fn what_makes_no_sense_is_refused_in_one_line() {
    let deep = "(".repeat(10_000);
    let brackets = "[".repeat(10_000);
    let minus = "-".repeat(10_000);
    let wrong = [
        "", " ", "1+", "*", "(1", "1)", "[1; 2", "1 2", "1..2", "1/0", "0/0", "1e999", "10^400", "3 parsec",
        "[1 2]", "1 kg^99", "nan", "$", "\u{0}", "1 /", "5 m/", &deep, &brackets, &minus,
    ];
    for text in wrong {
        let message = match parse(text) {
            // A lone word is a choice; it is refused where a number is needed.
            Ok(value) => value.in_unit("").map(|x| panic!("'{text}' gave {x}")).unwrap_err().to_string(),
            Err(error) => error.to_string(),
        };
        assert!(!message.contains('\n') && message.len() < 200, "{message}");
    }
}

/// A scenario with one line changed, and a word that the message must hold.
#[test]
fn a_scenario_that_is_wrong_names_the_line_and_the_nearest_name() {
    let good = "precess = 1\n[system]\nid = \"pendulum\"\nparameters = { l = 2 }\n[start]\ntheta = 1\n\
                [run]\nmethod = \"rk4\"\ndt = 0.01\nuntil = 1\nevery = 0.1\n";
    let planned = |text: &str| Scenario::parse(text).and_then(|s| Plan::new(&s));
    assert!(planned(good).is_ok());
    let cases = [
        ("id = \"pendulum\"", "id = \"pendulm\"", "pendulum"),
        ("[start]", "[strat]", "start"),
        ("l = 2", "lenght = 2", "l"),
        ("theta = 1", "teta = 1", "theta"),
        ("\"rk4\"", "\"rk5\"", "rk4"),
        ("dt = 0.01", "td = 0.01", "dt"),
        ("dt = 0.01", "dt = 0", "dt"),
        ("dt = 0.01", "dt = -1", "dt"),
        ("dt = 0.01", "dt = nan", "finite"),
        ("dt = 0.01", "rtol = 1e-9", "dt"),
        ("until = 1", "until = inf", "finite"),
        ("until = 1", "until = 1e300", "every"),
        ("every = 0.1", "every = 2", "every"),
        ("every = 0.1", "every = 1e-12", "samples"),
        ("l = 2", "l = -2", "l"),
        ("l = 2", "l = \"2 kg\"", "kg"),
        ("precess = 1", "precess = 2", "format"),
        ("precess = 1", "", "precess"),
        ("theta = 1", "theta = 1\ntheta = 2", "line"),
        ("[run]", "[run", "line"),
    ];
    for (from, to, hint) in cases {
        let text = good.replacen(from, to, 1);
        let message = match planned(&text) {
            Ok(_) => panic!("{to} was accepted"),
            Err(error) => error.to_string(),
        };
        assert!(message.contains(hint), "{to}: {message}");
        assert!(!message.contains('\n'), "{message}");
    }
}

#[test]
fn the_scenarios_that_come_with_the_program_are_right() {
    let all = scenarios::all();
    assert!(all.len() >= 3);
    for (name, text) in all {
        let scenario = Scenario::parse(text).unwrap_or_else(|e| panic!("{name}: {e}"));
        let words = &scenario.text;
        assert!(
            [&scenario.title, &words.title_fr, &words.note, &words.note_fr].iter().all(|t| !t.is_empty()),
            "{name}: a title and a note, in English and in French"
        );
        let plan = Plan::new(&scenario);
        assert!(plan.is_ok(), "{name}: {}", plan.err().map(|e| e.to_string()).unwrap_or_default());
        fuzz_body::parsers(text.as_bytes());
    }
}

/// A scenario with more text behind a plain pendulum.
fn pendulum_with(more: &str) -> Result<Plan, String> {
    let text = format!("precess = 1\n[system]\nid = \"pendulum\"\n{more}");
    Scenario::parse(&text).and_then(|s| Plan::new(&s)).map_err(|e| e.to_string())
}

#[test]
fn families_are_lines_of_starts_and_lists_of_parameters() {
    let plan = pendulum_with(
        "[[family]]\nlabel = \"{theta}\"\nstart = { theta = \"-1:1:5\", theta_dot = 2 }\n\
         [[family]]\nparameters = { l = [1, 2] }\nboth_ways = true\n\
         [[family]]\nsystem = \"harmonic_oscillator\"\nnames = { theta = \"x\" }\nrun = { method = \"rk4\", dt = 0.1 }",
    );
    let plan = plan.unwrap_or_else(|e| panic!("{e}"));
    let starts: Vec<Vec<f64>> = plan.members.iter().map(|m| m.plan.start.clone()).collect();
    assert_eq!(starts[..5], [-1.0, -0.5, 0.0, 0.5, 1.0].map(|x| vec![x, 2.0]));
    assert_eq!(plan.members[1].label, "-0.5");
    let lengths: Vec<_> =
        plan.members[5..7].iter().map(|m| m.plan.values.number(&m.plan.card, "l")).collect();
    assert_eq!(lengths, [Some(1.0), Some(2.0)]);
    assert_eq!((plan.members.len(), plan.members[7].plan.card.id == "harmonic_oscillator"), (8, true));
}

#[test]
fn a_family_or_panel_that_makes_no_sense_is_told_apart() {
    let wrong = [
        ("[[family]]\nstarts = { theta = 1 }", "did you mean 'start'"),
        ("[[family]]\nstart = { teta = 1 }", "did you mean 'theta'"),
        ("[[family]]\nstart = { theta = [] }", "empty"),
        ("[[family]]\nstart = { theta = \"0:1:1\" }", "between 2 and"),
        ("[[family]]\nstart = { theta = \"0:1:99999999\" }", "between 2 and"),
        ("[[family]]\nstart = { theta = [1, 2], theta_dot = [1, 2, 3] }", "go together"),
        ("[[family]]\nlabel = \"{l}\"\nstart = { theta = 1 }", "braces"),
        ("[[family]]\nsystem = \"pendulm\"", "did you mean 'pendulum'"),
        ("[[family]]\nnames = { theta = \"speed\" }", "quantity of pendulum"),
        ("[[family]]\nstyle = \"dot\"", "did you mean 'dots'"),
        ("[[figure]]\ny = \"thet\"", "did you mean 'theta'"),
        ("[[figure]]\ny = \"theta\"\nof = \"others\"", "known are run"),
        ("[[figure]]\ny = \"theta\"\nx_range = [2, 1]", "2 is not below 1"),
        ("[[figure]]\ny = \"theta\"\nx_range = [1]", "two values"),
        ("[[figure]]\ny = \"theta\"\nbetween = [\"0 m\", 1]", "a value in s"),
        ("[[figure]]\nkind = \"curve\"", "did you mean 'curves'"),
        ("[[figure]]\ny = [\"theta\", \"energy\"]\nx = [\"t\", \"t\", \"t\"]", "one x for all"),
    ];
    for (text, part) in wrong {
        let Err(said) = pendulum_with(text) else { panic!("understood: {text}") };
        assert!(said.contains(part) && !said.contains('\n'), "{text}: {said}");
    }
}

/// A scenario of the project with a few bytes changed, cut or doubled.
fn damaged() -> impl Strategy<Value = Vec<u8>> {
    let count = scenarios::all().len();
    let edit = (any::<prop::sample::Index>(), any::<u8>(), 0u8..4);
    (0..count, prop::collection::vec(edit, 1..6)).prop_map(|(k, edits)| {
        let mut bytes = scenarios::all()[k].1.as_bytes().to_vec();
        for (at, byte, kind) in edits {
            let at = at.index(bytes.len());
            match kind {
                0 => bytes[at] = byte,
                1 => bytes.truncate(at.max(1)),
                2 => bytes.insert(at, byte),
                _ => {
                    let piece = bytes[at..(at + 20).min(bytes.len())].to_vec();
                    bytes.splice(at..at, piece);
                }
            }
        }
        bytes
    })
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 2000, ..ProptestConfig::default() })]

    #[test]
    fn any_bytes_are_parsed_without_a_panic(bytes in prop::collection::vec(any::<u8>(), 0..200)) {
        fuzz_body::parsers(&bytes);
    }

    #[test]
    fn any_arithmetic_is_parsed_without_a_panic(text in "[-+*/^() 0-9.,eπpi;m\\[\\]°s]{0,40}") {
        fuzz_body::parsers(text.as_bytes());
    }

    #[test]
    fn damaged_scenarios_are_parsed_without_a_panic(bytes in damaged()) {
        fuzz_body::parsers(&bytes);
    }

    #[test]
    fn any_number_survives_writing_and_reading(bits in any::<u64>()) {
        let x = f64::from_bits(bits);
        prop_assume!(x.is_finite());
        let back = parse(&precess::value::shortest(x)).and_then(|v| v.in_unit(""));
        prop_assert_eq!(back.map(f64::to_bits), Ok(x.to_bits()));
    }
}
