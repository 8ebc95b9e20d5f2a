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

/// On the vertical the limit holds: psi'' = 0 with `psi' = i3 omega3 / (2 I_A1)`, minus that at pi. Close to it the numerator of
/// (2) is then as small as sin theta, so the acceleration stays small; without the limit it is large.
#[test]
fn a_start_on_the_vertical_takes_the_limit() {
    for id in ["gyroscope", "gyroscope_rolling", "symmetric_body", "tippe_top_rolling"] {
        let top = ready(id);
        let first = top.layout.coordinates.len();
        for theta in [0.0, PI, -PI] {
            let up = Scalar::cos(theta).sign();
            let names = [("theta", theta), ("theta_dot", 2.0), ("psi_dot", 7.0), ("phi_dot", 60.0)];
            let mut y = top.start(&names).expect("the limit");
            close(y[first] * up + y[first + 2], 7.0 * up + 60.0, 1e-15);
            assert!(top.rate(&y).iter().all(|x| x.is_finite()), "{id}");
            assert_eq!(top.rate(&y)[first], 0.0, "{id}");
            y[1] += 1e-6;
            let near = top.rate(&y)[first].abs();
            y[first] += 1.0;
            let off = top.rate(&y)[first].abs();
            assert!(near < 1e-3 && off > 1e5, "{id} at {theta}: {near:e}, and without the limit {off:e}");
        }
        let asleep = top.start(&[("theta", 0.0), ("phi_dot", 60.0)]).expect("a sleeping top");
        assert!(top.rate(&asleep)[first..].iter().all(|x| x.abs() < 1e-300), "{id} sleeps");
    }
}

/// Euler angles and their rates of one top, the accelerations of the other.
#[test]
fn the_gyroscope_is_the_same_by_the_general_method_and_in_quaternions() {
    let (top, rolling, heavy) = (ready("gyroscope"), ready("gyroscope_rolling"), ready("heavy_top"));
    for k in 0..100 {
        let x = f64::from(k);
        let theta = 0.05 + 3.0 * Scalar::sin(x * 0.37).abs();
        let [psi_dot, theta_dot, phi_dot] = [1.1, 1.7, 2.3].map(|f| 30.0 * Scalar::sin(x * f + f));
        let names = [
            ("psi", 0.3 * x),
            ("theta", theta),
            ("psi_dot", psi_dot),
            ("theta_dot", theta_dot),
            ("phi_dot", phi_dot),
        ];
        let y = top.start(&names).expect("a sound start");
        let (rate, other) = (top.rate(&y), rolling.rate(&y));
        let size = 1.0 + rate.iter().fold(0.0, |sum, x| x.abs() + sum);
        for (a, b) in rate.iter().zip(&other) {
            assert!((a - b).abs() <= 1e-13 * size, "{rate:?} is not {other:?}");
        }
        // omega' in body axes, which at phi = 0 are (u, b, a) but turn with phi'.
        let q = heavy.start(&names).expect("a sound start");
        let turning = heavy.rate(&q);
        let (sin, cos) = Scalar::sin_cos(theta);
        let omega = [theta_dot, psi_dot * sin, psi_dot * cos + phi_dot];
        let expected = [
            rate[4] + phi_dot * omega[1],
            rate[3] * sin + psi_dot * theta_dot * cos - phi_dot * omega[0],
            rate[5] + rate[3] * cos - psi_dot * theta_dot * sin,
        ];
        for (a, b) in turning[4..].iter().zip(expected) {
            assert!((a - b).abs() <= 1e-13 * size, "{turning:?} is not {expected:?}");
        }
        for name in ["energy", "L_Az", "L_A3", "L_A", "axis_x", "axis_y", "axis_z"] {
            let (a, b) = (top.observe(&y, name), heavy.observe(&q, name));
            assert!((a - b).abs() <= 1e-14 * (1.0 + a.abs()), "{name}: {a} is not {b}");
        }
    }
}

/// The derivative along the flow by a central difference of the rate's direction: small steps of the state.
fn slope(top: &Ready, y: &[f64], name: &str) -> f64 {
    let (h, rate) = (1e-5, top.rate(y));
    let at = |s: f64| {
        let moved: Vec<f64> = y.iter().zip(&rate).map(|(y, r)| y + s * h * r).collect();
        top.observe(&moved, name)
    };
    (at(1.0) - at(-1.0)) / (2.0 * h)
}

