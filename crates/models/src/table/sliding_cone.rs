//! A cone that spins on its sharp tip, and slips (T, section 6.5).
//!
//! The tip lies on the axis, so no push at it turns the cone about its axis: `omega_3` is constant under any friction, and
//! what friction takes comes from the height. The cone does not rise; with a rounded tip (`rounded_top`) it does. It is
//! T's cone of section 6.1, spun fast enough to stand: `omega_3^2 > 4 (I1 + m d^2) m g d / I3^2`, 330 rad/s; at the
//! start it goes round as slowly as a fast top does, `m g d / (I3 omega_3)`, or else it would nod and jump. The side
//! of the cone is not there: it would meet the table where the axis comes near the horizontal.

use super::form::Form;
use super::slider::Slider;
use super::top::Top;
use precess_system::{Card, Parameter, card, number};
use std::f64::consts::PI;

/// See the module.
pub const SLIDING_CONE: Slider = Slider(&Top {
    form: Form::Tip,
    card: text,
    parameters: sharp,
    angles: [0.0, 0.3, 0.0],
    omega: [0.0, 0.725, 600.0],
    speed: 0.0,
    run,
});

/// A homogeneous cone of T's density, height and radius.
const MASS: f64 = 100.0 * PI / 3.0 * RADIUS * RADIUS * HEIGHT;
const HEIGHT: f64 = 0.15;
const RADIUS: f64 = 0.05;

fn text() -> Card {
    card("sliding_cone", "Sliding cone", "Cône glissant").about(
        "A cone that spins and slips on its sharp tip. Friction cannot slow its spin, and does not raise it: it sinks.",
        "Un cône qui tourne et glisse sur sa pointe vive. Le frottement ne peut pas freiner sa rotation propre, et ne le redresse pas : il s'affaisse.",
    ).source("T, sections 6.1 and 6.5")
}

fn sharp() -> Vec<Parameter> {
    parameters(0.0)
}

/// Of the cone whose tip is rounded by a ball of this radius.
pub(super) fn parameters(tip: f64) -> Vec<Parameter> {
    let square = RADIUS * RADIUS;
    vec![
        number("m", "kg", MASS, "mass", "masse").positive(),
        number(
            "d",
            "m",
            0.75 * HEIGHT - tip,
            "distance from G to the centre of the tip",
            "distance de G au centre de la pointe",
        )
        .positive(),
        number("tip", "m", tip, "radius of the tip", "rayon de la pointe").not_negative(),
        number(
            "i1",
            "kg m^2",
            0.0375 * MASS * (4.0 * square + HEIGHT * HEIGHT),
            "transverse inertia at G",
            "inertie transverse en G",
        )
        .positive(),
        number("i3", "kg m^2", 0.3 * MASS * square, "inertia about the axis", "inertie axiale").positive(),
    ]
}

pub(super) fn run(card: Card) -> Card {
    card.time_view(&["theta"]).time_view(&["spin_axis"]).path_view("contact_x", "contact_y").run(4.0, 1e-4)
}
