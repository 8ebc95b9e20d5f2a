//! A rigid body of any inertia that turns about a fixed point A under its weight, in quaternions.
//!
//!     I_A omega' = I_A omega x omega + AG x (-m g gamma)      gamma = R^T k, the vertical in body axes
//!     q' = q (0, omega) / 2                                                                     (Euler, Poisson)
//!
//! `AG` is `centre`, in body axes. The moments i1, i2, i3 are those about A, as in the classical cases, or those about G
//! (`about = centre_of_mass`), which are carried to A by Huygens and Steiner.
//!
//! Energy and `L_Az` are always constant. A third constant, which makes the motion regular, is known for the tops of
//! Euler (no weight: L), of Lagrange (`i1 = i2`, centre on axis 3: `L_A3`), and of Kovalevskaya (`i1 = i2 = 2 i3`, centre across
//! axis 3):
//!
//!     | (omega1 + i omega2)^2 - (m g / i3) (c1 + i c2) (gamma1 + i gamma2) |^2
//!
//! With `i1 = i2 = 4 i3`, the centre on axis 1 and `L_Az` = 0 Goryachev and Chaplygin found
//! `omega3 (omega1^2 + omega2^2) - (m g / i3) c1 omega1 gamma3`. Any other top is chaotic somewhere. (Landau and Lifshitz,
//! Mechanics, paragraph 35; S. Kowalevski, Acta Math. 12, 177, 1889.) The signs are those of a centre *above*: they are checked
//! by dual numbers.

use crate::attitude::{self, halves};
use crate::inertia::{Matrix, apply, diagonal, solve, transferred};
use crate::rotation::{cross, dot, quaternion_rate, to_space};
use crate::tops::gyroscope_card::{D, I1, I3, MASS};
use crate::tops::lagrange::{Start, lagrange};
use precess_scalar::Scalar;
use precess_system::{
    Card, Given, Layout, ObservableKind, State, System, Values, card, choice, list, number,
};

/// See the module.
#[derive(Clone)]
pub struct HeavyTop;

/// Inertia about A, and AG.
#[inline(always)]
fn body<S: Scalar>(s: &State<S>) -> (Matrix<S>, [S; 3]) {
    let [m, _g, i1, i2, i3] = s.p();
    let centre = [s.list(0)[0], s.list(0)[1], s.list(0)[2]];
    let given = diagonal([i1, i2, i3]);
    (if s.choice(0) == 0 { given } else { transferred(given, m, centre) }, centre)
}

/// The vertical in body axes: the third row of R.
#[inline(always)]
fn vertical<S: Scalar>([w, x, y, z]: [S; 4]) -> [S; 3] {
    [(x * z - w * y) * 2.0, (y * z + w * x) * 2.0, w * w - x * x - y * y + z * z]
}

/// The product of two complex numbers.
#[inline(always)]
fn times<S: Scalar>([a, b]: [S; 2], [c, d]: [S; 2]) -> [S; 2] {
    [a * c - b * d, a * d + b * c]
}

fn is_symmetric(values: &Values<f64>) -> bool {
    let n = &values.numbers;
    n[2] == n[3] && matches!(values.lists[0].items[..], [0.0, 0.0, _])
}

fn is_kovalevskaya(values: &Values<f64>) -> bool {
    let n = &values.numbers;
    values.choices[0] == 0
        && n[2] == n[3]
        && n[2] == 2.0 * n[4]
        && matches!(values.lists[0].items[..], [_, _, 0.0])
}

