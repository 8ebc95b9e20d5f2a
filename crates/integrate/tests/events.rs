//! Events: crossings in their order, jumps, and a watch that ends the run.

mod toys;

use precess_integrate::{Failure, Needs, Pace, Source};
use precess_scalar::Scalar;
use precess_system::Direction;
use std::f64::consts::{FRAC_PI_2, PI};
use toys::run::{Run, paces, tight, watch};
use toys::{ball, harmonic, method};

#[test]
fn every_method_finds_the_crossings_in_order() {
    let field = harmonic(1.0);
    for (id, pace) in paces(0.01) {
        let watches = [
            watch(|_, y| y[1], Direction::Either, false),
            watch(|_, y| y[0], Direction::Rising, false),
            watch(|_, y| y[0], Direction::Falling, false),
        ];
        let (report, rows) =
            Run { watches: &watches, ..Run::new(&field, id, &[1.0, 0.0], (10.0, 0.5), pace) }.go();
        assert_eq!(rows.len(), 21, "{id}");
        let sources: Vec<_> = report.events.iter().map(|e| e.source).collect();
        let (turn, up, down) = (Source::Watch(0), Source::Watch(1), Source::Watch(2));
        assert_eq!(sources, [down, turn, up, turn, down, turn], "{id}");
        let loose = if method(id).card().order < 4 { 0.1 } else { 1e-6 };
        for (k, event) in report.events.iter().enumerate() {
            assert!((event.t - FRAC_PI_2 * (k + 1) as f64).abs() < loose, "{id}: {}", event.t);
        }
    }
}

#[test]
fn a_ball_bounces_at_its_geometric_times() {
    let e = 0.8;
    let field = ball(e);
    for (id, pace) in [
        ("dop853", tight(1e-10)),
        ("dopri5", tight(1e-8)),
        ("rk4", Pace::Fixed(0.01)),
        ("rk4", Pace::Fixed(0.5)),
    ] {
        // From height 1 with unit gravity: the floor at sqrt 2, then flights of 2 sqrt 2 e^n.
        let run =
            Run { directions: &[Direction::Falling], ..Run::new(&field, id, &[1.0, 0.0], (12.5, 0.1), pace) };
        let (report, rows) = run.go();
        let root = 2.0_f64.sqrt();
        let mut t = root;
        assert!(report.events.len() >= 16, "{id}: {} bounces", report.events.len());
        for (n, event) in report.events.iter().take(16).enumerate() {
            assert!((event.t - t).abs() < 1e-10, "{id}, bounce {n}: {} against {t}", event.t);
            t += 2.0 * root * Scalar::powf(e, n as f64 + 1.0);
        }
        assert!(rows.iter().all(|r| r.1[0] > -1e-9), "{id}: through the floor");
    }
}

#[test]
fn a_ball_that_comes_to_rest_ends_with_a_sentence_and_does_not_fall_through() {
    let field = ball(0.5);
    // All bounces are over at 3 sqrt 2.
    for (id, pace) in [("dop853", tight(1e-10)), ("rk4", Pace::Fixed(0.01))] {
        let run =
            Run { directions: &[Direction::Falling], ..Run::new(&field, id, &[1.0, 0.0], (10.0, 0.1), pace) };
        let (report, rows) = run.go();
        assert!(rows.iter().all(|r| r.1[0] > -1e-9), "{id}: through the floor");
        let Some(Failure::TooManyEvents { t }) = report.failure else { panic!("{id}: {:?}", report.failure) };
        assert!((t - 3.0 * 2.0_f64.sqrt()).abs() < 1e-6, "{id}: {t}");
    }
}

#[test]
fn an_event_exactly_on_a_sample_or_on_the_end_of_a_step_is_neither_lost_nor_doubled() {
    let field = harmonic(1.0);
    for (id, pace) in paces(0.1).chain(paces(0.07)) {
        for at in [0.3, 0.5, 0.7, 1.0, 1.4, 2.1] {
            let watches = [watch(move |t, _| t - at, Direction::Rising, false)];
            let (report, rows) =
                Run { watches: &watches, ..Run::new(&field, id, &[1.0, 0.0], (3.0, 0.5), pace.clone()) }.go();
            let times: Vec<f64> = rows.iter().map(|r| r.0).collect();
            assert_eq!(times, [0.0, 0.5, 1.0, 1.5, 2.0, 2.5, 3.0], "{id} {pace:?} at {at}");
            assert_eq!(report.events.len(), 1, "{id} {pace:?} at {at}");
            assert_eq!(report.events[0].t, at, "{id} {pace:?}");
        }
    }
}

/// Two equal buckets that fill at the same rate, and empty at 1.
struct Buckets;

impl toys::Toy for Buckets {
    fn rate<S: Scalar>(&self, _t: S, _y: &[S], dy: &mut [S]) {
        dy.fill(S::from(0.7));
    }
    fn crossings<S: Scalar>(&self, _t: S, y: &[S], out: &mut [S]) {
        out.copy_from_slice(&[y[0] - 1.0, y[1] - 1.0]);
    }
    fn jump<S: Scalar>(&self, event: usize, _t: S, y: &mut [S]) {
        y[event] = S::from(0.0);
    }
}

#[test]
fn events_at_the_same_time_all_happen() {
    let field = toys::bind(Buckets, 0, 2, 2);
    for (id, pace) in paces(0.03).filter(|(id, _)| method(id).card().needs != Needs::Separable) {
        let directions = [Direction::Rising; 2];
        let watches = [watch(|_, y| y[1] - 1.0, Direction::Rising, false)];
        let run = Run {
            directions: &directions,
            watches: &watches,
            ..Run::new(&field, id, &[0.0, 0.0], (9.9, 1.0), pace)
        };
        let (report, _) = run.go();
        let count = |source| report.events.iter().filter(|e| e.source == source).count();
        assert_eq!(
            [count(Source::System(0)), count(Source::System(1)), count(Source::Watch(0))],
            [6, 6, 6],
            "{id}"
        );
    }
}

#[test]
fn a_watch_that_stops_ends_the_run_with_a_sample_there() {
    let field = harmonic(1.0);
    let watches =
        [watch(|_, y| y[0], Direction::Rising, true), watch(|_, y| y[0], Direction::Falling, false)];
    let (report, rows) =
        Run { watches: &watches, ..Run::new(&field, "dop853", &[1.0, 0.0], (20.0, 1.0), tight(1e-12)) }.go();
    assert_eq!(report.stopped_by, Some(0));
    assert_eq!(report.events.len(), 2);
    assert_eq!(rows.len(), 6, "0 to 4, and the stop");
    let (t, _) = rows.last().expect("rows");
    assert_eq!(*t, report.end);
    assert!((t - 1.5 * PI).abs() < 1e-10);
}
