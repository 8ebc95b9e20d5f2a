//! SSE2, AVX2 and AVX-512. No fused multiply-add: it rounds once where others round twice.

use super::{Register, instructions};
use crate::Kernel;
#[allow(clippy::wildcard_imports, reason = "a hundred instructions by their own names")]
use std::arch::x86_64::*;

/// Runs a kernel with instructions switched on that not every machine has.
macro_rules! entry {
    ($features:literal) => {
        #[inline(always)]
        #[allow(unsafe_code)]
        fn enter<K: Kernel>(kernel: K) -> K::Output {
            #[target_feature(enable = $features)]
            fn inner<K: Kernel>(kernel: K) -> K::Output {
                kernel.run()
            }
            // The caller has made sure that the machine has them (see `Register`).
            unsafe { inner(kernel) }
        }
    };
}

impl Register for __m128d {
    const LANES: usize = 2;
    type Word = __m128i;
    type Mask = __m128d;

    instructions! {
        splat(x: f64) -> Self { _mm_set1_pd(x) }
        add(a: Self, b: Self) -> Self { _mm_add_pd(a, b) }
        sub(a: Self, b: Self) -> Self { _mm_sub_pd(a, b) }
        mul(a: Self, b: Self) -> Self { _mm_mul_pd(a, b) }
        div(a: Self, b: Self) -> Self { _mm_div_pd(a, b) }
        sqrt(a: Self) -> Self { _mm_sqrt_pd(a) }
        lt(a: Self, b: Self) -> Self { _mm_cmplt_pd(a, b) }
        le(a: Self, b: Self) -> Self { _mm_cmple_pd(a, b) }
        eq(a: Self, b: Self) -> Self { _mm_cmpeq_pd(a, b) }
        select(m: Self, a: Self, b: Self) -> Self { _mm_or_pd(_mm_and_pd(m, a), _mm_andnot_pd(m, b)) }
        both(a: Self, b: Self) -> Self { _mm_and_pd(a, b) }
        either(a: Self, b: Self) -> Self { _mm_or_pd(a, b) }
        not(a: Self) -> Self { _mm_xor_pd(a, _mm_castsi128_pd(_mm_set1_epi64x(-1))) }
        truth(m: Self) -> u32 { _mm_movemask_pd(m) as u32 }
        to_word(a: Self) -> __m128i { _mm_castpd_si128(a) }
        from_word(a: __m128i) -> Self { _mm_castsi128_pd(a) }
        word(bits: u64) -> __m128i { _mm_set1_epi64x(bits.cast_signed()) }
        and(a: __m128i, b: __m128i) -> __m128i { _mm_and_si128(a, b) }
        or(a: __m128i, b: __m128i) -> __m128i { _mm_or_si128(a, b) }
        xor(a: __m128i, b: __m128i) -> __m128i { _mm_xor_si128(a, b) }
        plus(a: __m128i, b: __m128i) -> __m128i { _mm_add_epi64(a, b) }
        minus(a: __m128i, b: __m128i) -> __m128i { _mm_sub_epi64(a, b) }
        left(a: __m128i, bits: u32) -> __m128i { _mm_sll_epi64(a, _mm_cvtsi32_si128(bits.cast_signed())) }
        right(a: __m128i, bits: u32) -> __m128i { _mm_srl_epi64(a, _mm_cvtsi32_si128(bits.cast_signed())) }
        odd(a: __m128i) -> Self {
            _mm_castsi128_pd(_mm_sub_epi64(_mm_setzero_si128(), _mm_and_si128(a, _mm_set1_epi64x(1))))
        }
    }
}

impl Register for __m256d {
    const LANES: usize = 4;
    type Word = __m256i;
    type Mask = __m256d;

