//! The tops against second formulations: closed forms of their bodies, vectors instead of angles.

mod common;
use common::{Ready, ready};
use precess_scalar::Scalar;
use std::f64::consts::PI;

type Vector = [f64; 3];

fn cross(a: Vector, b: Vector) -> Vector {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}
fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}
fn add(a: Vector, b: Vector) -> Vector {
    std::array::from_fn(|i| a[i] + b[i])
}
fn times(a: Vector, k: f64) -> Vector {
    a.map(|x| x * k)
}

#[track_caller]
fn close(a: f64, b: f64, part: f64) {
    assert!((a - b).abs() <= part * (a.abs() + b.abs()), "{a} is not {b}");
}

/// Sums a solid of revolution over discs: mass, height of G, I1 at G, I3.
fn solid(density: f64, low: f64, high: f64, square_radius: impl Fn(f64) -> f64) -> [f64; 4] {
    const SLICES: usize = 20_000;
    let thickness = (high - low) / SLICES as f64;
    let [mut m, mut first, mut second, mut i3] = [0.0; 4];
    for k in 0..SLICES {
        let z = low + (k as f64 + 0.5) * thickness;
        let square = square_radius(z);
        let slice = PI * density * square * thickness;
        m += slice;
        first += slice * z;
        second += slice * z * z;
        i3 += slice * square / 2.0;
    }
    let centre = first / m;
    [m, centre, i3 / 2.0 + second - m * centre * centre, i3]
}

#[test]
fn the_default_gyroscope_is_the_cone_of_the_source() {
    let top = ready("gyroscope");
    let [m, d, i1, i3] = solid(100.0, 0.0, 0.15, |z| (z / 3.0) * (z / 3.0));
    for (name, expected) in [("m", m), ("d", d), ("i1", i1), ("i3", i3)] {
        close(top.value(name), expected, 1e-8);
    }
    // T's remark in 3.3: the inertia about the tip.
    let (m, i_a1) = (top.value("m"), top.value("i1") + top.value("m") * top.value("d") * top.value("d"));
    close(i_a1, m * (3.0 / 20.0 * 0.05 * 0.05 + 3.0 / 5.0 * 0.15 * 0.15), 1e-15);
}

#[test]
fn the_default_tippe_top_is_the_truncated_sphere_of_the_source() {
    let top = ready("tippe_top_rolling");
    let (radius, cut) = (0.02, 0.015);
    let [m, centre, i1, i3] = solid(700.0, -radius, radius - cut, |z| radius * radius - z * z);
    for (name, expected) in [("m", m), ("alpha", -centre / radius), ("i1", i1), ("i3", i3)] {
        close(top.value(name), expected, 1e-7);
    }
}

/// A slow regular precession: `I3 omega3 psi' - I_A1 psi'^2 cos theta = m g d` leaves theta at rest.
#[test]
fn a_gyroscope_precesses_at_the_rate_of_the_closed_form() {
    let top = ready("gyroscope");
    let [m, i1, i3, d, g] = ["m", "i1", "i3", "d", "g"].map(|name| top.value(name));
    let (i_a1, theta, omega3) = (i1 + m * d * d, 0.7, 300.0);
    let cos = Scalar::cos(theta);
    let (a, b, c) = (i_a1 * cos, i3 * omega3, m * g * d);
    let psi_dot = 2.0 * c / (b + (b * b - 4.0 * a * c).sqrt());
    let phi_dot = omega3 - psi_dot * cos;
    let y =
        top.start(&[("theta", theta), ("psi_dot", psi_dot), ("phi_dot", phi_dot)]).expect("a sound start");
    let rate = top.rate(&y);
    assert!(rate[4].abs() < 1e-11 * c / i_a1, "theta'' = {}", rate[4]);
    assert_eq!([rate[3], rate[5]], [0.0, 0.0]);
}

