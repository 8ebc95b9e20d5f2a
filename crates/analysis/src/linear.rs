//! Linear equations, found by looking: y' = A y + f(t), with A the same everywhere and at all times.

use crate::flow::Flow;
use crate::matrix::Matrix;
use crate::response::Response;
use crate::tangents::jacobian;
use precess_scalar::Scalar;

/// The matrix of a system whose equations are linear with constant coefficients.
#[derive(Clone, Debug, PartialEq)]
pub struct Linear {
    /// A, of y' = A y + f(t).
    pub matrix: Matrix,
}

/// States and times at which the Jacobian is looked at, spread without a pattern.
const PROBES: [f64; 4] = [0.0, 0.7390851332151607, -1.618033988749895, 2.414213562373095];

/// A system's matrix; `None` where its Jacobian is not the same everywhere.
pub fn linear(flow: &Flow) -> Option<Linear> {
    let shape = flow.field.shape();
    if shape.modes > 0 {
        return None;
    }
    let at = |probe: f64| {
        let state: Vec<f64> =
            (0..shape.state()).map(|i| probe * (1.0 + 0.3 * i as f64 * probe.abs())).collect();
        jacobian(flow.tangents, probe.abs(), &state)
    };
    let matrix = at(PROBES[0]);
    let same = |other: Matrix| {
        let near = |(a, b): (&f64, &f64)| (a - b).abs() <= 1e-13 * Scalar::larger(a.abs(), b.abs());
        other.numbers.iter().zip(&matrix.numbers).all(near)
    };
    PROBES[1..].iter().all(|&probe| same(at(probe))).then_some(Linear { matrix })
}

/// Samples of a period of the forcing.
const SAMPLES: u32 = 64;

/// The fundamental (cosine and sine part) of the forcing f(t) = y' at y = 0, for each number of the state.
pub(crate) fn forcing(flow: &Flow, period: f64) -> Vec<[f64; 2]> {
    let (size, full) = (flow.size(), flow.field.shape().full());
    let (state, mut rate) = (vec![0.0; full], vec![0.0; full]);
    let mut parts = vec![[0.0; 2]; size];
    for k in 0..SAMPLES {
        let share = f64::from(k) / f64::from(SAMPLES);
        flow.field.rate(share * period, &state, &mut rate);
        let (sin, cos) = Scalar::sin_cos(std::f64::consts::TAU * share);
        for (part, x) in parts.iter_mut().zip(&rate) {
            part[0] += x * cos * (2.0 / f64::from(SAMPLES));
            part[1] += x * sin * (2.0 / f64::from(SAMPLES));
        }
    }
    parts
}

impl Linear {
    /// The steady oscillation of a number of the state under a harmonic drive, exactly: with f = Re(F exp(i w t)),
    /// the state is Re(X exp(i w t)) where (i w - A) X = F.
    pub fn steady(&self, flow: &Flow, period: f64, coordinate: usize) -> Option<Response> {
        let n = self.matrix.size;
        let omega = std::f64::consts::TAU / period;
        let parts = forcing(flow, period);
        let mut both = Matrix::zeros(2 * n);
        let mut right = vec![0.0; 2 * n];
        for i in 0..n {
            for j in 0..n {
                both.set(i, j, -self.matrix.at(i, j));
                both.set(n + i, n + j, -self.matrix.at(i, j));
            }
            both.set(i, n + i, -omega);
            both.set(n + i, i, omega);
            // A cos + B sin is the real part of (A - i B) exp(i w t).
            (right[i], right[n + i]) = (parts[i][0], -parts[i][1]);
        }
        let x = both.solve(&right)?;
        let own = [x[coordinate], -x[n + coordinate]];
        Some(Response::of(omega, own, drive(flow, &parts, coordinate)))
    }
}

/// The forcing of a coordinate: that of its velocity, where it has one.
pub(crate) fn drive(flow: &Flow, parts: &[[f64; 2]], coordinate: usize) -> [f64; 2] {
    let pair = flow.field.shape().pairs().find(|&(i, _)| i == coordinate);
    parts[pair.map_or(coordinate, |(_, velocity)| velocity)]
}