    entry!("avx2");
    instructions! {
        splat(x: f64) -> Self { _mm256_set1_pd(x) }
        add(a: Self, b: Self) -> Self { _mm256_add_pd(a, b) }
        sub(a: Self, b: Self) -> Self { _mm256_sub_pd(a, b) }
        mul(a: Self, b: Self) -> Self { _mm256_mul_pd(a, b) }
        div(a: Self, b: Self) -> Self { _mm256_div_pd(a, b) }
        sqrt(a: Self) -> Self { _mm256_sqrt_pd(a) }
        lt(a: Self, b: Self) -> Self { _mm256_cmp_pd::<_CMP_LT_OQ>(a, b) }
        le(a: Self, b: Self) -> Self { _mm256_cmp_pd::<_CMP_LE_OQ>(a, b) }
        eq(a: Self, b: Self) -> Self { _mm256_cmp_pd::<_CMP_EQ_OQ>(a, b) }
        select(m: Self, a: Self, b: Self) -> Self { _mm256_blendv_pd(b, a, m) }
        both(a: Self, b: Self) -> Self { _mm256_and_pd(a, b) }
        either(a: Self, b: Self) -> Self { _mm256_or_pd(a, b) }
        not(a: Self) -> Self { _mm256_xor_pd(a, _mm256_castsi256_pd(_mm256_set1_epi64x(-1))) }
        truth(m: Self) -> u32 { _mm256_movemask_pd(m) as u32 }
        to_word(a: Self) -> __m256i { _mm256_castpd_si256(a) }
        from_word(a: __m256i) -> Self { _mm256_castsi256_pd(a) }
        word(bits: u64) -> __m256i { _mm256_set1_epi64x(bits.cast_signed()) }
        and(a: __m256i, b: __m256i) -> __m256i { _mm256_and_si256(a, b) }
        or(a: __m256i, b: __m256i) -> __m256i { _mm256_or_si256(a, b) }
        xor(a: __m256i, b: __m256i) -> __m256i { _mm256_xor_si256(a, b) }
        plus(a: __m256i, b: __m256i) -> __m256i { _mm256_add_epi64(a, b) }
        minus(a: __m256i, b: __m256i) -> __m256i { _mm256_sub_epi64(a, b) }
        left(a: __m256i, bits: u32) -> __m256i { _mm256_sll_epi64(a, _mm_cvtsi32_si128(bits.cast_signed())) }
        right(a: __m256i, bits: u32) -> __m256i { _mm256_srl_epi64(a, _mm_cvtsi32_si128(bits.cast_signed())) }
        odd(a: __m256i) -> Self {
            _mm256_castsi256_pd(_mm256_sub_epi64(
                _mm256_setzero_si256(),
                _mm256_and_si256(a, _mm256_set1_epi64x(1)),
            ))
        }
    }
}

impl Register for __m512d {
    const LANES: usize = 8;
    type Word = __m512i;
    type Mask = __mmask8;

    entry!("avx512f,avx512vl,avx512dq,avx512bw");
    instructions! {
        splat(x: f64) -> Self { _mm512_set1_pd(x) }
        add(a: Self, b: Self) -> Self { _mm512_add_pd(a, b) }
        sub(a: Self, b: Self) -> Self { _mm512_sub_pd(a, b) }
        mul(a: Self, b: Self) -> Self { _mm512_mul_pd(a, b) }
        div(a: Self, b: Self) -> Self { _mm512_div_pd(a, b) }
        sqrt(a: Self) -> Self { _mm512_sqrt_pd(a) }
        lt(a: Self, b: Self) -> __mmask8 { _mm512_cmp_pd_mask::<_CMP_LT_OQ>(a, b) }
        le(a: Self, b: Self) -> __mmask8 { _mm512_cmp_pd_mask::<_CMP_LE_OQ>(a, b) }
        eq(a: Self, b: Self) -> __mmask8 { _mm512_cmp_pd_mask::<_CMP_EQ_OQ>(a, b) }
        select(m: __mmask8, a: Self, b: Self) -> Self { _mm512_mask_blend_pd(m, b, a) }
        both(a: __mmask8, b: __mmask8) -> __mmask8 { a & b }
        either(a: __mmask8, b: __mmask8) -> __mmask8 { a | b }
        not(a: __mmask8) -> __mmask8 { !a }
        truth(m: __mmask8) -> u32 { u32::from(m) }
        to_word(a: Self) -> __m512i { _mm512_castpd_si512(a) }
        from_word(a: __m512i) -> Self { _mm512_castsi512_pd(a) }
        word(bits: u64) -> __m512i { _mm512_set1_epi64(bits.cast_signed()) }
        and(a: __m512i, b: __m512i) -> __m512i { _mm512_and_si512(a, b) }
        or(a: __m512i, b: __m512i) -> __m512i { _mm512_or_si512(a, b) }
        xor(a: __m512i, b: __m512i) -> __m512i { _mm512_xor_si512(a, b) }
        plus(a: __m512i, b: __m512i) -> __m512i { _mm512_add_epi64(a, b) }
        minus(a: __m512i, b: __m512i) -> __m512i { _mm512_sub_epi64(a, b) }
        left(a: __m512i, bits: u32) -> __m512i { _mm512_sll_epi64(a, _mm_cvtsi32_si128(bits.cast_signed())) }
        right(a: __m512i, bits: u32) -> __m512i { _mm512_srl_epi64(a, _mm_cvtsi32_si128(bits.cast_signed())) }
        odd(a: __m512i) -> __mmask8 { _mm512_test_epi64_mask(a, _mm512_set1_epi64(1)) }
    }
}
