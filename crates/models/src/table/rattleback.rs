//! The rattleback (anagyre, celt), rolling without slipping.
//!
//! Kane and Levinson's (1982): semi-axes 20, 3, 2 cm, G 1 cm below the ellipsoid's centre, inertia by mass 2, 16, 17 cm^2 and
//! the product 0.2 cm^2. It cannot be a solid of revolution, as T takes its tops to be. Nothing is lost here, and it reverses
//! all the same: spun at +5 rad/s it turns back after 2.7 s, at -5 rad/s only after 11.5 s.

use super::form::Form;
use super::roller::Roller;
use super::top::Top;
use precess_system::{Card, Parameter, card, number};
use std::f64::consts::FRAC_PI_4;

/// See the module.
pub const RATTLEBACK: Roller = Roller(&Top {
    form: Form::Ellipsoid,
    card: text,
    parameters,
    // Tilted by half a degree about axis 1 and about axis 2.
    angles: [FRAC_PI_4, 0.012341, -FRAC_PI_4],
    omega: [0.0, 0.0, -5.0],
    speed: 0.0,
    run,
});

fn text() -> Card {
    card("rattleback", "Rattleback", "Anagyre").about(
        "Half an ellipsoid whose axes of inertia are turned a little against those of its shape. Spun one way it rattles, stops and turns back; the other way it just spins.",
        "Un demi-ellipsoïde dont les axes d'inertie sont un peu tournés par rapport à ceux de sa forme. Lancé dans un sens, il se met à tanguer, s'arrête et repart à l'envers ; dans l'autre, il tourne sans façon.",
    ).source("T, section 6.3.2; T. R. Kane and D. A. Levinson, Int. J. Non-Linear Mech. 17, 175 (1982)")
}

fn parameters() -> Vec<Parameter> {
    vec![
        number("m", "kg", 1.0, "mass", "masse").positive(),
        number("a", "m", 0.2, "semi-axis 1", "demi-axe 1").positive(),
        number("b", "m", 0.03, "semi-axis 2", "demi-axe 2").positive(),
        number("c", "m", 0.02, "semi-axis 3", "demi-axe 3").positive(),
        number(
            "h",
            "m",
            0.01,
            "height of the ellipsoid's centre above G",
            "hauteur du centre de l'ellipsoïde au-dessus de G",
        ),
        number("i11", "kg m^2", 2e-4, "inertia at G, entry 11", "inertie en G, coefficient 11").positive(),
        number("i22", "kg m^2", 16e-4, "inertia at G, entry 22", "inertie en G, coefficient 22").positive(),
        number("i33", "kg m^2", 17e-4, "inertia at G, entry 33", "inertie en G, coefficient 33").positive(),
        number("i12", "kg m^2", 2e-5, "inertia at G, entry 12", "inertie en G, coefficient 12"),
    ]
}

fn run(card: Card) -> Card {
    card.time_view(&["spin"])
        .path_view("contact_x", "contact_y")
        .path_view("contact1", "contact2")
        .run(20.0, 1e-3)
}
