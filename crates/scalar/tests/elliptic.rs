//! Jacobi's elliptic functions: known values, their differential equations, their limits.

use precess_scalar::{Dual, Scalar, jacobi};

fn close(a: f64, b: f64, bound: f64) -> bool {
    (a - b).abs() <= bound
}

/// K(k) = pi / (2 mean), for k^2 = 1/2: Gamma(1/4)^2 / (4 sqrt pi), A&S 17.3 and 18.15.
#[test]
fn the_quarter_period_of_the_lemniscate() {
    let mean = jacobi(0.3, 0.5).mean;
    assert!(close(std::f64::consts::FRAC_PI_2 / mean, 1.854_074_677_301_371_9, 4e-16), "{mean}");
}

/// From mpmath with 50 digits: (u, k'^2, sn, cn, dn).
const VALUES: [(f64, f64, f64, f64, f64); 5] = [
    (0.8, 0.5, 0.69093485086643878929, 0.72291702971929772448, 0.87252765911980463401),
    (-2.3, 0.1, -0.99604544309732297643, 0.088845232202170177311, 0.32726766989201941103),
    (11.0, 1e-06, 0.99997224282188552184, -0.0074507439741289887929, 0.007517548154447277603),
    (17.5, 1e-12, 0.99999999998785800888, -4.9278780665327214233e-6, 5.0283180327610532702e-6),
    (30.0, 1e-20, 0.99999999999999991078, -1.3357906074446199551e-8, 1.3358280379364953158e-8),
];

#[test]
fn values_at_ordinary_and_at_steep_places() {
    for (u, complement, sn, cn, dn) in VALUES {
        let f = jacobi(u, complement);
        for (found, expected) in [(f.sn, sn), (f.cn, cn), (f.dn, dn)] {
            // As if u were off by an ulp.
            let bound = 4e-16 * (expected.abs() + u.abs() * (cn * dn).abs().larger((sn * dn).abs()));
            assert!(close(found, expected, bound), "{u} {complement:e}: {found} is not {expected}");
        }
    }
}

#[test]
fn the_derivatives_are_products_of_the_others() {
    for complement in [1.0, 0.7, 1e-3, 1e-9, 0.0] {
        for k in -40..40 {
            let u = f64::from(k) * 0.37;
            let f = jacobi(Dual::new(u, 1.0), Dual::constant(complement));
            let (sn, cn, dn) = (f.sn.value, f.cn.value, f.dn.value);
            assert!(close(f.sn.slope, cn * dn, 1e-14), "{u} {complement}");
            assert!(close(f.cn.slope, -sn * dn, 1e-14), "{u} {complement}");
            assert!(close(f.dn.slope, (complement - 1.0) * sn * cn, 1e-14), "{u} {complement}");
            assert!(close(sn * sn + cn * cn, 1.0, 1e-15), "{u} {complement}");
            assert!(close(dn * dn - complement, (1.0 - complement) * cn * cn, 1e-15), "{u} {complement}");
        }
    }
}

#[test]
fn the_limits_are_sines_and_hyperbolic_functions() {
    for u in [-3.0, 0.0, 0.4, 7.0] {
        let (round, straight) = (jacobi(u, 1.0), jacobi(u, 0.0));
        let (sin, cos) = Scalar::sin_cos(u);
        assert!(close(round.sn, sin, 2e-16) && close(round.cn, cos, 2e-16) && round.dn == 1.0);
        assert_eq!([straight.sn, straight.cn], [Scalar::tanh(u), 1.0 / Scalar::cosh(u)]);
        // The limit is reached steadily.
        let near = jacobi(u, 1e-30);
        assert!(close(near.sn, straight.sn, 1e-15) && close(near.cn, straight.cn, 1e-15), "{u}");
    }
}
