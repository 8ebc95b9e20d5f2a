//! The tippe top that rolls without slipping: a sphere whose centre of mass lies off its centre.
//!
//! The centre of the sphere is C, GC = R alpha a, and the sphere touches the table at A, CA = -R k. With
//! omega3 = psi' cos theta + phi' and f3 = I1 I3 + m R^2 I1 sin^2 theta + m R^2 I3 (alpha - cos theta)^2:
//!
//!     theta'' = sin theta / (I1 + m R^2 ((alpha - cos theta)^2 + sin^2 theta))
//!               [ psi'^2 (I1 cos theta - m R^2 (alpha - cos theta) (1 - alpha cos theta))
//!                 + omega3 psi' (m R^2 (alpha cos theta - 1) - I3) - m R^2 alpha theta'^2 - m R alpha g ]  (16)
//!     psi''   = theta' omega3 I3 (I3 + m R^2 (1 - alpha cos theta)) / (f3 sin theta)
//!               - 2 psi' theta' cot theta                                                              (17)
//!     phi''   = psi' theta' sin theta - psi'' cos theta
//!               - omega3 theta' sin theta m R^2 (I3 (alpha - cos theta) + I1 cos theta) / f3           (18)
//!
//! and C moves with omega x R k: `cx' = R omega_y`, `cy' = -R omega_x`. (T, section 6.2.) A test derives the
//! rates again from L' = GA x F in vectors.
//!
//! Constant are the energy, Jellett's -L.GA and Routh's omega3 sqrt(f3). The contact lies on the *complete*
//! sphere (T's note 6). A top that only rolls does not turn over; that takes slipping.

use super::euler_angles::{over_sine, start_on_the_vertical};
use super::truncated_sphere::{ALPHA, I1, I3, MASS, RADIUS};
use crate::rotation::{cross, dot};
use precess_scalar::Scalar;
use precess_system::{Card, Given, State, System, Values, card, coordinate, number};

/// See the module.
#[derive(Clone)]
pub struct TippeTopRolling;

/// T's f3.
#[inline(always)]
fn f3<S: Scalar>(s: &State<S>) -> S {
    let ([_psi, theta], [m, radius, alpha, i1, i3]) = (s.q(), s.p());
    let (sin, cos) = theta.sin_cos();
    let m_r2 = m * radius * radius;
    i1 * i3 + m_r2 * i1 * sin * sin + m_r2 * i3 * (alpha - cos).squared()
}

/// (psi'', theta'', phi'').
#[inline(always)]
fn accelerations<S: Scalar>(s: &State<S>) -> [S; 3] {
    let ([_psi, theta], [psi_dot, theta_dot, phi_dot]) = (s.q(), s.v());
    let [m, radius, alpha, i1, i3, g] = s.p();
    let (sin, cos) = theta.sin_cos();
    let (m_r2, f3) = (m * radius * radius, f3(s));
    let omega3 = psi_dot * cos + phi_dot;
    let off_axis = alpha - cos;
    // The height of G above the table, in radii.
    let height = -(alpha * cos) + 1.0;

    let turning = omega3 * i3 * (i3 + m_r2 * height) / f3 - psi_dot * cos * 2.0;
    let psi_ddot = over_sine(theta_dot * turning, sin);
    let bracket = psi_dot * psi_dot * (i1 * cos - m_r2 * off_axis * height)
        - omega3 * psi_dot * (m_r2 * height + i3)
        - m_r2 * theta_dot * theta_dot * alpha
        - m * radius * alpha * g;
    let theta_ddot = sin / (i1 + m_r2 * (off_axis * off_axis + sin * sin)) * bracket;
    let omega3_dot = -(omega3 * theta_dot * sin * m_r2 * (i3 * off_axis + i1 * cos) / f3);
    [psi_ddot, theta_ddot, omega3_dot + psi_dot * theta_dot * sin - psi_ddot * cos]
}

/// Angular velocity and GA, in the axes (u, b, a).
#[inline(always)]
fn omega_and_arm<S: Scalar>(s: &State<S>) -> [[S; 3]; 2] {
    let ([_psi, theta], [psi_dot, theta_dot, phi_dot]) = (s.q(), s.v());
    let [_m, radius, alpha] = s.p();
    let (sin, cos) = theta.sin_cos();
    let omega = [theta_dot, psi_dot * sin, psi_dot * cos + phi_dot];
    [omega, [S::from(0.0), -(radius * sin), radius * (alpha - cos)]]
}

/// Kinetic and potential energy (zero at the height of the table).
#[inline(always)]
fn energies<S: Scalar>(s: &State<S>) -> (S, S) {
    let ([_psi, theta], [m, radius, alpha, i1, i3, g]) = (s.q(), s.p());
    let [omega, arm] = omega_and_arm(s);
    let v = cross(arm, omega);
    let kinetic = (m * dot(v, v) + dot([i1, i1, i3], omega.map(S::squared))) * 0.5;
    (kinetic, m * g * radius * (-(alpha * theta.cos()) + 1.0))
}

