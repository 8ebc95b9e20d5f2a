//! A disc with a round edge that rolls without slipping (Euler's disk, a coin).
//!
//! It obeys the equations of Chaplygin and Appell, which a test holds it against. A disc that lies flat touches in a face,
//! which is not modelled.

use super::form::Form;
use super::roller::Roller;
use super::top::Top;
use precess_system::{Card, Parameter, card, number};

/// See the module.
pub const EULER_DISK: Roller = Roller(&Top {
    form: Form::Disc,
    card: text,
    parameters,
    angles: [0.0, 0.6, 0.0],
    omega: [0.0, 30.0, 5.0],
    speed: 0.0,
    run,
});

fn text() -> Card {
    card("euler_disk", "Euler's disk", "Disque d'Euler").about(
        "A disc that rolls on its edge, as a coin does. As it sinks (give it some damping) the contact runs round faster and faster.",
        "Un disque qui roule sur sa tranche, comme une pièce. À mesure qu'il s'abaisse (avec un peu d'amortissement), le contact tourne de plus en plus vite.",
    ).source("P. Appell, Traité de mécanique rationnelle II, paragraph 462; S. A. Chaplygin (1897)")
}

fn parameters() -> Vec<Parameter> {
    vec![
        number("m", "kg", 0.44, "mass", "masse").positive(),
        number("radius", "m", 0.038, "radius of the disc", "rayon du disque").positive(),
        number("edge", "m", 0.001, "radius of the round edge", "rayon de l'arête arrondie").not_negative(),
        number("i1", "kg m^2", 1.6e-4, "transverse inertia at G", "inertie transverse en G").positive(),
        number("i3", "kg m^2", 3.2e-4, "inertia about the axis", "inertie axiale").positive(),
    ]
}

fn run(card: Card) -> Card {
    card.path_view("contact_x", "contact_y").time_view(&["theta"]).run(2.0, 1e-4)
}
