//! Printed text means what was recorded.

use crate::calculator;
use crate::random::{Generator, expression, value_and_size};
use precess_scalar::{Notation, Scalar, Tape, Traced};

fn names() -> Vec<String> {
    ["x", "theta'", "v_1"].map(String::from).to_vec()
}

#[test]
fn text_read_back_gives_the_value() {
    let mut checked = 0;
    for seed in 0..3000 {
        let mut g = Generator::new(seed + 31);
        let tape = Tape::record(3, |x| vec![expression(seed, 5 + seed as usize % 12, x)]);
        let x = [g.number(), g.number(), g.number()];
        for tape in [&tape, &tape.simplified()] {
            let (value, Some(largest)) = value_and_size(tape, &x) else { continue };
            let printed = tape.print(&names(), Notation::Text);
            let mut known: Vec<_> = names().into_iter().zip(x).collect();
            for (name, meaning) in &printed.definitions {
                known.push((name.clone(), calculator::value(meaning, &known)));
            }
            let read = calculator::value(&printed.outputs[0], &known);
            let close = (read - value).abs() <= 1e-12 * largest;
            assert!(close, "expression {seed} at {x:?}: {value}, but {read} from {printed:?}\n{tape:?}");
            checked += 1;
        }
    }
    assert!(checked > 2400, "only {checked} expressions were tame enough");
}

/// Braces, `\left` and environments of LaTeX must balance, and no sign may follow another.
#[test]
fn latex_is_well_formed() {
    for seed in 0..1000 {
        let tape = Tape::record(3, |x| vec![expression(seed, 20, x)]);
        let names = ["x^{*}", r"\dot\theta", "v_1"].map(String::from);
        let printed = tape.print(&names, Notation::Latex);
        for text in printed.outputs.iter().chain(printed.definitions.iter().map(|(_, text)| text)) {
            let count = |part: &str| text.matches(part).count();
            assert_eq!(count("{"), count("}"), "{text}");
            assert_eq!(count("("), count(")"), "{text}");
            assert_eq!(count(r"\left"), count(r"\right"), "{text}");
            assert_eq!(count(r"\begin{cases}"), count(r"\end{cases}"), "{text}");
            for wrong in ["--", "- -", "+ -", r"\, \,", "x^{*}^", "}^{2}^", "{}"] {
                assert!(!text.contains(wrong), "{wrong} in {text}");
            }
        }
    }
}

#[test]
fn numbers_are_written_as_in_books() {
    use std::f64::consts::{FRAC_PI_2, PI, SQRT_2, TAU};
    let table = [
        (3.0, "3", "3"),
        (-2.5, "-2.5", "-2.5"),
        (0.5, "0.5", r"\frac{1}{2}"),
        (-1.5, "-1.5", r"-\frac{3}{2}"),
        (0.1, "0.1", "0.1"),
        (1.0 / 3.0, "1 / 3", r"\frac{1}{3}"),
        (-7.0 / 12.0, "-7 / 12", r"-\frac{7}{12}"),
        (PI, "pi", r"\pi"),
        (TAU, "2 * pi", r"2\pi"),
        (FRAC_PI_2, "pi / 2", r"\frac{\pi}{2}"),
        (PI / 180.0, "pi / 180", r"\frac{\pi}{180}"),
        (PI / 90.0, "pi / 90", r"\frac{\pi}{90}"),
        (SQRT_2, "sqrt(2)", r"\sqrt{2}"),
        (Scalar::sqrt(3.0) / 2.0, "sqrt(3) / 2", r"\frac{\sqrt{3}}{2}"),
        (6.674e-11, "6.674e-11", r"6.674 \times 10^{-11}"),
        (1e9, "1e9", "10^{9}"),
        (0.333, "0.333", "0.333"),
        (0.0, "0", "0"),
        (-0.0, "-0", "-0"),
        (f64::NAN, "NaN", r"\mathrm{NaN}"),
        (f64::INFINITY, "inf", r"\infty"),
        (f64::NEG_INFINITY, "-inf", r"-\infty"),
        (5e-324, "5e-324", r"5 \times 10^{-324}"),
    ];
    for (x, text, latex) in table {
        let tape = Tape::record(0, |_| vec![Traced::from(x)]);
        assert_eq!(tape.print(&[], Notation::Text).outputs[0], text);
        assert_eq!(tape.print(&[], Notation::Latex).outputs[0], latex);
    }
}

#[test]
fn odd_numbers_in_odd_places_print() {
    for x in [f64::NAN, f64::INFINITY, -0.0, 0.0, -1.0, 5e-324, f64::MAX] {
        let tape = Tape::record(1, |y| {
            let c = Traced::from(x);
            vec![
                c * y[0],
                y[0] / c,
                y[0].powf(c),
                c.powf(y[0]),
                y[0] * c * c / c,
                y[0].powi(i32::MIN),
                y[0].powi(0),
            ]
        });
        for tape in [&tape, &tape.simplified()] {
            // Too few names is no reason to fail either.
            assert_eq!(tape.print(&[], Notation::Text).outputs.len(), 7);
            assert_eq!(tape.print(&[], Notation::Latex).outputs.len(), 7);
        }
    }
}

#[test]
fn a_generated_name_is_nobody_elses() {
    let tape = Tape::record(2, |x| {
        let long = x[0].sin() * x[1] + x[1].cos() * x[0] + x[0] * x[1];
        vec![long.sqrt(), long.exp()]
    });
    let printed = tape.print(&["s1".into(), "s3".into()], Notation::Text);
    assert_eq!(printed.definitions, [("s2".into(), "sin(s1) * s3 + cos(s3) * s1 + s1 * s3".into())]);
    assert_eq!(printed.outputs, ["sqrt(s2)", "exp(s2)"]);
}

#[test]
fn a_long_node_is_told_with_definitions() {
    let names = ["x".into(), "y".into()];
    let tape = Tape::record(2, |x| {
        let long = x[0].sin() * x[1] + x[1].cos() * x[0] + x[0] * x[1];
        vec![(0..6).fold(x[0], |sum, i| sum + long.powi(i + 2))]
    });
    let output = tape.outputs().next().unwrap_or(0);
    assert_eq!(
        tape.text_of(output, &names),
        "x + s1^2 + s1^3 + s1^4 + s1^5 + s1^6 + s1^7, where s1 = sin(x) * y + cos(y) * x + x * y"
    );
    assert_eq!(tape.text_of(2, &names), "sin(x)");
}

#[test]
fn a_long_sum_prints() {
    let tape = Tape::record(1, |x| vec![(1..3000).fold(x[0], |sum, i| sum + x[0] / f64::from(i))]);
    assert!(tape.print(&["x".into()], Notation::Text).outputs[0].ends_with("+ x / 2998 + x / 2999"));
}
