//! Equations as mechanics writes them, and as they must look.

use precess_scalar::{Dual, Notation, Scalar, Tape, Traced};

/// Records and simplifies expressions of the named quantities, and compares what is printed, definitions
/// first. A name is given as text and as LaTeX.
fn check<const N: usize>(
    names: [(&str, &str); N],
    f: impl FnOnce([Traced; N]) -> Vec<Traced>,
    text: &[&str],
    latex: &[&str],
) {
    let tape = Tape::record(N, |x| f(std::array::from_fn(|i| x[i]))).simplified();
    let lines = |names: Vec<String>, notation| {
        let printed = tape.print(&names, notation);
        let definitions =
            printed.definitions.into_iter().map(|(name, meaning)| format!("{name} = {meaning}"));
        definitions.chain(printed.outputs).collect::<Vec<_>>()
    };
    assert_eq!(lines(names.iter().map(|name| name.0.into()).collect(), Notation::Text), text);
    assert_eq!(lines(names.iter().map(|name| name.1.into()).collect(), Notation::Latex), latex);
}

const PENDULUM: [(&str, &str); 6] =
    [("theta", r"\theta"), ("theta'", r"\dot\theta"), ("m", "m"), ("l", "l"), ("g", "g"), ("b", "b")];

#[test]
fn pendulum() {
    check(
        PENDULUM,
        |[theta, w, m, l, g, b]| {
            let tension = m * l * w.squared() + m * g * theta.cos();
            let energy = m * (l * w).squared() * 0.5 + m * g * l * (Traced::from(1.0) - theta.cos());
            vec![-(b * w) - g / l * theta.sin(), tension, energy]
        },
        &[
            "-b * theta' - g / l * sin(theta)",
            "m * l * theta'^2 + m * g * cos(theta)",
            "0.5 * m * (l * theta')^2 + m * g * l * (1 - cos(theta))",
        ],
        &[
            r"-b\,\dot\theta - \frac{g}{l}\sin\theta",
            r"m\,l\,\dot\theta^{2} + m\,g\cos\theta",
            r"\frac{1}{2}\,m\,(l\,\dot\theta)^{2} + m\,g\,l\,(1 - \cos\theta)",
        ],
    );
}

#[test]
fn linearised_pendulum() {
    // The derivative of the acceleration with respect to the angle.
    check(
        PENDULUM,
        |[theta, w, _, l, g, b]| {
            let theta = Dual::new(theta, Traced::from(1.0));
            let [w, l, g, b] = [w, l, g, b].map(Dual::constant);
            vec![(-(b * w) - g / l * theta.sin()).slope]
        },
        &["-g / l * cos(theta)"],
        &[r"-\frac{g}{l}\cos\theta"],
    );
}

#[test]
fn van_der_pol() {
    check(
        [("x", "x"), ("x'", r"\dot x"), ("b0", "b_0"), ("x0", "x_0"), ("omega", r"\omega")],
        |[x, v, b0, x0, omega]| vec![b0 * (Traced::from(1.0) - x * x / (x0 * x0)) * v - omega.squared() * x],
        &["b0 * (1 - x^2 / x0^2) * x' - omega^2 * x"],
        &[r"b_0\,\left(1 - \frac{x^{2}}{x_0^{2}}\right)\,\dot x - \omega^{2}\,x"],
    );
}

#[test]
fn parametric_and_driven_oscillators() {
    check(
        [("t", "t"), ("x", "x"), ("omega", r"\omega"), ("h", "h"), ("alpha", r"\alpha")],
        |[t, x, omega, h, alpha]| {
            let parametric = -omega.squared() * (Traced::from(1.0) - h * (alpha * t).sin()) * x;
            let driven =
                h * (t * std::f64::consts::TAU / alpha - std::f64::consts::FRAC_PI_2).cos() - x / 3.0;
            vec![parametric, driven]
        },
        &["-omega^2 * (1 - h * sin(alpha * t)) * x", "h * cos(2 * pi * t / alpha - pi / 2) - x / 3"],
        &[
            r"-\omega^{2}\,(1 - h\sin(\alpha\,t))\,x",
            r"h\cos\left(\frac{2\pi\,t}{\alpha} - \frac{\pi}{2}\right) - \frac{x}{3}",
        ],
    );
}

