//! The cone of T's section 6.1 on a round tip: slipping makes it rise, and Jellett's quantity is constant.

use super::form::Form;
use super::on_table::{Slider, Top};
use precess_system::{Card, Parameter, card, number};

/// See the module.
pub const ROUNDED_TOP: Slider = Slider(&Top {
    form: Form::Tip,
    card: text,
    parameters,
    angles: [0.0, 0.3, 0.0],
    omega: [0.0, 0.0, 150.0],
    speed: 0.0,
    run,
});

fn text() -> Card {
    card("rounded_top", "Top with a round tip", "Toupie à pointe ronde").about(
        "The same cone on a round tip: friction now has a lever, and the top rises until it sleeps.",
        "Le même cône sur une pointe ronde : le frottement a maintenant un bras de levier, et la toupie se redresse jusqu'à dormir.",
    ).source("T, section 6.5; J. H. Jellett, A Treatise on the Theory of Friction (1872)")
}

fn parameters() -> Vec<Parameter> {
    vec![
        number("m", "kg", 0.039269908169872414, "mass", "masse").positive(),
        number("d", "m", 0.1125, "distance from G to the lowest point", "distance de G au point le plus bas")
            .positive(),
        number("tip", "m", 0.003, "radius of the tip", "rayon de la pointe").not_negative(),
        number("i1", "kg m^2", 4.786020058203201e-5, "transverse inertia at G", "inertie transverse en G")
            .positive(),
        number("i3", "kg m^2", 2.945243112740431e-5, "inertia about the axis", "inertie axiale").positive(),
    ]
}

fn run(card: Card) -> Card {
    card.time_view(&["theta"]).path_view("contact_x", "contact_y").run(2.0, 1e-4)
}
