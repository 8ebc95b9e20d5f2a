//! The drive: samples, events, failures.

mod common;

use common::{Ball, BlowUp, Driven, Kepler, Oscillator, Pendulum, field, layout, method, needs_separable};
use precess_integrate::{
    Drive, Failure, METHODS, Options, Pace, Report, Samples, Source, Tolerance, Watched, drive,
};
use precess_system::{Direction, System};
use std::ops::ControlFlow;

struct Run {
    report: Report,
    samples: Vec<(f64, Vec<f64>)>,
}

fn pace(id: &str, step: f64) -> Pace {
    match method(id).card().kind {
        precess_integrate::Kind::Fixed => Pace::Fixed(step),
        precess_integrate::Kind::Adaptive => {
            Pace::Adaptive(Tolerance { rtol: step, atol: step, skip: vec![] })
        }
    }
}

fn run(system: &impl System, id: &str, step: f64, until: f64, every: f64, watches: &[Watched]) -> Run {
    run_with(system, id, step, until, every, watches, &mut |_| ControlFlow::Continue(()))
}

fn run_with(
    system: &impl System,
    id: &str,
    step: f64,
    until: f64,
    every: f64,
    watches: &[Watched],
    progress: &mut dyn FnMut(f64) -> ControlFlow<()>,
) -> Run {
    let field = field::<f64>(system);
    let layout = layout(system);
    let directions: Vec<Direction> = layout.events.iter().map(|e| e.direction).collect();
    let start = layout.start();
    let job = Drive {
        field: field.as_ref(),
        method: method(id),
        options: Options::default(),
        start: &start,
        samples: Samples::new(until, every),
        pace: pace(id, step),
        directions: &directions,
        watches,
    };
    let mut samples = vec![];
    let report = drive(&job, &mut |t, y| samples.push((t, y.to_vec())), progress);
    Run { report, samples }
}

/// Complete elliptic integral of the first kind by the arithmetic-geometric mean.
fn elliptic_k(k: f64) -> f64 {
    let (mut a, mut b) = (1.0, (1.0 - k * k).sqrt());
    while (a - b).abs() > 1e-16 * a {
        (a, b) = (0.5 * (a + b), (a * b).sqrt());
    }
    std::f64::consts::FRAC_PI_2 / a
}

/// P, exercise 1.2: from 49 pi / 50 the pendulum is at the bottom after a quarter of its period.
#[test]
fn the_pendulum_from_near_the_top_reaches_the_bottom_in_a_quarter_period() {
    let start = 49.0 * std::f64::consts::PI / 50.0;
    let quarter = elliptic_k(precess_scalar::Scalar::sin(start / 2.0));
    let bottom = Watched { function: Box::new(|_, y| y[0]), direction: Direction::Falling, stop: false };
    let run = run(&Pendulum { start }, "dop853", 1e-15, 2.0 * quarter, quarter, &[bottom]);
    assert_eq!(run.samples[1].0, quarter);
    assert!(run.samples[1].1[0].abs() < 1e-12, "{:e}", run.samples[1].1[0]);
    assert_eq!(run.report.events.len(), 1);
    assert!((run.report.events[0].t - quarter).abs() < 1e-12, "{:e}", run.report.events[0].t - quarter);
}

#[test]
fn a_crossing_is_found_to_rounding_by_every_method() {
    for (id, step, bound) in
        [("rk4", 1e-3, 1e-12), ("verlet", 1e-4, 1e-8), ("dopri5", 1e-13, 1e-11), ("dop853", 1e-14, 1e-13)]
    {
        let zero = Watched { function: Box::new(|_, y| y[0]), direction: Direction::Either, stop: false };
        let run = run(&Oscillator, id, step, 10.0, 10.0, &[zero]);
        let times: Vec<f64> = run.report.events.iter().map(|e| e.t).collect();
        assert_eq!(times.len(), 3, "{id}");
        for (k, t) in times.iter().enumerate() {
            let exact = std::f64::consts::FRAC_PI_2 * (2 * k + 1) as f64;
            assert!((t - exact).abs() < bound, "{id}: {:e}", t - exact);
        }
        // The state there has passed: the first representable time on the far side.
        assert!(run.report.events[0].state[0] <= 0.0 && run.report.events[1].state[0] >= 0.0, "{id}");
    }
}

#[test]
fn directions_are_told_apart_and_a_stop_ends_the_run() {
    let watch = |direction, stop| Watched { function: Box::new(|_, y| y[0]), direction, stop };
    let run = run(
        &Oscillator,
        "dop853",
        1e-12,
        20.0,
        1.0,
        &[watch(Direction::Rising, true), watch(Direction::Falling, false)],
    );
    assert_eq!(run.report.stopped_by, Some(0));
    assert_eq!(run.report.events.len(), 2);
    assert_eq!(run.report.events[0].source, Source::Watch(1));
    let last = run.samples.last().expect("samples");
    assert_eq!(last.0, run.report.end);
    assert!((last.0 - 1.5 * std::f64::consts::PI).abs() < 1e-10);
    assert_eq!(run.samples.len(), 6, "0 to 4, and the stop");
}

/// From height 1 with g = 2 the ball lands at t = 1 with speed 2, then every 2 e^n.
#[test]
fn a_ball_bounces_at_the_right_times() {
    for (id, step) in [("dop853", 1e-12), ("dopri5", 1e-12), ("rk4", 1e-2), ("newmark", 1e-2)] {
        let run = run(&Ball { kept: 0.5 }, id, step, 2.9, 0.1, &[]);
        let times: Vec<f64> = run.report.events.iter().map(|e| e.t).collect();
        let exact = [1.0, 2.0, 2.5, 2.75, 2.875];
        assert_eq!(times.len(), exact.len(), "{id}: {times:?}");
        for (t, exact) in times.iter().zip(exact) {
            assert!((t - exact).abs() < 1e-11, "{id}: {t} {exact}");
        }
        assert!(run.samples.iter().all(|(_, y)| y[0] > -1e-12), "{id} never falls through the floor");
        assert_eq!(run.samples.len(), 30, "{id}");
    }
}

