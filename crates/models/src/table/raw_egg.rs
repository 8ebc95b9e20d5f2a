//! A raw egg: a simple model of two bodies, and no more than that.
//!
//! What is liquid is taken for one ball, the core, that turns about the egg's centre inside a rigid shell; both rub like a
//! viscous film would. With omega of the shell, Omega of the core (`I_c` its inertia, any axis) and the coupling k:
//!
//!     I omega' + omega x I omega = (the table) - k (omega - Omega),     I_c Omega' = k (omega - Omega)   (Omega in space)
//!     energy' = friction.slip - k |omega - Omega|^2
//!
//! The core stays in the centre, so it adds its weight (m is the whole mass) and its turning, and nothing else: no sloshing, no
//! yolk off the centre, no flow inside the liquid. What one sees with an egg on a table is in it all the same. The
//! shell's spin sinks quickly to what both have together; an egg that is stopped for a moment and let go turns on. A very large
//! coupling makes it the boiled egg of inertia `I + I_c`, which a test holds it against.
//!
//! Without a table's friction the vertical angular momentum of both is constant.

use super::body::{length, plus, scaled};
use super::check::check;
use super::form::Form;
use super::friction::Friction;
use super::measure::{Found, contact, measure, motion};
use super::parameters::{smooth, table};
use super::regimes::SLIDES;
use super::rolling::roll;
use super::slider::Slider;
use super::sliding::slide;
use super::top::{Seen, Top};
use crate::attitude;
use crate::inertia::apply;
use crate::rotation::{Vector, dot, from_euler, quaternion_rate};
use precess_scalar::Scalar;
use precess_system::{Card, Given, Parameter, State, System, Values, card, coordinate, number};

/// See the module.
#[derive(Clone)]
pub struct RawEgg;

/// The shell. The numbers of a state: attitude, omega, Omega, the place of G.
const SHELL: Top = Top {
    form: Form::Spheroid,
    card: text,
    parameters,
    angles: [0.0, 1.5, 0.0],
    omega: [0.0, 120.0, 0.0],
    speed: 0.0,
    run,
};
/// Where Omega stands among the coordinates, and G.
const CORE: usize = attitude::COORDINATES;
const PLACE: usize = CORE + 3;

fn text() -> Card {
    card("raw_egg", "Raw egg", "Œuf cru").about(
        "A shell with a ball inside that turns on its own: a simple model of a raw egg. Spun on its side it slows down and stays down, where the boiled egg rises; stopped for a moment, it turns on.",
        "Une coquille et, dedans, une boule qui tourne librement : un modèle simple de l'œuf cru. Lancé sur le flanc, il ralentit et reste couché, alors que l'œuf dur se dresse ; arrêté un instant, il repart.",
    ).source("this program's own model; the boiled egg: H. K. Moffatt and Y. Shimomura, Nature 416, 385 (2002)")
}

fn parameters() -> Vec<Parameter> {
    vec![
        number("m", "kg", 0.06, "mass of shell and core", "masse de la coquille et du noyau").positive(),
        number("a", "m", 0.03, "semi-axis along the axis", "demi-axe selon l'axe").positive(),
        number("b", "m", 0.02, "semi-axis across", "demi-axe transverse").positive(),
        number(
            "h",
            "m",
            0.0,
            "height of the spheroid's centre above G along the axis",
            "position du centre du sphéroïde, depuis G, selon l'axe",
        ),
        number(
            "i1",
            "kg m^2",
            9.6e-6,
            "transverse inertia of the shell",
            "inertie transverse de la coquille",
        )
        .positive(),
        number(
            "i3",
            "kg m^2",
            3.6e-6,
            "inertia of the shell about the axis",
            "inertie axiale de la coquille",
        )
        .positive(),
    ]
}

fn run(card: Card) -> Card {
    card.time_view(&["spin", "core_spin"])
        .time_view(&["theta"])
        .path_view("contact_x", "contact_y")
        .run(4.0, 1e-4)
}

/// What the core adds.
struct Core<S> {
    /// In space.
    omega: Vector<S>,
    inertia: S,
    coupling: S,
    friction: Friction<S>,
}

/// A point of the motion: the shell, with the core's torque on it, and the core.
#[inline(always)]
fn see<S: Scalar>(s: &State<S>) -> (Seen<S>, Core<S>) {
    let mut seen = SHELL.see(s);
    let p = &s.values.numbers[SHELL.form.count() + SHELL.of_table()..];
    let (mu, epsilon) = (p[0], p[1]);
    let friction = Friction { law: 0, mu, epsilon, speed: S::from(1.0), spot: S::from(0.0) };
    let omega = [s.coordinates[CORE], s.coordinates[CORE + 1], s.coordinates[CORE + 2]];
    let core = Core { omega, inertia: p[2], coupling: p[3], friction };
    let [x, y, z] = seen.rows;
    let inside = plus(plus(scaled(x, omega[0]), scaled(y, omega[1])), scaled(z, omega[2]));
    seen.torque = plus(seen.torque, scaled(plus(inside, scaled(seen.omega, S::from(-1.0))), core.coupling));
    (seen, core)
}