impl System for TippeTopRolling {
    fn card(&self) -> Card {
        card("tippe_top_rolling", "Rolling tippe top", "Toupie chinoise roulante")
            .about(
                "A truncated sphere that rolls without slipping. It rocks and wanders, but does not turn over: a \
                 tippe top needs to slip for that.",
                "Une sphère tronquée qui roule sans glisser. Elle se balance et se promène, mais ne se retourne \
                 pas : il lui faudrait glisser.",
            )
            .source("T, sections 3.3 and 6.2, equations 16 to 18")
            .coordinate(coordinate("psi", "rad", "precession", "précession").start_dot(20.0))
            .coordinate(coordinate("theta", "rad", "nutation", "nutation").start(0.4))
            .coordinate(coordinate("phi", "rad", "proper rotation", "rotation propre").start_dot(120.0))
            .coordinate(
                coordinate("cx", "m", "centre of the sphere, abscissa", "centre de la sphère, abscisse").first_order(),
            )
            .coordinate(
                coordinate("cy", "m", "centre of the sphere, ordinate", "centre de la sphère, ordonnée").first_order(),
            )
            .parameter(number("m", "kg", MASS, "mass", "masse").positive())
            .parameter(number("radius", "m", RADIUS, "radius of the sphere", "rayon de la sphère").positive())
            .parameter(
                number("alpha", "", ALPHA, "distance from G to C, in radii", "distance de G à C, en rayons")
                    .within(0.0, 1.0),
            )
            .parameter(number("i1", "kg m^2", I1, "transverse inertia at G", "inertie transverse en G").positive())
            .parameter(number("i3", "kg m^2", I3, "inertia about the axis", "inertie axiale").positive())
            .parameter(number("g", "m/s^2", 9.81, "gravity", "pesanteur"))
            .invariant("energy", "J", "total energy", "énergie totale")
            .invariant("jellett", "kg m^3/s", "Jellett's constant, -L.GA", "constante de Jellett, -L.GA")
            .invariant("routh", "kg m^2/s", "Routh's constant", "constante de Routh")
            .signal("kinetic", "J", "kinetic energy", "énergie cinétique")
            .signal("potential", "J", "potential energy", "énergie potentielle")
            .signal("omega3", "rad/s", "angular velocity along the axis", "vitesse angulaire selon l'axe")
            .signal("gx", "m", "centre of mass, abscissa", "centre de masse, abscisse")
            .signal("gy", "m", "centre of mass, ordinate", "centre de masse, ordonnée")
            .signal("gz", "m", "height of the centre of mass", "hauteur du centre de masse")
            .signal("contact_x", "m", "contact point, abscissa", "point de contact, abscisse")
            .signal("contact_y", "m", "contact point, ordinate", "point de contact, ordonnée")
            .signal("normal", "N", "normal force of the table", "réaction normale de la table")
            .path_view("contact_x", "contact_y")
            .time_view(&["theta"])
            .run(2.0, 1e-4)
    }

    #[inline(always)]
    fn equations<S: Scalar>(&self, s: &State<S>, highest: &mut [S]) {
        let ([psi, theta], [_psi_dot, theta_dot, phi_dot]) = (s.q(), s.v());
        let [_m, radius] = s.p();
        let ((sin_psi, cos_psi), sin) = (psi.sin_cos(), theta.sin());
        highest[..3].copy_from_slice(&accelerations(s));
        highest[3] = radius * (theta_dot * sin_psi - phi_dot * cos_psi * sin);
        highest[4] = -(radius * (theta_dot * cos_psi + phi_dot * sin_psi * sin));
    }

    #[inline(always)]
    fn observe<S: Scalar>(&self, s: &State<S>, out: &mut [S]) {
        let ([psi, theta, _phi, cx, cy], [_psi_dot, theta_dot]) = (s.q(), s.v());
        let [m, radius, alpha, i1, i3, g] = s.p();
        let ((sin_psi, cos_psi), (sin, cos)) = (psi.sin_cos(), theta.sin_cos());
        let [omega, arm] = omega_and_arm(s);
        let momentum = [i1 * omega[0], i1 * omega[1], i3 * omega[2]];
        let (kinetic, potential) = energies(s);
        let offset = radius * alpha;
        let gx = cx - offset * sin_psi * sin;
        let gy = cy + offset * cos_psi * sin;
        let gz = radius - offset * cos;
        let [_, theta_ddot, _] = accelerations(s);
        let lift = offset * (theta_ddot * sin + theta_dot * theta_dot * cos);
        out[..3].copy_from_slice(&[kinetic + potential, -dot(momentum, arm), omega[2] * f3(s).sqrt()]);
        out[3..9].copy_from_slice(&[kinetic, potential, omega[2], gx, gy, gz]);
        out[9..].copy_from_slice(&[cx, cy, m * (g + lift)]);
    }

    fn start(&self, _given: &Given, values: &Values<f64>, y: &mut [f64]) -> Result<(), String> {
        let [m, radius, alpha, i1, i3] = *values.numbers.first_chunk().expect("the card's parameters");
        let m_r2 = m * radius * radius;
        let cos = Scalar::sign(Scalar::cos(y[1]));
        let f3 = i1 * i3 + m_r2 * i3 * (alpha - cos) * (alpha - cos);
        start_on_the_vertical(y, 5, i3 * (i3 + m_r2 * (1.0 - alpha * cos)) / (2.0 * f3));
        Ok(())
    }

    fn check(&self, s: &State<f64>) -> Result<(), String> {
        let [_m, _radius, _alpha, i1, i3] = s.p();
        super::possible_inertia([i1, i1, i3])
    }
}
