//! Verlet steps of several lengths, one after another: the shared form of `verlet` and Yoshida's methods.
//!
//! With weights w that read the same from both ends and sum to one, the Verlet steps `w h` make a symmetric step of
//! length h; further conditions on the weights raise its order (H. Yoshida, Phys. Lett. A 150, 262, 1990). Each Verlet
//! step is half a kick, a drift, half a kick, and the acceleration at its end serves the next one.

use crate::coefficient::Coefficient;
use crate::{NoConvergence, Step, Stepper};
use precess_scalar::Scalar;
use precess_system::Shape;

/// What a step needs besides the state.
pub struct Composition<S> {
    /// Length of each Verlet step, and the time it ends, in steps.
    parts: Vec<(S, S)>,
    /// Coordinates of all rows; behind them stand as many velocities.
    coordinates: usize,
    /// Rates at the start and at the end of the step.
    start: Vec<S>,
    end: Vec<S>,
    /// `start` holds already what is needed: the end of the step before.
    warm: bool,
    evaluations: u64,
}

impl<S: Scalar> Composition<S> {
    /// From the weights of the outer half, the outermost first, and the one in the middle.
    pub fn new(shape: &Shape, outer: &[Coefficient], middle: Coefficient) -> Self {
        let weights = outer.iter().chain([&middle]).chain(outer.iter().rev()).map(|c| c.value::<S>());
        let mut end = S::from(0.0);
        let mut parts: Vec<(S, S)> = weights
            .map(|weight| {
                end = end + weight;
                (weight, end)
            })
            .collect();
        if let Some(last) = parts.last_mut() {
            last.1 = S::from(1.0);
        }
        let zeros = vec![S::from(0.0); shape.size()];
        Self {
            parts,
            coordinates: shape.rows * shape.coordinates,
            start: zeros.clone(),
            end: zeros,
            warm: false,
            evaluations: 0,
        }
    }
}

impl<S: Scalar> Stepper<S> for Composition<S> {
    #[inline(always)]
    fn step(&mut self, step: &mut Step<S>) -> Result<(), NoConvergence> {
        let Step { field, t, y, h, ref mut out } = *step;
        if !self.warm {
            field.rate(t, y, &mut self.start);
            self.evaluations += 1;
            self.warm = true;
        }
        let n = self.coordinates;
        out[2 * n..].copy_from_slice(&y[2 * n..]);
        for (part, &(weight, end)) in self.parts.iter().enumerate() {
            let length = h * weight;
            let half = length * 0.5;
            let (x, v) = out[..2 * n].split_at_mut(n);
            if part == 0 {
                let (x0, v0, a) = (&y[..n], &y[n..2 * n], &self.start[n..2 * n]);
                for k in 0..n {
                    v[k] = v0[k] + half * a[k];
                    x[k] = x0[k] + length * v[k];
                }
            } else {
                let a = &self.end[n..2 * n];
                for k in 0..n {
                    v[k] = v[k] + half * a[k];
                    x[k] = x[k] + length * v[k];
                }
            }
            // The accelerations see positions and time alone, so the half-kicked velocities do no harm.
            field.rate(t + h * end, out, &mut self.end);
            self.evaluations += 1;
            let (v, a) = (&mut out[n..2 * n], &self.end[n..2 * n]);
            for k in 0..n {
                v[k] = v[k] + half * a[k];
            }
        }
        Ok(())
    }
    #[inline(always)]
    fn accept(&mut self, accepted: S::Mask) {
        if S::all(accepted) {
            std::mem::swap(&mut self.start, &mut self.end);
            return;
        }
        for (start, end) in self.start.iter_mut().zip(&self.end) {
            *start = S::select(accepted, *end, *start);
        }
    }
    fn restart(&mut self) {
        self.warm = false;
    }
    fn evaluations(&self) -> u64 {
        self.evaluations
    }
}
