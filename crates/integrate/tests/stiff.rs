//! Stiff equations: what is fast has died out, and only an implicit method may ignore it.

mod toys;

use precess_integrate::{Drive, METHODS, Options, Pace, Samples, Tolerance, drive};
use precess_scalar::Scalar;
use toys::{Toy, bind};

/// `y' = -k (y - cos t)`, whose solution soon stays within 1/k of the cosine (Curtiss and Hirschfelder).
struct Pull {
    k: f64,
}

impl Toy for Pull {
    fn rate<S: Scalar>(&self, t: S, y: &[S], dy: &mut [S]) {
        dy[0] = (t.cos() - y[0]) * self.k;
    }
}

/// The state at the end, the steps, the evaluations.
fn run(id: &str, k: f64, until: f64) -> (f64, u64, u64) {
    let field = bind(Pull { k }, 0, 1, 0);
    let method = *METHODS.iter().find(|m| m.card().id == id).expect("a method");
    let mut last = f64::NAN;
    let pace = Pace::Adaptive(Tolerance { rtol: 1e-8, atol: 1e-8, skip: vec![] });
    let run = Drive {
        field: &field,
        method,
        options: Options::default(),
        pace,
        start: &[0.0],
        samples: Samples::new(until, until),
        directions: &[],
        watches: &[],
    };
    let report = drive(&run, &mut |_, y| last = y[0], &mut |_| std::ops::ControlFlow::Continue(()));
    assert!(report.failure.is_none(), "{id}: {:?}", report.failure);
    (last, report.steps, report.evaluations)
}

/// After the start, `y = (k^2 cos t + k sin t) / (k^2 + 1)`.
#[test]
fn steps_do_not_follow_what_has_died_out() {
    let until = 10.0;
    for k in [1e3, 1e5, 1e7] {
        let (end, steps, _) = run("radau5", k, until);
        let (sin, cos) = Scalar::sin_cos(until);
        let exact = (k * k * cos + k * sin) / (k * k + 1.0);
        println!("k {k:e}: {steps} steps, error {:.1e}", end - exact);
        assert!((end - exact).abs() < 1e-7, "{k}: {end} instead of {exact}");
        assert!(steps < 300, "{k}: {steps} steps");
    }
    let (_, _, explicit) = run("dopri5", 1e5, until);
    let (_, _, implicit) = run("radau5", 1e5, until);
    assert!(explicit > 100 * implicit, "{explicit} evaluations of dopri5, {implicit} of radau5");
}
