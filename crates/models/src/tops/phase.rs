//! Where a periodic motion is: Jacobi's functions of its phase, and the integral of the third kind up to it.

use precess_scalar::{Scalar, jacobi, rf, rj};
use std::f64::consts::PI;

/// Jacobi's functions at a point, and how many half periods it is from zero.
pub(super) struct Phase<S> {
    pub u: S,
    pub sn: S,
    pub cn: S,
    pub dn: S,
    /// The half periods (2 K), and sn of what is left.
    turns: S,
    rest: S,
}

impl<S: Scalar> Phase<S> {
    /// Within the first quarter period before or after zero, from the functions themselves.
    #[inline(always)]
    pub fn start(sn: S, cn: S, dn: S) -> Self {
        let u = sn * rf(cn * cn, dn * dn, S::from(1.0));
        Self { u, sn, cn, dn, turns: S::from(0.0), rest: sn }
    }

    /// Later, by the addition theorem: where nothing is added nothing changes, to the last bit.
    #[inline(always)]
    pub fn after(&self, added: S, complement: S) -> Self {
        let (by, u) = (jacobi(added, complement), self.u + added);
        let (square, sines) = (S::from(1.0) - complement, self.sn * by.sn);
        // 1 - k^2 sn^2 sn^2, also where it is small.
        let (product, rest) = (square * sines * sines, square * (self.sn * by.cn).squared());
        let below = S::select(product.lt(S::from(0.5)), S::from(1.0) - product, self.dn * self.dn + rest);
        let angle = u * by.mean;
        let (sin, cos) = angle.sin_cos();
        let side = S::select(cos.lt(S::from(0.0)), S::from(-1.0), S::from(1.0));
        let sn = (self.sn * by.cn * by.dn + self.cn * self.dn * by.sn) / below;
        Self {
            u,
            sn,
            cn: (self.cn * by.cn - sines * self.dn * by.dn) / below,
            dn: (self.dn * by.dn - square * sines * self.cn * by.cn) / below,
            turns: (angle - (sin * side).atan2(cos * side)) / PI,
            rest: sn * side,
        }
    }

    /// The amplitude, whose sine is sn, continued beyond a quarter turn.
    #[inline(always)]
    pub fn amplitude(&self) -> S {
        self.turns * PI + self.rest.atan2(self.cn.abs())
    }

    /// How many lower turns (multiples of 2 K) lie behind, since zero or ahead of it.
    #[inline(always)]
    pub fn lower_turns(&self) -> S {
        let (zero, one) = (S::from(0.0), S::from(1.0));
        self.turns - S::select(self.rest.lt(zero), one, zero)
    }

    /// How many upper turns (odd multiples of K) do; one where a start stands on it.
    #[inline(always)]
    pub fn upper_turns(&self) -> S {
        let (zero, one) = (S::from(0.0), S::from(1.0));
        self.turns + S::select(self.cn.abs().le(zero), one, zero)
    }

    /// Three times what the integral of `1 / (1 - n sn^2)` exceeds u by, over n, from `here = 1 - n sn^2` and `far = 1 - n`.
    #[inline(always)]
    pub fn third(&self, here: S, far: S, complement: S) -> S {
        let (zero, one) = (S::from(0.0), S::from(1.0));
        let (sn2, cn2, dn2) = (self.rest.squared(), self.cn.squared(), self.dn.squared());
        let part = sn2 * self.rest * rj(cn2, dn2, one, here);
        let whole = self.turns * 2.0 * rj(zero, complement, one, far);
        // Within the first half period there is no whole one, which may be infinite.
        S::select(self.turns.abs().lt(S::from(0.5)), part, part + whole)
    }
}
