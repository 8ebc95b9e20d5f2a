//! The card of a body on a table: coordinates, and the parameters of table and contact.

use super::form::Form;
use super::friction::LAWS;
use super::measure::observables;
use super::top::Top;
use crate::attitude;
use crate::rotation::from_euler;
use precess_system::{Card, choice, coordinate, number};

/// The options of the parameter `contact`.
const CONTACTS: &[&str; 2] = &["kept", "free"];

/// The card of a top that rolls, or that slides.
pub(super) fn card_of(top: &Top, slides: bool) -> Card {
    let card = attitude::coordinates((top.card)(), from_euler(top.angles), top.omega);
    let place = |name, en, fr| {
        let place = coordinate(name, "m", en, fr);
        if slides { place } else { place.first_order() }
    };
    let speed = if slides { top.speed } else { 0.0 };
    let card = card
        .coordinate(place("x", "centre of mass, abscissa", "centre de masse, abscisse").start_dot(speed))
        .coordinate(place("y", "centre of mass, ordinate", "centre de masse, ordonnée"));
    let card = (top.parameters)().into_iter().fold(card, Card::parameter);
    let card = table(card, top.form == Form::General);
    let card = if slides { contact(card) } else { card };
    (top.run)(observables(top, card, slides))
}

/// Gravity, slope, resistance; and how the table shakes.
pub(super) fn table(card: Card, shaken: bool) -> Card {
    let card = card
        .parameter(number("g", "m/s^2", 9.81, "gravity", "pesanteur"))
        .parameter(number(
            "slope",
            "",
            0.0,
            "slope of the table, downhill along x",
            "pente de la table, selon x",
        ))
        .parameter(
            number(
                "damping",
                "kg m^2/s",
                0.0,
                "resisting torque by angular velocity",
                "couple résistant par vitesse angulaire",
            )
            .not_negative(),
        );
    if !shaken {
        return card;
    }
    card.parameter(number(
        "shake_x",
        "m",
        0.0,
        "swing of the table along x",
        "oscillation de la table selon x",
    ))
    .parameter(number(
        "shake_z",
        "m",
        0.0,
        "swing of the table up and down",
        "oscillation verticale de la table",
    ))
    .parameter(number("shake_omega", "rad/s", 0.0, "pulsation of the table", "pulsation de la table"))
}

/// The smooth law of friction alone.
pub(super) fn smooth(card: Card) -> Card {
    card.parameter(
        number("mu", "", 0.3, "coefficient of friction", "coefficient de frottement").not_negative(),
    )
    .parameter(
        number(
            "epsilon",
            "m/s",
            1e-3,
            "slip below which friction is smooth (coulomb_smooth, drilling)",
            "glissement sous lequel le frottement est lissé (coulomb_smooth, drilling)",
        )
        .positive(),
    )
}

fn contact(card: Card) -> Card {
    smooth(card)
        .parameter(
            number(
                "speed",
                "m/s",
                1.0,
                "slip of the viscous law at which friction is mu N",
                "glissement de la loi visqueuse où le frottement vaut mu N",
            )
            .positive(),
        )
        .parameter(
            number(
                "spot",
                "m",
                0.0,
                "radius of the contact spot that drills",
                "rayon de la tache de contact qui pivote",
            )
            .not_negative(),
        )
        .parameter(
            number(
                "restitution",
                "",
                0.0,
                "share of the normal speed that an impact gives back (a free contact)",
                "part de la vitesse normale que rend un choc (contact libre)",
            )
            .within(0.0, 1.0),
        )
        .parameter(choice("friction", LAWS, "law of friction", "loi de frottement"))
        .parameter(choice(
            "contact",
            CONTACTS,
            "kept on the table, or free to lift off and land",
            "maintenu sur la table, ou libre de décoller et de retomber",
        ))
}
