//! The card of `noria`: eight buckets' worth of names.

use precess_system::{Card, Direction, card, coordinate, number};
use std::f64::consts::PI;

/// How many buckets hang on the wheel.
pub(super) const BUCKETS: usize = 8;

/// The wheel of P, exercise 8.
pub(super) fn card_of_noria() -> Card {
    let mut card = card("noria", "Noria", "Noria")
        .about(
            "A water wheel with eight buckets that fill under a stream, empty when full and dry out slowly: it \
             turns one way, then the other, without a rule.",
            "Une roue à huit cuvettes qui se remplissent sous un filet d'eau, se vident une fois pleines et \
             s'assèchent lentement : elle tourne dans un sens, puis dans l'autre, sans règle.",
        )
        .source("P, exercise 8, figure 26")
        .coordinate(coordinate("theta", "", "angle of the wheel", "angle de la roue").start(0.15));
    for i in 0..BUCKETS {
        let (en, fr) = (format!("water in bucket {i}"), format!("eau dans la cuvette {i}"));
        card = card.coordinate(coordinate(&format!("m{i}"), "", &en, &fr).first_order().not_negative());
    }
    events(parameters(card))
        .modes(BUCKETS + 1)
        .signal("water", "", "water on the wheel", "eau sur la roue")
        .signal(
            "moment",
            "",
            "moment of the water, sum of m sin theta",
            "moment de l'eau, somme des m sin theta",
        )
        .time_view(&["theta"])
        .phase_view("theta", "theta_dot")
        .run(30.0, 0.001)
}

fn parameters(card: Card) -> Card {
    card.parameter(number("k", "", 50.0, "strength of the weight", "effet du poids"))
        .parameter(number("gamma", "", 75.0, "friction of the axle", "frottement de l'axe").not_negative())
        .parameter(
            number("inflow", "", 1000.0 / 9.0, "water per time", "débit du filet d'eau").not_negative(),
        )
        .parameter(
            number("capacity", "", 800.0 / 9.0, "water that a bucket holds", "contenance d'une cuvette")
                .positive(),
        )
        .parameter(
            number("evaporation", "", 50.0 / 9.0, "water lost per time", "évaporation par unité de temps")
                .not_negative(),
        )
        .parameter(
            number("floor", "", 20.0 / 9.0, "water that does not evaporate", "eau qui ne s'évapore pas")
                .not_negative(),
        )
        .parameter(
            number(
                "window",
                "",
                0.35,
                "half-width of the stream, in radians",
                "demi-largeur du filet, en radians",
            )
            .within(0.0, PI / 8.0),
        )
        .parameter(
            number(
                "threshold",
                "",
                0.0005,
                "water below which the wheel rests",
                "eau sous laquelle la roue reste immobile",
            )
            .positive(),
        )
}

fn events(mut card: Card) -> Card {
    let kinds = [
        ("enters", Direction::Rising, "comes under the stream", "arrive sous le filet d'eau"),
        ("leaves", Direction::Falling, "leaves the stream", "quitte le filet d'eau"),
        ("full", Direction::Rising, "is full and empties", "est pleine et se vide"),
        ("dry", Direction::Falling, "stops evaporating", "cesse de s'évaporer"),
    ];
    for (kind, direction, en, fr) in kinds {
        for i in 0..BUCKETS {
            let (en, fr) = (format!("bucket {i} {en}"), format!("la cuvette {i} {fr}"));
            card = card.event(&format!("bucket{i}_{kind}"), direction, &en, &fr);
        }
    }
    card.event("sets_off", Direction::Rising, "enough water to turn", "assez d'eau pour tourner").event(
        "halts",
        Direction::Falling,
        "too little water to turn",
        "trop peu d'eau pour tourner",
    )
}
