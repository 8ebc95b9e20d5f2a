//! The method `taylor`: as accurate as it is asked, also inside its long steps.

mod toys;

use precess_integrate::{Drive, Options, Pace, Samples, Tolerance, drive};
use precess_scalar::{DoubleDouble, Scalar};
use toys::{Known, kepler, method};

/// The ellipse of Kepler at a mean anomaly, from his equation.
fn ellipse(e: f64, mean: f64) -> [f64; 2] {
    let mut anomaly = DoubleDouble::from(mean);
    for _ in 0..30 {
        let (sin, cos) = anomaly.sin_cos();
        anomaly = anomaly - (anomaly - sin * e - mean) / (DoubleDouble::from(1.0) - cos * e);
    }
    let (sin, cos) = anomaly.sin_cos();
    let minor = (DoubleDouble::from(1.0) - DoubleDouble::from(e) * e).sqrt();
    [(cos - e).to_f64(), (minor * sin).to_f64()]
}

/// The largest error over a revolution, and the steps.
fn revolution(rtol: f64) -> (f64, u64) {
    let (field, e) = (kepler(), 0.5);
    let fastest = ((1.0 + e) / (1.0 - e)).sqrt();
    let mut worst = 0.0;
    let run = Drive {
        field: &field,
        method: method("taylor"),
        options: field.options(),
        start: &[1.0 - e, 0.0, 0.0, fastest],
        samples: Samples::new(6.25, 0.03125),
        pace: Pace::Adaptive(Tolerance { rtol, atol: rtol, skip: vec![] }),
        directions: &[],
        watches: &[],
    };
    let mut record = |t: f64, y: &[f64]| {
        let exact = ellipse(e, t);
        worst = (y[0] - exact[0]).abs().larger((y[1] - exact[1]).abs()).larger(worst);
    };
    let report = drive(&run, &mut record, &mut |_| std::ops::ControlFlow::Continue(()));
    assert_eq!(report.failure, None);
    (worst, report.steps)
}

#[test]
fn the_tolerance_is_kept_between_the_steps_too() {
    for rtol in [1e-8, 1e-11, 1e-14] {
        let (error, steps) = revolution(rtol);
        println!("{rtol:e}: {error:.1e} in {steps} steps");
        assert!(error < 3.0 * rtol + 2e-14, "{rtol:e}: {error:e}");
        assert!(steps < 60, "{rtol:e}: {steps} steps");
    }
}

#[test]
fn without_equations_it_says_so() {
    let field = kepler();
    let run = Drive {
        field: &field,
        method: method("taylor"),
        options: Options::default(),
        start: &[1.0, 0.0, 0.0, 1.0],
        samples: Samples::new(1.0, 1.0),
        pace: Pace::Adaptive(Tolerance { rtol: 1e-9, atol: 1e-9, skip: vec![] }),
        directions: &[],
        watches: &[],
    };
    let report = drive(&run, &mut |_, _| {}, &mut |_| std::ops::ControlFlow::Continue(()));
    let failure = report.failure.expect("it is refused").to_string();
    assert!(failure.contains("equations"), "{failure}");
}
