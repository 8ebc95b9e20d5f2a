//! Whole runs against a second form of the equations: those of the Lagrangian, worked out from its record.
//!
//!     W a = f - (d/dt of the momenta at constant velocities)        W = d2L/dv dv,  f = dL/dq

use precess::integrate::{Block, Options, Pace, Samples, Tolerance};
use precess::scalar::{Dual, Scalar, Tape};
use precess::system::{Bind, Field, ObservableKind, Shape, beside_the_lagrangian, expression, momenta};
use precess::value::Value;
use precess::{Plan, Scenario, catalogue};

/// The Euler-Lagrange equations of a recorded Lagrangian.
struct EulerLagrange {
    shape: Shape,
    /// Momenta, forces, and the derivatives of the momenta by the velocities.
    momenta: Tape,
}

impl Field<f64> for EulerLagrange {
    fn shape(&self) -> &Shape {
        &self.shape
    }
    fn rate(&self, t: f64, y: &[f64], dy: &mut [f64]) {
        let n = self.shape.coordinates;
        let (rates, accelerations) = dy.split_at_mut(n);
        rates.copy_from_slice(&y[n..]);
        let drift = y[n..].iter().copied().chain(std::iter::repeat(0.0));
        let inputs: Vec<_> = std::iter::once(Dual::new(t, 1.0))
            .chain(y.iter().zip(drift).map(|(x, v)| Dual::new(*x, v)))
            .collect();
        let outputs = self.momenta.evaluate(&inputs);
        for (i, a) in accelerations.iter_mut().enumerate() {
            *a = outputs[n + i].value - outputs[i].slope;
        }
        let mut masses: Vec<Vec<f64>> =
            outputs[2 * n..].chunks(n).map(|row| row.iter().map(|w| w.value).collect()).collect();
        solve(&mut masses, accelerations);
    }
}

/// Gauss's elimination. The matrix of the masses is symmetric and positive: no pivot is needed.
fn solve(a: &mut [Vec<f64>], b: &mut [f64]) {
    let n = b.len();
    for k in 0..n {
        let (upper, lower) = a.split_at_mut(k + 1);
        for (i, row) in lower.iter_mut().enumerate() {
            let factor = row[k] / upper[k][k];
            for j in k..n {
                row[j] -= factor * upper[k][j];
            }
            b[k + 1 + i] -= factor * b[k];
        }
    }
    for k in (0..n).rev() {
        let known: f64 = (k + 1..n).map(|j| a[k][j] * b[j]).sum();
        b[k] = (b[k] - known) / a[k][k];
    }
}

/// The default scenario of a system, with the parameters at zero that take its energy beside the Lagrangian.
fn default_plan(id: &str) -> Option<(Plan, Tape)> {
    let mut scenario = Scenario::of(id);
    let plan = Plan::new(&scenario).expect("a plan");
    if plan.layout.shape().coordinates > 20 {
        return None;
    }
    let read = |plan: &Plan| {
        let tape = momenta(plan.system, &plan.values, &plan.layout)?;
        let rates = expression(plan.system, &plan.values, &plan.layout);
        let beside = beside_the_lagrangian(&rates, &tape, &plan.start);
        Some((tape, beside))
    };
    let (tape, beside) = read(&plan)?;
    if beside < 1e-9 {
        return Some((plan, tape));
    }
    let energy = plan.layout.observables.iter().find(|o| o.quantity.name == "energy")?;
    let ObservableKind::Invariant { when_zero } = &energy.kind else { return None };
    for name in when_zero {
        Scenario::set(&mut scenario.parameters, name, Value::number(0.0));
    }
    let plan = Plan::new(&scenario).expect("a plan without losses");
    let (tape, beside) = read(&plan)?;
    (beside < 1e-9).then_some((plan, tape))
}

/// The states at the samples.
fn run(field: &dyn Field<f64>, plan: &Plan, tolerance: f64) -> Vec<Vec<f64>> {
    let pace = Pace::Adaptive(Tolerance { rtol: tolerance, atol: tolerance, skip: vec![] });
    let samples = Samples::new(plan.until, plan.every);
    let block = Block {
        field,
        method: catalogue::method("dop853").expect("a method"),
        options: Options::default(),
        samples,
        pace: &pace,
    };
    let mut states = vec![];
    block.run(&plan.start, &mut |_, _, y| states.push(y.to_vec()));
    states
}

/// The largest difference, relative to the larger of one and the state.
fn apart(a: &[f64], b: &[f64]) -> f64 {
    let size = a.iter().fold(1.0, |size: f64, x| x.abs().larger(size));
    a.iter().zip(b).fold(0.0, |worst: f64, (x, y)| ((x - y).abs() / size).larger(worst))
}

#[test]
fn a_default_run_is_that_of_its_lagrangian() {
    let (mut whole, mut begun) = (vec![], vec![]);
    for system in catalogue::systems() {
        let id = system.card().id;
        let Some((plan, tape)) = default_plan(id) else { continue };
        let field = Bind::<f64>::bind(plan.system, plan.values.clone(), &plan.layout);
        let second = EulerLagrange { shape: plan.layout.shape(), momenta: tape };
        let own = run(&*field, &plan, 1e-14);
        let other = run(&second, &plan, 1e-14);
        // Where a run no longer agrees with itself at another tolerance, rounding is compared, not equations.
        let loose = run(&*field, &plan, 3e-14);
        let agrees = own.iter().zip(&loose).take_while(|(a, b)| apart(a, b) < 2e-12).count();
        for (k, (own, other)) in own.iter().zip(&other).take(agrees).enumerate() {
            let apart = apart(own, other);
            assert!(apart < 1e-11, "{id}: {apart:e} apart at sample {k}");
        }
        // A twentieth of a chaotic one's default scenario is several turns.
        assert!(agrees > own.len() / 20, "{id} agrees with itself for {agrees} samples of {}", own.len());
        if agrees == own.len() { whole.push(id) } else { begun.push(id) }
    }
    assert!(whole.len() >= 17 && begun.len() >= 10, "{whole:?} {begun:?}");
}
