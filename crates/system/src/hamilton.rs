//! Momenta and forces, from the recorded Lagrangian.
//!
//! ```text
//! p_i = dL/dv_i        f_i = dL/dq_i        dp_i/dt = f_i
//! ```
//!
//! These are Hamilton's equations seen from the velocities: `f = -dH/dq` at fixed momenta, and `v = dH/dp`. (L. Landau, E. Lifshitz,
//! *Mechanics*, 40.)

use crate::{AnySystem, Layout, Rates, Values};
use precess_scalar::{Dual, Scalar, Tape, Traced};

/// The Lagrangian as a tape, where the system has one and its state is coordinates and their velocities.
fn lagrangian(system: &dyn AnySystem, values: &Values<f64>, layout: &Layout) -> Option<Tape> {
    let shape = layout.shape();
    if !shape.is_second_order() || shape.modes > 0 {
        return None;
    }
    let tape = Tape::try_record(1 + shape.full(), |x| {
        let values = values.map(|&x| Traced::from(x));
        Rates::lagrangian(system, values, layout, x[0], &x[1..]).map(|l| vec![l]).ok_or(())
    });
    tape.ok().map(|tape| tape.simplified())
}

/// The slope of the outputs of a tape along a direction.
fn slopes(tape: &Tape, at: &[Traced], direction: impl Fn(usize) -> Traced) -> Vec<Traced> {
    let inputs: Vec<_> = at.iter().enumerate().map(|(i, x)| Dual::new(*x, direction(i))).collect();
    tape.evaluate(&inputs).into_iter().map(|y| y.slope).collect()
}

/// One along an axis, zero along the others.
fn axis(j: usize) -> impl Fn(usize) -> Traced {
    move |i| Traced::from(if i == j { 1.0 } else { 0.0 })
}

/// The momenta, the forces, and the derivatives of the momenta by the velocities (row after row), as one tape: its inputs are
/// time, the coordinates and the velocities. None without a Lagrangian.
pub fn momenta(system: &dyn AnySystem, values: &Values<f64>, layout: &Layout) -> Option<Tape> {
    let lagrangian = lagrangian(system, values, layout)?;
    let n = layout.shape().coordinates;
    let momenta =
        Tape::record(1 + 2 * n, |x| (0..n).flat_map(|i| slopes(&lagrangian, x, axis(1 + n + i))).collect());
    let all = Tape::record(1 + 2 * n, |x| {
        let forces = (0..n).flat_map(|i| slopes(&lagrangian, x, axis(1 + i)));
        let columns: Vec<Vec<Traced>> = (0..n).map(|j| slopes(&momenta, x, axis(1 + n + j))).collect();
        let masses = (0..n).flat_map(|i| columns.iter().map(move |column| column[i]));
        momenta.evaluate(x).into_iter().chain(forces).chain(masses).collect()
    });
    Some(all.simplified())
}

/// By how much, at a state, the equations miss `dp/dt = f`, relative to the largest of these: friction, or a moment, of
/// which the Lagrangian does not know.
///
/// `rates` is the [`expression`](crate::expression()) of the system, `momenta` its [`momenta`].
pub fn beside_the_lagrangian(rates: &Tape, momenta: &Tape, y: &[f64]) -> f64 {
    let n = y.len() / 2;
    let at: Vec<f64> = std::iter::once(0.0).chain(y.iter().copied()).collect();
    let along: Vec<f64> = std::iter::once(1.0).chain(rates.evaluate(&at)).collect();
    let inputs: Vec<_> = at.iter().zip(&along).map(|(x, slope)| Dual::new(*x, *slope)).collect();
    let outputs = momenta.evaluate(&inputs);
    let pairs = || outputs[..n].iter().zip(&outputs[n..2 * n]).map(|(p, f)| (p.slope, f.value));
    let size = pairs().fold(1e-300, |size: f64, (p, f)| p.abs().larger(f.abs()).larger(size));
    pairs().fold(0.0, |worst: f64, (p, f)| ((p - f).abs() / size).larger(worst))
}
