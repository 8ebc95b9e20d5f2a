//! The phase portrait of one degree of freedom: energy levels, separatrices, the potential above.

use crate::contour::{Line, contour};
use crate::eigenvalues::Complex;
use crate::fixed_points::{FixedPoint, Kind, Window};
use crate::flow::Flow;
use crate::tangents::jacobian;
use precess_integrate::Watched;
use precess_scalar::Scalar;
use precess_system::{Direction, Field};

/// Points along an axis from one end of a range to the other.
fn along((low, high): (f64, f64), points: usize) -> Vec<f64> {
    (0..points).map(|k| low + (high - low) * (k as f64 / (points - 1) as f64)).collect()
}

/// An observable along the first coordinate with everything else at zero: the potential, where it is the energy.
pub fn at_rest(field: &dyn Field<f64>, observable: usize, window: &Window, points: usize) -> Line {
    let mut observed = vec![0.0; field.shape().observables];
    let mut state = vec![0.0; field.shape().full()];
    let mut value = |x: f64| {
        state[0] = x;
        field.observe(0.0, &state, &mut observed);
        (x, observed[observable])
    };
    along(window.ranges[0], points).into_iter().map(&mut value).collect()
}

/// The lines on which an observable has these values, over the window of a state of two numbers.
pub fn levels(
    field: &dyn Field<f64>,
    observable: usize,
    window: &Window,
    levels: &[f64],
    points: usize,
) -> Vec<Line> {
    let (xs, ys) = (along(window.ranges[0], points), along(window.ranges[1], points));
    let mut observed = vec![0.0; field.shape().observables];
    let mut state = vec![0.0; field.shape().full()];
    let mut values = Vec::with_capacity(points * points);
    for &y in &ys {
        for &x in &xs {
            (state[0], state[1]) = (x, y);
            field.observe(0.0, &state, &mut observed);
            values.push(observed[observable]);
        }
    }
    levels.iter().flat_map(|&level| contour(&xs, &ys, &values, level)).collect()
}

/// A branch of a separatrix: it leaves a saddle, or ends there.
#[derive(Clone, Debug, PartialEq)]
pub struct Branch {
    /// Its points, from the saddle on.
    pub line: Line,
    /// It leaves the saddle as time goes on.
    pub leaves: bool,
}

/// A branch begins at this distance from its saddle, in shares of the window: its error is the square of that.
const BEGINS: f64 = 1e-5;
/// And ends this near to any fixed point: a branch that ends in a saddle never gets there.
const ENDS: f64 = 2e-3;
/// Records of a branch.
const RECORDS: f64 = 4000.0;

/// The branches of all saddles among these points of a state of two numbers, followed for `span` at most and within
/// the window (with as much around it).
pub fn separatrices(flow: &Flow, points: &[FixedPoint], window: &Window, span: f64) -> Vec<Branch> {
    let mut branches = vec![];
    for saddle in points.iter().filter(|p| p.kind == Kind::Saddle && p.state.len() == 2) {
        for &Complex { re, .. } in &saddle.eigenvalues {
            let direction = eigenvector(flow, saddle, re);
            let scale = window.distance(&[0.0, 0.0], &direction);
            for side in [BEGINS, -BEGINS] {
                let start: Vec<f64> =
                    (0..2).map(|i| saddle.state[i] + direction[i] * (side / scale)).collect();
                let line = follow(flow, points, window, &start, if re > 0.0 { span } else { -span });
                branches.push(Branch { line, leaves: re > 0.0 });
            }
        }
    }
    branches
}

/// The direction that the Jacobian of a saddle stretches by `value`.
fn eigenvector(flow: &Flow, saddle: &FixedPoint, value: f64) -> [f64; 2] {
    let mut full = saddle.state.clone();
    full.resize(flow.field.shape().full(), 0.0);
    let j = jacobian(flow.tangents, 0.0, &full);
    let (a, b) = ([j.at(0, 1), value - j.at(0, 0)], [value - j.at(1, 1), j.at(1, 0)]);
    let length = |v: [f64; 2]| Scalar::hypot(v[0], v[1]);
    if length(a) > length(b) { a } else { b }
}

/// A trajectory from a state of two numbers, followed for `span` at most and within the window (with as much around it).
pub fn trail(flow: &Flow, window: &Window, start: &[f64; 2], span: f64) -> Line {
    follow(flow, &[], window, start, span)
}

fn follow(flow: &Flow, points: &[FixedPoint], window: &Window, start: &[f64], span: f64) -> Line {
    let outside = |y: &[f64]| {
        (0..2).fold(f64::NEG_INFINITY, |most, i| {
            let (low, high) = window.ranges[i];
            let beyond = Scalar::larger(low - y[i], y[i] - high) / (high - low);
            Scalar::larger(most, beyond)
        }) - 1.0
    };
    let nearest = |y: &[f64]| {
        points.iter().fold(f64::INFINITY, |d, p| Scalar::smaller(d, window.distance(&p.state, y))) - ENDS
    };
    let watches = [
        Watched { function: Box::new(|_, y| outside(y)), direction: Direction::Rising, stop: true },
        Watched { function: Box::new(|_, y| nearest(y)), direction: Direction::Falling, stop: true },
    ];
    let mut full = start.to_vec();
    full.resize(flow.field.shape().full(), 0.0);
    let mut line = vec![];
    let mut record = |_: f64, y: &[f64]| line.push((y[0], y[1]));
    // A branch that cannot be followed to its end is as long as it is.
    let _ = flow.run(0.0, &full, (span, span.abs() / RECORDS), &watches, &mut record);
    line
}
