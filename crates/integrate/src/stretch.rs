//! The steps of a fixed length from one time to another: all of exactly that length but the last.

/// A remainder below this share of a step is merged into the last step.
const MERGED: f64 = 1e-9;

/// Steps as (length, time at the end); times are computed from the start, never accumulated.
#[derive(Clone, Debug)]
pub(crate) struct Stretch {
    from: f64,
    to: f64,
    dt: f64,
    taken: u64,
    steps: u64,
}

impl Stretch {
    /// From one time to another by steps of length `dt`, which has the sign of their difference.
    pub fn new(from: f64, to: f64, dt: f64) -> Self {
        let whole = ((to - from) / dt - MERGED).ceil();
        let steps = if whole < 1.0 { 1 } else { whole as u64 };
        Self { from, to, dt, taken: 0, steps }
    }
    #[inline(always)]
    fn time(&self, n: u64) -> f64 {
        self.from + n as f64 * self.dt
    }
}

impl Iterator for Stretch {
    type Item = (f64, f64);

    #[inline(always)]
    fn next(&mut self) -> Option<(f64, f64)> {
        if self.taken == self.steps {
            return None;
        }
        self.taken += 1;
        if self.taken < self.steps {
            return Some((self.dt, self.time(self.taken)));
        }
        // A last step that differs from dt by no more than the rounding of the times is dt.
        let rest = self.to - self.time(self.taken - 1);
        let largest = if self.from.abs() < self.to.abs() { self.to.abs() } else { self.from.abs() };
        let merged = (rest - self.dt).abs() <= 4.0 * f64::EPSILON * largest;
        Some((if merged { self.dt } else { rest }, self.to))
    }
}
