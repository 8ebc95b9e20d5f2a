//! Bodies: mass, centre, inertia and surface, one shape a file.
//!
//! A body is drawn in axes of its own, with axis 3 along its axis of revolution where it has one. Its inertia is given
//! about its centre of mass in those same axes, its surface by its support function (see [`Surface`]).
//!
//! ```
//! use precess_models::bodies::named;
//! let cone = named("cone", &[("density", 100.0), ("height", 0.15), ("radius", 0.05)], &[]).unwrap();
//! assert!((cone.centre[2] - 0.1125).abs() < 1e-15);
//! ```

mod cone;
mod cylinder;
mod egg;
mod ellipsoid;
mod names;
mod principal;
mod profile;
mod sphere;
mod surface;
mod truncated_sphere;

pub use names::{BodyCard, SHAPES, Size, named};
pub use profile::convex;
pub use surface::{Form, Ovoid, Piece, Surface};

use crate::inertia::transferred;
use crate::rotation::{dot, from_euler, to_space};

/// A vector.
pub type Vector = [f64; 3];
/// A matrix, row by row.
pub type Matrix = [Vector; 3];

/// A rigid body.
#[derive(Clone, Debug, PartialEq)]
pub struct Solid {
    /// Mass, kg.
    pub mass: f64,
    /// Centre of mass in the axes the body is drawn in, m.
    pub centre: Vector,
    /// Inertia about the centre of mass in the same axes, kg m^2.
    pub inertia: Matrix,
    /// The surface in the same axes.
    pub surface: Surface,
}

impl Solid {
    /// A body of revolution: mass, height of the centre, moments across and along the axis (about the centre).
    pub(crate) fn of_revolution(mass: f64, height: f64, i1: f64, i3: f64, surface: Surface) -> Self {
        let inertia = [[i1, 0.0, 0.0], [0.0, i1, 0.0], [0.0, 0.0, i3]];
        Self { mass, centre: [0.0, 0.0, height], inertia, surface }
    }

    /// The same shape with mass and inertia multiplied.
    fn heavier(mut self, factor: f64) -> Self {
        self.mass *= factor;
        self.inertia = self.inertia.map(|row| row.map(|x| x * factor));
        self
    }

    /// The inertia about a point given in the body's axes (Huygens and Steiner; T, section 3.2).
    pub fn inertia_about(&self, point: Vector) -> Matrix {
        transferred(self.inertia, self.mass, std::array::from_fn(|i| self.centre[i] - point[i]))
    }

    /// The same body moved.
    #[must_use]
    pub fn moved(mut self, by: Vector) -> Self {
        self.centre = std::array::from_fn(|i| self.centre[i] + by[i]);
        self.surface = self.surface.moved(by);
        self
    }

    /// Two bodies as one; its surface is the hull of both. Where they overlap their masses add up all the same.
    #[must_use]
    pub fn with(self, other: Self) -> Self {
        let mass = self.mass + other.mass;
        let centre =
            std::array::from_fn(|i| (self.mass * self.centre[i] + other.mass * other.centre[i]) / mass);
        let (a, b) = (self.inertia_about(centre), other.inertia_about(centre));
        let inertia = std::array::from_fn(|i| std::array::from_fn(|j| a[i][j] + b[i][j]));
        Self { mass, centre, inertia, surface: self.surface.with(other.surface) }
    }

    /// How far the body reaches in a direction, measured from its centre of mass: 1-homogeneous in `n`.
    pub fn support(&self, n: Vector) -> f64 {
        self.surface.support(n) - dot(self.centre, n)
    }

    /// The point that reaches farthest in a direction, from the centre of mass.
    pub fn farthest(&self, n: Vector) -> Vector {
        let point = self.surface.farthest(n);
        std::array::from_fn(|i| point[i] - self.centre[i])
    }

    /// The part of the surface that is lowest while axis 3 is upright (of a cone its tip), where that is of the simple form
    /// which models of contact take.
    pub fn form(&self) -> Option<Form> {
        self.surface.form(self.centre)
    }

    /// The moments across the axis and about it, where this is a body of revolution about axis 3.
    pub fn revolution(&self) -> Option<(f64, f64)> {
        let i = &self.inertia;
        let tiny = 1e-12 * (i[0][0] + i[2][2]);
        let round = (i[0][0] - i[1][1]).abs() <= tiny && self.centre[0] == 0.0 && self.centre[1] == 0.0;
        let diagonal = [i[0][1], i[0][2], i[1][2]].iter().all(|x| x.abs() <= tiny);
        (round && diagonal).then_some((i[0][0], i[2][2]))
    }

    /// The principal moments of inertia, in ascending order, and their axes (unit vectors).
    pub fn principal(&self) -> (Vector, Matrix) {
        principal::principal(self.inertia)
    }
}

/// The matrix `R matrix R^T` of something turned by Euler angles, R = Rz(psi) Rx(theta) Rz(phi) (T, section 3.2).
pub fn turned(matrix: Matrix, angles: Vector) -> Matrix {
    let q = from_euler(angles);
    // Rows to space, then columns: (R (R M)^T)^T.
    let half = transposed(matrix).map(|column| to_space(q, column));
    transposed(transposed(half).map(|row| to_space(q, row)))
}

fn transposed(matrix: Matrix) -> Matrix {
    std::array::from_fn(|i| std::array::from_fn(|j| matrix[j][i]))
}