#[test]
fn two_bodies() {
    check(
        [("x", "x"), ("y", "y"), ("x2", "x_2"), ("y2", "y_2"), ("G", "G"), ("m2", "m_2")],
        |[x, y, x2, y2, gravity, m2]| {
            let (dx, dy) = (x2 - x, y2 - y);
            let r2 = dx.squared() + dy.squared();
            let pull = gravity * m2 / (r2 * r2.sqrt());
            vec![pull * dx, pull * dy, -(gravity * m2) / r2.sqrt()]
        },
        &[
            "s1 = (x2 - x)^2 + (y2 - y)^2",
            "G * m2 / (s1 * sqrt(s1)) * (x2 - x)",
            "G * m2 / (s1 * sqrt(s1)) * (y2 - y)",
            "-G * m2 / sqrt(s1)",
        ],
        &[
            r"s_1 = (x_2 - x)^{2} + (y_2 - y)^{2}",
            r"\frac{G\,m_2}{s_1\,\sqrt{s_1}}\,(x_2 - x)",
            r"\frac{G\,m_2}{s_1\,\sqrt{s_1}}\,(y_2 - y)",
            r"-\frac{G\,m_2}{\sqrt{s_1}}",
        ],
    );
}

#[test]
fn double_pendulum() {
    check(
        [
            ("theta1", r"\theta_1"),
            ("theta2", r"\theta_2"),
            ("theta1'", r"\dot\theta_1"),
            ("theta2'", r"\dot\theta_2"),
            ("m1", "m_1"),
            ("m2", "m_2"),
            ("l1", "l_1"),
            ("l2", "l_2"),
            ("g", "g"),
        ],
        |[theta1, theta2, w1, w2, m1, m2, l1, l2, g]| {
            let (sin, cos) = (theta1 - theta2).sin_cos();
            let f1 = -(m2 * l2 * w2.squared() * sin) - (m1 + m2) * g * theta1.sin();
            let f2 = l1 * w1.squared() * sin - g * theta2.sin();
            let mass = m1 + m2 * sin.squared();
            vec![(f1 - m2 * cos * f2) / (l1 * mass), ((m1 + m2) * f2 - cos * f1) / (l2 * mass)]
        },
        &[
            "s1 = -m2 * l2 * theta2'^2 * sin(theta1 - theta2) - (m1 + m2) * g * sin(theta1)",
            "s2 = l1 * theta1'^2 * sin(theta1 - theta2) - g * sin(theta2)",
            "s3 = m1 + m2 * sin(theta1 - theta2)^2",
            "(s1 - m2 * cos(theta1 - theta2) * s2) / (l1 * s3)",
            "((m1 + m2) * s2 - cos(theta1 - theta2) * s1) / (l2 * s3)",
        ],
        &[
            r"s_1 = -m_2\,l_2\,\dot\theta_2^{2}\sin(\theta_1 - \theta_2) - (m_1 + m_2)\,g\sin\theta_1",
            r"s_2 = l_1\,\dot\theta_1^{2}\sin(\theta_1 - \theta_2) - g\sin\theta_2",
            r"s_3 = m_1 + m_2\sin^{2}(\theta_1 - \theta_2)",
            r"\frac{s_1 - m_2\,s_2\cos(\theta_1 - \theta_2)}{l_1\,s_3}",
            r"\frac{(m_1 + m_2)\,s_2 - s_1\cos(\theta_1 - \theta_2)}{l_2\,s_3}",
        ],
    );
}

