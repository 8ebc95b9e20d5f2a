//! Bodies on a table against other formulations and closed forms.

mod common;
use common::{Ready, ready};
use precess_scalar::{Dual, Scalar};

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

/// The contact point is the gradient of the support function h(n) = c.n + rho |n| + |A n| at the downward vertical.
#[test]
fn a_body_touches_where_its_support_function_says() {
    let mut body = ready("rolling_body");
    let (centre, rho, axes) = ([0.03, -0.02, 0.05], 0.01, [1.2, 1.0, 0.8]);
    body.set("radius", rho);
    for (name, x) in ["point1", "point2", "point3"].iter().zip(centre) {
        body.set(name, x);
    }
    let y = body.start(&[("psi", 0.3), ("theta", 0.9), ("phi", 2.1)]).expect("a start");
    let ((sin, cos), (sin_phi, cos_phi)) = (Scalar::sin_cos(0.9), Scalar::sin_cos(2.1));
    let down = [-sin * sin_phi, -sin * cos_phi, -cos];
    let support = |n: [Dual<f64>; 3]| {
        let size = |v: [Dual<f64>; 3]| Scalar::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
        let along = n[0] * centre[0] + n[1] * centre[1] + n[2] * centre[2];
        along + size(n) * rho + size([n[0] * axes[0], n[1] * axes[1], n[2] * axes[2]])
    };
    for (i, name) in ["contact1", "contact2", "contact3"].iter().enumerate() {
        let h = support([0, 1, 2].map(|j| Dual::new(down[j], if i == j { 1.0 } else { 0.0 })));
        assert!((body.observe(&y, name) - h.slope).abs() < 1e-14, "{name}");
        assert!((body.observe(&y, "z") - h.value).abs() < 1e-14, "z");
    }
}

/// A body whose support is a point turns about it: a heavy top.
#[test]
fn a_body_on_a_point_is_a_heavy_top() {
    let (mut body, mut top) = (ready("rolling_body"), ready("heavy_top"));
    for name in ["axis1", "axis2", "axis3", "point1", "point2"] {
        body.set(name, 0.0);
    }
    body.set("point3", -0.3);
    top.values.lists[0].items = vec![0.0, 0.0, 0.3];
    top.choose("about", "centre_of_mass");
    for (of_body, of_top) in [("m", "m"), ("i11", "i1"), ("i22", "i2"), ("i33", "i3")] {
        top.set(of_top, body.value(of_body));
    }
    let start =
        [("theta", 0.7), ("phi", 0.4), ("psi", 1.0), ("omega1", 3.0), ("omega2", -2.0), ("omega3", 5.0)];
    let found = body.rate(&body.start(&start).expect("a start"));
    let expected = top.rate(&top.start(&start).expect("a start"));
    for (a, b) in found[..7].iter().zip(expected) {
        assert!((a - b).abs() < 1e-13, "{:?}", &found[..7]);
    }
}

/// Chaplygin and Appell, for a thin disc (A across, C along the axis, w = psi' cos theta + phi'):
///
///     (C + m R^2) w'        = m R^2 theta' psi' sin theta
///     A (psi' sin theta)'   = C w theta' - A psi' theta' cos theta
///     (A + m R^2) theta''   = A psi'^2 sin theta cos theta - (C + m R^2) w psi' sin theta - m g R cos theta
#[test]
fn a_rolling_disc_obeys_chaplygin_and_appell() {
    let mut disc = ready("euler_disk");
    disc.set("edge", 0.0);
    let [m, radius, a, c] = ["m", "radius", "i1", "i3"].map(|name| disc.value(name));
    let square = m * radius * radius;
    for (theta, [psi1, theta1, phi1]) in
        [(0.3, [9.0, -2.0, 4.0]), (1.2, [-3.0, 5.0, 30.0]), (2.5, [1.0, 7.0, -20.0])]
    {
        let (sin, cos) = Scalar::sin_cos(theta);
        let w = psi1 * cos + phi1;
        let w1 = square * theta1 * psi1 * sin / (c + square);
        let psi2 = (c * w * theta1 / a - 2.0 * psi1 * theta1 * cos) / sin;
        let theta2 = (a * psi1 * psi1 * sin * cos - (c + square) * w * psi1 * sin - m * 9.81 * radius * cos)
            / (a + square);
        let phi2 = w1 - psi2 * cos + psi1 * theta1 * sin;
        let expected = omega_dot(theta, [psi1, theta1, phi1], [psi2, theta2, phi2]);
        let start = [("theta", theta), ("psi_dot", psi1), ("theta_dot", theta1), ("phi_dot", phi1)];
        let rate = disc.rate(&disc.start(&start).expect("a start"));
        let size = expected.iter().map(|x| x.abs()).sum::<f64>();
        for (found, expected) in rate[4..7].iter().zip(expected) {
            assert!((found - expected).abs() < 1e-12 * size, "{:?} {expected:?}", &rate[4..7]);
        }
    }
}

