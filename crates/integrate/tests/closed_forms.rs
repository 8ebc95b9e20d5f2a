//! Runs against what is known in closed form, and the closed form as a method.

mod toys;

use precess_integrate::{Failure, Pace};
use precess_scalar::Scalar;
use precess_system::Direction;
use std::f64::consts::{FRAC_PI_2, PI};
use toys::run::{Run, tight, watch};
use toys::{harmonic, pendulum};

#[test]
fn the_oscillator_passes_zero_at_a_quarter_of_its_period() {
    let field = harmonic(1.0);
    let watches =
        [watch(|_, y| y[0], Direction::Falling, false), watch(|_, y| y[0], Direction::Either, true)];
    let (report, _) =
        Run { watches: &watches, ..Run::new(&field, "dop853", &[1.0, 0.0], (10.0, 1.0), tight(1e-14)) }.go();
    assert_eq!(report.stopped_by, Some(1));
    assert_eq!(report.events.len(), 2);
    for event in &report.events {
        assert!((event.t - FRAC_PI_2).abs() < 1e-12, "{:e}", event.t - FRAC_PI_2);
        assert!(event.state[0] <= 0.0 && event.state[0] > -1e-15);
    }
    assert_eq!(report.end, report.events[0].t);
}

/// Complete elliptic integral of the first kind by the arithmetic-geometric mean.
fn elliptic_k(k: f64) -> f64 {
    let (mut a, mut b) = (1.0, (1.0 - k * k).sqrt());
    for _ in 0..10 {
        (a, b) = (f64::midpoint(a, b), (a * b).sqrt());
    }
    PI / (2.0 * a)
}

#[test]
fn the_pendulum_of_figure_3_is_at_the_bottom_after_a_quarter_of_its_elliptic_period() {
    let field = pendulum(0.0);
    let start = [49.0 * PI / 50.0, 0.0];
    let quarter = elliptic_k(Scalar::sin(49.0 * PI / 100.0));
    let watches = [watch(|_, y| y[0], Direction::Falling, false)];
    let run = Run { watches: &watches, ..Run::new(&field, "dop853", &start, (6.0, quarter), tight(1e-14)) };
    let (report, rows) = run.go();
    println!("theta {:e}, event off by {:e}", rows[1].1[0], report.events[0].t - quarter);
    assert!(rows[1].1[0].abs() < 1e-12, "{:e}", rows[1].1[0]);
    assert!((report.events[0].t - quarter).abs() < 1e-12, "{:e}", report.events[0].t - quarter);
}

/// Every state is computed from the start: the steps neither cost digits nor matter.
#[test]
fn the_closed_form_adds_up_no_errors() {
    let field = harmonic(1.0);
    let end = |dt, until: f64| {
        let run = Run {
            field: &field,
            method: "exact",
            start: &[1.0, 0.0],
            until,
            every: until.abs(),
            pace: Pace::Fixed(dt),
            directions: &[],
            watches: &[],
        };
        let (report, rows) = run.go();
        assert_eq!(report.failure, None);
        rows.last().expect("rows").1.clone()
    };
    for until in [1000.0, -1000.0] {
        let (sin, cos) = until.sin_cos();
        assert_eq!(end(0.125, until), [cos, -sin]);
        assert_eq!(end(1000.0, until), [cos, -sin]);
    }
}

#[test]
fn the_closed_form_refuses_events() {
    let field = harmonic(1.0);
    let watches = [watch(|_, y| y[0], Direction::Either, false)];
    let (report, rows) =
        Run { watches: &watches, ..Run::new(&field, "exact", &[1.0, 0.0], (10.0, 1.0), Pace::Fixed(1.0)) }
            .go();
    assert!(matches!(report.failure, Some(Failure::Refused { what }) if what.contains("no event")));
    assert_eq!(rows.len(), 0);
}
