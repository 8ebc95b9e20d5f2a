//! The elementary functions of double-double numbers, right to about `1e-30` of themselves.
//!
//! Taylor series after a reduction, or one step of Newton's iteration from the `f64` value, which doubles
//! its digits. Sine and cosine reduce every argument by the 2/pi of Payne and Hanek; their error is
//! `1e-31` absolutely, and relatively too for arguments that are doubles. `powf` loses the digits of
//! `y ln x`: at most three.

use super::DoubleDouble;
use super::constants::{FRAC_PI_2, INVERSE_FACTORIAL, LN2_PARTS, LN2_REST};
use crate::{Scalar, elementary};

type Dd = DoubleDouble;

/// `sum z^k / (first + step k)!` up to the last factorial of the table.
fn inverse_factorials(z: Dd, first: usize, step: usize) -> Dd {
    let mut sum = Dd::from(0.0);
    for term in INVERSE_FACTORIAL[first..].iter().step_by(step).rev() {
        sum = sum * z + *term;
    }
    sum
}

/// `n ln 2`, exactly but for the last part.
fn times_ln2(n: f64) -> [Dd; 3] {
    [Dd::from(n * LN2_PARTS[0]), Dd::from(n * LN2_PARTS[1]), LN2_REST * n]
}

/// `2^n` for `n` in -1022..=1023.
fn power_of_two(n: i64) -> f64 {
    f64::from_bits((n + 1023).cast_unsigned() << 52)
}

/// The integer nearest to a number below `2^51`.
fn nearest(x: f64) -> f64 {
    (x + 6755399441055744.0) - 6755399441055744.0
}

/// The power of two (as an exponent) that brings a positive double near 1.
fn binary_exponent(x: f64) -> i64 {
    let (bits, shift) =
        if x < f64::MIN_POSITIVE { ((x * 18014398509481984.0).to_bits(), 54) } else { (x.to_bits(), 0) };
    ((bits >> 52) & 0x7ff).cast_signed() - 1023 - shift
}

impl DoubleDouble {
    /// `self 2^n`, in steps that a double can hold.
    fn shifted(self, n: i64) -> Self {
        let half = n / 2;
        self.scaled(power_of_two(half)).scaled(power_of_two(n - half))
    }
    /// Quadrant and rest, in units of a quarter turn, of a finite angle.
    fn quarter_turns(self) -> (u64, Self) {
        let part = |x: f64| {
            if x.abs() < 0.00390625 {
                (0, Self::from(x) / FRAC_PI_2)
            } else {
                let (quadrant, (high, low)) = elementary::turns(x);
                (quadrant, Self::new(high, low))
            }
        };
        let ((q1, first), (q2, second)) = (part(self.hi), part(self.lo));
        let sum = first + second;
        let whole = nearest(sum.hi);
        (q1.wrapping_add(q2).wrapping_add((whole as i64).cast_unsigned()), sum - whole)
    }
    /// `e^x - 1` of a small argument (below one in size).
    fn exp_m1(self) -> Self {
        let x = self.scaled(1.0 / 512.0);
        let mut power = x * inverse_factorials(x, 1, 1);
        for _ in 0..9 {
            power = power.scaled(2.0) + power * power;
        }
        power
    }
    /// `e^x 2^shift`.
    fn exp_times(self, shift: i64) -> Self {
        if self.hi.is_nan() || self.hi.abs() > 745.2 {
            return Self::from(elementary::exp(self.hi));
        }
        let n = nearest(self.hi * std::f64::consts::LOG2_E);
        let [first, second, third] = times_ln2(n);
        ((self - first - second - third).exp_m1() + 1.0).shifted(n as i64 + shift)
    }
    /// `2 atanh s`, by its series.
    fn twice_atanh(s: Self) -> Self {
        let square = s * s;
        let mut sum = Self::from(0.0);
        for k in (0..24).rev() {
            sum = sum * square + Self::from(2.0) / f64::from(2 * k + 1);
        }
        s * sum
    }
}

impl Scalar for DoubleDouble {
    type Mask = bool;
    type Abreast = Self;

    fn all(mask: bool) -> bool {
        mask
    }

