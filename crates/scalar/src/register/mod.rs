//! Registers: what one instruction of a machine computes with.
//!
//! | register          | numbers | where                                    |
//! |-------------------|---------|------------------------------------------|
//! | `f64`             | 1       | everywhere                               |
//! | [`Narrow`]        | 4       | SSE2, NEON, simd128; else one `f64`      |
//! | [`Wide`]          | 8       | AVX2; else the narrow one                |
//! | [`Widest`]        | 16      | AVX-512; else the narrow one             |
//!
//! The last three are pairs: two registers, used in turn.
//!
//! Plain loops over arrays were tried first: the compiler turned some into vector instructions and others into
//! shuffles and reloads, twice as slow and never the same from one release to the next. The operations are
//! therefore named one by one, and every machine rounds each of them in the same way.

#[cfg(target_arch = "aarch64")]
mod neon;
mod pair;
#[cfg(all(target_arch = "wasm32", target_feature = "simd128"))]
mod simd128;
mod single;
mod word;
#[cfg(target_arch = "x86_64")]
mod x86;

pub use word::Word;

use crate::Kernel;

#[cfg(target_arch = "x86_64")]
mod widths {
    pub type Narrow = [std::arch::x86_64::__m128d; 2];
    pub type Wide = [std::arch::x86_64::__m256d; 2];
    pub type Widest = [std::arch::x86_64::__m512d; 2];
}
#[cfg(target_arch = "aarch64")]
mod widths {
    pub type Narrow = [std::arch::aarch64::float64x2_t; 2];
    pub type Wide = Narrow;
    pub type Widest = Narrow;
}
#[cfg(all(target_arch = "wasm32", target_feature = "simd128"))]
mod widths {
    pub type Narrow = [std::arch::wasm32::v128; 2];
    pub type Wide = Narrow;
    pub type Widest = Narrow;
}
/// A machine without such registers computes with plain numbers: nothing is compiled a second time for it.
#[cfg(not(any(
    target_arch = "x86_64",
    target_arch = "aarch64",
    all(target_arch = "wasm32", target_feature = "simd128")
)))]
mod lanes {
    /// Plain numbers: this machine has no lanes.
    pub type Narrow = f64;
    /// The same.
    pub type Wide = f64;
    /// The same.
    pub type Widest = f64;
}
#[cfg(any(
    target_arch = "x86_64",
    target_arch = "aarch64",
    all(target_arch = "wasm32", target_feature = "simd128")
))]
mod lanes {
    use super::widths;
    use crate::Batch;
    /// The lanes that every machine of this architecture has.
    pub type Narrow = Batch<widths::Narrow>;
    /// Wider ones, or the same.
    pub type Wide = Batch<widths::Wide>;
    /// The widest, or the same.
    pub type Widest = Batch<widths::Widest>;
}
pub use lanes::{Narrow, Wide, Widest};

/// A few numbers that go through the same operations at once, each rounded as IEEE 754 says.
///
/// A register that not every machine has must be used inside [`enter`](Register::enter) alone, on a machine that
/// has it (see [`Isa`](crate::Isa)); elsewhere the program ends on an instruction that does not exist.
pub trait Register: Copy + Send + Sync + 'static {
    /// How many numbers.
    const LANES: usize;
    /// The bits of the numbers.
    type Word: Copy + Send + Sync;
    /// A truth value for each number.
    type Mask: Copy + Send + Sync;

    /// Runs a kernel with the register's instructions switched on.
    #[inline(always)]
    fn enter<K: Kernel>(kernel: K) -> K::Output {
        kernel.run()
    }

    /// The same number everywhere.
    fn splat(x: f64) -> Self;
    /// Sum.
    fn add(a: Self, b: Self) -> Self;
    /// Difference.
    fn sub(a: Self, b: Self) -> Self;
    /// Product.
    fn mul(a: Self, b: Self) -> Self;
    /// Quotient.
    fn div(a: Self, b: Self) -> Self;
    /// Square root.
    fn sqrt(a: Self) -> Self;

    /// `a < b`; false where either is NaN.
    fn lt(a: Self, b: Self) -> Self::Mask;
    /// `a <= b`; false where either is NaN.
    fn le(a: Self, b: Self) -> Self::Mask;
    /// `a == b`; false where either is NaN.
    fn eq(a: Self, b: Self) -> Self::Mask;
    /// `a` where the mask holds, `b` elsewhere.
    fn select(mask: Self::Mask, a: Self, b: Self) -> Self;
    /// Both hold.
    fn both(a: Self::Mask, b: Self::Mask) -> Self::Mask;
    /// One of them holds.
    fn either(a: Self::Mask, b: Self::Mask) -> Self::Mask;
    /// It does not hold.
    fn not(a: Self::Mask) -> Self::Mask;
    /// Bit i tells whether the mask holds for number i.
    fn truth(mask: Self::Mask) -> u32;

    /// The numbers as bits.
    fn to_word(a: Self) -> Self::Word;
    /// The bits as numbers.
    fn from_word(a: Self::Word) -> Self;
    /// The same bits everywhere.
    fn word(bits: u64) -> Self::Word;
    /// Bitwise and.
    fn and(a: Self::Word, b: Self::Word) -> Self::Word;
    /// Bitwise or.
    fn or(a: Self::Word, b: Self::Word) -> Self::Word;
    /// Bitwise exclusive or.
    fn xor(a: Self::Word, b: Self::Word) -> Self::Word;
    /// Sum modulo `2^64`.
    fn plus(a: Self::Word, b: Self::Word) -> Self::Word;
    /// Difference modulo `2^64`.
    fn minus(a: Self::Word, b: Self::Word) -> Self::Word;
    /// Shift towards the high bits.
    fn left(a: Self::Word, bits: u32) -> Self::Word;
    /// Shift towards the low bits.
    fn right(a: Self::Word, bits: u32) -> Self::Word;
    /// Whether the lowest bit is set.
    fn odd(a: Self::Word) -> Self::Mask;
}

/// The operations of a register, each an instruction or two.
///
/// `unsafe`: the instructions of a wide register need a machine that has them; see [`Register`].
#[cfg(any(
    target_arch = "x86_64",
    target_arch = "aarch64",
    all(target_arch = "wasm32", target_feature = "simd128")
))]
macro_rules! instructions {
    ($($name:ident($($argument:ident: $type:ty),*) -> $result:ty { $body:expr })*) => {$(
        #[inline(always)]
        #[allow(unsafe_code, unused_unsafe)]
        fn $name($($argument: $type),*) -> $result {
            unsafe { $body }
        }
    )*};
}
#[cfg(any(
    target_arch = "x86_64",
    target_arch = "aarch64",
    all(target_arch = "wasm32", target_feature = "simd128")
))]
use instructions;
