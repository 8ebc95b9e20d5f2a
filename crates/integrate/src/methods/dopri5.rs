//! Dormand and Prince's method of order 5, with an error estimate of order 4 and dense output of order 4.
//!
//! (J. R. Dormand, P. J. Prince, J. Comp. Appl. Math. 6, 19, 1980; dense output by Shampine in Hairer, Norsett,
//! Wanner, *Solving ODEs I*, II.6.) The method for moderate accuracy.

use crate::tableau::{Row, Tableau};
use crate::{Kind, Method, MethodCard, Needs, Options, Stepper};
use precess_scalar::Scalar;
use precess_system::Shape;

/// See the module.
pub struct Dopri5;

static CARD: MethodCard = MethodCard {
    id: "dopri5",
    title: ("Dormand-Prince 5(4)", "Dormand-Prince 5(4)"),
    about: (
        "Adaptive, of order 5: the method for moderate accuracy.",
        "Adaptative, d'ordre 5 : la méthode des précisions moyennes.",
    ),
    order: 5,
    kind: Kind::Adaptive,
    needs: Needs::Any,
    symplectic: false,
    reversible: false,
    source: "J. R. Dormand, P. J. Prince, J. Comp. Appl. Math. 6, 19 (1980)",
    options: &[],
};

impl Method for Dopri5 {
    fn card(&self) -> &'static MethodCard {
        &CARD
    }
    fn stepper<S: Scalar + Send>(&self, shape: &Shape, _: &Options) -> Box<dyn Stepper<S>> {
        TABLEAU.stepper(shape)
    }
}

pub(crate) static TABLEAU: Tableau = Tableau {
    nodes: &[0.0, 1.0 / 5.0, 3.0 / 10.0, 4.0 / 5.0, 8.0 / 9.0, 1.0],
    stages: &[
        &[(0, 1.0 / 5.0)],
        &[(0, 3.0 / 40.0), (1, 9.0 / 40.0)],
        &[(0, 44.0 / 45.0), (1, -56.0 / 15.0), (2, 32.0 / 9.0)],
        &[(0, 19372.0 / 6561.0), (1, -25360.0 / 2187.0), (2, 64448.0 / 6561.0), (3, -212.0 / 729.0)],
        &[
            (0, 9017.0 / 3168.0),
            (1, -355.0 / 33.0),
            (2, 46732.0 / 5247.0),
            (3, 49.0 / 176.0),
            (4, -5103.0 / 18656.0),
        ],
    ],
    weights: WEIGHTS,
    error: &[
        (0, 71.0 / 57600.0),
        (2, -71.0 / 16695.0),
        (3, 71.0 / 1920.0),
        (4, -17253.0 / 339200.0),
        (5, 22.0 / 525.0),
        (6, -1.0 / 40.0),
    ],
    second_error: &[],
    extra_nodes: &[],
    extra_stages: &[],
    dense: &[&[
        (0, -12715105075.0 / 11282082432.0),
        (2, 87487479700.0 / 32700410799.0),
        (3, -10690763975.0 / 1880347072.0),
        (4, 701980252875.0 / 199316789632.0),
        (5, -1453857185.0 / 822651844.0),
        (6, 69997945.0 / 29380423.0),
    ]],
};

const WEIGHTS: Row =
    &[(0, 35.0 / 384.0), (2, 500.0 / 1113.0), (3, 125.0 / 192.0), (4, -2187.0 / 6784.0), (5, 11.0 / 84.0)];
