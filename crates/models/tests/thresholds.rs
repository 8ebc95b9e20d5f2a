//! Where a motion of a top becomes unstable: by the eigenvalues of its linearised flow.

mod common;
use common::{Ready, ready};
use precess_scalar::Scalar;

type Complex = [f64; 2];

fn times([a, b]: Complex, [c, d]: Complex) -> Complex {
    [a * c - b * d, a * d + b * c]
}
fn over(a: Complex, [c, d]: Complex) -> Complex {
    let square = c * c + d * d;
    times(a, [c / square, -d / square])
}
fn minus([a, b]: Complex, [c, d]: Complex) -> Complex {
    [a - c, b - d]
}

fn size([a, b]: Complex) -> f64 {
    (a * a + b * b).sqrt()
}

/// The characteristic polynomial of a matrix (Faddeev and Leverrier), the leading coefficient first.
fn characteristic(matrix: &[Vec<Complex>]) -> Vec<Complex> {
    let n = matrix.len();
    let mut polynomial = vec![[1.0, 0.0]];
    let mut power = vec![vec![[0.0; 2]; n]; n];
    for k in 1..=n {
        // power = matrix * power + c 1, c the last coefficient.
        let c = polynomial[k - 1];
        let mut next = vec![vec![[0.0; 2]; n]; n];
        for i in 0..n {
            for j in 0..n {
                for l in 0..n {
                    let product = times(matrix[i][l], power[l][j]);
                    next[i][j] = [next[i][j][0] + product[0], next[i][j][1] + product[1]];
                }
            }
            next[i][i] = [next[i][i][0] + c[0], next[i][i][1] + c[1]];
        }
        power = next;
        let mut trace = [0.0; 2];
        for i in 0..n {
            for l in 0..n {
                let product = times(matrix[i][l], power[l][i]);
                trace = [trace[0] + product[0], trace[1] + product[1]];
            }
        }
        polynomial.push([-trace[0] / k as f64, -trace[1] / k as f64]);
    }
    polynomial
}

/// All roots of a polynomial (Durand and Kerner), which is scaled so that they are of size one.
fn roots(polynomial: &[Complex]) -> Vec<Complex> {
    let n = polynomial.len() - 1;
    let scale = polynomial.iter().skip(1).map(|&c| size(c)).zip(1..).fold(0.0, |largest: f64, (c, k)| {
        let root = Scalar::powf(c, 1.0 / f64::from(k));
        if root > largest { root } else { largest }
    });
    let scaled: Vec<Complex> =
        polynomial.iter().enumerate().map(|(k, c)| c.map(|x| x / Scalar::powi(scale, k as i32))).collect();
    let mut roots: Vec<Complex> = (0..n)
        .map(|k| {
            let (sin, cos) = Scalar::sin_cos(0.4 + 6.283 * k as f64 / n as f64);
            [0.8 * cos, 0.8 * sin]
        })
        .collect();
    for _ in 0..500 {
        for i in 0..n {
            let value = scaled.iter().fold([0.0; 2], |sum, &c| {
                let product = times(sum, roots[i]);
                [product[0] + c[0], product[1] + c[1]]
            });
            let others = (0..n)
                .filter(|&j| j != i)
                .fold([1.0, 0.0], |product, j| times(product, minus(roots[i], roots[j])));
            roots[i] = minus(roots[i], over(value, others));
        }
    }
    roots.into_iter().map(|root| root.map(|x| x * scale)).collect()
}

/// The largest growth rate, without so many modes that rest (another steady motion beside this one).
fn growth(matrix: &[Vec<Complex>], resting: usize) -> f64 {
    let mut roots = roots(&characteristic(matrix));
    roots.sort_by(|a, b| size(*a).total_cmp(&size(*b)));
    roots[resting..]
        .iter()
        .fold(f64::NEG_INFINITY, |largest, [re, _]| if *re > largest { *re } else { largest })
}

/// Where a growth rate passes through zero.
fn threshold(mut low: f64, mut high: f64, growth: impl Fn(f64) -> f64) -> f64 {
    let at_low = growth(low) > 0.0;
    assert_ne!(at_low, growth(high) > 0.0, "the threshold lies between");
    for _ in 0..40 {
        let middle = (low + high) / 2.0;
        if (growth(middle) > 0.0) == at_low { low = middle } else { high = middle }
    }
    low
}

const STEP: f64 = 1e-6;

/// A top that spins about its axis, which is upright (theta = 0) or upside down (pi): the motion of axis, angular velocity
/// across and velocity, each as a complex number, is linear with complex coefficients for the symmetry about the vertical.
fn of_vertical_top(top: &Ready, down: bool, spin: f64) -> Vec<Vec<Complex>> {
    let side = if down { -1.0 } else { 1.0 };
    let rate = |axis: f64, omega: f64, velocity: f64| -> [Complex; 3] {
        // R = Ry(angle), or with the axis down Ry(angle) Rx(pi).
        let (sin, cos) = Scalar::sin_cos(side * axis / 2.0);
        let q = if down { [0.0, cos, 0.0, -sin] } else { [cos, 0.0, sin, 0.0] };
        let (sin, cos) = (2.0 * sin * cos, cos * cos - sin * sin);
        let to_body = |[x, y, z]: [f64; 3]| {
            let [a, c] = [cos * x - sin * z, sin * x + cos * z];
            [a, side * y, side * c]
        };
        let to_space = |[a, b, c]: [f64; 3]| [cos * a + sin * side * c, side * b, -sin * a + cos * side * c];
        let w = to_body([omega, 0.0, spin]);
        let start = [
            ("qw", q[0]),
            ("qx", q[1]),
            ("qy", q[2]),
            ("qz", q[3]),
            ("omega1", w[0]),
            ("omega2", w[1]),
            ("omega3", w[2]),
            ("x_dot", velocity),
            ("y_dot", 0.0),
        ];
        let found = top.rate(&top.start(&start).expect("a start"));
        let turning = to_space([found[4], found[5], found[6]]);
        // The axis e has the rate omega x e.
        let e = to_space([0.0, 0.0, 1.0]);
        let axis_dot = [-spin * e[1], spin * e[0] - omega * e[2]];
        [axis_dot, [turning[0], turning[1]], [found[9], found[10]]]
    };
    let column = |j: usize| {
        let at = |x: f64| {
            rate(if j == 0 { x } else { 0.0 }, if j == 1 { x } else { 0.0 }, if j == 2 { x } else { 0.0 })
        };
        let (above, below) = (at(STEP), at(-STEP));
        [0, 1, 2].map(|i| minus(above[i], below[i]).map(|x| x / (2.0 * STEP)))
    };
    let columns = [column(0), column(1), column(2)];
    (0..3).map(|i| (0..3).map(|j| columns[j][i]).collect()).collect()
}

