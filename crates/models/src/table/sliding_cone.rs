//! The cone of T's section 6.1 that slips on its sharp tip (T, section 6.5): it does not rise.

use super::form::Form;
use super::on_table::{Slider, Top};
use precess_system::{Card, Parameter, card, number};

/// See the module.
pub const SLIDING_CONE: Slider = Slider(&Top {
    form: Form::Tip,
    card: text,
    parameters,
    angles: [0.0, 0.3, 0.0],
    omega: [0.0, 0.0, 150.0],
    speed: 0.0,
    run,
});

fn text() -> Card {
    card("sliding_cone", "Sliding cone", "Toupie conique glissante").about(
        "A top that slips on a sharp tip. It does not rise: a point on the axis has no lever, so the spin is kept.",
        "Une toupie qui glisse sur une pointe aiguë. Elle ne se redresse pas : une pointe sur l'axe n'a pas de bras de levier, et la rotation propre se conserve.",
    ).source("T, sections 6.1 and 6.5")
}

fn parameters() -> Vec<Parameter> {
    vec![
        number("m", "kg", 0.039269908169872414, "mass", "masse").positive(),
        number("d", "m", 0.1125, "distance from G to the tip", "distance de G à la pointe").positive(),
        number("tip", "m", 0.0, "radius of the tip", "rayon de la pointe").not_negative(),
        number("i1", "kg m^2", 4.786020058203201e-5, "transverse inertia at G", "inertie transverse en G")
            .positive(),
        number("i3", "kg m^2", 2.945243112740431e-5, "inertia about the axis", "inertie axiale").positive(),
    ]
}

fn run(card: Card) -> Card {
    card.time_view(&["theta"]).path_view("contact_x", "contact_y").run(2.0, 1e-4)
}
