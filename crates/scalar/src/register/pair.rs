//! Two registers that are used in turn: while one waits for a division or a root, the other is begun. One alone would
//! leave the processor half idle; more do not fit the sixteen registers that most machines name.

use super::Register;
use crate::Kernel;

macro_rules! twice {
    ($($name:ident($($argument:ident: $type:ty),*) -> $result:ty;)*) => {$(
        #[inline(always)]
        fn $name($($argument: [$type; 2]),*) -> [$result; 2] {
            [V::$name($($argument[0]),*), V::$name($($argument[1]),*)]
        }
    )*};
}

impl<V: Register> Register for [V; 2] {
    const LANES: usize = 2 * V::LANES;
    type Word = [V::Word; 2];
    type Mask = [V::Mask; 2];

    #[inline(always)]
    fn enter<K: Kernel>(kernel: K) -> K::Output {
        V::enter(kernel)
    }
    #[inline(always)]
    fn splat(x: f64) -> Self {
        [V::splat(x); 2]
    }
    #[inline(always)]
    fn word(bits: u64) -> Self::Word {
        [V::word(bits); 2]
    }
    #[inline(always)]
    fn truth(mask: Self::Mask) -> u32 {
        V::truth(mask[0]) | (V::truth(mask[1]) << V::LANES)
    }
    #[inline(always)]
    fn left(a: Self::Word, bits: u32) -> Self::Word {
        [V::left(a[0], bits), V::left(a[1], bits)]
    }
    #[inline(always)]
    fn right(a: Self::Word, bits: u32) -> Self::Word {
        [V::right(a[0], bits), V::right(a[1], bits)]
    }
    twice! {
        add(a: V, b: V) -> V;
        sub(a: V, b: V) -> V;
        mul(a: V, b: V) -> V;
        div(a: V, b: V) -> V;
        sqrt(a: V) -> V;
        lt(a: V, b: V) -> V::Mask;
        le(a: V, b: V) -> V::Mask;
        eq(a: V, b: V) -> V::Mask;
        select(mask: V::Mask, a: V, b: V) -> V;
        both(a: V::Mask, b: V::Mask) -> V::Mask;
        either(a: V::Mask, b: V::Mask) -> V::Mask;
        not(a: V::Mask) -> V::Mask;
        to_word(a: V) -> V::Word;
        from_word(a: V::Word) -> V;
        and(a: V::Word, b: V::Word) -> V::Word;
        or(a: V::Word, b: V::Word) -> V::Word;
        xor(a: V::Word, b: V::Word) -> V::Word;
        plus(a: V::Word, b: V::Word) -> V::Word;
        minus(a: V::Word, b: V::Word) -> V::Word;
        odd(a: V::Word) -> V::Mask;
    }
}
