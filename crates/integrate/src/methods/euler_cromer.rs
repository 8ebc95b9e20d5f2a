//! Euler-Cromer: the velocity first, then the position with the new velocity.
//!
//!     v1 = v0 + h a(t0, x0, v0)        x1 = x0 + h v1
//!
//! (T 5.2; A. Cromer, Am. J. Phys. 49, 455, 1981.) Symplectic where accelerations depend on positions alone;
//! elsewhere its energy error grows. A first-order coordinate follows the velocity's formula, which is Euler's
//! (T 5.2.2).

use crate::{Kind, Method, MethodCard, Needs, NoConvergence, Options, Stepper};
use precess_scalar::Scalar;
use precess_system::{Field, Shape};

/// See the module.
pub struct EulerCromer;

static CARD: MethodCard = MethodCard {
    id: "euler_cromer",
    title: ("Euler-Cromer", "Euler-Cromer"),
    about: (
        "As cheap as Euler, and symplectic where forces depend on positions alone: the energy oscillates but \
         stays.",
        "Aussi simple qu'Euler, et symplectique quand les forces ne dépendent que des positions : l'énergie \
         oscille mais se conserve en moyenne.",
    ),
    order: 1,
    kind: Kind::Fixed,
    needs: Needs::Any,
    symplectic: true,
    reversible: false,
    source: "T 5.2; A. Cromer, Am. J. Phys. 49, 455 (1981)",
    options: &[],
};

impl Method for EulerCromer {
    fn card(&self) -> &'static MethodCard {
        &CARD
    }
    fn stepper<S: Scalar + Send>(&self, shape: &Shape, _: &Options) -> Box<dyn Stepper<S>> {
        Box::new(Steps {
            pairs: shape.pairs().collect(),
            rate: vec![S::from(0.0); shape.full()],
            evaluations: 0,
        })
    }
}

struct Steps<S> {
    pairs: Vec<(usize, usize)>,
    rate: Vec<S>,
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
        for &(x, v) in &self.pairs {
            out[x] = y[x] + h * out[v];
        }
        Ok(())
    }
    fn evaluations(&self) -> u64 {
        self.evaluations
    }
}
