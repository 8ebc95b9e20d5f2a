//! One number: a register that every machine has.

use super::Register;

impl Register for f64 {
    const LANES: usize = 1;
    type Word = u64;
    type Mask = bool;

    #[inline(always)]
    fn splat(x: f64) -> Self {
        x
    }
    #[inline(always)]
    fn add(a: Self, b: Self) -> Self {
        a + b
    }
    #[inline(always)]
    fn sub(a: Self, b: Self) -> Self {
        a - b
    }
    #[inline(always)]
    fn mul(a: Self, b: Self) -> Self {
        a * b
    }
    #[inline(always)]
    fn div(a: Self, b: Self) -> Self {
        a / b
    }
    #[inline(always)]
    fn sqrt(a: Self) -> Self {
        a.sqrt()
    }
    #[inline(always)]
    fn lt(a: Self, b: Self) -> bool {
        a < b
    }
    #[inline(always)]
    fn le(a: Self, b: Self) -> bool {
        a <= b
    }
    #[inline(always)]
    fn eq(a: Self, b: Self) -> bool {
        a == b
    }
    #[inline(always)]
    fn select(mask: bool, a: Self, b: Self) -> Self {
        if mask { a } else { b }
    }
    #[inline(always)]
    fn both(a: bool, b: bool) -> bool {
        a & b
    }
    #[inline(always)]
    fn either(a: bool, b: bool) -> bool {
        a | b
    }
    #[inline(always)]
    fn not(a: bool) -> bool {
        !a
    }
    #[inline(always)]
    fn truth(mask: bool) -> u32 {
        u32::from(mask)
    }
    #[inline(always)]
    fn to_word(a: Self) -> u64 {
        a.to_bits()
    }
    #[inline(always)]
    fn from_word(a: u64) -> Self {
        Self::from_bits(a)
    }
    #[inline(always)]
    fn word(bits: u64) -> u64 {
        bits
    }
    #[inline(always)]
    fn and(a: u64, b: u64) -> u64 {
        a & b
    }
    #[inline(always)]
    fn or(a: u64, b: u64) -> u64 {
        a | b
    }
    #[inline(always)]
    fn xor(a: u64, b: u64) -> u64 {
        a ^ b
    }
    #[inline(always)]
    fn plus(a: u64, b: u64) -> u64 {
        a.wrapping_add(b)
    }
    #[inline(always)]
    fn minus(a: u64, b: u64) -> u64 {
        a.wrapping_sub(b)
    }
    #[inline(always)]
    fn left(a: u64, bits: u32) -> u64 {
        a << bits
    }
    #[inline(always)]
    fn right(a: u64, bits: u32) -> u64 {
        a >> bits
    }
    #[inline(always)]
    fn odd(a: u64) -> bool {
        a & 1 == 1
    }
}
