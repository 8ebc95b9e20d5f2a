//! Dormand and Prince's method of order 5, with an error estimate of order 4 and dense output of order 4.
//!
//! (J. R. Dormand, P. J. Prince, J. Comp. Appl. Math. 6, 19, 1980; dense output by Shampine in Hairer, Norsett,
//! Wanner, *Solving ODEs I*, II.6.) The method for moderate accuracy.

use crate::coefficient::ratio;
use crate::tableau::{Row, Steps, Tableau};
use crate::{Kind, Method, MethodCard, Needs, Options};
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
    type Steps<S: Scalar> = Steps<S>;

    fn stepper<S: Scalar>(&self, shape: &Shape, _: &Options) -> Steps<S> {
        TABLEAU.stepper(shape)
    }
}

pub(crate) static TABLEAU: Tableau = Tableau {
    nodes: &[ratio(0, 1), ratio(1, 5), ratio(3, 10), ratio(4, 5), ratio(8, 9), ratio(1, 1)],
    stages: &[
        &[(0, ratio(1, 5))],
        &[(0, ratio(3, 40)), (1, ratio(9, 40))],
        &[(0, ratio(44, 45)), (1, ratio(-56, 15)), (2, ratio(32, 9))],
        &[(0, ratio(19372, 6561)), (1, ratio(-25360, 2187)), (2, ratio(64448, 6561)), (3, ratio(-212, 729))],
        &[
            (0, ratio(9017, 3168)),
            (1, ratio(-355, 33)),
            (2, ratio(46732, 5247)),
            (3, ratio(49, 176)),
            (4, ratio(-5103, 18656)),
        ],
    ],
    weights: WEIGHTS,
    error: &[
        (0, ratio(71, 57600)),
        (2, ratio(-71, 16695)),
        (3, ratio(71, 1920)),
        (4, ratio(-17253, 339200)),
        (5, ratio(22, 525)),
        (6, ratio(-1, 40)),
    ],
    second_error: &[],
    extra_nodes: &[],
    extra_stages: &[],
    dense: &[&[
        (0, ratio(-12715105075, 11282082432)),
        (2, ratio(87487479700, 32700410799)),
        (3, ratio(-10690763975, 1880347072)),
        (4, ratio(701980252875, 199316789632)),
        (5, ratio(-1453857185, 822651844)),
        (6, ratio(69997945, 29380423)),
    ]],
};

const WEIGHTS: Row = &[
    (0, ratio(35, 384)),
    (2, ratio(500, 1113)),
    (3, ratio(125, 192)),
    (4, ratio(-2187, 6784)),
    (5, ratio(11, 84)),
];
