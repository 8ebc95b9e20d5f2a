//! Velocity Verlet: half a kick, a drift, half a kick.
//!
//!     v = v0 + h/2 a(x0)     x1 = x0 + h v     v1 = v + h/2 a(x1)
//!
//! (Verlet 1967; Swope et al. 1982.) Of order 2, symplectic and reversible; one evaluation a step.

use crate::{Kind, Method, MethodCard, Needs, NoConvergence, Options, Step, Stepper};
use precess_scalar::Scalar;
use precess_system::Shape;

/// See the module.
pub struct Verlet;

static CARD: MethodCard = MethodCard {
    id: "verlet",
    title: ("Velocity Verlet", "Verlet (vitesses)"),
    about: (
        "Symplectic, reversible and as cheap as Euler: the method for planets and pendulums without friction.",
        "Symplectique, réversible et aussi peu coûteuse qu'Euler : la méthode des planètes et des pendules sans \
         frottement.",
    ),
    order: 2,
    kind: Kind::Fixed,
    needs: Needs::Separable,
    symplectic: true,
    reversible: true,
    source: "L. Verlet, Phys. Rev. 159, 98 (1967)",
    options: &[],
};

impl Method for Verlet {
    fn card(&self) -> &'static MethodCard {
        &CARD
    }
    type Steps<S: Scalar + Send> = Steps<S>;

    fn stepper<S: Scalar + Send>(&self, shape: &Shape, _: &Options) -> Steps<S> {
        let zeros = vec![S::from(0.0); shape.size()];
        Steps {
            pairs: shape.pairs().collect(),
            start: zeros.clone(),
            end: zeros,
            warm: false,
            evaluations: 0,
        }
    }
}

/// What a step needs besides the state.
pub struct Steps<S> {
    pairs: Vec<(usize, usize)>,
    /// Rates at the start and at the end of the step.
    start: Vec<S>,
    end: Vec<S>,
    /// `start` holds already what is needed: the end of the step before.
    warm: bool,
    evaluations: u64,
}

impl<S: Scalar + Send> Stepper<S> for Steps<S> {
    #[inline(always)]
    fn step(&mut self, step: &mut Step<S>) -> Result<(), NoConvergence> {
        let Step { field, t, y, h, ref mut out } = *step;
        if !self.warm {
            field.rate(t, y, &mut self.start);
            self.evaluations += 1;
            self.warm = true;
        }
        let half = h * 0.5;
        for &(x, v) in &self.pairs {
            out[v] = y[v] + half * self.start[v];
            out[x] = y[x] + h * out[v];
        }
        // The accelerations see positions and time alone, so the half-kicked velocities do no harm.
        field.rate(t + h, out, &mut self.end);
        self.evaluations += 1;
        for &(_, v) in &self.pairs {
            out[v] = out[v] + half * self.end[v];
        }
        Ok(())
    }
    #[inline(always)]
    fn accept(&mut self, accepted: S::Mask) {
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
