//! A tape gives the bits of the function it was recorded from, and holds each operation once.

use crate::random::{Generator, expression, value_and_size};
use precess_scalar::{Dimension, Dual, Isa, Lanes, Scalar, Tape, Traced, Unit, Workspace, with_lanes};

fn same(a: f64, b: f64) -> bool {
    a.to_bits() == b.to_bits() || (a.is_nan() && b.is_nan())
}

#[test]
fn a_replay_gives_the_same_bits() {
    let mut finite = 0;
    for seed in 0..2000 {
        let mut g = Generator::new(seed + 9000);
        let operations = 3 + g.below(40);
        let tape = Tape::record(3, |x| vec![expression(seed, operations, x)]);
        let mut workspace = Workspace::default();
        for special in [None, Some(0.0), Some(-0.0), Some(f64::INFINITY)] {
            let x = [g.number(), g.number(), special.unwrap_or(g.number())];
            let direct = expression(seed, operations, &x);
            let mut again = [0.0];
            tape.evaluate_into(&mut workspace, &x, &mut again);
            assert!(same(tape.evaluate(&x)[0], direct), "expression {seed} at {x:?}");
            assert!(same(again[0], direct), "expression {seed} at {x:?}");
            finite += usize::from(direct.is_finite());
        }
    }
    assert!(finite > 4000, "only {finite} of the values tested were finite");
}

fn lanes_of_a_replay<S: Lanes>() {
    let values = [[0.7, -0.0, 2.0, 1e200], [-1.3, 0.4, f64::INFINITY, 3.0]];
    for seed in 0..300 {
        let tape = Tape::record(2, |x| vec![expression(seed, 25, x)]);
        let x = values.map(|values| S::from_lanes(|i| values[i % 4]));
        let number = tape.evaluate(&x)[0];
        for (i, &lane) in number.lanes().iter().enumerate() {
            let plain = values.map(|values| values[i % 4]);
            assert!(same(lane, expression(seed, 25, &plain)), "expression {seed}, lane {i}");
        }
    }
}

#[test]
fn every_lane_of_a_replay_gives_the_same_bits() {
    for isa in Isa::available() {
        with_lanes!(isa, S => lanes_of_a_replay::<S>());
    }
}

#[test]
fn a_replay_differentiates() {
    for seed in 0..300 {
        let tape = Tape::record(2, |x| vec![expression(seed, 12, x)]);
        let x = [Dual::new(0.7, 1.0), Dual::new(-1.3, 0.5)];
        let (direct, replayed) = (expression(seed, 12, &x), tape.evaluate(&x)[0]);
        assert!(same(direct.value, replayed.value), "expression {seed}");
        // A folded literal has no slope where the direct run may carry a zero times infinity.
        let close = direct.slope.is_nan()
            || direct.slope == replayed.slope
            || (direct.slope - replayed.slope).abs() < 1e-12 * direct.slope.abs();
        assert!(close, "expression {seed}: {direct:?} and {replayed:?}");
    }
}

#[test]
fn a_simplified_tape_agrees_to_rounding() {
    let (mut checked, mut before, mut after) = (0, 0, 0);
    for seed in 0..2000 {
        let mut g = Generator::new(seed + 777);
        let tape = Tape::record(3, |x| vec![expression(seed, 14, x)]);
        let x = [g.number(), g.number(), g.number()];
        let (value, largest) = value_and_size(&tape, &x);
        let Some(largest) = largest else { continue };
        let simple = tape.simplified();
        before += tape.operations();
        after += simple.operations();
        let other = simple.evaluate(&x)[0];
        assert!((other - value).abs() <= 1e-12 * largest, "expression {seed} at {x:?}: {value} and {other}");
        checked += 1;
    }
    assert!(checked > 800, "only {checked} expressions were tame enough");
    assert!(after < before, "{before} operations became {after}");
}

#[test]
fn equal_operations_are_recorded_once() {
    let tape = Tape::record(2, |x| vec![x[0].sin() * x[1] + x[1] * x[0].sin(), x[0].sin_cos().0]);
    // x, y, sin x, their product, its double; the cosine reaches no output.
    assert_eq!((tape.len(), tape.operations()), (5, 3));
    assert_eq!(Tape::record(1, |x| vec![x[0] - 1.0, x[0] - 1.0]).operations(), 1);
    // The order of a difference matters, and so does the sign of a zero.
    assert_eq!(Tape::record(2, |x| vec![x[0] - x[1], x[1] - x[0]]).operations(), 2);
    assert_eq!(Tape::record(1, |x| vec![x[0] + 0.0, x[0] * -0.0]).len(), 5);
}

