//! Any convex body that slips on a plane with friction (T, section 6.5).
//!
//! The equations are in `sliding.rs`, the laws of friction in `friction.rs`, sliding, rolling and
//! flight in `regimes.rs`.

use super::form::Form;
use super::slider::Slider;
use super::top::Top;
use precess_system::{Card, Parameter, card, number};

/// See the module.
pub const SLIDING_BODY: Slider = Slider(&Top {
    form: Form::General,
    card: text,
    parameters,
    angles: [0.0, 0.3, 0.0],
    omega: [0.5, 0.0, -3.0],
    speed: 0.0,
    run,
});

fn text() -> Card {
    card("sliding_body", "Sliding body", "Corps glissant").about(
        "Any convex body that slips on a table with friction, given by its mass, its inertia and its support function.",
        "Un corps convexe quelconque qui glisse sur une table avec frottement, donné par sa masse, son inertie et sa fonction d'appui.",
    ).source("T, section 6.5")
}

fn parameters() -> Vec<Parameter> {
    vec![
        number("m", "kg", 10.0, "mass", "masse").positive(),
        number("i11", "kg m^2", 3.28, "inertia at G, entry 11", "inertie en G, coefficient 11").positive(),
        number("i22", "kg m^2", 4.16, "inertia at G, entry 22", "inertie en G, coefficient 22").positive(),
        number("i33", "kg m^2", 4.88, "inertia at G, entry 33", "inertie en G, coefficient 33").positive(),
        number("i12", "kg m^2", 0.0, "inertia at G, entry 12", "inertie en G, coefficient 12"),
        number("i13", "kg m^2", 0.0, "inertia at G, entry 13", "inertie en G, coefficient 13"),
        number("i23", "kg m^2", 0.0, "inertia at G, entry 23", "inertie en G, coefficient 23"),
        number("point1", "m", 0.0, "point of the support, axis 1", "point du support, axe 1"),
        number("point2", "m", 0.0, "point of the support, axis 2", "point du support, axe 2"),
        number("point3", "m", 0.0, "point of the support, axis 3", "point du support, axe 3"),
        number("radius", "m", 0.0, "radius of the support", "rayon du support").not_negative(),
        number("axis1", "m", 1.2, "semi-axis 1 of the support", "demi-axe 1 du support").not_negative(),
        number("axis2", "m", 1.0, "semi-axis 2 of the support", "demi-axe 2 du support").not_negative(),
        number("axis3", "m", 0.8, "semi-axis 3 of the support", "demi-axe 3 du support").not_negative(),
    ]
}

fn run(card: Card) -> Card {
    card.time_view(&["spin"])
        .path_view("contact_x", "contact_y")
        .path_view("contact1", "contact2")
        .run(10.0, 1e-3)
}
