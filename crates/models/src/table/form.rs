//! The ways to give a body by parameters: written out, or by the few numbers of a named top.

use super::body::Body;
use crate::inertia::diagonal;
use precess_scalar::Scalar;

/// How a system's first parameters make a body.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Form {
    /// `m, i11, i22, i33, i12, i13, i23, point1, point2, point3, radius, axis1, axis2, axis3`.
    General,
    /// `m, radius, alpha, i1, i3`: a sphere whose centre lies `alpha radius` above G.
    Sphere,
    /// `m, a, b, h, i1, i3`: a spheroid, a along its axis, its centre h above G.
    Spheroid,
    /// `m, a, b, c, h, i11, i22, i33, i12`: an ellipsoid whose centre lies h above G.
    Ellipsoid,
    /// `m, radius, edge, i1, i3`: a disc of this radius whose edge is round.
    Disc,
    /// `m, d, tip, i1, i3`: a tip of this radius whose centre lies d below G.
    Tip,
}

impl Form {
    /// How many parameters it takes.
    pub const fn count(self) -> usize {
        match self {
            Self::General => 14,
            Self::Sphere | Self::Disc | Self::Tip => 5,
            Self::Spheroid => 6,
            Self::Ellipsoid => 9,
        }
    }

    /// The body touches with a sphere about a point of its axis of symmetry: Jellett's quantity is constant.
    pub const fn is_spherical(self) -> bool {
        matches!(self, Self::Sphere | Self::Tip)
    }

    /// The body may touch with a sphere: Routh's quantity means something.
    pub const fn has_routh(self) -> bool {
        matches!(self, Self::General | Self::Sphere | Self::Tip)
    }

    /// The body of these parameters.
    #[inline(always)]
    pub fn body<S: Scalar>(self, p: &[S]) -> Body<S> {
        let zero = S::from(0.0);
        let symmetric = |i1, i3| diagonal([i1, i1, i3]);
        match *p {
            [m, i11, i22, i33, i12, i13, i23, p1, p2, p3, radius, a1, a2, a3, ..]
                if self == Self::General =>
            {
                let inertia = [[i11, i12, i13], [i12, i22, i23], [i13, i23, i33]];
                Body { mass: m, inertia, point: [p1, p2, p3], radius, axes: [a1, a2, a3] }
            }
            [m, a, b, c, h, i11, i22, i33, i12, ..] if self == Self::Ellipsoid => {
                let inertia = [[i11, i12, zero], [i12, i22, zero], [zero, zero, i33]];
                Body { mass: m, inertia, point: [zero, zero, h], radius: zero, axes: [a, b, c] }
            }
            [m, a, b, h, i1, i3, ..] if self == Self::Spheroid => Body {
                mass: m,
                inertia: symmetric(i1, i3),
                point: [zero, zero, h],
                radius: zero,
                axes: [b, b, a],
            },
            [m, size, other, i1, i3, ..] => {
                let (point, radius, axes) = match self {
                    Self::Sphere => (size * other, size, zero),
                    Self::Tip => (-size, other, zero),
                    _ => (zero, other, size - other),
                };
                let inertia = symmetric(i1, i3);
                Body { mass: m, inertia, point: [zero, zero, point], radius, axes: [axes, axes, zero] }
            }
            _ => unreachable!("a card lists the parameters of its form"),
        }
    }
}