#[test]
fn events_without_end_are_a_failure_not_a_hang() {
    let run = run(&Ball { kept: 0.5 }, "dop853", 1e-9, 10.0, 1.0, &[]);
    let failure = run.report.failure.expect("the bounces pile up at t = 3");
    assert!(matches!(failure, Failure::TooManyEvents { .. } | Failure::StepTooSmall { .. }), "{failure:?}");
    assert!((failure.time() - 3.0).abs() < 1e-6, "{failure:?}");
}

#[test]
fn samples_lie_where_they_should() {
    for candidate in METHODS {
        let id = candidate.card().id;
        let step = if candidate.card().kind == precess_integrate::Kind::Fixed { 0.003 } else { 1e-8 };
        let run = run(&Oscillator, id, step, 1.05, 0.1, &[]);
        let times: Vec<f64> = run.samples.iter().map(|s| s.0).collect();
        let mut expected: Vec<f64> = (0..=10).map(|k| f64::from(k) * 0.1).collect();
        expected.push(1.05);
        assert_eq!(times, expected, "{id}");
        let exact = precess_scalar::Scalar::cos(1.05);
        assert!((run.samples[11].1[0] - exact).abs() < 4e-3, "{id}");
    }
}

/// Samples do not change the steps of an adaptive method.
#[test]
fn samples_leave_the_steps_alone() {
    let coarse = run(&Kepler, "dop853", 1e-10, 20.0, 20.0, &[]);
    let fine = run(&Kepler, "dop853", 1e-10, 20.0, 0.01, &[]);
    assert_eq!(coarse.report.steps, fine.report.steps);
    assert_eq!(coarse.samples.last(), fine.samples.last());
}

#[test]
fn a_run_backwards_mirrors_a_run_forwards() {
    for candidate in METHODS.iter().filter(|m| !needs_separable(**m)) {
        let id = candidate.card().id;
        let step = if candidate.card().kind == precess_integrate::Kind::Fixed { 0.01 } else { 1e-9 };
        // Released at rest, the oscillator's past mirrors its future.
        let (there, back) =
            (run(&Oscillator, id, step, 2.0, 0.5, &[]), run(&Oscillator, id, step, -2.0, 0.5, &[]));
        for (a, b) in there.samples.iter().zip(&back.samples) {
            assert_eq!(a.0, -b.0, "{id}");
            assert!((a.1[0] - b.1[0]).abs() < 1e-14 && (a.1[1] + b.1[1]).abs() < 1e-14, "{id}");
        }
    }
}

#[test]
fn a_motion_that_diverges_keeps_what_it_has() {
    for (id, step) in [("dop853", 1e-9), ("rk4", 1e-3)] {
        let run = run(&BlowUp, id, step, 10.0, 0.1, &[]);
        let failure = run.report.failure.expect("it goes to infinity near t = 2");
        assert!((1.5..3.0).contains(&failure.time()), "{id}: {failure}");
        assert!(run.samples.len() > 15, "{id}");
        assert!(run.samples.iter().all(|(_, y)| y.iter().all(|x| x.is_finite())), "{id}");
    }
}

#[test]
fn an_interrupted_run_keeps_what_it_has() {
    let mut looks = 0;
    let run = run_with(&Oscillator, "rk4", 1e-3, 10.0, 0.1, &[], &mut |_| {
        looks += 1;
        if looks > 5 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    });
    let failure = run.report.failure.expect("interrupted");
    assert!(matches!(failure, Failure::Interrupted { .. }));
    assert!(run.samples.len() > 3 && run.samples.len() < 101);
}

#[test]
fn a_loop_that_does_not_converge_says_when() {
    let run = run(&Oscillator, "newmark", 3.0, 30.0, 3.0, &[]);
    assert!(
        matches!(run.report.failure, Some(Failure::NoConvergence { t: 0.0, h: 3.0, .. })),
        "{:?}",
        run.report.failure
    );
}

#[test]
fn a_start_that_is_not_finite_ends_at_once() {
    let field = field::<f64>(&Oscillator);
    for pace in [Pace::Fixed(0.1), pace("dop853", 1e-9)] {
        let job = Drive {
            field: field.as_ref(),
            method: method(if pace == Pace::Fixed(0.1) { "rk4" } else { "dop853" }),
            options: Options::default(),
            start: &[f64::NAN, 0.0],
            samples: Samples::new(1.0, 0.1),
            pace,
            directions: &[],
            watches: &[],
        };
        let report = drive(&job, &mut |_, _| {}, &mut |_| ControlFlow::Continue(()));
        assert_eq!(report.failure.map(|f| f.time()), Some(0.0));
    }
}

/// A tighter tolerance gives a smaller error, about in proportion.
#[test]
fn the_tolerance_is_kept() {
    for id in ["dopri5", "dop853"] {
        for tolerance in [1e-6, 1e-8, 1e-10, 1e-12] {
            let run = run(&Driven { friction: 0.2 }, id, tolerance, 5.0, 5.0, &[]);
            let exact = self::run(&Driven { friction: 0.2 }, "dop853", 1e-15, 5.0, 5.0, &[]);
            let error = (run.samples[1].1[0] - exact.samples[1].1[0]).abs();
            assert!(error < 30.0 * tolerance, "{id} at {tolerance:e}: {error:e}");
        }
    }
}
