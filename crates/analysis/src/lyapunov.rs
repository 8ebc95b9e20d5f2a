//! Lyapunov exponents: how fast neighbours of a trajectory move away from it, in every direction.
//!
//! As many tangent vectors as the state has numbers are carried along and made orthonormal again and again; the
//! logarithms of what they have grown by, over time, are the exponents, the largest first (Benettin, Galgani,
//! Giorgilli, Strelcyn 1980). Their sum is the mean divergence of the equations, whatever the motion.
//!
//! The first part of the run is left out: the motion settles and the frame turns into place. The rest is cut into
//! batches, whose means are nearly independent, and Student's 95 % interval about their mean is the error.

use crate::flow::{Flow, Stopped};
use crate::frame::orthonormalise;
use precess_scalar::Scalar;

/// An exponent.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Exponent {
    /// The mean over the batches, per second.
    pub value: f64,
    /// Half the width of its 95 % interval.
    pub error: f64,
}

/// A spectrum and how it came about.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Lyapunov {
    /// The exponents in the order of the frame: the largest first, but for their errors.
    pub exponents: Vec<Exponent>,
    /// Time at the end of each batch, those left out included.
    pub times: Vec<f64>,
    /// For each exponent, its mean from the end of what is left out up to that time.
    pub history: Vec<Vec<f64>>,
}

/// Batches of the run, and how many of them are left out at the beginning.
const BATCHES: usize = 24;
const LEFT_OUT: usize = 4;
/// Student's t at 97.5 % for the `BATCHES - LEFT_OUT - 1` = 19 degrees of freedom.
const STUDENT: f64 = 2.093024054408263;
/// Between two orthonormalisations no direction may outgrow another by more than this: half the digits stay.
const STRETCHED: f64 = 1e6;
/// And where the frame stays rounder than this, the intervals become longer.
const ROUND: f64 = 10.0;
/// A batch is cut into at most two to this power intervals.
const FINEST: u32 = 40;

/// The spectrum of the motion from a full state at time zero over the time `until`.
///
/// # Errors
/// Where the integration cannot go on.
pub fn lyapunov(flow: &Flow, start: &[f64], until: f64) -> Result<Lyapunov, Stopped> {
    let size = flow.size();
    let mut frame = Frame { state: start.to_vec(), vectors: skew(size), halvings: 6 };
    let batch = until / BATCHES as f64;
    let mut rates: Vec<Vec<f64>> = vec![];
    let mut result = Lyapunov { history: vec![vec![]; size], ..Lyapunov::default() };
    for k in 0..BATCHES {
        let from = k as f64 * batch;
        let grown = frame.carry(flow, from, batch)?;
        rates.push(grown.into_iter().map(|sum| sum / batch).collect());
        result.times.push(from + batch);
        let first = if k < LEFT_OUT { k } else { LEFT_OUT };
        for (i, history) in result.history.iter_mut().enumerate() {
            let seen = &rates[first..];
            history.push(seen.iter().fold(0.0, |sum, r| sum + r[i]) / seen.len() as f64);
        }
    }
    let of = |i: usize| interval(&rates[LEFT_OUT..].iter().map(|r| r[i]).collect::<Vec<_>>());
    result.exponents = (0..size).map(of).collect();
    Ok(result)
}

/// An orthonormal frame along no axis: one that begins in a direction which the equations keep to themselves would
/// never turn out of it, and the exponents would not come in order.
fn skew(size: usize) -> Vec<Vec<f64>> {
    let part = |n: usize| (n as f64 * 0.618033988749895).fract() - 0.5;
    let vector = |k: usize| {
        (0..size).map(|i| if i == k { 1.0 } else { 0.0 } + part((i + 1) * (k + 2)) * 0.5).collect()
    };
    let mut vectors: Vec<Vec<f64>> = (0..size).map(vector).collect();
    orthonormalise(&mut vectors);
    vectors
}

/// Mean and half-width of the 95 % interval of the batches' rates.
fn interval(rates: &[f64]) -> Exponent {
    let n = rates.len() as f64;
    let value = rates.iter().fold(0.0, |sum, r| sum + r) / n;
    let square = rates.iter().fold(0.0, |sum, r| sum + (r - value) * (r - value)) / (n - 1.0);
    Exponent { value, error: STUDENT * (square / n).sqrt() }
}

/// A state with its orthonormal frame.
struct Frame {
    state: Vec<f64>,
    vectors: Vec<Vec<f64>>,
    /// A batch is cut into two to this power intervals.
    halvings: u32,
}

impl Frame {
    /// Carries the frame over a batch; the logarithms of what each direction has grown by.
    fn carry(&mut self, flow: &Flow, from: f64, batch: f64) -> Result<Vec<f64>, Stopped> {
        let mut grown = vec![0.0; self.vectors.len()];
        let mut done: u64 = 0;
        while done < 1 << self.halvings {
            let interval = batch / (1_u64 << self.halvings) as f64;
            let mut next = (self.state.clone(), self.vectors.clone());
            let carried = flow.carry(from + done as f64 * interval, &mut next.0, &mut next.1, interval);
            let diagonal = orthonormalise(&mut next.1);
            let (low, high) = diagonal
                .iter()
                .fold((f64::INFINITY, 0.0), |(low, high): (f64, f64), &r| (r.smaller(low), r.larger(high)));
            let whole = diagonal.iter().all(|r| r.is_finite()) && high <= STRETCHED * low;
            if !whole && self.halvings < FINEST && !matches!(carried, Err(Stopped::Interrupted { .. })) {
                // Too far at once: the same again in two halves.
                (self.halvings, done) = (self.halvings + 1, done * 2);
                continue;
            }
            carried?;
            (self.state, self.vectors) = next;
            for (sum, r) in grown.iter_mut().zip(&diagonal) {
                *sum += Scalar::ln(*r);
            }
            done += 1;
            if high <= ROUND * low && self.halvings > 0 && done.is_multiple_of(2) {
                (self.halvings, done) = (self.halvings - 1, done / 2);
            }
        }
        Ok(grown)
    }
}