#[test]
fn friction() {
    check(
        [("x", "x"), ("x'", r"\dot x"), ("mu", r"\mu"), ("k", "k")],
        |[x, v, mu, k]| {
            let zero = Traced::from(0.0);
            let stuck = v.abs().lt(Traced::from(1e-6)) & (k * x).abs().le(mu);
            let sliding = Traced::select(v.gt(zero), -mu, mu);
            let wall = Traced::select(x.lt(zero) | !x.lt(mu), k * x, zero);
            vec![-mu * v.sign() * v.squared(), Traced::select(stuck, zero, sliding), -wall - v.larger(x)]
        },
        &[
            "s1 = if(x < 0 or x >= mu, k * x, 0)",
            "-mu * sign(x') * x'^2",
            "if(abs(x') < 1e-6 and abs(k * x) <= mu, 0, if(x' > 0, -mu, mu))",
            "-s1 - max(x', x)",
        ],
        &[
            r"s_1 = \begin{cases} k\,x & \text{if } x < 0 \text{ or } x \ge \mu \\ 0 & \text{otherwise} \end{cases}",
            r"-\mu\,\dot x^{2}\operatorname{sign}\dot x",
            concat!(
                r"\begin{cases} 0 & \text{if } \left|\dot x\right| < 10^{-6} \text{ and } \left|k\,x\right| \le \mu \\ ",
                r"-\mu & \text{if } \dot x > 0 \\ \mu & \text{otherwise} \end{cases}"
            ),
            r"-s_1 - \max(\dot x, x)",
        ],
    );
}

#[test]
fn powers_and_functions() {
    check(
        [("x", "x"), ("y", "y"), ("z", r"\zeta"), ("p", "p^{*}")],
        |[x, y, z, p]| {
            vec![
                x - (y - z) - -(x + y) * z,
                x / y / z - x / (y / z),
                (x / y).squared() + (x * y).powi(-2) + p.squared() * p,
                (-x * y).exp() * (x * 2.0).sin() / 3.0,
                x.sin().squared().squared() * x - x.tan().powi(-1) + x.sin().asin().squared(),
                x.abs().powf(Traced::from(1.5)) + p.powf(y) * x.sin().powf(z) - (x + y).powf(-z * y),
                x.hypot(y + z) * y.atan2(x).cos() * (x * y).cbrt() * 0.75,
                // 0.1 times 3 is 0.30000000000000004: better left alone.
                (x * 2.0 * (y * 3.0)) / 4.0 + x * 0.1 * 3.0 * y - x.squared().powf(y),
            ]
        },
        &[
            "x - (y - z) + (x + y) * z",
            "x / (y * z) - x * z / y",
            "(x / y)^2 + (x * y)^(-2) + p^3",
            "exp(-x * y) * sin(2 * x) / 3",
            "sin(x)^4 * x - tan(x)^(-1) + asin(sin(x))^2",
            "abs(x)^1.5 + p^y * sin(x)^z - (x + y)^(-z * y)",
            "0.75 * hypot(x, y + z) * cos(atan2(y, x)) * cbrt(x * y)",
            "3 * x * y / 2 + 0.1 * 3 * x * y - (x^2)^y",
        ],
        &[
            r"x - (y - \zeta) + (x + y)\,\zeta",
            r"\frac{x}{y\,\zeta} - \frac{x\,\zeta}{y}",
            r"\left(\frac{x}{y}\right)^{2} + (x\,y)^{-2} + {p^{*}}^{3}",
            r"\frac{\mathrm{e}^{-x\,y}\sin(2x)}{3}",
            r"x\sin^{4} x - (\tan x)^{-1} + (\arcsin(\sin x))^{2}",
            r"\left|x\right|^{3/2} + {p^{*}}^{y}\,(\sin x)^{\zeta} - (x + y)^{-\zeta\,y}",
            r"\frac{3}{4}\,\sqrt{x^{2} + (y + \zeta)^{2}}\,\sqrt[3]{x\,y}\cos(\operatorname{atan2}(y, x))",
            r"\frac{3x\,y}{2} + 0.1 \cdot 3\,x\,y - (x^{2})^{y}",
        ],
    );
}
