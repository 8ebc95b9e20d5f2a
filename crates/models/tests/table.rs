//! Bodies on a table against other formulations and closed forms.

mod common;
use common::{Ready, ready};
use precess_scalar::Scalar;

#[track_caller]
fn close(a: f64, b: f64, part: f64) {
    assert!((a - b).abs() <= part * (a.abs() + b.abs()), "{a} is not {b}");
}

/// The classical Runge-Kutta method, and what `look` sees after each step.
fn follow(
    body: &Ready,
    mut y: Vec<f64>,
    dt: f64,
    steps: usize,
    look: &mut dyn FnMut(f64, &[f64]),
) -> Vec<f64> {
    let field = body.field();
    let mut k = vec![vec![0.0; y.len()]; 4];
    for n in 0..steps {
        let t = n as f64 * dt;
        for (stage, part) in [0.0, 0.5, 0.5, 1.0].into_iter().enumerate() {
            let at = |i: usize| if stage == 0 { y[i] } else { y[i] + part * dt * k[stage - 1][i] };
            let point: Vec<f64> = (0..y.len()).map(at).collect();
            field.rate(t + part * dt, &point, &mut k[stage]);
        }
        for i in 0..y.len() {
            y[i] += dt / 6.0 * (k[0][i] + 2.0 * (k[1][i] + k[2][i]) + k[3][i]);
        }
        look(t + dt, &y);
    }
    y
}

/// Angular velocity's rate in body axes from the accelerations of the Euler angles, where phi = 0.
fn omega_dot(
    theta: f64,
    [psi_dot, theta_dot, phi_dot]: [f64; 3],
    [psi2, theta2, phi2]: [f64; 3],
) -> [f64; 3] {
    let (sin, cos) = Scalar::sin_cos(theta);
    [
        theta2 + psi_dot * sin * phi_dot,
        psi2 * sin + psi_dot * theta_dot * cos - theta_dot * phi_dot,
        phi2 + psi2 * cos - psi_dot * theta_dot * sin,
    ]
}

#[test]
fn a_rolling_body_contains_the_rolling_tippe_top() {
    let top = ready("tippe_top_rolling");
    let mut body = ready("rolling_body");
    let [m, radius, alpha, i1, i3] = ["m", "radius", "alpha", "i1", "i3"].map(|name| top.value(name));
    for (name, value) in [
        ("m", m),
        ("i11", i1),
        ("i22", i1),
        ("i33", i3),
        ("point3", alpha * radius),
        ("radius", radius),
        ("axis1", 0.0),
        ("axis2", 0.0),
        ("axis3", 0.0),
    ] {
        body.set(name, value);
    }
    for theta in [0.1, 0.7, 1.9, 2.9] {
        let rates = [11.0, -7.0, 90.0];
        let start = [
            ("psi", 0.4),
            ("theta", theta),
            ("psi_dot", rates[0]),
            ("theta_dot", rates[1]),
            ("phi_dot", rates[2]),
        ];
        let (by_angles, y) = (top.start(&start).expect("a start"), body.start(&start).expect("a start"));
        let rate = top.rate(&by_angles);
        let expected = omega_dot(theta, rates, [rate[5], rate[6], rate[7]]);
        let found = body.rate(&y);
        let size = expected.iter().map(|x| x.abs()).sum::<f64>();
        for (a, b) in found[4..7].iter().zip(expected) {
            assert!((a - b).abs() < 1e-12 * size, "theta = {theta}: {:?} is not {expected:?}", &found[4..7]);
        }
        for name in ["energy", "jellett", "normal"] {
            close(body.observe(&y, name), top.observe(&by_angles, name), 1e-11);
        }
    }
}

/// Appell: a thin disc whose centre rests goes round with Omega^2 = 4 g / (R sin theta).
#[test]
fn eulers_disk_goes_round_about_a_centre_at_rest() {
    let mut disk = ready("euler_disk");
    let (m, radius, theta) = (disk.value("m"), disk.value("radius"), 0.3);
    disk.set("edge", 0.0);
    disk.set("i1", m * radius * radius / 4.0);
    disk.set("i3", m * radius * radius / 2.0);
    let (sin, cos) = Scalar::sin_cos(theta);
    let turn = (4.0 * 9.81 / (radius * sin)).sqrt();
    let rates = [turn, 0.0, -turn * cos];
    let y = disk.start(&[("theta", theta), ("psi_dot", rates[0]), ("phi_dot", rates[2])]).expect("a start");
    let rate = disk.rate(&y);
    for (a, b) in rate[4..7].iter().zip(omega_dot(theta, rates, [0.0; 3])) {
        assert!((a - b).abs() < 1e-10 * turn * turn, "{:?}", &rate[4..7]);
    }
    assert!(rate[7].abs() + rate[8].abs() < 1e-14 * turn * radius + 1e-15, "{:?}", &rate[7..9]);
    close(disk.observe(&y, "normal"), m * 9.81, 1e-12);
}

#[test]
fn a_billiard_ball_rolls_after_two_sevenths() {
    let mut ball = ready("billiard_ball");
    ball.set("epsilon", 1e-6);
    let (mu, g, u0) = (ball.value("mu"), ball.value("g"), 2.0);
    let rolls = 2.0 * u0 / (7.0 * mu * g);
    let start = ball.start(&[]).expect("a start");
    let half = follow(&ball, start, rolls / 2000.0, 1000, &mut |_, _| {});
    close(ball.observe(&half, "slip"), u0 / 2.0, 1e-9);
    close(half[9], u0 - mu * g * rolls / 2.0, 1e-9);
    assert!((ball.observe(&half, "power") + mu * ball.value("m") * g * u0 / 2.0).abs() < 1e-9);
}

#[test]
fn bodies_that_make_no_sense_are_refused() {
    let refusal = |id: &str, set: &[(&str, f64)], start: &[(&str, f64)]| {
        let mut body = ready(id);
        for (name, value) in set {
            body.set(name, *value);
        }
        body.start(start).expect_err("this makes no sense")
    };
    assert!(refusal("rolling_body", &[("i33", 9.0)], &[]).contains("inertia"));
    assert!(refusal("rolling_body", &[("i12", 5.0)], &[]).contains("inertia"));
    assert!(refusal("rolling_body", &[("radius", -1.0)], &[]).contains("convex"));
    assert!(refusal("euler_disk", &[], &[("theta", 0.0)]).contains("flat face"));
    assert!(refusal("rolling_body", &[("point3", 3.0)], &[]).contains("centre of mass"));
    assert!(refusal("tippe_top", &[], &[("theta", 1.0), ("qw", 1.0)]).contains("twice"));
}