impl System for RawEgg {
    fn card(&self) -> Card {
        let card = attitude::coordinates(text(), from_euler(SHELL.angles), SHELL.omega);
        let card = ["x", "y", "z"].into_iter().fold(card, |card, axis| {
            let en = format!("angular velocity of the core along {axis}");
            let fr = format!("vitesse angulaire du noyau selon {axis}");
            card.coordinate(coordinate(&format!("core_{axis}"), "rad/s", &en, &fr).first_order())
        });
        let card = card
            .coordinate(coordinate("x", "m", "centre of mass, abscissa", "centre de masse, abscisse"))
            .coordinate(coordinate("y", "m", "centre of mass, ordinate", "centre de masse, ordonnée"));
        let card = smooth(table(parameters().into_iter().fold(card, Card::parameter), false))
            .parameter(number("core", "kg m^2", 6e-6, "inertia of the core", "inertie du noyau").positive())
            .parameter(
                number(
                    "coupling",
                    "kg m^2/s",
                    6e-6,
                    "torque between shell and core by angular velocity",
                    "couple entre coquille et noyau par vitesse angulaire",
                )
                .not_negative(),
            );
        let card = card
            .invariant_if("energy", "J", &["damping", "mu", "coupling"], "total energy", "énergie totale")
            .signal(
                "jellett",
                "kg m^3/s",
                "Jellett's quantity of the shell",
                "grandeur de Jellett de la coquille",
            );
        let card = attitude::angles(contact(motion(card)))
            .signal(
                "core_spin",
                "rad/s",
                "spin of the core about the vertical",
                "rotation du noyau autour de la verticale",
            )
            .invariant_if(
                "Lz",
                "kg m^2/s",
                &["damping", "mu"],
                "vertical angular momentum of shell and core about G",
                "moment cinétique vertical de la coquille et du noyau en G",
            );
        run(card)
    }

    #[inline(always)]
    fn equations<S: Scalar>(&self, s: &State<S>, highest: &mut [S]) {
        let (seen, core) = see(s);
        let grip = core.friction.grip(Slider::slip(&seen, s), S::from(0.0));
        let moving = slide(&seen.body, &seen.touch, &seen.rows, seen.omega, seen.felt[1], seen.torque, &grip);
        highest[..4].copy_from_slice(&quaternion_rate(seen.attitude, seen.omega));
        highest[4..CORE].copy_from_slice(&moving.omega_dot);
        let shell = seen.on_table(seen.omega);
        for i in 0..3 {
            highest[CORE + i] = core.coupling * (shell[i] - core.omega[i]) / core.inertia;
        }
        highest[PLACE] = moving.pressed * grip.k[0] / seen.body.mass + seen.felt[0];
        highest[PLACE + 1] = moving.pressed * grip.k[1] / seen.body.mass;
    }

    #[inline(always)]
    fn observe<S: Scalar>(&self, s: &State<S>, out: &mut [S]) {
        let (seen, core) = see(s);
        let zero = S::from(0.0);
        let slip = Slider::slip(&seen, s);
        let grip = core.friction.grip(slip, zero);
        let moving = slide(&seen.body, &seen.touch, &seen.rows, seen.omega, seen.felt[1], seen.torque, &grip);
        let [height, rise] = super::measure::height(&seen);
        let [fx, fy, _] =
            seen.on_table(roll(&seen.body, &seen.touch, seen.omega, seen.gravity(), seen.torque).force);
        let found = Found {
            place: [s.coordinates[PLACE], s.coordinates[PLACE + 1]],
            velocity: s.v(),
            height,
            rise,
            slip,
            force: [moving.pressed * grip.k[0], moving.pressed * grip.k[1], moving.normal],
            drill: zero,
            needed: length([fx, fy]),
            denominator: moving.denominator,
            regime: S::from(SLIDES),
        };
        measure(&SHELL, &seen, &found, out);
        // What turns in the shell: its energy, and the power that the film takes from the core.
        let turning = core.inertia * dot(core.omega, core.omega) * 0.5;
        out[0] = out[0] + turning;
        out[2] = out[2] + turning;
        let shell = seen.on_table(seen.omega);
        let behind = [shell[0] - core.omega[0], shell[1] - core.omega[1], shell[2] - core.omega[2]];
        out[15] = out[15] + core.coupling * dot(core.omega, behind);
        let last = out.len() - 2;
        out[last] = core.omega[2];
        out[last + 1] =
            dot(seen.rows[2], apply(seen.body.inertia, seen.omega)) + core.inertia * core.omega[2];
    }

    fn start(&self, given: &Given, _values: &Values<f64>, y: &mut [f64]) -> Result<(), String> {
        attitude::start(given, y)
    }

    fn check(&self, s: &State<f64>) -> Result<(), String> {
        check(&SHELL, s)
    }
}
