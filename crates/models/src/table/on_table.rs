//! What all bodies on a table share: one implementation, which a named top fills with its parameters and texts.
//!
//! The table keeps the body (T, section 1, first hypothesis): where the normal force would turn negative the body is held,
//! and `normal` shows it. R is the attitude (body to space); all vectors below are in body axes.

use super::body::{Body, Touch, minus, plus, scaled};
use super::form::Form;
use super::friction::{Friction, LAWS};
use super::ground::Ground;
use super::rolling::roll;
use super::sliding::slide;
use crate::attitude;
use crate::rotation::{Vector, cross, dot, from_euler, quaternion_rate};
use precess_scalar::Scalar;
use precess_system::{Card, Given, Parameter, State, System, Values, choice, coordinate, number};

/// What a named top differs in from the others.
pub struct Top {
    /// How its parameters make a body.
    pub(super) form: Form,
    /// Id, texts, source.
    pub(super) card: fn() -> Card,
    /// The parameters of its form.
    pub(super) parameters: fn() -> Vec<Parameter>,
    /// Euler angles at the start.
    pub(super) angles: [f64; 3],
    /// Angular velocity at the start, in body axes.
    pub(super) omega: [f64; 3],
    /// Velocity of G along x at the start (sliding only).
    pub(super) speed: f64,
    /// Views and defaults of a run.
    pub(super) run: fn(Card) -> Card,
}

