//! The table: level or inclined, at rest or shaken; and the gravity that is felt on it.
//!
//! In the table's axes (z its normal, x downhill) a slope s = tan of the inclination gives g (s, 0, -1) / sqrt(1 + s^2).
//! A table that moves by a sin(w t) adds a w^2 sin(w t).

use precess_scalar::Scalar;

/// Parameters of the table, after those of the body.
#[derive(Clone, Copy)]
pub(super) struct Ground<S> {
    pub g: S,
    pub slope: S,
    /// A torque `-damping omega`.
    pub damping: S,
    /// Along x, along z, and how fast; only where the body is written out.
    pub shake: Option<[S; 3]>,
}

impl<S: Scalar> Ground<S> {
    /// Gravity along x and z, without the shaking.
    #[inline(always)]
    pub fn at_rest(&self) -> [S; 2] {
        let part = self.g / (self.slope * self.slope + 1.0).sqrt();
        [self.slope * part, -part]
    }

    /// Gravity along x and z as it is felt at this time.
    #[inline(always)]
    pub fn felt(&self, t: S) -> [S; 2] {
        let [x, z] = self.at_rest();
        match self.shake {
            None => [x, z],
            Some([along_x, along_z, w]) => {
                let swing = w * w * (w * t).sin();
                [x + along_x * swing, z + along_z * swing]
            }
        }
    }
}
