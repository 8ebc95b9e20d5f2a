//! Tsitouras' method of order 5, with an error estimate of order 4 and dense output of order 4.
//!
//! (Ch. Tsitouras, Comput. Math. Appl. 62, 770, 2011.) Of the cost of `dopri5`, with smaller errors. The weights of the
//! estimate and of the dense output, which were published with 16 digits, are the nearest numbers that meet the order
//! conditions to 33.

use crate::coefficient::{decimal, ratio};
use crate::tableau::{Steps, Tableau};
use crate::{Kind, Method, MethodCard, Needs, Options};
use precess_scalar::Scalar;
use precess_system::Shape;

/// See the module.
pub struct Tsit5;

static CARD: MethodCard = MethodCard {
    id: "tsit5",
    title: ("Tsitouras 5(4)", "Tsitouras 5(4)"),
    about: (
        "Adaptive, of order 5: as cheap as dopri5, with smaller errors.",
        "Adaptative, d'ordre 5 : au prix de dopri5, avec des erreurs plus petites.",
    ),
    order: 5,
    kind: Kind::Adaptive,
    needs: Needs::Any,
    symplectic: false,
    reversible: false,
    source: "Ch. Tsitouras, Comput. Math. Appl. 62, 770 (2011)",
    options: &[],
};

impl Method for Tsit5 {
    fn card(&self) -> &'static MethodCard {
        &CARD
    }
    type Steps<S: Scalar> = Steps<S>;

    fn stepper<S: Scalar>(&self, shape: &Shape, _: &Options) -> Steps<S> {
        TABLEAU.stepper(shape)
    }
}

static TABLEAU: Tableau = Tableau {
    nodes: &[
        ratio(0, 1),
        ratio(161, 1000),
        ratio(327, 1000),
        ratio(9, 10),
        decimal("0.98002554090450968572981028628702"),
        ratio(1, 1),
    ],
    stages: &[
        &[(0, ratio(161, 1000))],
        &[
            (0, decimal("-8.48065549235698854442687425023077e-3")),
            (1, decimal("3.35480655492356988544426874250231e-1")),
        ],
        &[
            (0, decimal("2.89715305710549343213043259419294")),
            (1, decimal("-6.35944848997507484314815991238383")),
            (2, decimal("4.36229543286958141101772731819089")),
        ],
        &[
            (0, decimal("5.32586482843925660442887792084051")),
            (1, decimal("-11.7488835640628278777471703397858")),
            (2, decimal("7.49553934288983620830460478456436")),
            (3, decimal("-9.24950663617552492565020793320719e-2")),
        ],
        &[
            (0, decimal("5.86145544294642002865925148698265")),
            (1, decimal("-12.9209693178471092917061186817834")),
            (2, decimal("8.15936789857615864318040079453925")),
            (3, decimal("-7.15849732814009972245305425258297e-2")),
            (4, decimal("-2.82690503940683829090030572127122e-2")),
        ],
    ],
    weights: &[
        (0, decimal("9.64607668180652295181673131651288e-2")),
        (1, ratio(1, 100)),
        (2, decimal("4.79889650414499574775249532290597e-1")),
        (3, decimal("1.37900857410374189319227482185687")),
        (4, decimal("-3.29006951543608067990104758571136")),
        (5, decimal("2.32471052409977398241535591839877")),
    ],
    error: &[
        (0, decimal("-1.78001105222577144337855060753953e-3")),
        (1, decimal("-8.16434459656746903223636063354686e-4")),
        (2, decimal("7.88087801026199601031472767252630e-3")),
        (3, decimal("-1.44711007173262907537165147972635e-1")),
        (4, decimal("5.82357165452555225019937610652042e-1")),
        (5, decimal("-4.58082105929186946661636518832554e-1")),
        (6, ratio(1, 66)),
    ],
    second_error: &[],
    extra_nodes: &[],
    extra_stages: &[],
    dense: &[&[
        (0, decimal("-1.05308849772902155722749030252307")),
        (1, ratio(1017, 10000)),
        (2, decimal("2.49062728565125279308354507258820")),
        (3, decimal("-16.5481028892449027183072978622825")),
        (4, decimal("47.3795219628192812186815818681989")),
        (5, decimal("-34.8706578614966097362303387759815")),
        (6, ratio(5, 2)),
    ]],
};