/// omega' of the rolling tippe top in axes fixed in the body with phi = 0 now, from
/// (I + m (r.r 1 - r r^T)) omega' = - omega x I omega + m r x (r' x omega) + m r x (omega x (r x omega)) + m g r x gamma.
fn rolling_omega_dot(top: &Ready, theta: f64, omega: Vector) -> Vector {
    let [m, radius, alpha, i1, i3, g] = ["m", "radius", "alpha", "i1", "i3", "g"].map(|name| top.value(name));
    let inertia = [i1, i1, i3];
    let (sin, cos) = Scalar::sin_cos(theta);
    let gamma = [0.0, sin, cos];
    let gamma_dot = cross(gamma, omega);
    let r = add([0.0, 0.0, radius * alpha], times(gamma, -radius));
    let r_dot = times(gamma_dot, -radius);
    let spin = cross(omega, std::array::from_fn(|i| inertia[i] * omega[i]));
    let drift = add(cross(r_dot, omega), cross(omega, cross(r, omega)));
    let moment = add(times(cross(r, add(drift, times(gamma, g))), m), times(spin, -1.0));
    let matrix: [Vector; 3] = std::array::from_fn(|i| {
        std::array::from_fn(|j| {
            let diagonal = if i == j { inertia[i] + m * dot(r, r) } else { 0.0 };
            diagonal - m * r[i] * r[j]
        })
    });
    solve(matrix, moment)
}

/// Cramer's rule.
fn solve(m: [Vector; 3], b: Vector) -> Vector {
    let columns: [Vector; 3] = std::array::from_fn(|j| std::array::from_fn(|i| m[i][j]));
    let determinant = dot(columns[0], cross(columns[1], columns[2]));
    [
        dot(b, cross(columns[1], columns[2])) / determinant,
        dot(columns[0], cross(b, columns[2])) / determinant,
        dot(columns[0], cross(columns[1], b)) / determinant,
    ]
}

#[test]
fn the_tippe_top_rolls_as_vectors_say() {
    let top = ready("tippe_top_rolling");
    for k in 0..200 {
        let x = f64::from(k);
        // Spread over attitudes and spins without a pattern that could hide a term.
        let theta = 0.05 + 3.0 * Scalar::sin(x * 0.37).abs();
        let [psi_dot, theta_dot, phi_dot] = [1.1, 1.7, 2.3].map(|f| 30.0 * Scalar::sin(x * f + f));
        let names = [("theta", theta), ("psi_dot", psi_dot), ("theta_dot", theta_dot), ("phi_dot", phi_dot)];
        let rate = top.rate(&top.start(&names).expect("a sound start"));
        let [psi_ddot, theta_ddot, phi_ddot] = [rate[5], rate[6], rate[7]];

        let (sin, cos) = Scalar::sin_cos(theta);
        let omega = [theta_dot, psi_dot * sin, psi_dot * cos + phi_dot];
        let expected = rolling_omega_dot(&top, theta, omega);
        // The derivatives of the components in (u, b, a) and in body axes differ by the proper rotation.
        let found = [
            theta_ddot + phi_dot * omega[1],
            psi_ddot * sin + psi_dot * theta_dot * cos - phi_dot * omega[0],
            phi_ddot + psi_ddot * cos - psi_dot * theta_dot * sin,
        ];
        let size = expected.iter().map(|x| x.abs()).sum::<f64>() + dot(omega, omega);
        for (a, b) in found.iter().zip(expected) {
            assert!((a - b).abs() <= 1e-13 * size, "theta = {theta}: {found:?} is not {expected:?}");
        }
    }
}