/// A body with dry friction that sticks is a rolling body.
#[test]
fn what_sticks_rolls() {
    let (mut sliding, rolling) = (ready("sliding_body"), ready("rolling_body"));
    sliding.choose("friction", "coulomb");
    let start = [("theta", 0.6), ("phi", 0.5), ("omega1", 0.3), ("omega2", -0.4), ("omega3", 0.2)];
    let as_rolling = rolling.start(&start).expect("a start");
    let rate = rolling.rate(&as_rolling);
    let with = |slip: f64| [&start[..], &[("x_dot", rate[7] + slip), ("y_dot", rate[8])]].concat();
    let y = sliding.start(&with(0.0)).expect("a start");
    assert_eq!(y[11], 1.0, "it sticks: little friction is needed at such a spin");
    let found = sliding.rate(&y);
    assert_eq!(found[4..7], rate[4..7]);
    for name in ["energy", "normal", "friction_needed", "regime"] {
        close(sliding.observe(&y, name), rolling.observe(&as_rolling, name), 1e-15);
    }
    // Slipping the slightest bit it does not.
    let y = sliding.start(&with(1e-3)).expect("a start");
    assert_eq!(y[11], 0.0);
}

/// Under viscous friction a body tends to rolling as the friction grows: what is left falls as one over it.
#[test]
fn sliding_with_much_friction_tends_to_rolling() {
    let (mut sliding, rolling) = (ready("sliding_body"), ready("rolling_body"));
    sliding.choose("friction", "viscous");
    let as_rolling = rolling.start(&[]).expect("a start");
    let rate = rolling.rate(&as_rolling);
    let slip_free = [("x_dot", rate[7]), ("y_dot", rate[8])];
    let end = follow(&rolling, as_rolling, 1e-3, 1000, &mut |_, _| {});
    let mut off = |mu: f64| {
        sliding.set("mu", mu);
        let y = sliding.start(&slip_free).expect("a start");
        let slid = follow(&sliding, y, 2e-4, 5000, &mut |_, _| {});
        slid[..7].iter().zip(&end).map(|(a, b)| (a - b).abs()).sum::<f64>()
    };
    let (some, more) = (off(50.0), off(100.0));
    assert!((some / more - 2.0).abs() < 0.1 && more < 0.02, "{some} {more}");
}

/// The kinetic energy of a body that rolls is a sum over the axes about which it turns.
#[test]
fn the_kinetic_energy_of_a_rattleback_is_shared_out() {
    let stone = ready("rattleback");
    let y = stone.start(&[("omega1", 2.0), ("omega2", -1.5), ("omega3", 4.0)]).expect("a start");
    let parts: f64 = ["kinetic1", "kinetic2", "kinetic3"].iter().map(|name| stone.observe(&y, name)).sum();
    close(parts, stone.observe(&y, "kinetic"), 1e-14);
}

/// Hertz: without slip the contact spot resists turning with (3 pi / 16) mu N a; without turning it is Coulomb's law.
#[test]
fn a_drilling_contact_has_its_limits() {
    let mut ball = ready("billiard_ball");
    ball.choose("friction", "drilling");
    ball.set("spot", 1e-3);
    let (mu, normal, i3) = (ball.value("mu"), ball.value("m") * 9.81, ball.value("i3"));
    let turning = ball.rate(&ball.start(&[("omega3", 1e9), ("x_dot", 0.0)]).expect("a start"));
    close(-i3 * turning[6], 3.0 * std::f64::consts::PI / 16.0 * mu * normal * 1e-3, 1e-5);
    let slipping = ball.rate(&ball.start(&[("omega3", 0.0), ("x_dot", 1e3)]).expect("a start"));
    close(-slipping[9], mu * 9.81, 1e-9);
}

