//! The times at which a run is sampled: every multiple of `every`, and the end.

/// Sample times of a run from zero, or of a stretch of it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Samples {
    until: f64,
    every: f64,
    /// Indices of the first sample and of the last.
    first: u64,
    last: u64,
    /// Index of the one at the end of the whole.
    end: u64,
}

/// A multiple of `every` this close to the end (in units of `every`) is the end.
const CLOSE: f64 = 1e-9;

impl Samples {
    /// Samples at k `every` up to `until` (negative: backwards), and at `until`.
    pub fn new(until: f64, every: f64) -> Self {
        let whole = (until.abs() / every + CLOSE).floor();
        let ends = (until.abs() - whole * every).abs() <= CLOSE * every;
        let end = if ends { whole as u64 } else { (whole as u64).saturating_add(1) };
        Self { until, every, first: 0, last: end, end }
    }
    /// Some of these samples: a run from the state at the first to the last, with the steps that the whole takes there.
    #[must_use]
    pub fn between(self, first: u64, last: u64) -> Self {
        Self { first, last, ..self }
    }
    /// Whether both numbers are finite, and `every` above zero.
    pub fn is_sensible(&self) -> bool {
        self.until.is_finite() && self.every.is_finite() && self.every > 0.0
    }
    /// Index of the first sample, where the run starts.
    pub fn first(&self) -> u64 {
        self.first
    }
    /// Index of the last sample, where it ends.
    pub fn last(&self) -> u64 {
        self.last
    }
    /// The time of a sample: computed from its index, not accumulated.
    pub fn time(&self, k: u64) -> f64 {
        let t = k as f64 * self.every;
        match k {
            _ if k >= self.end => self.until,
            _ if self.until < 0.0 => -t,
            _ => t,
        }
    }
}
