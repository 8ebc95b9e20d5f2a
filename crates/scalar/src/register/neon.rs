//! NEON, which every 64-bit ARM has.

use super::{Register, instructions};
#[allow(clippy::wildcard_imports, reason = "a hundred instructions by their own names")]
use std::arch::aarch64::*;

impl Register for float64x2_t {
    const LANES: usize = 2;
    type Word = uint64x2_t;
    type Mask = uint64x2_t;

    instructions! {
        splat(x: f64) -> Self { vdupq_n_f64(x) }
        add(a: Self, b: Self) -> Self { vaddq_f64(a, b) }
        sub(a: Self, b: Self) -> Self { vsubq_f64(a, b) }
        mul(a: Self, b: Self) -> Self { vmulq_f64(a, b) }
        div(a: Self, b: Self) -> Self { vdivq_f64(a, b) }
        sqrt(a: Self) -> Self { vsqrtq_f64(a) }
        lt(a: Self, b: Self) -> uint64x2_t { vcltq_f64(a, b) }
        le(a: Self, b: Self) -> uint64x2_t { vcleq_f64(a, b) }
        eq(a: Self, b: Self) -> uint64x2_t { vceqq_f64(a, b) }
        select(m: uint64x2_t, a: Self, b: Self) -> Self { vbslq_f64(m, a, b) }
        both(a: uint64x2_t, b: uint64x2_t) -> uint64x2_t { vandq_u64(a, b) }
        either(a: uint64x2_t, b: uint64x2_t) -> uint64x2_t { vorrq_u64(a, b) }
        not(a: uint64x2_t) -> uint64x2_t { veorq_u64(a, vdupq_n_u64(u64::MAX)) }
        truth(m: uint64x2_t) -> u32 {
            ((vgetq_lane_u64::<0>(m) & 1) | (vgetq_lane_u64::<1>(m) & 2)) as u32
        }
        to_word(a: Self) -> uint64x2_t { vreinterpretq_u64_f64(a) }
        from_word(a: uint64x2_t) -> Self { vreinterpretq_f64_u64(a) }
        word(bits: u64) -> uint64x2_t { vdupq_n_u64(bits) }
        and(a: uint64x2_t, b: uint64x2_t) -> uint64x2_t { vandq_u64(a, b) }
        or(a: uint64x2_t, b: uint64x2_t) -> uint64x2_t { vorrq_u64(a, b) }
        xor(a: uint64x2_t, b: uint64x2_t) -> uint64x2_t { veorq_u64(a, b) }
        plus(a: uint64x2_t, b: uint64x2_t) -> uint64x2_t { vaddq_u64(a, b) }
        minus(a: uint64x2_t, b: uint64x2_t) -> uint64x2_t { vsubq_u64(a, b) }
        left(a: uint64x2_t, bits: u32) -> uint64x2_t { vshlq_u64(a, vdupq_n_s64(i64::from(bits))) }
        // A shift by a negative count goes the other way.
        right(a: uint64x2_t, bits: u32) -> uint64x2_t { vshlq_u64(a, vdupq_n_s64(-i64::from(bits))) }
        odd(a: uint64x2_t) -> uint64x2_t { vsubq_u64(vdupq_n_u64(0), vandq_u64(a, vdupq_n_u64(1))) }
    }
}
