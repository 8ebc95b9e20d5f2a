//! WebAssembly's fixed-width SIMD; the relaxed one may round differently from machine to machine.

use super::{Register, instructions};
#[allow(clippy::wildcard_imports, reason = "a hundred instructions by their own names")]
use std::arch::wasm32::*;

impl Register for v128 {
    const LANES: usize = 2;
    type Word = v128;
    type Mask = v128;

    instructions! {
        splat(x: f64) -> Self { f64x2_splat(x) }
        add(a: Self, b: Self) -> Self { f64x2_add(a, b) }
        sub(a: Self, b: Self) -> Self { f64x2_sub(a, b) }
        mul(a: Self, b: Self) -> Self { f64x2_mul(a, b) }
        div(a: Self, b: Self) -> Self { f64x2_div(a, b) }
        sqrt(a: Self) -> Self { f64x2_sqrt(a) }
        lt(a: Self, b: Self) -> v128 { f64x2_lt(a, b) }
        le(a: Self, b: Self) -> v128 { f64x2_le(a, b) }
        eq(a: Self, b: Self) -> v128 { f64x2_eq(a, b) }
        select(m: v128, a: Self, b: Self) -> Self { v128_bitselect(a, b, m) }
        both(a: v128, b: v128) -> v128 { v128_and(a, b) }
        either(a: v128, b: v128) -> v128 { v128_or(a, b) }
        not(a: v128) -> v128 { v128_not(a) }
        truth(m: v128) -> u32 { u32::from(i64x2_bitmask(m)) }
        to_word(a: Self) -> v128 { a }
        from_word(a: v128) -> Self { a }
        word(bits: u64) -> v128 { u64x2_splat(bits) }
        and(a: v128, b: v128) -> v128 { v128_and(a, b) }
        or(a: v128, b: v128) -> v128 { v128_or(a, b) }
        xor(a: v128, b: v128) -> v128 { v128_xor(a, b) }
        plus(a: v128, b: v128) -> v128 { i64x2_add(a, b) }
        minus(a: v128, b: v128) -> v128 { i64x2_sub(a, b) }
        left(a: v128, bits: u32) -> v128 { i64x2_shl(a, bits) }
        right(a: v128, bits: u32) -> v128 { u64x2_shr(a, bits) }
        odd(a: v128) -> v128 { i64x2_sub(i64x2_splat(0), v128_and(a, i64x2_splat(1))) }
    }
}
