//! The tippe top that slips, and turns over.
//!
//! It does where Jellett's constant exceeds sqrt(m g R^3 I3 alpha) (1 + alpha)^2 / sqrt(1 + alpha - I1/I3), with
//! 1 - alpha^2 < I1/I3 < 1. Jellett's quantity is constant under any friction.

use super::form::Form;
use super::slider::Slider;
use super::top::Top;
use precess_system::{Card, Parameter, card, number};

/// See the module.
pub const TIPPE_TOP: Slider = Slider(&Top {
    form: Form::Sphere,
    card: text,
    parameters,
    angles: [0.0, 0.1, 0.0],
    omega: [0.0, 0.0, 150.0],
    speed: 0.0,
    run,
});

fn text() -> Card {
    card("tippe_top", "Tippe top", "Toupie chinoise").about(
        "A ball whose centre of mass lies below its centre. Spun fast it turns over, because it slips: the same top that rolls without slipping does not. A homogeneous truncated sphere hardly ever can.",
        "Une boule dont le centre de masse est sous le centre. Lancée vite, elle se retourne, parce qu'elle glisse : la même qui roule sans glisser ne le fait pas. Une sphère homogène tronquée n'y arrive presque jamais.",
    ).source("T, sections 6.2 and 6.5; R. J. Cohen, Am. J. Phys. 45, 12 (1977)")
}

fn parameters() -> Vec<Parameter> {
    vec![
        number("m", "kg", 0.02, "mass", "masse").positive(),
        number("radius", "m", 0.02, "radius of the sphere", "rayon de la sphère").positive(),
        number(
            "alpha",
            "",
            0.3,
            "distance from G to the centre, in radii",
            "distance de G au centre, en rayons",
        )
        .within(0.0, 1.0),
        number("i1", "kg m^2", 131.0 / 350.0 * 8e-6, "transverse inertia at G", "inertie transverse en G")
            .positive(),
        number("i3", "kg m^2", 0.4 * 8e-6, "inertia about the axis", "inertie axiale").positive(),
    ]
}

fn run(card: Card) -> Card {
    card.time_view(&["theta"]).path_view("contact_x", "contact_y").run(8.0, 1e-4)
}