/// The centre moves with R omega x k, omega in space.
#[test]
fn the_centre_of_the_tippe_top_follows_its_rotation() {
    let top = ready("tippe_top_rolling");
    let (psi, theta, radius) = (0.7, 1.1, top.value("radius"));
    let rates = [3.0, -2.0, 5.0];
    let ((sin_psi, cos_psi), (sin, cos)) = (Scalar::sin_cos(psi), Scalar::sin_cos(theta));
    let k = [0.0, 0.0, 1.0];
    let (u, a) = ([cos_psi, sin_psi, 0.0], [sin_psi * sin, -cos_psi * sin, cos]);
    let omega = add(times(k, rates[0]), add(times(u, rates[1]), times(a, rates[2])));
    let names = [("psi", psi), ("theta", theta), ("psi_dot", 3.0), ("theta_dot", -2.0), ("phi_dot", 5.0)];
    let rate = top.rate(&top.start(&names).expect("a sound start"));
    let expected = times(cross(omega, k), radius);
    close(rate[3], expected[0], 1e-15);
    close(rate[4], expected[1], 1e-15);
}

#[test]
fn a_start_on_the_vertical_is_refused() {
    for id in ["gyroscope", "tippe_top_rolling"] {
        let top = ready(id);
        for theta in [0.0, PI, -PI] {
            let refusal = top.start(&[("theta", theta)]).expect_err("the axis is vertical");
            assert!(refusal.contains("heavy_top"), "{refusal}");
        }
        let rate = top.rate(&top.start(&[("theta", 1e-6)]).expect("close to it is fine"));
        assert!(rate.iter().all(|x| x.is_finite()));
    }
}

#[test]
fn a_free_body_starts_by_euler_angles() {
    let body = ready("free_body");
    let angles = [("psi", 0.4), ("theta", 0.9), ("phi", -1.3)];
    let rates = [("psi_dot", 2.0), ("theta_dot", -0.5), ("phi_dot", 3.0)];
    let y = body.start(&[angles, rates].concat()).expect("a sound start");
    for (name, x) in angles.into_iter().chain(rates) {
        close(body.observe(&y, name), x, 1e-14);
    }
    close(body.observe(&y, "norm"), 1.0, 1e-15);
    // The third axis of the body stands where T's matrix S puts it.
    close(body.observe(&y, "axis_x"), Scalar::sin(0.4) * Scalar::sin(0.9), 1e-14);
    close(body.observe(&y, "axis_y"), -Scalar::cos(0.4) * Scalar::sin(0.9), 1e-14);
}

#[test]
fn a_free_body_keeps_its_angles_where_only_rates_are_given() {
    let body = ready("free_body");
    let half = 0.5_f64.sqrt();
    let y = body.start(&[("qw", half), ("qx", half), ("phi_dot", 2.0)]).expect("a sound start");
    close(body.observe(&y, "theta"), PI / 2.0, 1e-15);
    assert_eq!(y[4..7], [0.0, 0.0, 2.0]);
}

#[test]
fn a_free_body_refuses_what_makes_no_sense() {
    let mut body = ready("free_body");
    let y = body.start(&[("qw", 3.0), ("qz", 4.0)]).expect("a quaternion of any length");
    assert_eq!(y[..4], [0.6, 0.0, 0.0, 0.8]);
    let refusal = |starts: &[(&str, f64)]| body.start(starts).expect_err("this makes no sense");
    assert!(refusal(&[("qw", 0.0)]).contains("zero"));
    assert!(refusal(&[("qw", 1.0), ("theta", 1.0)]).contains("twice"));
    assert!(refusal(&[("omega1", 1.0), ("psi_dot", 1.0)]).contains("twice"));
    body.set("i3", 3.1);
    assert!(body.start(&[]).expect_err("no such body").contains("i3"));
}

/// Where the axis is vertical the angles still add up to the rotation about it.
#[test]
fn an_upright_body_has_finite_angles() {
    let body = ready("free_body");
    let y = body.start(&[("psi", 0.5), ("omega3", 1.2)]).expect("a sound start");
    close(body.observe(&y, "psi") + body.observe(&y, "phi"), 0.5, 1e-15);
    close(body.observe(&y, "psi_dot") + body.observe(&y, "phi_dot"), 1.2, 1e-15);
}
