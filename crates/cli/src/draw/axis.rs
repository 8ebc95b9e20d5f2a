//! One axis: the numbers of the data become numbers of moderate size for the plotting library.
//!
//! A range of 1e-14 about 6.28, or one of 1e300, has no ticks in common arithmetic. So an axis
//! subtracts an offset, divides by a power of ten, and says both in its labels.

use super::number::{decimal, decimals, exponent, next_step, nice_step, plain, superscript};

/// Larger values are left out of the picture: their differences overflow.
pub const LARGEST: f64 = 1e305;

/// Ranges narrower than this part of their values get an offset.
const NARROW: f64 = 2e-5;

/// The map from data to moderate numbers, the visible range of these, and the step of the ticks.
#[derive(Clone, Debug, PartialEq)]
pub struct Axis {
    logarithmic: bool,
    offset: f64,
    power: i32,
    /// Ten to the power.
    unit: f64,
    /// Visible range, in local numbers.
    pub lo: f64,
    /// Upper end.
    pub hi: f64,
    /// Between two ticks, in local numbers.
    pub step: f64,
}

impl Axis {
    /// An axis over the data range `lo..hi` with about `ticks` intervals.
    pub fn linear(lo: f64, hi: f64, ticks: f64) -> Self {
        let offset = offset(lo, hi);
        let (low, high) = (lo - offset, hi - offset);
        let lead = exponent(low.abs().max(high.abs()));
        let power = if (-3..6).contains(&lead) { 0 } else { lead };
        let unit = power_of_ten(power);
        let (lo, hi) = (low / unit, high / unit);
        Self { logarithmic: false, offset, power, unit, lo, hi, step: nice_step((hi - lo) / ticks) }
    }

    /// An axis in decades over the positive range `lo..hi`, from one power of ten to another.
    pub fn decades(lo: f64, hi: f64, ticks: f64) -> Self {
        let (low, high) = ((lo.log10() + 0.02).floor(), (hi.log10() - 0.02).ceil());
        let high = if high > low { high } else { low + 1.0 };
        let step = nice_step((high - low) / ticks).max(1.0);
        Self { logarithmic: true, offset: 0.0, power: 0, unit: 1.0, lo: low, hi: high, step }
    }

    /// The local number of a datum; NaN for what this axis cannot show.
    pub fn local(&self, value: f64) -> f64 {
        if !value.is_finite() || value.abs() > LARGEST {
            return f64::NAN;
        }
        if self.logarithmic {
            return if value > 0.0 { value.log10() } else { f64::NAN };
        }
        (value - self.offset) / self.unit
    }

    /// The length in data of a local length.
    pub fn value(&self, local: f64) -> f64 {
        local * self.unit
    }

    /// The ticks, in local numbers.
    pub fn ticks(&self) -> Vec<f64> {
        let slack = 1e-9 * self.step;
        let first = ((self.lo - slack) / self.step).ceil();
        let last = ((self.hi + slack) / self.step).floor();
        (0..=(last - first).clamp(-1.0, 99.0) as i64).map(|i| (first + i as f64) * self.step).collect()
    }

    /// What stands at the tick `local`.
    pub fn label(&self, local: f64) -> String {
        if self.logarithmic {
            return format!("10{}", superscript(local.round() as i32));
        }
        let text = decimal(local, decimals(self.step));
        let zero = local.abs() < 0.5 * self.step;
        if self.power == 0 {
            text
        } else if zero {
            "0".to_owned()
        } else {
            format!("{text}×10{}", superscript(self.power))
        }
    }

    /// What the label of the axis must add: ` − 6.2831853` where the ticks count from there.
    pub fn note(&self) -> String {
        if self.offset == 0.0 {
            return String::new();
        }
        let sign = if self.offset > 0.0 { '−' } else { '+' };
        format!(" {sign} {}", plain(self.offset))
    }

    /// Widens the step until labels of the measured width leave each other room on `length` pixels.
    pub fn spread(&mut self, length: f64, width: impl Fn(&str) -> f64) {
        for _ in 0..12 {
            let widest = self.ticks().iter().map(|&t| width(&self.label(t))).fold(0.0, f64::max);
            let pitch = length * self.step / (self.hi - self.lo);
            if widest + 16.0 <= pitch || self.ticks().len() < 3 {
                return;
            }
            self.step = next_step(self.step);
        }
    }
}

/// The number with the fewest digits close to a range too narrow for its own magnitude, else zero.
fn offset(lo: f64, hi: f64) -> f64 {
    let size = lo.abs().max(hi.abs());
    let span = hi - lo;
    if span <= 0.0 || span >= NARROW * size {
        return 0.0;
    }
    let middle = lo + 0.5 * span;
    let digits = exponent(size) - exponent(span);
    let rounded = |digits: i32| format!("{middle:.*e}", digits.clamp(0, 17) as usize).parse::<f64>();
    let near = |&o: &f64| o >= lo - 0.5 * span && o <= hi + 0.5 * span;
    (digits - 1..=digits + 1).filter_map(|d| rounded(d).ok()).find(near).unwrap_or(middle)
}

/// The nearest double to a power of ten, where repeated multiplication would be a little off.
fn power_of_ten(power: i32) -> f64 {
    format!("1e{power}").parse().unwrap_or(1.0)
}
