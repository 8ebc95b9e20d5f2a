//! Floquet multipliers: what a small departure from a periodic orbit is multiplied by in one period.
//!
//! They are the eigenvalues of the derivative of the flow over the period. One outside the unit circle means that the
//! orbit is unstable; for an equilibrium under a periodic change of parameters that is parametric resonance, and the
//! parameters for which it happens make the tongues of Mathieu's equation (Floquet 1883; Arnold, *Mathematical
//! Methods of Classical Mechanics*, section 25).

use crate::eigenvalues::{Complex, eigenvalues};
use crate::flow::{Flow, Stopped};
use crate::matrix::Matrix;
use crate::response::periodic_orbit;
use precess_scalar::Scalar;

/// The multipliers of an orbit.
#[derive(Clone, Debug, PartialEq)]
pub struct Multipliers {
    /// They, the largest modulus first.
    pub values: Vec<Complex>,
    /// The derivative of the flow over the period.
    pub map: Matrix,
    /// A full state on the orbit at time zero.
    pub state: Vec<f64>,
    /// How far the orbit is from closing after a period.
    pub gap: f64,
}

impl Multipliers {
    /// The largest modulus.
    pub fn largest(&self) -> f64 {
        self.values.first().map_or(f64::NAN, |v| v.modulus())
    }
}

/// The multipliers of the orbit through a full state. Of a driven system (`find`) the periodic orbit near the state is
/// found first; of one without a drive the state must lie on it.
///
/// # Errors
/// Where the integration cannot go on.
pub fn multipliers(flow: &Flow, start: &[f64], period: f64, find: bool) -> Result<Multipliers, Stopped> {
    let mut state = start.to_vec();
    let map = if find { periodic_orbit(flow, &mut state, period)? } else { Matrix::zeros(0) };
    let mut end = state.clone();
    let map = if find {
        flow.advance(0.0, &mut end, period)?;
        map
    } else {
        flow.derivative(0.0, &mut end, period)?
    };
    let gap = (0..flow.size()).fold(0.0, |most: f64, i| (end[i] - state[i]).abs().larger(most));
    let mut values = eigenvalues(&map).unwrap_or_default();
    values.sort_by(|a, b| b.modulus().total_cmp(&a.modulus()));
    Ok(Multipliers { values, map, state, gap })
}
