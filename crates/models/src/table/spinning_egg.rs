//! A boiled egg, a spheroid, that slips and rises.
//!
//! With its axis level and spinning about the vertical it is unstable under friction above
//! Omega^2 = m g b (a^2 - b^2) / (I3 a^2 - I1 b^2): 5 g / b for a uniform one.

use super::form::Form;
use super::slider::Slider;
use super::top::Top;
use precess_system::{Card, Parameter, card, number};

/// See the module.
pub const SPINNING_EGG: Slider = Slider(&Top {
    form: Form::Spheroid,
    card: text,
    parameters,
    angles: [0.0, 1.5, 0.0],
    omega: [0.0, 120.0, 0.0],
    speed: 0.0,
    run,
});

fn text() -> Card {
    card("spinning_egg", "Spinning egg", "Œuf tournant").about(
        "A boiled egg that spins on its side slips, and rises onto its end. Rolling without slipping it would not.",
        "Un œuf dur qui tourne sur le flanc glisse, et se dresse sur sa pointe. S'il roulait sans glisser, il resterait couché.",
    ).source("T, section 6.3.2; H. K. Moffatt and Y. Shimomura, Nature 416, 385 (2002)")
}

fn parameters() -> Vec<Parameter> {
    vec![
        number("m", "kg", 0.06, "mass", "masse").positive(),
        number("a", "m", 0.03, "semi-axis along the axis", "demi-axe selon l'axe").positive(),
        number("b", "m", 0.02, "semi-axis across", "demi-axe transverse").positive(),
        number(
            "h",
            "m",
            0.0,
            "height of the spheroid's centre above G along the axis",
            "position du centre du sphéroïde, depuis G, selon l'axe",
        ),
        number("i1", "kg m^2", 0.2 * 0.06 * 13e-4, "transverse inertia at G", "inertie transverse en G")
            .positive(),
        number("i3", "kg m^2", 0.4 * 0.06 * 4e-4, "inertia about the axis", "inertie axiale").positive(),
    ]
}

fn run(card: Card) -> Card {
    card.time_view(&["theta"])
        .path_view("contact_x", "contact_y")
        .path_view("contact1", "contact3")
        .run(10.0, 1e-4)
}
