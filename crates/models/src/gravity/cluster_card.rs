//! The card of `cluster`, and where its rings start.

use precess_system::{Card, Coordinate, Given, Layout, card, choice, coordinate, list, number, rows};

/// The bodies that attract.
pub(super) const HEAVY: usize = 2;
/// More asteroids than this fit no memory.
const MOST: f64 = 1e6;
/// What P's program takes for 2 pi.
const TURN: f64 = 6.28;
/// Place and velocity of body 1 in P's program, about which the rings are set.
const CENTRE: [f64; 4] = [200.0, 220.0, -0.5, -0.8];

/// How many asteroids, on how many equal places of a turn, at which distance from body 1, at which speed.
type Ring = [f64; 4];

/// The rings of P's program, inner ones first: 135 asteroids (P counts 138). The fifth has 30 asteroids on 20 places.
const RINGS: [Ring; 7] = [
    [15.0, 15.0, 5.0, 2.4],
    [15.0, 15.0, 10.0, 1.7],
    [15.0, 15.0, 20.0, 1.2],
    [20.0, 20.0, 25.0, 1.1],
    [30.0, 20.0, 30.0, 1.0],
    [20.0, 20.0, 35.0, 0.93],
    [20.0, 20.0, 40.0, 0.86],
];

pub(super) fn card_of_cluster() -> Card {
    let card = card("cluster", "Rings torn apart", "Désagrégation d'un amas")
        .about(
            "A small body with rings of asteroids flies past a large one, which strips the outer rings and keeps some of \
             the asteroids. They attract nothing, so there may be a million of them.",
            "Un petit corps entouré d'anneaux d'astéroïdes passe près d'un grand, qui arrache les anneaux extérieurs et \
             garde une partie des astéroïdes. Ils n'attirent rien : il peut y en avoir un million.",
        )
        .source("P, exercise 10, figure 29")
        .parameter(number("k", "", 1.0, "constant of gravitation", "constante de gravitation"))
        .parameter(
            list("masses", "", &[100.0, 30.0], "masses of the two bodies", "masses des deux corps")
                .not_negative()
                .symbol("m")
                .at_most(HEAVY),
        )
        .parameter(
            rows(
                "rings",
                &["count", "places", "radius", "speed"],
                &RINGS,
                "rings about body 1: asteroids, places on a turn, radius, speed (clockwise)",
                "anneaux autour du corps 1 : astéroïdes, places sur un tour, rayon, vitesse (sens horaire)",
            )
            .structural()
            .at_most(1000),
        )
        .parameter(choice(
            "stepping",
            &["corrected", "as_printed"],
            "as_printed: the asteroids' velocities take the acceleration of body 1 once more, as in P's program",
            "as_printed : les vitesses des astéroïdes reçoivent en plus l'accélération du corps 1, comme dans P",
        ))
        .invariant("energy", "", "energy of the two bodies", "énergie des deux corps")
        .invariant("momentum_x", "", "momentum along x", "quantité de mouvement selon x")
        .invariant("momentum_y", "", "momentum along y", "quantité de mouvement selon y")
        .invariant("angular_momentum", "", "angular momentum of the two bodies", "moment cinétique des deux corps")
        .signal("distance", "", "distance of the two bodies", "distance des deux corps")
        .signal("bound", "", "asteroids bound to body 1", "astéroïdes liés au corps 1")
        .signal("captured", "", "asteroids bound to body 0 alone", "astéroïdes liés au seul corps 0")
        .path_view("x*", "y*")
        .time_view(&["bound", "captured"])
        .run(350.0, 0.01);
    coordinates(&RINGS).into_iter().fold(card, Card::coordinate)
}

pub(super) fn layout(rings: &[Ring]) -> Layout {
    Layout { coordinates: coordinates(rings), ..Layout::of(&card_of_cluster()) }
}

fn coordinates(rings: &[Ring]) -> Vec<Coordinate> {
    let starts = [[-100.0, 0.0, 0.0, 0.0], CENTRE].into_iter().chain(asteroids(rings));
    let one = |(body, [x, y, u, v]): (usize, [f64; 4])| {
        let (en, fr) = if body < HEAVY { ("body", "du corps") } else { ("asteroid", "de l'astéroïde") };
        [("x", x, u), ("y", y, v)].map(|(axis, place, speed)| {
            let (en, fr) = (format!("{axis} of {en} {body}"), format!("{axis} {fr} {body}"));
            coordinate(&format!("{axis}{body}"), "", &en, &fr).start(place).start_dot(speed)
        })
    };
    starts.enumerate().flat_map(one).collect()
}

/// The starts of the asteroids as P's program has them: its angles count on from ring to ring. Rings that make no sense
/// have none, and are refused by the check.
fn asteroids(rings: &[Ring]) -> impl Iterator<Item = [f64; 4]> + '_ {
    let sound = check_rings(rings).is_ok();
    let mut before = 0.0;
    rings.iter().filter(move |_| sound).flat_map(move |&[count, places, radius, speed]| {
        let first = before;
        before += count;
        (0..count as usize).map(move |k| {
            let (sin, cos) = precess_scalar::Scalar::sin_cos(TURN * (first + k as f64) / places);
            let [x, y, u, v] = CENTRE;
            [x + radius * cos, y + radius * sin, u + speed * sin, v - speed * cos]
        })
    })
}

pub(super) fn check_rings(rings: &[Ring]) -> Result<(), String> {
    let whole = |x: f64| (0.0..=MOST).contains(&x) && x.fract() == 0.0;
    for (k, &[count, places, radius, _]) in rings.iter().enumerate() {
        let k = k + 1;
        match () {
            () if !whole(count) => {
                return Err(format!("ring {k} cannot have {count} asteroids: 0, 1, 2, ... do"));
            }
            () if !whole(places) || places == 0.0 => {
                return Err(format!("ring {k} cannot have {places} places: 1, 2, ... do"));
            }
            () if radius <= 0.0 => {
                return Err(format!("the radius of ring {k} must be above zero, not {radius}"));
            }
            () => {}
        }
    }
    let total: f64 = rings.iter().map(|ring| ring[0]).sum();
    if total > MOST { Err(format!("{total} asteroids are too many: at most a million")) } else { Ok(()) }
}

/// How far body 1 starts from where P has it.
pub(super) fn shifts(start: [f64; 4]) -> [f64; 4] {
    std::array::from_fn(|k| start[k] - CENTRE[k])
}

/// Whether a start of an asteroid is given: x, y and their rates.
pub(super) fn is_given(given: &Given, body: usize, k: usize) -> bool {
    let name = format!("{}{body}{}", ["x", "y"][k % 2], ["", "_dot"][k / 2]);
    given.get(&name).is_some()
}
