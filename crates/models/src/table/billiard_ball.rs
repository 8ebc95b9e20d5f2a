//! A billiard ball: it slips, its path is a parabola, and it rolls after 2 u0 / (7 mu g).

use super::form::Form;
use super::slider::Slider;
use super::top::Top;
use precess_system::{Card, Parameter, card, number};

/// See the module.
pub const BILLIARD_BALL: Slider = Slider(&Top {
    form: Form::Sphere,
    card: text,
    parameters,
    angles: [0.0, 0.0, 0.0],
    omega: [0.0, 0.0, 0.0],
    speed: 2.0,
    run,
});

fn text() -> Card {
    card("billiard_ball", "Billiard ball", "Boule de billard").about(
        "A ball that slips at first, and rolls after the time 2 u0 / (7 mu g), with five sevenths of its speed.",
        "Une boule qui glisse d'abord, puis roule après le temps 2 u0 / (7 mu g), avec les cinq septièmes de sa vitesse.",
    ).source("G. Coriolis, Théorie mathématique des effets du jeu de billard (1835)")
}

fn parameters() -> Vec<Parameter> {
    vec![
        number("m", "kg", 0.17, "mass", "masse").positive(),
        number("radius", "m", 0.028575, "radius", "rayon").positive(),
        number(
            "alpha",
            "",
            0.0,
            "distance from G to the centre, in radii",
            "distance de G au centre, en rayons",
        )
        .within(0.0, 1.0),
        number(
            "i1",
            "kg m^2",
            0.4 * 0.17 * 0.028575 * 0.028575,
            "transverse inertia at G",
            "inertie transverse en G",
        )
        .positive(),
        number("i3", "kg m^2", 0.4 * 0.17 * 0.028575 * 0.028575, "inertia about the axis", "inertie axiale")
            .positive(),
    ]
}

fn run(card: Card) -> Card {
    card.time_view(&["slip", "x_dot"]).path_view("contact_x", "contact_y").run(1.0, 1e-4)
}
