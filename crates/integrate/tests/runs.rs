//! Whole runs: where samples lie, which steps are taken, and the way back.

mod toys;

use precess_integrate::{Failure, Pace, Tolerance};
use precess_scalar::Scalar;
use toys::run::{Run, paces, tight};
use toys::{harmonic, mixed, pendulum};

#[test]
fn samples_lie_at_the_multiples_and_at_the_end() {
    let field = harmonic(1.0);
    for (id, pace) in paces(0.03) {
        for (until, every, count) in
            [(1.0, 0.1, 11), (1.0, 0.3, 5), (-1.0, 0.3, 5), (2.1, 0.7, 4), (0.05, 1.0, 2), (0.0, 1.0, 1)]
        {
            let run = Run {
                field: &field,
                method: id,
                start: &[1.0, 0.0],
                until,
                every,
                pace: pace.clone(),
                directions: &[],
                watches: &[],
            };
            let (report, rows) = run.go();
            assert_eq!(rows.len(), count, "{id} {until} {every}");
            for (k, (t, y)) in rows.iter().enumerate() {
                let expected = if k + 1 == count { until } else { until.signum() * (k as f64 * every) };
                assert_eq!(*t, expected, "{id}");
                if id == "dop853" {
                    assert!((y[0] - Scalar::cos(*t)).abs() < 1e-8, "{id} at {t}: {}", y[0]);
                }
            }
            assert_eq!(report.failure, None);
            assert_eq!(report.end, until);
        }
    }
}

#[test]
fn steps_of_fixed_length_are_exactly_that() {
    // The plain loop, 1000 steps of 0.001, gives the bits of the run that samples every ten steps.
    let field = harmonic(1.0);
    let (report, rows) = Run::new(&field, "euler_cromer", &[1.0, 0.2], (1.0, 0.01), Pace::Fixed(0.001)).go();
    assert_eq!(report.steps, 1000);
    let (mut x, mut v) = (1.0, 0.2);
    for (k, (_, y)) in rows.iter().enumerate() {
        assert_eq!(*y, [x, v], "row {k}");
        for _ in 0..10 {
            v += 0.001 * -x;
            x += 0.001 * v;
        }
    }
}

#[test]
fn a_run_backwards_returns_to_the_start() {
    let field = mixed();
    let start = [0.4, 1.0, 0.7];
    // Time enters, so the way back is the run over t from 0 to -3 of the system shifted by 3; without time:
    let free = pendulum(0.1);
    for pace in [tight(1e-12), Pace::Fixed(0.01)] {
        let there = Run::new(&free, "dop853", &start[..2], (3.0, 1.0), pace.clone()).go().1;
        let end = &there[3].1;
        let back = Run::new(&free, "dop853", end, (-3.0, 1.0), pace).go().1;
        for (a, b) in back[3].1.iter().zip(&start) {
            assert!((a - b).abs() < 1e-11, "{a} against {b}");
        }
    }
    // And the state before the start, with time entering.
    let rows = Run::new(&field, "dop853", &start, (-1.0, 0.5), tight(1e-11)).go().1;
    assert_eq!(rows.iter().map(|r| r.0).collect::<Vec<_>>(), [0.0, -0.5, -1.0]);
}

#[test]
fn a_growing_angle_left_out_of_the_norm_does_not_change_the_rest() {
    // Twice the oscillator: leaving one of them out must give the steps of the other alone.
    struct Both;
    impl toys::Toy for Both {
        fn rate<S: Scalar>(&self, _t: S, y: &[S], dy: &mut [S]) {
            (dy[0], dy[1], dy[2]) = (y[1], -y[0], y[0] * 1e3);
        }
    }
    let (alone, both) = (harmonic(1.0), toys::bind(Both, 0, 3, 0));
    let pace = Pace::Adaptive(Tolerance { rtol: 1e-8, atol: 1e-8, skip: vec![false, false, true] });
    let run = |field, start, pace| {
        Run { field, method: "dopri5", start, until: 20.0, every: 1.0, pace, directions: &[], watches: &[] }
            .go()
    };
    let (one, two) = (run(&alone, &[1.0, 0.0], tight(1e-8)), run(&both, &[1.0, 0.0, 0.0], pace));
    assert_eq!(one.0.steps, two.0.steps);
    for (a, b) in one.1.iter().zip(&two.1) {
        assert_eq!(a.1[..2], b.1[..2]);
    }
}

/// Samples come from dense output: they never change a step.
#[test]
fn samples_leave_the_steps_of_an_adaptive_method_alone() {
    let field = pendulum(0.1);
    let run = |every: f64| {
        Run {
            field: &field,
            method: "dop853",
            start: &[1.0, 0.0],
            until: 20.0,
            every,
            pace: tight(1e-10),
            directions: &[],
            watches: &[],
        }
        .go()
    };
    let ((few, rows), (many, finer)) = (run(20.0), run(0.01));
    assert_eq!(few.steps, many.steps);
    assert_eq!(rows.last(), finer.last());
}

#[test]
fn a_loop_that_does_not_converge_says_how_far_it_is() {
    let field = harmonic(1.0);
    let failure = |id, dt| {
        let run = Run::new(&field, id, &[1.0, 0.0], (10.0 * dt, dt), Pace::Fixed(dt));
        run.go().0.failure.expect("a step too long")
    };
    for id in ["newmark", "implicit_midpoint", "gauss_legendre4", "gauss_legendre6", "gauss_legendre16"] {
        let failure = failure(id, 40.0);
        let Failure::NoConvergence { t: 0.0, h: 40.0, residual, .. } = failure else { panic!("{failure:?}") };
        assert!(residual > 0.1 || !residual.is_finite(), "{id} {residual}");
    }
    // Each iteration of newmark turns the position over: x becomes -(h^2 / 6) x, and the rest. At 1.1 the changes grow as the
    // iterates do, and stay (1 + 1/1.1) times as large; at 0.94 two hundred of them do not suffice.
    let text = failure("newmark", (6.0_f64 * 1.1).sqrt()).to_string();
    assert!(text.contains("changed the state by 1.9e0 of its size (try a smaller dt)"), "{text}");
    let Failure::NoConvergence { residual, .. } = failure("newmark", (6.0_f64 * 0.94).sqrt()) else {
        panic!("it converged");
    };
    let expected = 1.94 * Scalar::powi(0.94_f64, 199);
    assert!((0.1..10.0).contains(&(residual / expected)), "{residual:e}, not {expected:e}");
    let text = failure("newmark", (6.0_f64 * 0.94).sqrt()).to_string();
    assert!(text.ends_with("(try a smaller dt)"), "{text}");
    let text = failure("newmark", (6.0_f64 * 0.92).sqrt()).to_string();
    assert!(text.ends_with("(try a smaller dt, or a larger epsilon)"), "{text}");
}