/// A body that rolls without slipping.
#[derive(Clone)]
pub struct Roller(pub(super) &'static Top);

/// A body that slips.
#[derive(Clone)]
pub struct Slider(pub(super) &'static Top);

/// Observables that every body has, besides the angles.
const COMMON: usize = 20;

/// A point of the motion, taken apart.
struct Seen<S> {
    body: Body<S>,
    ground: Ground<S>,
    attitude: [S; 4],
    omega: Vector<S>,
    /// The table's axes in body axes; the last one is the vertical gamma.
    rows: [Vector<S>; 3],
    touch: Touch<S>,
    torque: Vector<S>,
    felt: [S; 2],
}

/// Space's axes in body axes, from a quaternion of any length.
#[inline(always)]
fn axes<S: Scalar>([w, x, y, z]: [S; 4]) -> [Vector<S>; 3] {
    let part = S::from(1.0) / (w * w + x * x + y * y + z * z);
    let rows = [
        [w * w + x * x - y * y - z * z, (x * y - w * z) * 2.0, (x * z + w * y) * 2.0],
        [(x * y + w * z) * 2.0, w * w - x * x + y * y - z * z, (y * z - w * x) * 2.0],
        [(x * z - w * y) * 2.0, (y * z + w * x) * 2.0, w * w - x * x - y * y + z * z],
    ];
    [scaled(rows[0], part), scaled(rows[1], part), scaled(rows[2], part)]
}

impl Top {
    #[inline(always)]
    fn see<S: Scalar>(&self, s: &State<S>) -> Seen<S> {
        let (attitude, omega) = attitude::halves(s);
        let (own, rest) = s.values.numbers.split_at(self.form.count());
        let body = self.form.body(own);
        let shake = (self.form == Form::General).then(|| [rest[3], rest[4], rest[5]]);
        let ground = Ground { g: rest[0], slope: rest[1], damping: rest[2], shake };
        let rows = axes(attitude);
        let touch = body.touch(rows[2], omega);
        let (torque, felt) = (scaled(omega, -ground.damping), ground.felt(s.t));
        Seen { body, ground, attitude, omega, rows, touch, torque, felt }
    }

    /// Parameters of the friction, after those of body and table.
    #[inline(always)]
    fn friction<S: Scalar>(&self, s: &State<S>) -> Friction<S> {
        let table = if self.form == Form::General { 6 } else { 3 };
        let p = &s.values.numbers[self.form.count() + table..];
        Friction { law: s.choice(0), mu: p[0], epsilon: p[1], speed: p[2], spot: p[3] }
    }

    fn card(&self, slides: bool) -> Card {
        let card = attitude::coordinates((self.card)(), from_euler(self.angles), self.omega);
        let place = |name, en, fr| {
            let place = coordinate(name, "m", en, fr);
            if slides { place } else { place.first_order() }
        };
        let speed = if slides { self.speed } else { 0.0 };
        let card = card
            .coordinate(place("x", "centre of mass, abscissa", "centre de masse, abscisse").start_dot(speed))
            .coordinate(place("y", "centre of mass, ordinate", "centre de masse, ordonnée"));
        let card = (self.parameters)().into_iter().fold(card, Card::parameter);
        let card = table_parameters(card, self.form == Form::General);
        let card = if slides { friction_parameters(card) } else { card };
        (self.run)(self.observables(card, slides))
    }

    fn observables(&self, card: Card, slides: bool) -> Card {
        // What drills turns the body about the normal, which the lever r is not.
        let held: &[&str] = if slides { &["damping", "spot"] } else { &["damping"] };
        let mut free = vec!["damping"];
        if slides {
            free.push("mu");
        }
        if self.form == Form::General {
            free.extend(["shake_x", "shake_z"]);
        }
        let card = card.invariant_if("energy", "J", &free, "total energy", "énergie totale");
        let (en, fr) = ("Jellett's quantity, -L.r", "grandeur de Jellett, -L.r");
        let card = if self.form.is_spherical() {
            card.invariant_if("jellett", "kg m^3/s", held, en, fr)
        } else {
            card.signal("jellett", "kg m^3/s", en, fr)
        };
        attitude::angles(forces(card))
    }

    #[inline(always)]
    fn observe<S: Scalar>(seen: &Seen<S>, place: [S; 2], found: &Found<S>, out: &mut [S]) {
        let Seen { body, rows, omega, touch, ground, .. } = seen;
        let r = touch.r;
        let momentum = body.inertia.times(*omega);
        let height = -dot(touch.gamma, r);
        let rise = -dot(cross(r, touch.gamma), *omega);
        let [vx, vy] = found.velocity;
        let kinetic = (body.mass * (vx * vx + vy * vy + rise * rise) + dot(*omega, momentum)) * 0.5;
        let [along_x, along_z] = ground.at_rest();
        let potential = -(body.mass * (along_x * place[0] + along_z * height));
        let [ux, uy] = found.slip;
        let [fx, fy, normal] = found.force;
        let friction = (fx * fx + fy * fy).sqrt();
        out[..7].copy_from_slice(&[
            kinetic + potential,
            -dot(momentum, r),
            kinetic,
            potential,
            height,
            normal,
            friction,
        ]);
        out[7..14].copy_from_slice(&[
            found.needed,
            found.denominator,
            ux,
            uy,
            found.slip_size,
            found.power,
            omega[2],
        ]);
        out[14] = dot(touch.gamma, *omega);
        out[15] = place[0] + dot(rows[0], r);
        out[16] = place[1] + dot(rows[1], r);
        out[17..COMMON].copy_from_slice(&r);
        attitude::observe(seen.attitude, *omega, &mut out[COMMON..]);
    }

    fn check(&self, s: &State<f64>) -> Result<(), String> {
        let seen = self.see(s);
        let body = &seen.body;
        possible(body)?;
        if body.radius < 0.0 || body.axes.iter().any(|&a| a < 0.0) {
            return Err(
                "the body is not convex: radius and axes of its support must not be below zero".into()
            );
        }
        let reach = plus([0.0; 3], [0, 1, 2].map(|i| body.axes[i] * seen.touch.gamma[i]));
        let (reach, longest) =
            (dot(reach, reach).sqrt(), body.axes.iter().fold(0.0, |a: f64, &b| a.larger(b)));
        if longest > 0.0 && reach < 1e-9 * longest {
            return Err(
                "a flat face lies on the table: only contacts in a point are modelled, so tilt it a little"
                    .into(),
            );
        }
        let height = -dot(seen.touch.gamma, seen.touch.r);
        if height <= 0.0 {
            return Err(format!(
                "the centre of mass would start {height} m above the table, that is not above it: the body reaches \
                 no farther down in this attitude"
            ));
        }
        Ok(())
    }
}

/// Whether a body of some shape has this inertia: positive, and no moment above the sum of the two others.
fn possible(body: &Body<f64>) -> Result<(), String> {
    let ([d1, d2, d3], [o23, o13, o12]) = (body.inertia.diagonal, body.inertia.off);
    // The second moments of mass, half the trace minus the inertia, must not be negative; a flat body has zero.
    let half = (d1 + d2 + d3) / 2.0;
    let (m1, m2, m3) = (half - d1, half - d2, half - d3);
    let slack = -1e-12 * half;
    let minors = [m1 * m2 - o12 * o12, m1 * m3 - o13 * o13, m2 * m3 - o23 * o23];
    let determinant = m1 * minors[2] - o12 * (o12 * m3 + o13 * o23) - o13 * (o12 * o23 + o13 * m2);
    let sound = [m1, m2, m3].iter().all(|&m| m >= slack)
        && minors.iter().all(|&m| m >= slack * half)
        && determinant >= slack * half * half
        && d1 > 0.0
        && d2 > 0.0
        && d3 > 0.0;
    if sound {
        return Ok(());
    }
    Err("no body has this inertia: its moments must be positive, and none may exceed the sum of the two others \
         (products of inertia included)"
        .into())
}

/// What the equations of rolling or of sliding say besides the acceleration.
struct Found<S> {
    velocity: [S; 2],
    slip: [S; 2],
    slip_size: S,
    /// On the body, along the table's axes.
    force: [S; 3],
    /// The friction that rolling without slipping needs.
    needed: S,
    denominator: S,
    power: S,
}

impl System for Roller {
    fn card(&self) -> Card {
        self.0.card(false)
    }

    #[inline(always)]
    fn equations<S: Scalar>(&self, s: &State<S>, highest: &mut [S]) {
        let seen = self.0.see(s);
        let gravity = plus(scaled(seen.rows[0], seen.felt[0]), scaled(seen.rows[2], seen.felt[1]));
        let rolling = roll(&seen.body, &seen.touch, seen.omega, gravity, seen.torque);
        let velocity = cross(seen.touch.r, seen.omega);
        highest[..4].copy_from_slice(&quaternion_rate(seen.attitude, seen.omega));
        highest[4..7].copy_from_slice(&rolling.omega_dot);
        highest[7] = dot(seen.rows[0], velocity);
        highest[8] = dot(seen.rows[1], velocity);
    }

    #[inline(always)]
    fn observe<S: Scalar>(&self, s: &State<S>, out: &mut [S]) {
        let seen = self.0.see(s);
        let zero = S::from(0.0);
        let gravity = plus(scaled(seen.rows[0], seen.felt[0]), scaled(seen.rows[2], seen.felt[1]));
        let rolling = roll(&seen.body, &seen.touch, seen.omega, gravity, seen.torque);
        let velocity = cross(seen.touch.r, seen.omega);
        let force = seen.rows.map(|row| dot(row, rolling.force));
        let arm = cross(seen.touch.r, seen.touch.gamma);
        let found = Found {
            velocity: [dot(seen.rows[0], velocity), dot(seen.rows[1], velocity)],
            slip: [zero, zero],
            slip_size: zero,
            force,
            needed: (force[0] * force[0] + force[1] * force[1]).sqrt(),
            denominator: S::from(1.0) / seen.body.mass + dot(arm, seen.body.inertia.inverse().times(arm)),
            power: zero,
        };
        Top::observe(&seen, [s.coordinates[7], s.coordinates[8]], &found, out);
    }

    fn start(&self, given: &Given, _values: &Values<f64>, y: &mut [f64]) -> Result<(), String> {
        attitude::start(given, y)
    }

    fn check(&self, s: &State<f64>) -> Result<(), String> {
        self.0.check(s)
    }
}

impl System for Slider {
    fn card(&self) -> Card {
        self.0.card(true)
    }

    #[inline(always)]
    fn equations<S: Scalar>(&self, s: &State<S>, highest: &mut [S]) {
        let seen = self.0.see(s);
        let swing = cross(seen.omega, seen.touch.r);
        let [vx, vy] = s.v();
        let slip = [vx + dot(seen.rows[0], swing), vy + dot(seen.rows[1], swing)];
        let grip = self.0.friction(s).grip(slip, dot(seen.touch.gamma, seen.omega));
        let moving = slide(&seen.body, &seen.touch, &seen.rows, seen.omega, seen.felt[1], seen.torque, &grip);
        let part = moving.normal / seen.body.mass;
        highest[..4].copy_from_slice(&quaternion_rate(seen.attitude, seen.omega));
        highest[4..7].copy_from_slice(&moving.omega_dot);
        highest[7] = part * grip.k[0] + seen.felt[0];
        highest[8] = part * grip.k[1];
    }

    #[inline(always)]
    fn observe<S: Scalar>(&self, s: &State<S>, out: &mut [S]) {
        let seen = self.0.see(s);
        let swing = cross(seen.omega, seen.touch.r);
        let [vx, vy] = s.v();
        let slip = [vx + dot(seen.rows[0], swing), vy + dot(seen.rows[1], swing)];
        let spin = dot(seen.touch.gamma, seen.omega);
        let grip = self.0.friction(s).grip(slip, spin);
        let moving = slide(&seen.body, &seen.touch, &seen.rows, seen.omega, seen.felt[1], seen.torque, &grip);
        let gravity = plus(scaled(seen.rows[0], seen.felt[0]), scaled(seen.rows[2], seen.felt[1]));
        let rolling = roll(&seen.body, &seen.touch, seen.omega, gravity, seen.torque);
        let across = minus(rolling.force, scaled(seen.touch.gamma, dot(seen.touch.gamma, rolling.force)));
        let force = [moving.normal * grip.k[0], moving.normal * grip.k[1], moving.normal];
        let loss = dot(seen.omega, seen.torque);
        let found = Found {
            velocity: [vx, vy],
            slip,
            slip_size: (slip[0] * slip[0] + slip[1] * slip[1]).sqrt(),
            force,
            needed: dot(across, across).sqrt(),
            denominator: moving.denominator,
            power: force[0] * slip[0] + force[1] * slip[1] + moving.normal * grip.drill * spin + loss,
        };
        Top::observe(&seen, [s.coordinates[7], s.coordinates[8]], &found, out);
    }

    fn start(&self, given: &Given, _values: &Values<f64>, y: &mut [f64]) -> Result<(), String> {
        attitude::start(given, y)
    }

    fn check(&self, s: &State<f64>) -> Result<(), String> {
        self.0.check(s)
    }
}

fn table_parameters(card: Card, shaken: bool) -> Card {
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

fn friction_parameters(card: Card) -> Card {
    card.parameter(
        number("mu", "", 0.3, "coefficient of friction", "coefficient de frottement").not_negative(),
    )
    .parameter(
        number(
            "epsilon",
            "m/s",
            1e-3,
            "slip below which friction is smooth",
            "glissement sous lequel le frottement est lissé",
        )
        .positive(),
    )
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
    .parameter(choice("friction", LAWS, "law of friction", "loi de frottement"))
}

/// What the table does, and where.
fn forces(card: Card) -> Card {
    card.signal("kinetic", "J", "kinetic energy", "énergie cinétique")
        .signal("potential", "J", "potential energy", "énergie potentielle")
        .signal("z", "m", "height of the centre of mass", "hauteur du centre de masse")
        .signal("normal", "N", "normal force of the table", "réaction normale de la table")
        .signal("friction_force", "N", "force of friction", "force de frottement")
        .signal(
            "friction_needed",
            "N",
            "friction that rolling without slipping needs",
            "frottement que demande le roulement sans glissement",
        )
        .signal("painleve", "1/kg", "Painleve's denominator", "dénominateur de Painlevé")
        .signal("slip_x", "m/s", "slip along x", "glissement selon x")
        .signal("slip_y", "m/s", "slip along y", "glissement selon y")
        .signal("slip", "m/s", "slip of the contact point", "glissement du point de contact")
        .signal(
            "power",
            "W",
            "power of friction and damping",
            "puissance du frottement et de l'amortissement",
        )
        .signal("spin_axis", "rad/s", "spin about the body's axis", "rotation autour de l'axe du corps")
        .signal("spin", "rad/s", "spin about the vertical", "rotation autour de la verticale")
        .signal(
            "contact_x",
            "m",
            "contact point on the table, abscissa",
            "point de contact sur la table, abscisse",
        )
        .signal(
            "contact_y",
            "m",
            "contact point on the table, ordinate",
            "point de contact sur la table, ordonnée",
        )
        .signal("contact1", "m", "contact point on the body, axis 1", "point de contact sur le corps, axe 1")
        .signal("contact2", "m", "contact point on the body, axis 2", "point de contact sur le corps, axe 2")
        .signal("contact3", "m", "contact point on the body, axis 3", "point de contact sur le corps, axe 3")
}
