//! Where a system can rest, and what it does near there.
//!
//! Newton's method from a grid of coordinates with all velocities zero; the eigenvalues of the Jacobian then say
//! whether neighbours turn about the point (centre), spiral (focus), move straight (node) or pass by (saddle).

use crate::eigenvalues::{Complex, eigenvalues};
use crate::flow::Flow;
use crate::tangents::jacobian;
use precess_scalar::Scalar;

/// The part of the space of states that is looked at: a range for each number of the state.
#[derive(Clone, Debug, PartialEq)]
pub struct Window {
    /// From and to.
    pub ranges: Vec<(f64, f64)>,
}

impl Window {
    /// Whether a state lies inside, or on the border.
    pub fn contains(&self, state: &[f64]) -> bool {
        let slack = |(low, high): (f64, f64)| (high - low) * 1e-9;
        self.ranges.iter().zip(state).all(|(&r, &x)| r.0 - slack(r) <= x && x <= r.1 + slack(r))
    }
    /// The distance of two states, each number measured by its range.
    pub fn distance(&self, a: &[f64], b: &[f64]) -> f64 {
        let part = |i: usize| (a[i] - b[i]) / self.width(i);
        (0..self.ranges.len()).fold(0.0, |sum, i| sum + part(i) * part(i)).sqrt()
    }
    /// The width of a range.
    pub fn width(&self, i: usize) -> f64 {
        self.ranges[i].1 - self.ranges[i].0
    }
}

/// What neighbours of a fixed point do, to first order.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// They turn about it: all eigenvalues imaginary.
    Centre,
    /// They pass by: eigenvalues on both sides.
    Saddle,
    /// They move straight towards or away from it: all real, of one sign.
    Node,
    /// They spiral: some complex, all real parts of one sign.
    Focus,
    /// First order does not tell: some eigenvalue is zero, or only some are imaginary.
    Degenerate,
}

impl Kind {
    /// In a word.
    pub fn name(self) -> &'static str {
        match self {
            Self::Centre => "centre",
            Self::Saddle => "saddle",
            Self::Node => "node",
            Self::Focus => "focus",
            Self::Degenerate => "degenerate",
        }
    }
}

/// A state in which a system stays.
#[derive(Clone, Debug, PartialEq)]
pub struct FixedPoint {
    /// The state, without modes.
    pub state: Vec<f64>,
    /// Eigenvalues of the Jacobian there.
    pub eigenvalues: Vec<Complex>,
    /// What they say.
    pub kind: Kind,
    /// Neighbours come nearer: all real parts are below zero.
    pub stable: bool,
}

/// Starts of the search in one coordinate, and in several together.
const STARTS: f64 = 401.0;
const STARTS_TOGETHER: f64 = 4000.0;
/// Steps of Newton's method.
const STEPS: usize = 60;
/// The longest step, in shares of the window.
const LONGEST: f64 = 0.05;
/// Points nearer to each other than this, in shares of the window, are one.
const SAME: f64 = 1e-6;
/// A part of an eigenvalue below this share of the largest modulus is zero.
const ZERO: f64 = 1e-7;

/// The fixed points inside a window, in the order of their coordinates. The field must not depend on time; `modes`
/// are those that the state rests in.
pub fn fixed_points(flow: &Flow, modes: &[f64], window: &Window) -> Vec<FixedPoint> {
    let shape = flow.field.shape();
    let coordinates = shape.coordinates;
    let side = if coordinates == 1 {
        STARTS
    } else {
        let root = Scalar::exp(Scalar::ln(STARTS_TOGETHER) / coordinates as f64).floor();
        Scalar::larger(root, 3.0)
    };
    let mut counters = vec![0_u64; coordinates];
    let mut found: Vec<Vec<f64>> = vec![];
    loop {
        let mut state = vec![0.0; shape.state()];
        for (i, &counter) in counters.iter().enumerate() {
            state[i] = window.ranges[i].0 + window.width(i) * (counter as f64 / (side - 1.0));
        }
        if let Some(point) = newton(flow, modes, window, state)
            && !found.iter().any(|other| window.distance(other, &point) < SAME)
        {
            found.push(point);
        }
        let Some(turning) = counters.iter().position(|&c| c as f64 + 1.0 < side) else { break };
        counters[turning] += 1;
        counters[..turning].fill(0);
    }
    found.sort_by(|a, b| a.iter().zip(b).fold(std::cmp::Ordering::Equal, |o, (x, y)| o.then(x.total_cmp(y))));
    found.into_iter().filter_map(|state| classify(flow, modes, state)).collect()
}

fn newton(flow: &Flow, modes: &[f64], window: &Window, mut state: Vec<f64>) -> Option<Vec<f64>> {
    let size = state.len();
    let mut rate = vec![0.0; size + modes.len()];
    for _ in 0..STEPS {
        let full = [&state[..], modes].concat();
        flow.field.rate(0.0, &full, &mut rate);
        let step = jacobian(flow.tangents, 0.0, &full).solve(&rate[..size])?;
        let length = (0..size).fold(0.0, |sum: f64, i| sum.larger((step[i] / window.width(i)).abs()));
        if !length.is_finite() {
            return None;
        }
        let share = if length > LONGEST { LONGEST / length } else { 1.0 };
        for (x, d) in state.iter_mut().zip(&step) {
            *x -= share * d;
        }
        if length < 1e-14 {
            // The last digits of a zero are rounding about the scale of the window.
            state.iter_mut().enumerate().for_each(|(i, x)| {
                if x.abs() < 1e-14 * window.width(i) {
                    *x = 0.0;
                }
            });
            return window.contains(&state).then_some(state);
        }
    }
    None
}

/// What neighbours of a state of rest do; `None` where the Jacobian there has no numbers.
pub fn classify(flow: &Flow, modes: &[f64], state: Vec<f64>) -> Option<FixedPoint> {
    let full = [&state[..], modes].concat();
    let eigenvalues = eigenvalues(&jacobian(flow.tangents, 0.0, &full))?;
    let scale = eigenvalues.iter().fold(0.0, |largest: f64, e| e.modulus().larger(largest));
    let zero = |x: f64| x.abs() <= ZERO * scale;
    let all = |test: &dyn Fn(&Complex) -> bool| eigenvalues.iter().all(test);
    let any = |test: &dyn Fn(&Complex) -> bool| eigenvalues.iter().any(test);
    let (falls, grows) = (|e: &Complex| !zero(e.re) && e.re < 0.0, |e: &Complex| !zero(e.re) && e.re > 0.0);
    let turns = |e: &Complex| !zero(e.im);
    let kind = if all(&|e| zero(e.re) && turns(e)) && scale > 0.0 {
        Kind::Centre
    } else if any(&|e| zero(e.re) && !turns(e)) {
        Kind::Degenerate
    } else if any(&falls) && any(&grows) {
        Kind::Saddle
    } else if !(all(&falls) || all(&grows)) {
        Kind::Degenerate
    } else if any(&turns) {
        Kind::Focus
    } else {
        Kind::Node
    };
    let stable = all(&falls);
    Some(FixedPoint { state, eigenvalues, kind, stable })
}
