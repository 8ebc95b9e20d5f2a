//! Whole runs: samples, events, jumps, failures.

mod toys;

use precess_integrate::{
    Drive, Failure, Needs, Options, Pace, Report, Samples, Source, Tolerance, Watched, drive,
};
use precess_scalar::Scalar;
use precess_system::Direction;
use std::f64::consts::{FRAC_PI_2, PI};
use std::ops::ControlFlow;
use toys::{Known, ball, blow_up, harmonic, method, methods, mixed, pendulum};

type Rows = Vec<(f64, Vec<f64>)>;

struct Run<'a> {
    field: &'a dyn Known,
    method: &'a str,
    start: &'a [f64],
    until: f64,
    every: f64,
    pace: Pace,
    directions: &'a [Direction],
    watches: &'a [Watched<'a>],
}

impl Run<'_> {
    fn go(&self) -> (Report, Rows) {
        let mut rows = vec![];
        let report = drive(
            &Drive {
                field: self.field,
                method: method(self.method),
                options: self.field.options(),
                start: self.start,
                samples: Samples::new(self.until, self.every),
                pace: self.pace.clone(),
                directions: self.directions,
                watches: self.watches,
            },
            &mut |t, y| rows.push((t, y.to_vec())),
            &mut |_| ControlFlow::Continue(()),
        );
        (report, rows)
    }
}

fn tight(rtol: f64) -> Pace {
    Pace::Adaptive(Tolerance { rtol, atol: rtol, skip: vec![] })
}

fn watch<'a>(f: impl Fn(f64, &[f64]) -> f64 + 'a, direction: Direction, stop: bool) -> Watched<'a> {
    Watched { function: Box::new(f), direction, stop }
}

/// Every method with its pace.
fn paces(dt: f64) -> impl Iterator<Item = (&'static str, Pace)> {
    methods().flat_map(move |card| {
        let adaptive = card.kind == precess_integrate::Kind::Adaptive;
        [(card.id, Pace::Fixed(dt))].into_iter().chain(adaptive.then(|| (card.id, tight(1e-10))))
    })
}

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
                    assert!((y[0] - t.cos_()).abs() < 1e-8, "{id} at {t}: {}", y[0]);
                }
            }
            assert_eq!(report.failure, None);
            assert_eq!(report.end, until);
        }
    }
}

trait Ours {
    fn cos_(&self) -> f64;
}
impl Ours for f64 {
    fn cos_(&self) -> f64 {
        Scalar::cos(*self)
    }
}

#[test]
fn steps_of_fixed_length_are_exactly_that() {
    // The plain loop, 1000 steps of 0.001, gives the bits of the run that samples every ten steps.
    let field = harmonic(1.0);
    let (report, rows) = Run {
        field: &field,
        method: "euler_cromer",
        start: &[1.0, 0.2],
        until: 1.0,
        every: 0.01,
        pace: Pace::Fixed(0.001),
        directions: &[],
        watches: &[],
    }
    .go();
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
        let there = Run {
            field: &free,
            method: "dop853",
            start: &start[..2],
            until: 3.0,
            every: 1.0,
            pace: pace.clone(),
            directions: &[],
            watches: &[],
        }
        .go()
        .1;
        let end = &there[3].1;
        let back = Run {
            field: &free,
            method: "dop853",
            start: end,
            until: -3.0,
            every: 1.0,
            pace,
            directions: &[],
            watches: &[],
        }
        .go()
        .1;
        for (a, b) in back[3].1.iter().zip(&start) {
            assert!((a - b).abs() < 1e-11, "{a} against {b}");
        }
    }
    // And the state before the start, with time entering.
    let rows = Run {
        field: &field,
        method: "dop853",
        start: &start,
        until: -1.0,
        every: 0.5,
        pace: tight(1e-11),
        directions: &[],
        watches: &[],
    }
    .go()
    .1;
    assert_eq!(rows.iter().map(|r| r.0).collect::<Vec<_>>(), [0.0, -0.5, -1.0]);
}

#[test]
fn the_oscillator_passes_zero_at_a_quarter_of_its_period() {
    let field = harmonic(1.0);
    let watches =
        [watch(|_, y| y[0], Direction::Falling, false), watch(|_, y| y[0], Direction::Either, true)];
    let (report, _) = Run {
        field: &field,
        method: "dop853",
        start: &[1.0, 0.0],
        until: 10.0,
        every: 1.0,
        pace: tight(1e-14),
        directions: &[],
        watches: &watches,
    }
    .go();
    assert_eq!(report.stopped_by, Some(1));
    assert_eq!(report.events.len(), 2);
    for event in &report.events {
        assert!((event.t - FRAC_PI_2).abs() < 1e-12, "{:e}", event.t - FRAC_PI_2);
        assert!(event.state[0] <= 0.0 && event.state[0] > -1e-15);
    }
    assert_eq!(report.end, report.events[0].t);
}