#[test]
fn the_constants_of_the_classical_tops() {
    let mut top = ready("heavy_top");
    for (name, x) in [("m", 1.0), ("g", 2.0), ("i1", 2.0), ("i2", 2.0), ("i3", 1.0)] {
        top.set(name, x);
    }
    top.values.lists[0].items = vec![0.6, 0.4, 0.0];
    let names =
        [("psi", 0.3), ("theta", 1.1), ("phi", 0.8), ("psi_dot", 0.9), ("theta_dot", -0.7), ("phi_dot", 1.3)];
    let y = top.start(&names).expect("a start");
    assert!(slope(&top, &y, "kovalevskaya").abs() < 1e-8, "Kovalevskaya");
    // It is hers alone.
    top.set("i3", 1.1);
    assert!(slope(&top, &y, "kovalevskaya").abs() > 1e-2);
    for (name, x) in [("i1", 4.0), ("i2", 4.0), ("i3", 1.0)] {
        top.set(name, x);
    }
    top.values.lists[0].items = vec![0.6, 0.0, 0.0];
    // L_Az = 0: psi' is chosen so.
    let mut y = top.start(&names).expect("a start");
    let gamma = [1, 2, 3].map(|k| top.observe(&y, &format!("gamma{k}")));
    let (a, b) = (4.0 * (y[4] * gamma[0] + y[5] * gamma[1]), y[6] * gamma[2]);
    y[6] -= (a + b) / gamma[2];
    assert!(top.observe(&y, "L_Az").abs() < 1e-14);
    assert!(slope(&top, &y, "goryachev_chaplygin").abs() < 1e-8, "Goryachev and Chaplygin");
    y[6] += 0.5;
    assert!(slope(&top, &y, "goryachev_chaplygin").abs() > 1e-2);
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

/// T 6.3 takes `m g d sin(theta) u` for the moment of the weight; about the contact of its tippe top it is `-m g R alpha sin(theta) u`:
/// at rest, tilted, it rights itself.
#[test]
fn the_weight_rights_a_tippe_top() {
    for (id, first) in [("tippe_top_rolling", 5), ("rolling_top", 6)] {
        let top = ready(id);
        let y = top.start(&[("theta", 0.4), ("psi_dot", 0.0), ("phi_dot", 0.0)]).expect("a start at rest");
        let rate = top.rate(&y)[first + 1];
        let of = |name: &str| ready("tippe_top_rolling").value(name);
        let (m, radius, alpha, i1) = (of("m"), of("radius"), of("alpha"), of("i1"));
        let (sin, cos) = Scalar::sin_cos(0.4);
        let arm = radius * radius * (sin * sin + (alpha - cos) * (alpha - cos));
        close(rate, -(m * 9.81 * radius * alpha * sin) / (i1 + m * arm), 1e-14);
    }
}

/// With the exact rate of `I_A` and the corrected moments, T's general method is the rolling tippe top of (16) to (18).
#[test]
fn the_general_method_is_the_rolling_tippe_top() {
    let (special, mut general) = (ready("tippe_top_rolling"), ready("rolling_top"));
    general.values.choices[0] = 2;
    for k in 0..100 {
        let x = f64::from(k);
        let theta = 0.05 + 3.0 * Scalar::sin(x * 0.37).abs();
        let [psi_dot, theta_dot, phi_dot] = [1.1, 1.7, 2.3].map(|f| 30.0 * Scalar::sin(x * f + f));
        let names = [("theta", theta), ("psi_dot", psi_dot), ("theta_dot", theta_dot), ("phi_dot", phi_dot)];
        let a = special.rate(&special.start(&names).expect("a sound start"));
        let b = general.rate(&general.start(&names).expect("a sound start"));
        let size = 1.0 + a[5..].iter().fold(0.0, |sum, x| x.abs() + sum);
        for i in 0..3 {
            assert!((a[5 + i] - b[6 + i]).abs() <= 1e-13 * size, "{:?} is not {:?}", &a[5..], &b[6..]);
        }
    }
}

/// On a tip it is the gyroscope, whatever is made of a rate that vanishes.
#[test]
fn the_general_method_on_a_tip_is_the_gyroscope() {
    let (cone, mut general) = (ready("gyroscope"), ready("rolling_top"));
    for name in ["m", "i1", "i3"] {
        general.set(name, cone.value(name));
    }
    for (name, x) in [("point", -cone.value("d")), ("across", 0.0), ("along", 0.0)] {
        general.set(name, x);
    }
    let names = [("theta", 0.7), ("psi_dot", 3.0), ("theta_dot", -2.0), ("phi_dot", 50.0)];
    for choice in 0..3 {
        general.values.choices[0] = choice;
        let a = cone.rate(&cone.start(&names).expect("a sound start"));
        let b = general.rate(&general.start(&names).expect("a sound start"));
        for i in 0..3 {
            close(a[3 + i], b[6 + i], 1e-13);
        }
    }
}
