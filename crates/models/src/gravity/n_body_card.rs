//! The card of `n_body`, whose coordinates and observables depend on the number of bodies.

use precess_system::{Card, Coordinate, Layout, card, coordinate, list, number};

/// The sum over all pairs grows with the square of this.
const MOST_BODIES: usize = 2000;

const AXES: [&str; 3] = ["x", "y", "z"];

/// The card with the two planets of P, exercise 9.1.
pub(super) fn card_of_two() -> Card {
    let card = card("n_body", "Bodies that attract one another", "Problème à n corps")
        .about(
            "Two bodies go round one another on ellipses; three already do as they please. As many bodies as \
             there are masses, in space if a start names a z.",
            "Deux corps tournent l'un autour de l'autre sur des ellipses ; dès trois, ils n'en font qu'à leur tête. \
             Autant de corps que de masses, dans l'espace si un départ nomme un z.",
        )
        .source("P, section 9 and exercise 9, figures 27 and 28")
        .parameter(number("k", "", 1.0, "constant of gravitation", "constante de gravitation"))
        .parameter(
            list("masses", "", &[10.0, 1.0], "masses of the bodies", "masses des corps")
                .not_negative()
                .symbol("m")
                .at_most(MOST_BODIES),
        )
        .parameter(
            number("softening", "", 0.0, "length that softens the pull", "longueur qui adoucit l'attraction")
                .not_negative(),
        )
        .path_view("xg*", "yg*")
        .run(10.0, 1e-4);
    observables(coordinates(2, 2).into_iter().fold(card, Card::coordinate), 2, 2)
}

/// The layout for any number of bodies.
pub(super) fn layout(bodies: usize, dimensions: usize) -> Layout {
    let card = observables(card("n_body", "", ""), bodies, dimensions);
    Layout { coordinates: coordinates(bodies, dimensions).into(), ..Layout::of(&card) }
}

/// Body by body: its place; the first two start as P's planets, any other at rest at the origin.
fn coordinates(bodies: usize, dimensions: usize) -> Vec<Coordinate> {
    let one = |body: usize, axis: &str| {
        let place = coordinate(
            &format!("{axis}{body}"),
            "",
            &format!("{axis} of body {body}"),
            &format!("{axis} du corps {body}"),
        );
        match (body, axis) {
            (0, "x") => place.start(-1.0),
            (1, "x") => place.start(1.0),
            (0, "y") => place.start_dot(1.8),
            (1, "y") => place.start_dot(-0.18),
            _ => place,
        }
    };
    (0..bodies).flat_map(|body| AXES[..dimensions].iter().map(move |axis| one(body, axis))).collect()
}

/// Constants of the motion, energies, places from the centre of mass.
fn observables(card: Card, bodies: usize, dimensions: usize) -> Card {
    let axes = &AXES[..dimensions];
    let mut card = card.invariant("energy", "", "total energy", "énergie totale");
    for axis in axes {
        let (en, fr) = (format!("momentum along {axis}"), format!("quantité de mouvement selon {axis}"));
        card = card.invariant(&format!("momentum_{axis}"), "", &en, &fr);
    }
    if dimensions == 2 {
        card = card.invariant("angular_momentum", "", "angular momentum", "moment cinétique");
    } else {
        for axis in axes {
            let (en, fr) =
                (format!("angular momentum along {axis}"), format!("moment cinétique selon {axis}"));
            card = card.invariant(&format!("angular_momentum_{axis}"), "", &en, &fr);
        }
    }
    card = card.signal("kinetic", "", "kinetic energy", "énergie cinétique").signal(
        "potential",
        "",
        "potential energy",
        "énergie potentielle",
    );
    for body in 0..bodies {
        for axis in axes {
            let en = format!("{axis} of body {body}, from the centre of mass");
            let fr = format!("{axis} du corps {body}, depuis le centre de masse");
            card = card.signal(&format!("{axis}g{body}"), "", &en, &fr);
        }
    }
    pairs(bodies).fold(card, |card, (i, j)| elements(card, bodies, i, j))
}

/// More bodies than this have too many pairs to be looked at.
const MOST_PAIRED: usize = 6;

/// The pairs whose elements are observables.
pub(super) fn pairs(bodies: usize) -> impl Iterator<Item = (usize, usize)> {
    let few = if bodies <= MOST_PAIRED { bodies } else { 0 };
    (0..few).flat_map(move |i| (i + 1..few).map(move |j| (i, j)))
}

/// The orbit that a pair would go on along if it were alone.
fn elements(card: Card, bodies: usize, i: usize, j: usize) -> Card {
    let (a, e) = (format!("a{i}{j}"), format!("e{i}{j}"));
    let texts = [
        format!("semi-major axis of the orbit of {i} and {j} (osculating)"),
        format!("demi-grand axe de l'orbite de {i} et {j} (osculatrice)"),
        format!("eccentricity of the orbit of {i} and {j} (osculating)"),
        format!("excentricité de l'orbite de {i} et {j} (osculatrice)"),
    ];
    // Two bodies are always alone.
    if bodies == 2 {
        card.invariant_if(&a, "", &["softening"], &texts[0], &texts[1]).invariant_if(
            &e,
            "",
            &["softening"],
            &texts[2],
            &texts[3],
        )
    } else {
        card.signal(&a, "", &texts[0], &texts[1]).signal(&e, "", &texts[2], &texts[3])
    }
}