#[test]
fn every_method_finds_the_crossings_in_order() {
    let field = harmonic(1.0);
    for (id, pace) in paces(0.01) {
        let watches = [
            watch(|_, y| y[1], Direction::Either, false),
            watch(|_, y| y[0], Direction::Rising, false),
            watch(|_, y| y[0], Direction::Falling, false),
        ];
        let (report, rows) = Run {
            field: &field,
            method: id,
            start: &[1.0, 0.0],
            until: 10.0,
            every: 0.5,
            pace,
            directions: &[],
            watches: &watches,
        }
        .go();
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
    let run = Run {
        field: &field,
        method: "dop853",
        start: &start,
        until: 6.0,
        every: quarter,
        pace: tight(1e-14),
        directions: &[],
        watches: &watches,
    };
    let (report, rows) = run.go();
    println!("theta {:e}, event off by {:e}", rows[1].1[0], report.events[0].t - quarter);
    assert!(rows[1].1[0].abs() < 1e-12, "{:e}", rows[1].1[0]);
    assert!((report.events[0].t - quarter).abs() < 1e-12, "{:e}", report.events[0].t - quarter);
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
        let run = Run {
            field: &field,
            method: id,
            start: &[1.0, 0.0],
            until: 12.5,
            every: 0.1,
            pace,
            directions: &[Direction::Falling],
            watches: &[],
        };
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
        let run = Run {
            field: &field,
            method: id,
            start: &[1.0, 0.0],
            until: 10.0,
            every: 0.1,
            pace,
            directions: &[Direction::Falling],
            watches: &[],
        };
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
            let (report, rows) = Run {
                field: &field,
                method: id,
                start: &[1.0, 0.0],
                until: 3.0,
                every: 0.5,
                pace: pace.clone(),
                directions: &[],
                watches: &watches,
            }
            .go();
            let times: Vec<f64> = rows.iter().map(|r| r.0).collect();
            assert_eq!(times, [0.0, 0.5, 1.0, 1.5, 2.0, 2.5, 3.0], "{id} {pace:?} at {at}");
            assert_eq!(report.events.len(), 1, "{id} {pace:?} at {at}");
            assert_eq!(report.events[0].t, at, "{id} {pace:?}");
        }
    }
}

#[test]
fn what_runs_away_keeps_what_was_recorded_and_says_when() {
    let field = blow_up();
    for (id, pace) in paces(0.001) {
        if method(id).card().needs == Needs::Separable {
            continue;
        }
        let (report, rows) = Run {
            field: &field,
            method: id,
            start: &[1.0, 1.0],
            until: 10.0,
            every: 0.1,
            pace,
            directions: &[],
            watches: &[],
        }
        .go();
        let failure = report.failure.expect("it runs away");
        assert!(rows.len() > 15 && rows.iter().all(|r| r.1[0].is_finite()), "{id}: {} rows", rows.len());
        assert!((1.5..3.5).contains(&failure.time()), "{id}: {failure}");
        println!("{id}: {failure}");
    }
}

#[test]
fn whoever_watches_may_interrupt() {
    let field = harmonic(1.0);
    for (id, pace) in paces(0.001) {
        let mut rows = vec![];
        let report = drive(
            &Drive {
                field: &field,
                method: method(id),
                options: field.options(),
                start: &[1.0, 0.0],
                samples: Samples::new(1e6, 0.01),
                pace,
                directions: &[],
                watches: &[],
            },
            &mut |t, y: &[f64]| rows.push((t, y.to_vec())),
            &mut |t| if t > 5.0 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) },
        );
        assert!(matches!(report.failure, Some(Failure::Interrupted { t }) if t > 5.0), "{id}");
        assert!(rows.len() > 500, "{id}");
    }
}

#[test]
fn nonsense_neither_hangs_nor_panics() {
    let field = harmonic(1.0);
    let odd = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 0.0, -1.0, 1e-320];
    for x in odd {
        for (until, every, pace, start) in [
            (1.0, 0.1, Pace::Fixed(x), 1.0),
            (1.0, 0.1, tight(x), 1.0),
            (x, 0.1, tight(1e-6), 1.0),
            (1.0, 0.1, tight(1e-6), x),
            (1.0, 0.1, Pace::Fixed(0.1), x),
        ] {
            let mut looks = 0;
            drive(
                &Drive {
                    field: &field,
                    method: method("dopri5"),
                    options: Options::default(),
                    start: &[start, 0.0],
                    samples: Samples::new(until, every),
                    pace,
                    directions: &[],
                    watches: &[],
                },
                &mut |_, _| {},
                &mut |_| {
                    looks += 1;
                    if looks > 1000 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
                },
            );
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
            field: &field,
            method: id,
            start: &[0.0, 0.0],
            until: 9.9,
            every: 1.0,
            pace,
            directions: &directions,
            watches: &watches,
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
fn a_watch_that_stops_ends_the_run_with_a_sample_there() {
    let field = harmonic(1.0);
    let watches =
        [watch(|_, y| y[0], Direction::Rising, true), watch(|_, y| y[0], Direction::Falling, false)];
    let (report, rows) = Run {
        field: &field,
        method: "dop853",
        start: &[1.0, 0.0],
        until: 20.0,
        every: 1.0,
        pace: tight(1e-12),
        directions: &[],
        watches: &watches,
    }
    .go();
    assert_eq!(report.stopped_by, Some(0));
    assert_eq!(report.events.len(), 2);
    assert_eq!(rows.len(), 6, "0 to 4, and the stop");
    let (t, _) = rows.last().expect("rows");
    assert_eq!(*t, report.end);
    assert!((t - 1.5 * PI).abs() < 1e-10);
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
    let (report, rows) = Run {
        field: &field,
        method: "exact",
        start: &[1.0, 0.0],
        until: 10.0,
        every: 1.0,
        pace: Pace::Fixed(1.0),
        directions: &[],
        watches: &watches,
    }
    .go();
    assert!(matches!(report.failure, Some(Failure::Refused { what }) if what.contains("no event")));
    assert_eq!(rows.len(), 0);
}
