//! A chain of point masses on massless rods, hung from a pivot, in a vertical plane.
//!
//! Rod i has the length `l_i`, ends at the mass `m_i` and points along `u_i`, at the angle `theta_i` from the downward
//! vertical; `t_i` is perpendicular. With the tensions `T_i` the masses have the accelerations
//!
//!     a_i = g + (T_{i+1} u_{i+1} - T_i u_i) / m_i
//!
//! and the rods keep their lengths, which makes a tridiagonal system for the tensions:
//!
//!     u_i . (a_i - a_{i-1}) = -l_i theta_i'^2
//!     (1/m_i + 1/m_{i-1}) T_i - (u_i.u_{i+1} / m_i) T_{i+1} - (u_i.u_{i-1} / m_{i-1}) T_{i-1} = l_i theta_i'^2
//!     l_i theta_i'' = t_i . (a_i - a_{i-1})
//!
//! The pivot counts as a mass without bounds, and the weight, g times the cosine of the first angle, enters the first
//! equation alone. The work grows with the number of rods, not with its cube as it does for the Lagrange equations,
//! against which the laws hold this form. Two rods are the `double_pendulum`.

use precess_scalar::Scalar;
use precess_system::{
    Card, Coordinate, Given, Layout, State, System, Values, card, coordinate, list, number,
};

/// See the module.
#[derive(Clone)]
pub struct NPendulum;

/// The longest chain.
const MOST: usize = 64;

impl System for NPendulum {
    fn card(&self) -> Card {
        let card = card("n_pendulum", "Chain of pendulums", "Chaîne de pendules")
            .about(
                "Pendulums hung one from another, as many as there are masses: three whip about in chaos, twenty are a \
                 chain.",
                "Des pendules accrochés l'un à l'autre, autant que de masses : trois fouettent l'air dans le chaos, vingt \
                 font une chaîne.",
            )
            .source("beyond P; W. Schiehlen, Multibody System Dynamics 1, 149 (1997)")
            .parameter(number("g", "m/s^2", 9.81, "gravity", "pesanteur"))
            .parameter(list("masses", "kg", &[1.0; 3], "masses, from the top", "masses, depuis le haut").positive().symbol("m").at_most(MOST))
            .parameter(list("lengths", "m", &[1.0; 3], "lengths of the rods, from the top", "longueurs des tiges, depuis le haut").positive().symbol("l").at_most(MOST))
            .invariant("energy", "J", "total energy", "énergie totale")
            .signal("kinetic", "J", "kinetic energy", "énergie cinétique")
            .signal("potential", "J", "potential energy, zero at the pivot's height", "énergie potentielle, nulle à la hauteur du pivot")
            .signal("x", "m", "last mass, horizontally", "dernière masse, horizontalement")
            .signal("y", "m", "last mass, upwards from the pivot", "dernière masse, vers le haut depuis le pivot")
            .path_view("x", "y")
            .time_view(&["theta1", "theta2", "theta3"])
            .run(20.0, 0.001);
        angles(3).into_iter().fold(card, Card::coordinate)
    }

    fn layout(&self, values: &Values<f64>, _given: &Given) -> Layout {
        Layout { coordinates: angles(values.lists[0].items.len()).into(), ..Layout::of(&self.card()) }
    }

    fn check(&self, s: &State<f64>) -> Result<(), String> {
        let (masses, lengths) = (s.list(0).len(), s.list(1).len());
        if masses == lengths {
            return Ok(());
        }
        Err(format!("there are {masses} masses and {lengths} lengths: each mass hangs on a rod of its own"))
    }

    #[inline(always)]
    fn equations<S: Scalar>(&self, s: &State<S>, highest: &mut [S]) {
        let ([g], masses, lengths) = (s.p(), s.list(0), s.list(1));
        let (n, zero) = (s.coordinates.len(), S::from(0.0));
        // Elimination from the top: T_i = base_i + slope_i T_{i+1}. `turn` holds u_i and the angle to the next rod.
        let (mut base, mut slope) = ([zero; MOST], [zero; MOST]);
        let mut between = [(zero, S::from(1.0)); MOST];
        let (sin1, cos1) = s.coordinates[0].sin_cos();
        for i in 0..n {
            let last = i + 1 == n;
            // Sine and cosine of theta_{i+1} - theta_i.
            between[i] =
                if last { (zero, zero) } else { (s.coordinates[i + 1] - s.coordinates[i]).sin_cos() };
            let mut diagonal = S::from(1.0) / masses[i];
            let mut right = lengths[i] * s.velocities[i].squared();
            if i == 0 {
                right = right + g * cos1;
            } else {
                let above = between[i - 1].1 / masses[i - 1];
                diagonal = diagonal + S::from(1.0) / masses[i - 1] - above * slope[i - 1];
                right = right + above * base[i - 1];
            }
            base[i] = right / diagonal;
            slope[i] = between[i].1 / masses[i] / diagonal;
        }
        for i in (0..n - 1).rev() {
            base[i] = base[i] + slope[i] * base[i + 1];
        }
        // t_i . u_{i+1} = sin(theta_{i+1} - theta_i), t_i . u_{i-1} = -sin(theta_i - theta_{i-1}).
        let tension = base;
        for i in 0..n {
            let mut across = if i + 1 < n { tension[i + 1] * between[i].0 / masses[i] } else { zero };
            across = if i == 0 {
                across - g * sin1
            } else {
                across - tension[i - 1] * between[i - 1].0 / masses[i - 1]
            };
            highest[i] = across / lengths[i];
        }
    }

    #[inline(always)]
    fn observe<S: Scalar>(&self, s: &State<S>, out: &mut [S]) {
        let (kinetic, potential, place) = parts(s);
        out.copy_from_slice(&[kinetic + potential, kinetic, potential, place[0], place[1]]);
    }

    #[inline(always)]
    fn lagrangian<S: Scalar>(&self, s: &State<S>) -> Option<S> {
        let (kinetic, potential, _) = parts(s);
        Some(kinetic - potential)
    }
}

fn angles(n: usize) -> Vec<Coordinate> {
    let angle = |i: usize| {
        let (en, fr) = (
            format!("angle of rod {i} from the vertical"),
            format!("angle de la tige {i} avec la verticale"),
        );
        coordinate(&format!("theta{i}"), "rad", &en, &fr).start(2.0)
    };
    (1..=n).map(angle).collect()
}

/// Energies, and the place of the last mass.
#[inline(always)]
fn parts<S: Scalar>(s: &State<S>) -> (S, S, [S; 2]) {
    let ([g], masses, lengths, zero) = (s.p(), s.list(0), s.list(1), S::from(0.0));
    let (mut kinetic, mut potential, mut place, mut velocity) = (zero, zero, [zero; 2], [zero; 2]);
    for i in 0..s.coordinates.len() {
        let (sin, cos) = s.coordinates[i].sin_cos();
        let speed = lengths[i] * s.velocities[i];
        place = [place[0] + lengths[i] * sin, place[1] - lengths[i] * cos];
        velocity = [velocity[0] + speed * cos, velocity[1] + speed * sin];
        kinetic = kinetic + masses[i] * (velocity[0].squared() + velocity[1].squared()) * 0.5;
        potential = potential + masses[i] * g * place[1];
    }
    (kinetic, potential, place)
}
