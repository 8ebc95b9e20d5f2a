//! Systems without a Lagrangian against another form of themselves.

mod common;
use common::ready;
use precess_scalar::{Dual, Scalar};
use precess_system::{Bind, Given};
use std::f64::consts::PI;

/// A few states that are nothing special.
fn states(size: usize) -> impl Iterator<Item = Vec<f64>> {
    (0..20)
        .map(move |k| (0..size).map(|i| 1.7 * Scalar::sin(1.0 + 3.1 * k as f64 + 1.3 * i as f64)).collect())
}

/// The wheel is Lorenz's system: x = w / K, y = c a, z = rho - c b with c = pi g r / (K nu), in the time K t.
#[test]
fn the_waterwheel_is_the_lorenz_system() {
    let (wheel, mut lorenz) = (ready("malkus_waterwheel"), ready("lorenz"));
    let of = |name: &str| wheel.value(name);
    let (leak, friction, c) =
        (of("leak"), of("friction"), PI * of("g") * of("radius") / (of("leak") * of("friction")));
    let rho = c * of("inflow") / leak;
    lorenz.set("sigma", friction / (of("inertia") * leak));
    lorenz.set("rho", rho);
    lorenz.set("beta", 1.0);
    assert!(
        (lorenz.value("rho") - 28.0).abs() < 1e-12 && lorenz.value("sigma") == 10.0,
        "the defaults are Lorenz's"
    );
    for y in states(4) {
        let rate = wheel.rate(&y);
        let [_theta, a, b, w] = [y[0], y[1], y[2], y[3]];
        let expected = lorenz.rate(&[w / leak, c * a, rho - c * b]);
        let found = [rate[3] / leak, c * rate[1], -c * rate[2]].map(|x| x / leak);
        for (x, y) in found.iter().zip(&expected) {
            assert!((x - y).abs() < 1e-11 * (1.0 + y.abs()), "{found:?} {expected:?}");
        }
    }
}

/// The bead in the coordinate x: (1 + y'^2) x'' + y' y'' x'^2 + g y' = 0, from its Lagrangian (1 + y'^2) x'^2 / 2 - g y.
#[test]
fn the_bead_along_the_wire_is_the_bead_along_x() {
    let bead = ready("bead_on_curve");
    let mut waves = bead.values.clone();
    waves.lists[1].items = vec![0.3, 2.0];
    for y in states(3) {
        let field = Bind::<Dual<f64>>::bind(bead.system, waves.map(|&x| Dual::constant(x)), &bead.layout);
        // The rate of x, and its own rate along the flow.
        let still: Vec<_> = y.iter().map(|&x| Dual::constant(x)).collect();
        let mut rate = still.clone();
        field.rate(Dual::constant(0.0), &still, &mut rate);
        let moving: Vec<_> = y.iter().zip(&rate).map(|(&x, r)| Dual::new(x, r.value)).collect();
        field.rate(Dual::constant(0.0), &moving, &mut rate);
        let (x, v, a) = (y[1], rate[1].value, rate[1].slope);
        // y = x^2 / 2 + 0.3 cos 2x
        let (sin, cos) = Scalar::sin_cos(2.0 * x);
        let (slope, bend) = (x - 0.6 * sin, 1.0 - 1.2 * cos);
        let residual = (1.0 + slope * slope) * a + slope * bend * v * v + slope;
        assert!(residual.abs() < 1e-12 * (1.0 + a.abs() + slope * slope), "{residual}");
    }
}

/// A cluster is two bodies of `n_body`, and for each asteroid a third one without mass.
#[test]
fn a_cluster_is_many_restricted_problems_of_three_bodies() {
    let (cluster, mut three) = (ready("cluster"), ready("n_body"));
    three.values.lists[0].items = vec![100.0, 30.0, 0.0];
    three.layout = three.system.layout(&three.values, &Given::default());
    let y = cluster.start(&[]).expect("a start");
    let rate = cluster.rate(&y);
    for body in [2, 40, 136] {
        let parts = |of: &[f64]| {
            [&of[..4], &of[2 * body..2 * body + 2], &of[274..278], &of[274 + 2 * body..][..2]].concat()
        };
        let (expected, found) = (three.rate(&parts(&y)), parts(&rate));
        for (x, y) in found.iter().zip(&expected) {
            assert!((x - y).abs() < 1e-15, "{found:?} {expected:?}");
        }
    }
}