    fn lt(self, other: Self) -> bool {
        self < other
    }
    fn le(self, other: Self) -> bool {
        self <= other
    }
    fn select(mask: bool, a: Self, b: Self) -> Self {
        if mask { a } else { b }
    }
    fn sqrt(self) -> Self {
        self.root()
    }
    fn sin_cos(self) -> (Self, Self) {
        if !self.hi.is_finite() || self.hi == 0.0 {
            let (sin, cos) = elementary::sin_cos(self.hi);
            return (Self::from(sin), Self::from(cos));
        }
        let (quadrant, r) = if self.hi.abs() < 0.785 {
            (0, self)
        } else {
            let (quadrant, rest) = self.quarter_turns();
            (quadrant, rest * FRAC_PI_2)
        };
        let minus_square = -(r * r);
        let sin = r * inverse_factorials(minus_square, 1, 2);
        let cos = inverse_factorials(minus_square, 0, 2);
        match quadrant & 3 {
            0 => (sin, cos),
            1 => (cos, -sin),
            2 => (-sin, -cos),
            _ => (-cos, sin),
        }
    }
    fn tan(self) -> Self {
        let (sin, cos) = self.sin_cos();
        sin / cos
    }
    fn atan2(self, x: Self) -> Self {
        let start = elementary::atan2(self.hi, x.hi);
        let long = if self.hi.abs() > x.hi.abs() { self.hi.abs() } else { x.hi.abs() };
        if start.is_nan() || long == 0.0 || long == f64::INFINITY {
            return Self::from(start);
        }
        // Scaled to unit size, then turned back by the approximate angle; the rest is its own tangent.
        let n = -binary_exponent(long);
        let (y, x) = (self.shifted(n), x.shifted(n));
        let (sin, cos) = Self::from(start).sin_cos();
        let rest = (y * cos - x * sin) / (x * cos + y * sin);
        if start == 0.0 { Self::from(start) } else { rest + start }
    }
    fn asin(self) -> Self {
        self.atan2(((-self + 1.0) * (self + 1.0)).sqrt())
    }
    fn acos(self) -> Self {
        ((-self + 1.0) * (self + 1.0)).sqrt().atan2(self)
    }
    fn exp(self) -> Self {
        self.exp_times(0)
    }
    fn ln(self) -> Self {
        if !(self.hi > 0.0 && self.hi < f64::INFINITY) {
            return Self::from(elementary::ln(self.hi));
        }
        let near_one = self.hi > 0.9 && self.hi < 1.1;
        let n = if near_one { 0 } else { binary_exponent(self.hi * 1.41) };
        let m = self.shifted(-n);
        if near_one {
            return Self::twice_atanh((m - 1.0) / (m + 1.0));
        }
        // Newton: ln m = y + ln(m e^-y), and m e^-y is 1 to the digits of a double.
        let y = elementary::ln(m.hi);
        let rest = m * (Self::from(-y).exp_m1() + 1.0) - 1.0;
        let [first, second, third] = times_ln2(n as f64);
        first + (second + (third + (rest + y)))
    }
    fn sinh(self) -> Self {
        if self.hi.abs() < 0.7 {
            return self * inverse_factorials(self * self, 1, 2);
        }
        let half = self.abs().exp_times(-1);
        let size = if half.hi < 1e20 { half - Self::from(0.25) / half } else { half };
        if self.hi < 0.0 { -size } else { size }
    }
    fn cosh(self) -> Self {
        let half = self.abs().exp_times(-1);
        if half.hi < 1e20 { half + Self::from(0.25) / half } else { half }
    }
    fn tanh(self) -> Self {
        if self.hi.abs() > 40.0 { Self::from(elementary::tanh(self.hi)) } else { self.sinh() / self.cosh() }
    }
    fn powi(self, n: i32) -> Self {
        elementary::repeated_squaring(self, n)
    }
    fn powf(self, exponent: Self) -> Self {
        let plain = elementary::powf(self.hi, exponent.hi);
        if !plain.is_finite() || plain == 0.0 || exponent.hi == 0.0 || !exponent.hi.is_finite() {
            return Self::from(plain);
        }
        let size = (exponent * self.abs().ln()).exp();
        if plain < 0.0 { -size } else { size }
    }
    fn cbrt(self) -> Self {
        if self.hi == 0.0 || !self.hi.is_finite() {
            return Self::from(elementary::cbrt(self.hi));
        }
        // Newton, on a number of moderate size.
        let n = binary_exponent(self.hi.abs()) / 3;
        let m = self.shifted(-3 * n);
        let root = Self::from(elementary::cbrt(m.hi));
        let square = root * root;
        (root - (square * root - m) / square.scaled(3.0)).shifted(n)
    }
    fn hypot(self, other: Self) -> Self {
        let long = if self.hi.abs() > other.hi.abs() { self.hi.abs() } else { other.hi.abs() };
        let plain = elementary::hypot(self.hi, other.hi);
        if !plain.is_finite() || long == 0.0 {
            return Self::from(plain);
        }
        let n = binary_exponent(long);
        let (a, b) = (self.shifted(-n), other.shifted(-n));
        (a * a + b * b).sqrt().shifted(n)
    }
    fn abs(self) -> Self {
        if self.hi.is_sign_negative() { -self } else { self }
    }
}
