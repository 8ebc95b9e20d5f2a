//! P's "improved Euler": the position to second order, the velocity to first.
//!
//!     x1 = x0 + h v0 + alpha h^2 a0        v1 = v0 + h a0
//!
//! with alpha = 1/2 (P, exercise 1; T, annex C). alpha = 0 is Euler and alpha = 1 is Euler-Cromer. With 1/2 an
//! oscillator's step has the determinant `1 + (omega h)^2 / 2`: the energy grows, an anti-damping of
//! `omega^2 h / 4`.

use crate::{Kind, Method, MethodCard, Needs, NoConvergence, OptionCard, Options, Stepper};
use precess_scalar::Scalar;
use precess_system::{Field, Shape};

/// See the module.
pub struct EulerTaylor;

static CARD: MethodCard = MethodCard {
    id: "euler_taylor",
    title: ("Euler-Taylor (\"improved Euler\")", "Euler-Taylor (« Euler améliorée »)"),
    about: (
        "The method of the second course's programs: better to look at than Euler, but of first order, and it \
         gains energy.",
        "La méthode des programmes du second cours : plus belle qu'Euler à l'écran, mais d'ordre un, et elle gagne \
         de l'énergie.",
    ),
    order: 1,
    kind: Kind::Fixed,
    needs: Needs::Any,
    symplectic: false,
    reversible: false,
    source: "P, exercise 1; T, annex C",
    options: &[OptionCard {
        name: "alpha",
        default: 0.5,
        low: 0.0,
        high: 1.0,
        text: (
            "share of the acceleration in the position: 0 Euler, 1 Euler-Cromer",
            "part de l'accélération dans la position : 0 Euler, 1 Euler-Cromer",
        ),
    }],
};

impl Method for EulerTaylor {
    fn card(&self) -> &'static MethodCard {
        &CARD
    }
    fn stepper<S: Scalar + Send>(&self, shape: &Shape, options: &Options) -> Box<dyn Stepper<S>> {
        Box::new(Steps {
            pairs: shape.pairs().collect(),
            rate: vec![S::from(0.0); shape.full()],
            alpha: options.alpha,
            evaluations: 0,
        })
    }
}

struct Steps<S> {
    pairs: Vec<(usize, usize)>,
    rate: Vec<S>,
    alpha: f64,
    evaluations: u64,
}

impl<S: Scalar + Send> Stepper<S> for Steps<S> {
    fn step(
        &mut self,
        field: &dyn Field<S>,
        t: S,
        y: &[S],
        h: S,
        out: &mut [S],
    ) -> Result<(), NoConvergence> {
        field.rate(t, y, &mut self.rate);
        self.evaluations += 1;
        for i in 0..y.len() {
            out[i] = y[i] + h * self.rate[i];
        }
        // P's order of operations: x += v*dt + 0.5*a*dt*dt.
        for &(x, v) in &self.pairs {
            out[x] = y[x] + (y[v] * h + self.rate[v] * self.alpha * h * h);
        }
        Ok(())
    }
    fn evaluations(&self) -> u64 {
        self.evaluations
    }
}
