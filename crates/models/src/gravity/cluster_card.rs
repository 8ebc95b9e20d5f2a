//! The card of `cluster`, and where its rings start.

use precess_system::{
    Card, Coordinate, Coordinates, Layout, Quantity, Swarm, card, choice, coordinate, list, number, quantity,
    rows,
};

/// The bodies that attract.
pub(super) const HEAVY: usize = 2;
/// More asteroids than this fit no memory.
const MOST: f64 = 1e6;
/// What P's program takes for 2 pi.
#[allow(clippy::approx_constant, reason = "as printed")]
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
    coordinates(&RINGS).iter().fold(card, Card::coordinate)
}

pub(super) fn layout(rings: &[Ring]) -> Layout {
    Layout { coordinates: coordinates(rings), ..Layout::of(&card_of_cluster()) }
}

fn coordinates(rings: &[Ring]) -> Coordinates {
    let heavy = [[-100.0, 0.0, 0.0, 0.0], CENTRE].into_iter().enumerate().flat_map(|(body, [x, y, u, v])| {
        [(x, u), (y, v)].into_iter().enumerate().map(move |(axis, (place, speed))| {
            let quantity = place_of(body, axis, "body", "du corps");
            Coordinate { quantity, ..coordinate("", "", "", "") }.start(place).start_dot(speed)
        })
    });
    Coordinates::with_swarm(heavy.collect(), Asteroids::of(rings))
}

/// A coordinate of a body by its number and axis.
fn place_of(body: usize, axis: usize, en: &str, fr: &str) -> Quantity {
    let axis = ["x", "y"][axis];
    let (en, fr) = (format!("{axis} of {en} {body}"), format!("{axis} {fr} {body}"));
    quantity(&format!("{axis}{body}"), "", &en, &fr)
}

/// x and y of each asteroid. Rings that make no sense have none, and are refused by the check.
#[derive(Debug)]
struct Asteroids {
    rings: Vec<Ring>,
    /// How many asteroids come before those of each ring, and how many there are.
    before: Vec<f64>,
}

impl Asteroids {
    fn of(rings: &[Ring]) -> Self {
        let rings = if check_rings(rings).is_ok() { rings.to_vec() } else { vec![] };
        let mut before = vec![0.0];
        for (k, ring) in rings.iter().enumerate() {
            before.push(before[k] + ring[0]);
        }
        Self { rings, before }
    }
}

impl Swarm for Asteroids {
    fn size(&self) -> usize {
        2 * self.before[self.rings.len()] as usize
    }

    fn quantity(&self, k: usize) -> Quantity {
        place_of(HEAVY + k / 2, k % 2, "asteroid", "de l'astéroïde")
    }

    /// As P's program has it: its angles count on from ring to ring.
    fn start(&self, k: usize) -> [f64; 2] {
        let number = (k / 2) as f64;
        let [_, places, radius, speed] =
            self.rings[self.before.partition_point(|first| *first <= number) - 1];
        let (sin, cos) = precess_scalar::Scalar::sin_cos(TURN * number / places);
        let [x, y, u, v] = CENTRE;
        if k.is_multiple_of(2) {
            [x + radius * cos, u + speed * sin]
        } else {
            [y + radius * sin, v - speed * cos]
        }
    }
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

/// The name of a start of an asteroid: x, y and their rates.
pub(super) fn name(body: usize, k: usize) -> String {
    format!("{}{body}{}", ["x", "y"][k % 2], ["", "_dot"][k / 2])
}