impl System for HeavyTop {
    fn card(&self) -> Card {
        let card = card("heavy_top", "Heavy top", "Toupie pesante")
            .about(
                "A rigid body of any shape on a fixed point, under its weight. Three shapes move regularly for ever \
                 (Euler, Lagrange, Kovalevskaya); any other is chaotic somewhere.",
                "Un solide de forme quelconque autour d'un point fixe, soumis à son poids. Trois formes ont toujours un \
                 mouvement régulier (Euler, Lagrange, Kovalevskaïa) ; toute autre est quelque part chaotique.",
            )
            .source("Landau and Lifshitz, Mechanics, paragraph 35; S. Kowalevski, Acta Math. 12, 177 (1889)");
        let (sin, cos) = Scalar::sin_cos(std::f64::consts::PI / 12.0);
        let i_a1 = I1 + MASS * D * D;
        let inertia = |name, default, en, fr| number(name, "kg m^2", default, en, fr).positive();
        let card = attitude::coordinates(card, [cos, sin, 0.0, 0.0], [0.0, 0.0, 60.0])
            .parameter(number("m", "kg", MASS, "mass", "masse").positive())
            .parameter(number("g", "m/s^2", 9.81, "gravity", "pesanteur"))
            .parameter(inertia("i1", i_a1, "inertia about axis 1", "inertie selon l'axe 1"))
            .parameter(inertia("i2", i_a1, "inertia about axis 2", "inertie selon l'axe 2"))
            .parameter(inertia("i3", I3, "inertia about axis 3", "inertie selon l'axe 3"))
            .parameter(
                list(
                    "centre",
                    "m",
                    &[0.0, 0.0, D],
                    "from the fixed point to G, in body axes",
                    "du point fixe à G, dans les axes du corps",
                )
                .at_most(3),
            )
            .parameter(choice(
                "about",
                &["fixed_point", "centre_of_mass"],
                "the point that i1, i2, i3 belong to",
                "le point auquel i1, i2, i3 se rapportent",
            ))
            .invariant("energy", "J", "total energy", "énergie totale")
            .invariant(
                "L_Az",
                "kg m^2/s",
                "angular momentum at A along the vertical",
                "moment cinétique en A selon la verticale",
            )
            .invariant(
                "L_A3",
                "kg m^2/s",
                "angular momentum at A along axis 3",
                "moment cinétique en A selon l'axe 3",
            )
            .signal("kovalevskaya", "1/s^4", "Kovalevskaya's constant", "constante de Kovalevskaïa")
            .signal(
                "goryachev_chaplygin",
                "1/s^3",
                "Goryachev and Chaplygin's constant",
                "constante de Goriatchev et Tchaplyguine",
            )
            .invariant("norm", "", "length of the quaternion", "norme du quaternion")
            .signal("kinetic", "J", "kinetic energy", "énergie cinétique")
            .signal("potential", "J", "potential energy", "énergie potentielle");
        attitude::angles(card)
            .signal("axis_x", "", "axis 3 in space, along x", "axe 3 dans l'espace, selon x")
            .signal("axis_y", "", "axis 3 in space, along y", "axe 3 dans l'espace, selon y")
            .signal("axis_z", "", "axis 3 in space, upwards", "axe 3 dans l'espace, vers le haut")
            .signal("gx", "m", "centre of mass, abscissa", "centre de masse, abscisse")
            .signal("gy", "m", "centre of mass, ordinate", "centre de masse, ordonnée")
            .signal("gz", "m", "height of the centre of mass", "hauteur du centre de masse")
            .signal("gamma1", "", "vertical along axis 1", "verticale selon l'axe 1")
            .signal("gamma2", "", "vertical along axis 2", "verticale selon l'axe 2")
            .signal("gamma3", "", "vertical along axis 3", "verticale selon l'axe 3")
            .signal("L_A", "kg m^2/s", "angular momentum at A", "moment cinétique en A")
            .signal("triple", "J", "axis . (omega x L_A)", "axe . (omega x L_A)")
            .path_view("axis_x", "axis_y")
            .time_view(&["theta"])
            .time_view(&["omega1", "omega2", "omega3"])
            .run(2.0, 1e-4)
    }

    /// `L_A3` and Kovalevskaya's constant are constant for their tops alone.
    fn layout(&self, values: &Values<f64>, _given: &Given) -> Layout {
        let mut layout = Layout::of(&self.card());
        if !is_symmetric(values) {
            layout.observables[2].kind = ObservableKind::Signal;
        }
        if is_kovalevskaya(values) {
            layout.observables[3].kind = ObservableKind::Invariant { when_zero: vec![] };
        }
        layout
    }

    #[inline(always)]
    fn equations<S: Scalar>(&self, s: &State<S>, highest: &mut [S]) {
        let (attitude, omega) = halves(s);
        let [m, g, i1, i2, i3] = s.p();
        let (inertia, centre) = body(s);
        // Moments about A are principal there: three divisions of which none waits for another, where elimination has a chain.
        let principal = s.choice(0) == 0;
        let [o1, o2, o3] = omega;
        let momentum = if principal { [i1 * o1, i2 * o2, i3 * o3] } else { apply(inertia, omega) };
        let (gyration, [g1, g2, g3]) = (cross(momentum, omega), vertical(attitude));
        let weight = cross(centre, [-(m * g * g1), -(m * g * g2), -(m * g * g3)]);
        let [m1, m2, m3] = [gyration[0] + weight[0], gyration[1] + weight[1], gyration[2] + weight[2]];
        highest[..4].copy_from_slice(&quaternion_rate(attitude, omega));
        let turning = if principal { [m1 / i1, m2 / i2, m3 / i3] } else { solve(inertia, [m1, m2, m3]) };
        highest[4..7].copy_from_slice(&turning);
    }

