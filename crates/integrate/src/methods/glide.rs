//! The step that Euler's method and its two improvements share.
//!
//!     v1 = v0 + h a      x1 = x0 + h (v0 + alpha h a)
//!
//! with alpha = 0 (`euler`), 1/2 (`euler_taylor`) or 1 (`euler_cromer`: `x1 = x0 + h v1`).

use crate::{NoConvergence, Step, Stepper};
use precess_scalar::Scalar;
use precess_system::Shape;

/// See the module.
pub struct Glide<S> {
    alpha: S,
    rate: Vec<S>,
    /// The accelerations of the positions, where they differ.
    drift: Vec<S>,
    /// Where the velocities begin, and where the coordinate of each stands.
    velocities: usize,
    coordinates: Vec<usize>,
    /// What is neither a velocity nor has one.
    singles: Vec<usize>,
    evaluations: u64,
}

impl<S: Scalar> Glide<S> {
    /// A stepper with this alpha.
    pub fn new(shape: &Shape, alpha: f64) -> Self {
        Self {
            alpha: S::from(alpha),
            rate: vec![S::from(0.0); shape.size()],
            drift: vec![S::from(0.0); shape.size()],
            velocities: shape.rows * shape.coordinates,
            coordinates: shape.pairs().map(|(x, _)| x).collect(),
            singles: shape.singles().collect(),
            evaluations: 0,
        }
    }
}

impl<S: Scalar> Stepper<S> for Glide<S> {
    #[inline(always)]
    fn step(&mut self, step: &mut Step<S>) -> Result<(), NoConvergence> {
        let Step { field, t, y, h, ref mut out } = *step;
        field.rate(t, y, &mut self.rate);
        self.evaluations += 1;
        let (q, v) = y.split_at(self.velocities);
        let (q_out, v_out) = out.split_at_mut(self.velocities);
        let accelerations = &self.rate[self.velocities..];
        let as_printed = field.drift(t, y, &mut self.drift);
        let drift = if as_printed { &self.drift[self.velocities..] } else { accelerations };
        for (k, &i) in self.coordinates.iter().enumerate() {
            q_out[i] = q[i] + h * (v[k] + self.alpha * (h * drift[k]));
            v_out[k] = v[k] + h * accelerations[k];
        }
        for &i in &self.singles {
            out[i] = y[i] + h * self.rate[i];
        }
        Ok(())
    }
    fn evaluations(&self) -> u64 {
        self.evaluations
    }
}
