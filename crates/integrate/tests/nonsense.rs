//! Runs that run away, are interrupted, or were never meant seriously.

mod toys;

use precess_integrate::{Drive, Failure, Needs, Options, Pace, Samples, drive};
use std::ops::ControlFlow;
use toys::run::{Run, paces, tight};
use toys::{Known, blow_up, harmonic, method};

#[test]
fn what_runs_away_keeps_what_was_recorded_and_says_when() {
    let field = blow_up();
    for (id, pace) in paces(0.001) {
        if method(id).card().needs == Needs::Separable {
            continue;
        }
        let (report, rows) = Run::new(&field, id, &[1.0, 1.0], (10.0, 0.1), pace).go();
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