/// A core that turns with its shell is part of a rigid body; one that does not, keeps its angular velocity.
#[test]
fn a_raw_egg_lies_between_a_boiled_one_and_a_hollow_one() {
    let start = [("omega1", 3.0), ("omega2", 60.0), ("omega3", 1.0), ("theta", 1.2), ("x_dot", 0.1)];
    let mut boiled = ready("spinning_egg");
    let mut raw = ready("raw_egg");
    for name in ["i1", "i3"] {
        boiled.set(name, raw.value(name) + raw.value("core"));
    }
    let end = |egg: &Ready, more: &[(&str, f64)], dt: f64| {
        let all: Vec<_> = start.iter().chain(more).copied().collect();
        let y = egg.start(&all).expect("a start");
        follow(egg, y, dt, (0.2 / dt).round() as usize, &mut |_, _| {})
    };
    for egg in [&mut boiled, &mut raw] {
        egg.set("epsilon", 0.05);
    }
    let rigid = end(&boiled, &[], 1e-4);
    // Turning with the shell at the start: R omega.
    let y = boiled.start(&start).expect("a start");
    let (sin, cos) = Scalar::sin_cos(1.2);
    let together = [("core_x", 3.0), ("core_y", cos * 60.0 - sin), ("core_z", sin * 60.0 + cos)];
    close(boiled.observe(&y, "spin"), together[2].1, 1e-12);
    // The core lags by I_c omega' / k: an error that halves as the coupling doubles.
    let off = |coupling: f64, dt: f64| {
        let mut stiff = ready("raw_egg");
        stiff.set("epsilon", 0.05);
        stiff.set("coupling", coupling);
        let found = end(&stiff, &together, dt);
        (0..4).map(|i| (found[i] - rigid[i]).abs()).sum::<f64>()
    };
    let (some, more) = (off(0.01, 1e-4), off(0.02, 1e-4));
    assert!((some / more - 2.0).abs() < 0.1 && more < 0.02, "{some} {more}");
    raw.set("coupling", 0.0);
    let alone = end(&raw, &together, 1e-4);
    for (i, (_, value)) in together.iter().enumerate() {
        close(alone[7 + i], *value, 1e-15);
    }
}

/// Friction and film take what the energy loses; without friction the vertical angular momentum of both stays.
#[test]
fn a_raw_egg_accounts_for_its_energy() {
    let mut egg = ready("raw_egg");
    egg.set("epsilon", 0.05);
    let start = egg.start(&[("x_dot", 0.2), ("core_x", 5.0), ("core_z", -30.0)]).expect("a start");
    let (dt, steps) = (2e-5, 5000);
    let (mut powers, mut energies) =
        (vec![egg.observe(&start, "power")], vec![egg.observe(&start, "energy")]);
    follow(&egg, start.clone(), dt, steps, &mut |_, y| {
        powers.push(egg.observe(y, "power"));
        energies.push(egg.observe(y, "energy"));
    });
    // Simpson's rule.
    let weight = |k: usize| if k == 0 || k == steps { 1.0 } else { 2.0 + 2.0 * (k % 2) as f64 };
    let work: f64 = powers.iter().enumerate().map(|(k, p)| weight(k) * p * dt / 3.0).sum();
    assert!(work < -0.1 * energies[0], "{work}");
    assert!((energies[steps] - energies[0] - work).abs() < 1e-10 * energies[0], "{work} {energies:?}");
    egg.set("mu", 0.0);
    let before = egg.observe(&start, "Lz");
    let after = follow(&egg, start, dt, steps, &mut |_, _| {});
    close(egg.observe(&after, "Lz"), before, 1e-12);
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
    let mut top = ready("tippe_top");
    top.choose("contact", "free");
    assert!(top.start(&[("z", 0.01)]).expect_err("too low").contains("below the table"));
    assert!(
        top.start(&[("omega1", 1.0), ("z_dot", -1.0)]).expect_err("downwards").contains("leave z_dot out")
    );
    assert!(top.start(&[("z", 0.1), ("z_dot", -1.0)]).is_ok(), "it falls");
}
