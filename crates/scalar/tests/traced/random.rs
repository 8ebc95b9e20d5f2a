//! Random expressions, the same for every number: a pool of values grows by operations on earlier ones.

use precess_scalar::{Scalar, Tape};

/// Knuth's generator (MMIX), the high bits of it.
pub struct Generator(u64);

impl Generator {
    pub fn new(seed: u64) -> Self {
        let mut generator = Self(seed.wrapping_mul(0x9E37_79B9_7F4A_7C15) ^ 0x5DEE_CE66);
        generator.below(2);
        generator
    }
    pub fn below(&mut self, n: usize) -> usize {
        self.0 = self.0.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (self.0 >> 33) as usize % n
    }
    /// In [-2, 2].
    pub fn number(&mut self) -> f64 {
        self.below(4001) as f64 / 1000.0 - 2.0
    }
}

const LITERALS: [f64; 14] = [
    0.0,
    1.0,
    -1.0,
    2.0,
    -3.0,
    0.5,
    1.0 / 3.0,
    -9.81,
    6.674e-5,
    1.5e8,
    std::f64::consts::PI,
    -std::f64::consts::FRAC_PI_2,
    std::f64::consts::SQRT_2,
    0.1,
];

/// An expression of `operations` operations in `x`, drawn by `seed`.
pub fn expression<S: Scalar>(seed: u64, operations: usize, x: &[S]) -> S {
    let mut g = Generator::new(seed);
    let mut pool = x.to_vec();
    for _ in 0..operations {
        let literal = LITERALS[g.below(LITERALS.len())];
        // The latest values are taken often, so that the expression grows deep.
        let recent = pool.len() - 1 - g.below(pool.len().min(3));
        let (a, b) = (pool[recent], pool[g.below(pool.len())]);
        let (a, b) = if g.below(2) == 0 { (a, b) } else { (b, a) };
        pool.push(match g.below(34) {
            0 | 1 => a + b,
            2 | 3 => a - b,
            4..=6 => a * b,
            7 | 8 => a / b,
            9 => -a,
            10 => a + literal,
            11 => S::from(literal) - a,
            12 => a * literal,
            13 => S::from(literal) / a,
            14 => a / literal,
            15 => a.squared(),
            16 => a.powi([-3, -2, -1, 0, 1, 2, 3][g.below(7)]),
            17 => a.abs().powf(S::from(literal.abs().sqrt())),
            18 => a.abs().powf(b.sin()),
            19 => a.abs().sqrt(),
            20 => a.sin_cos().0 + a.cos(),
            21 => a.sin() * b.tan(),
            22 => a.atan2(b),
            23 => a.sin().asin() - b.cos().acos(),
            24 => (-a.abs()).exp(),
            25 => (a.abs() + 1.0).ln(),
            26 => a.tanh() - b.sin().sinh() * b.cos().cosh(),
            27 => a.cbrt(),
            28 => a.hypot(b),
            29 => a.sign() + b.larger(a) - a.smaller(b),
            30 => S::select(a.lt(b) | b.gt(S::from(literal)), a, b),
            31 => {
                let (high, low) = (a.le(b) & !b.lt(S::from(literal)), a.gt(S::from(1.0)) | b.gt(a));
                S::select(a.lt(S::from(literal)) & !(high & low), -a, b * 2.0)
            }
            32 => a - (b - a * literal),
            _ => a / (b * literal) * (a + b),
        });
    }
    pool[pool.len() - 1]
}

/// The value of a tape, and the largest magnitude on the way to it (at least 1) if the expression is tame:
/// what is not finite may change by simplifying, and what is huge may cancel.
pub fn value_and_size(tape: &Tape, x: &[f64]) -> (f64, Option<f64>) {
    let mut sizes = vec![1.0];
    let value = tape.evaluate_with(x, |_, value: Option<&f64>| sizes.extend(value.map(|v| v.abs())))[0];
    let tame = sizes.iter().all(|&size| size < 1e4);
    let largest = sizes.into_iter().fold(1.0, Scalar::larger);
    (value, tame.then_some(largest))
}