#[test]
fn folding_while_recording_keeps_every_bit() {
    let folded = |f: fn(Traced) -> Traced| Tape::record(1, |x| vec![f(x[0])]).operations();
    assert_eq!(folded(|x| -(-x)), 0);
    assert_eq!(folded(|x| x * 1.0), 0);
    assert_eq!(folded(|x| Traced::from(1.0) * x / 1.0 - 0.0 + -0.0), 0);
    assert_eq!(folded(|x| x + (Traced::from(2.0).sqrt() * 3.0).sin()), 1);
    // These would change a zero, an infinity or a NaN.
    assert_eq!(folded(|x| x + 0.0), 1);
    assert_eq!(folded(|x| x * 0.0), 1);
    assert_eq!(folded(|x| x - x), 1);
    assert_eq!(folded(|x| Traced::from(0.0) - x), 1);
}

#[test]
fn simplification_knows_zeros_ones_and_signs() {
    let simple = |f: fn(Traced, Traced) -> Traced| {
        let tape = Tape::record(2, |x| vec![f(x[0], x[1])]).simplified();
        tape.text_of(tape.outputs().next().unwrap_or(0), &["x".into(), "y".into()])
    };
    assert_eq!(simple(|x, y| x * 0.0 + y), "y");
    assert_eq!(simple(|x, y| Traced::from(0.0) / x - y), "-y");
    assert_eq!(simple(|x, y| (-x) * y), "-x * y");
    assert_eq!(simple(|x, y| x + -y), "x - y");
    assert_eq!(simple(|x, y| x - -y), "x + y");
    assert_eq!(simple(|x, y| x * -y + 1.0), "1 - x * y");
    assert_eq!(simple(|x, _| x - x), "0");
    assert_eq!(simple(|x, _| x.powi(1) + x), "2 * x");
    assert_eq!(simple(|x, _| x * x + x.powi(2)), "2 * x^2");
    assert_eq!(simple(|x, y| (-x).sin() * (-y).cos()), "-sin(x) * cos(y)");
    assert_eq!(simple(|x, y| x * (Traced::from(1.0) / y)), "x / y");
    assert_eq!(simple(|x, _| x.powf(Traced::from(0.5))), "sqrt(x)");
    assert_eq!(simple(|x, y| Traced::select(Traced::from(1.0).lt(Traced::from(2.0)), x, y)), "x");
}

#[test]
fn dependence_follows_the_operations() {
    let tape = Tape::record(3, |x| vec![x[0] * x[1], x[1].cos(), x[2] * 0.0]);
    let table: Vec<bool> = (0..9).map(|i| tape.depends_on(i / 3, i % 3)).collect();
    assert_eq!(table, [true, true, false, false, true, false, false, false, true]);
    assert!(!tape.simplified().depends_on(2, 2));
}

#[test]
fn the_term_that_does_not_add_up_is_found() {
    let names = ["m", "v", "g"].map(String::from);
    let tape = Tape::record(3, |x| vec![x[0] * x[1] * x[1] * 0.5 + x[0] * x[2]]);
    let quantities = [[1, 0, 0], [0, 1, -1], [0, 1, -2]];
    let inputs = quantities.map(|[kg, m, s]| Unit::of(Dimension::new(kg, m, s)));
    let mut culprit = None;
    Unit::clash();
    tape.evaluate_with(&inputs, |node, _| {
        if Unit::clash().is_some() {
            culprit = culprit.or(Some(node));
        }
    });
    assert_eq!(culprit.map(|node| tape.text_of(node, &names)).as_deref(), Some("0.5 * m * v^2 + m * g"));
}

#[test]
fn recordings_nest_and_end_with_a_panic() {
    let inner = Tape::record(1, |x| vec![x[0].sin()]);
    let outer = Tape::record(1, |x| {
        assert_eq!(Tape::record(1, |y| vec![y[0] * 2.0]).operations(), 1);
        inner.evaluate(&[x[0] * 2.0])
    });
    assert!(same(outer.evaluate(&[0.3])[0], Scalar::sin(0.6)));

    assert_eq!(Tape::try_record(1, |_| Err("no such name")), Err("no such name"));
    assert_eq!(message(|| drop(Tape::record(1, |_| panic!("in a model")))), "in a model");
    assert!(message(|| _ = Traced::from(1.0)).contains("inside Tape::record only"));
    let stray = || drop(Tape::record(1, |x| Tape::record(1, |_| vec![x[0] + 1.0]).evaluate(x)));
    assert!(message(stray).contains("another recording"));
}

fn message(f: impl FnOnce() + std::panic::UnwindSafe) -> String {
    let payload = std::panic::catch_unwind(f).expect_err("it should have panicked");
    let text = payload.downcast_ref::<&str>().map(ToString::to_string);
    text.or_else(|| payload.downcast_ref::<String>().cloned()).unwrap_or_default()
}