/// A tippe top turns over completely where Jellett's constant exceeds
/// sqrt(m g R^3 I3 alpha) (1 + alpha)^2 / sqrt(1 + alpha - I1/I3): upside down it is stable then. Upright it is unstable where
/// it exceeds sqrt(m g R^3 I3 alpha) (1 - alpha)^2 / sqrt(I1/I3 - 1 + alpha).
#[test]
fn a_tippe_top_turns_over_beyond_jelletts_threshold() {
    let mut top = ready("tippe_top");
    let [m, radius, alpha, i1, i3] = ["m", "radius", "alpha", "i1", "i3"].map(|name| top.value(name));
    let unit = (m * 9.81 * radius * radius * radius * i3 * alpha).sqrt();
    for mu in [0.1, 0.5] {
        top.set("mu", mu);
        let over = unit * (1.0 + alpha) * (1.0 + alpha) / (1.0 + alpha - i1 / i3).sqrt();
        let spin = threshold(20.0, 80.0, |spin| growth(&of_vertical_top(&top, true, spin), 0));
        let jellett = i3 * spin * radius * (1.0 + alpha);
        assert!((jellett / over - 1.0).abs() < 2e-3, "upside down: {jellett} {over}");
        let leaves = unit * (1.0 - alpha) * (1.0 - alpha) / (i1 / i3 - 1.0 + alpha).sqrt();
        let spin = threshold(10.0, 60.0, |spin| growth(&of_vertical_top(&top, false, spin), 0));
        let jellett = i3 * spin * radius * (1.0 - alpha);
        assert!((jellett / leaves - 1.0).abs() < 2e-3, "upright: {jellett} {leaves}");
    }
}

/// The linearised flow of an egg that lies on its side and spins about the vertical, in axes that turn with it.
fn of_lying_egg(egg: &Ready, spin: f64) -> Vec<Vec<Complex>> {
    let rest = [std::f64::consts::FRAC_PI_2, 0.0, spin, 0.0, 0.0, 0.0];
    let rate = |[theta, theta1, psi1, phi1, vx, vy]: [f64; 6]| {
        let (sin, cos) = Scalar::sin_cos(theta);
        let start = [
            ("theta", theta),
            ("theta_dot", theta1),
            ("psi_dot", psi1),
            ("phi_dot", phi1),
            ("x_dot", vx),
            ("y_dot", vy),
        ];
        let found = egg.rate(&egg.start(&start).expect("a start"));
        let theta2 = found[4] - psi1 * sin * phi1;
        let psi2 = (found[5] - psi1 * theta1 * cos + theta1 * phi1) / sin;
        let phi2 = found[6] - psi2 * cos + psi1 * theta1 * sin;
        [theta1, theta2, psi2, phi2, found[9] + psi1 * vy, found[10] - psi1 * vx]
    };
    let columns: Vec<[f64; 6]> = (0..6)
        .map(|j| {
            let at = |x: f64| {
                let mut y = rest;
                y[j] += x;
                rate(y)
            };
            let (above, below) = (at(STEP), at(-STEP));
            [0, 1, 2, 3, 4, 5].map(|i| (above[i] - below[i]) / (2.0 * STEP))
        })
        .collect();
    (0..6).map(|i| (0..6).map(|j| [columns[j][i], 0.0]).collect()).collect()
}

/// Beyond Omega^2 = m g b (a^2 - b^2) / (I3 a^2 - I1 b^2), for a uniform spheroid 5 g / b, an egg does not stay on its side.
#[test]
fn an_egg_rises_beyond_its_threshold() {
    let mut egg = ready("spinning_egg");
    // The first one is uniform.
    for (a, i1, i3, uniform) in [(0.03, 1.56e-5, 9.6e-6, true), (0.026, 1.1e-5, 9e-6, false)] {
        egg.set("a", a);
        egg.set("i1", i1);
        egg.set("i3", i3);
        let [m, b] = ["m", "b"].map(|name| egg.value(name));
        let (aa, bb) = (a * a, b * b);
        let expected = (m * 9.81 * b * (aa - bb) / (i3 * aa - i1 * bb)).sqrt();
        assert!(!uniform || (expected * expected * b / 9.81 - 5.0).abs() < 1e-12);
        let found = threshold(0.5 * expected, 2.0 * expected, |spin| growth(&of_lying_egg(&egg, spin), 1));
        assert!((found / expected - 1.0).abs() < 2e-3, "{found} {expected}");
    }
}
