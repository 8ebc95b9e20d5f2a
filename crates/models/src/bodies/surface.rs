//! The surface of a convex body by its support function `h(n)`: how far the body reaches in direction n.
//!
//! A piece is a point and a sum of ovoids about it, `h = point . n + sum of |axes n|`: a tip, a disc (one zero axis), a
//! segment (two), an ellipsoid, an egg, a cylinder (a disc and a segment). A surface is the hull of its pieces, the larger
//! of their `h`, with all edges and tips rounded by a radius: `+ radius |n|` (Minkowski's sum with a sphere).

use super::Vector;

/// Two half ellipsoids with one equator, along the axes of the body: an egg, or an ellipsoid.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ovoid {
    /// Semi-axes along axes 1 and 2, m.
    pub across: [f64; 2],
    /// How far it reaches up axis 3, m.
    pub above: f64,
    /// How far it reaches down, m.
    pub below: f64,
}

impl Ovoid {
    pub(super) fn ellipsoid([a, b, c]: Vector) -> Self {
        Self { across: [a, b], above: c, below: c }
    }
    pub(super) fn disc(radius: f64) -> Self {
        Self::ellipsoid([radius, radius, 0.0])
    }
    /// The axes of the half that a direction meets.
    fn axes(&self, n: Vector) -> Vector {
        let [a, b] = self.across;
        [a, b, if n[2] < 0.0 { self.below } else { self.above }]
    }
    fn support(&self, n: Vector) -> f64 {
        norm(scaled(self.axes(n), n))
    }
    /// The gradient of the support function; of an edge seen along it, its middle.
    fn farthest(&self, n: Vector) -> Vector {
        let (axes, reach) = (self.axes(n), self.support(n));
        if reach > 0.0 { scaled(axes, scaled(axes, n)).map(|part| part / reach) } else { [0.0; 3] }
    }
}

/// A point and a sum of ovoids about it.
#[derive(Clone, Debug, PartialEq)]
pub struct Piece {
    /// The middle, m.
    pub point: Vector,
    /// What is added to it.
    pub ovoids: Vec<Ovoid>,
}

/// A convex surface.
#[derive(Clone, Debug, PartialEq)]
pub struct Surface {
    /// What it is the hull of: one piece at least.
    pub pieces: Vec<Piece>,
    /// Radius that rounds every edge, m.
    pub radius: f64,
}

/// A surface of the form that the models of rolling and sliding take, `h = point . n + radius |n| + |axes n|`, from the
/// centre of mass.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Form {
    /// From the centre of mass to the tip or to the middle, m.
    pub point: Vector,
    /// Radius of a sphere, m.
    pub radius: f64,
    /// Semi-axes of an ellipsoid, m.
    pub axes: Vector,
}

fn norm(v: Vector) -> f64 {
    dot(v, v).sqrt()
}
fn dot(a: Vector, b: Vector) -> f64 {
    crate::rotation::dot(a, b)
}
fn scaled(a: Vector, b: Vector) -> Vector {
    std::array::from_fn(|i| a[i] * b[i])
}
fn sum(a: Vector, b: Vector) -> Vector {
    std::array::from_fn(|i| a[i] + b[i])
}

impl Piece {
    fn support(&self, n: Vector) -> f64 {
        self.ovoids.iter().fold(dot(self.point, n), |reach, ovoid| reach + ovoid.support(n))
    }
    fn farthest(&self, n: Vector) -> Vector {
        self.ovoids.iter().fold(self.point, |point, ovoid| sum(point, ovoid.farthest(n)))
    }
}

impl Surface {
    /// One piece alone.
    pub(super) fn of(point: Vector, ovoids: Vec<Ovoid>, radius: f64) -> Self {
        Self { pieces: vec![Piece { point, ovoids }], radius }
    }
    /// A hull of circles about axis 3: (height, radius) each, a point where the radius is zero.
    pub(super) fn of_circles(circles: impl IntoIterator<Item = (f64, f64)>, radius: f64) -> Self {
        let piece = |(z, r)| Piece {
            point: [0.0, 0.0, z],
            ovoids: if r > 0.0 { vec![Ovoid::disc(r)] } else { vec![] },
        };
        Self { pieces: circles.into_iter().map(piece).collect(), radius }
    }

    /// The piece that reaches farthest.
    fn outermost(&self, n: Vector) -> &Piece {
        let first = &self.pieces[0];
        self.pieces
            .iter()
            .fold(first, |best, piece| if piece.support(n) > best.support(n) { piece } else { best })
    }
    /// How far it reaches in a direction, from the origin of the body's axes.
    pub fn support(&self, n: Vector) -> f64 {
        self.outermost(n).support(n) + self.radius * norm(n)
    }
    /// The point that reaches farthest.
    pub fn farthest(&self, n: Vector) -> Vector {
        let length = norm(n);
        sum(self.outermost(n).farthest(n), n.map(|part| self.radius * part / length))
    }
    /// The piece that is lowest while axis 3 is upright, seen from `origin`, where it is of the simple form.
    pub(super) fn form(&self, origin: Vector) -> Option<Form> {
        let piece = self.outermost([0.0, 0.0, -1.0]);
        let axes = match piece.ovoids[..] {
            [] => [0.0; 3],
            [Ovoid { across: [a, b], above, below }] if above == below => [a, b, above],
            _ => return None,
        };
        Some(Form { point: sum(piece.point, origin.map(|x| -x)), radius: self.radius, axes })
    }
    pub(super) fn moved(mut self, by: Vector) -> Self {
        for piece in &mut self.pieces {
            piece.point = sum(piece.point, by);
        }
        self
    }
    /// The hull of both; what one is rounded more than the other becomes part of its pieces.
    pub(super) fn with(self, other: Self) -> Self {
        let radius = if self.radius < other.radius { self.radius } else { other.radius };
        let pieces = [self, other].into_iter().flat_map(|surface| {
            let rest = surface.radius - radius;
            surface.pieces.into_iter().map(move |mut piece| {
                if rest > 0.0 {
                    piece.ovoids.push(Ovoid::ellipsoid([rest; 3]));
                }
                piece
            })
        });
        Self { pieces: pieces.collect(), radius }
    }
}