    #[inline(always)]
    fn observe<S: Scalar>(&self, s: &State<S>, out: &mut [S]) {
        let (attitude, omega) = halves(s);
        let [m, g, _i1, _i2, i3] = s.p();
        let (inertia, centre) = body(s);
        let (gamma, momentum) = (vertical(attitude), apply(inertia, omega));
        let [zero, one] = [0.0, 1.0].map(S::from);
        let axis = [zero, zero, one];
        let (kinetic, potential) = (dot(momentum, omega) * 0.5, m * g * dot(centre, gamma));
        let weight = m * g / i3;
        let square = times([omega[0], omega[1]], [omega[0], omega[1]]);
        let moment = times([centre[0], centre[1]], [gamma[0], gamma[1]]).map(|part| weight * part);
        out[0] = kinetic + potential;
        out[1] = dot(momentum, gamma);
        out[2] = momentum[2];
        out[3] = (square[0] - moment[0]).squared() + (square[1] - moment[1]).squared();
        out[4] =
            omega[2] * (omega[0] * omega[0] + omega[1] * omega[1]) - weight * centre[0] * omega[0] * gamma[2];
        let [qw, qx, qy, qz] = attitude.map(S::squared);
        out[5] = (qw + qx + qy + qz).sqrt();
        out[6..8].copy_from_slice(&[kinetic, potential]);
        attitude::observe(attitude, omega, &mut out[8..14]);
        out[14..17].copy_from_slice(&to_space(attitude, axis));
        out[17..20].copy_from_slice(&to_space(attitude, centre));
        out[20..23].copy_from_slice(&gamma);
        out[23] = dot(momentum, momentum).sqrt();
        out[24] = dot(axis, cross(omega, momentum));
    }

    fn solvable(&self, s: &State<f64>) -> Result<(), String> {
        let (inertia, centre) = body(s);
        let [m, g] = s.p();
        if !is_symmetric(s.values) {
            return Err(
                "only the symmetric heavy top has a closed form here: i1 = i2, and its centre on axis 3"
                    .into(),
            );
        }
        if m * g * centre[2] == 0.0 || inertia[0][0] != inertia[1][1] {
            return Err("without weight it is a free body: free_body has that motion in closed form".into());
        }
        Ok(())
    }

    #[inline(always)]
    fn solution<S: Scalar>(&self, s: &State<S>, t: S, q: &mut [S], _v: &mut [S]) {
        let ([w, x, y, z], omega) = halves(s);
        let ([m, g], ([[i_a1, ..], _, [_, _, i3]], centre)) = (s.p(), body(s));
        let zero = S::from(0.0);
        let (above, below) = ((w * w + z * z) * 2.0, (x * x + y * y) * 2.0);
        let (half_sum, half_difference) = (z.atan2(w), y.atan2(x));
        // On the vertical one of the two is free: theta' is then all of the angular velocity across.
        let leaving = S::select(above.le(zero), S::from(-1.0), S::from(1.0));
        let free = (-(omega[1] * leaving)).atan2(omega[0] * leaving);
        let phi = S::select(above.le(zero) | below.le(zero), free, half_sum - half_difference);
        let half_difference = S::select(below.le(zero), half_sum - phi, half_difference);
        let half_sum = S::select(above.le(zero), half_difference + phi, half_sum);
        let (sin_phi, cos_phi) = phi.sin_cos();
        let start = Start {
            above,
            below,
            sin: (above * below).sqrt(),
            omega: [
                omega[0] * cos_phi - omega[1] * sin_phi,
                omega[0] * sin_phi + omega[1] * cos_phi,
                omega[2],
            ],
            beta: m * g * centre[2] * 2.0 / i_a1,
            a: i3 * omega[2] / i_a1,
        };
        let now = lagrange(&start, t - s.t);
        let (sin_sum, cos_sum) = (half_sum + (now.psi + now.phi) * 0.5).sin_cos();
        let (sin_difference, cos_difference) = (half_difference + (now.psi - now.phi) * 0.5).sin_cos();
        let (cos, sin) = ((now.above * 0.5).sqrt(), (now.below * 0.5).sqrt());
        let (sin_phi, cos_phi) = (phi + now.phi).sin_cos();
        let [o1, o2] = now.omega;
        q.copy_from_slice(&[
            cos * cos_sum,
            sin * cos_difference,
            sin * sin_difference,
            cos * sin_sum,
            o1 * cos_phi + o2 * sin_phi,
            o2 * cos_phi - o1 * sin_phi,
            omega[2],
        ]);
    }

    fn start(&self, given: &Given, _values: &Values<f64>, y: &mut [f64]) -> Result<(), String> {
        attitude::start(given, y)
    }

    fn check(&self, s: &State<f64>) -> Result<(), String> {
        let [_m, _g, i1, i2, i3] = s.p();
        if s.list(0).len() != 3 {
            return Err(format!("the centre has three coordinates, not {}", s.list(0).len()));
        }
        super::possible_inertia([i1, i2, i3])
    }
}
