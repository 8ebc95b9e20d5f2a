//! How two quantities move: place, velocity and acceleration, and what the moving frames make of them.

use crate::analyses::subject::Subject;
use precess_scalar::{Dual, Scalar};
use precess_system::Observes;

/// Place, velocity and acceleration in a plane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Motion {
    pub place: [f64; 2],
    pub velocity: [f64; 2],
    pub acceleration: [f64; 2],
}

impl Motion {
    pub fn speed(&self) -> f64 {
        Scalar::hypot(self.velocity[0], self.velocity[1])
    }
    pub fn tangential(&self) -> f64 {
        dot(self.velocity, self.acceleration) / self.speed()
    }
    /// Positive to the left of the velocity.
    pub fn normal(&self) -> f64 {
        cross(self.velocity, self.acceleration) / self.speed()
    }
    pub fn curvature(&self) -> f64 {
        self.normal() / (self.speed() * self.speed())
    }
    /// Centre of the osculating circle.
    pub fn centre(&self) -> [f64; 2] {
        let reach = 1.0 / (self.curvature() * self.speed());
        [self.place[0] - self.velocity[1] * reach, self.place[1] + self.velocity[0] * reach]
    }
    pub fn distance(&self) -> f64 {
        Scalar::hypot(self.place[0], self.place[1])
    }
    pub fn radial(&self) -> f64 {
        dot(self.place, self.acceleration) / self.distance()
    }
    pub fn transverse(&self) -> f64 {
        cross(self.place, self.acceleration) / self.distance()
    }
}

fn dot(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}
fn cross(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[1] - a[1] * b[0]
}

/// How two columns of a row move.
pub(super) fn motion(subject: &Subject, row: &[f64], columns: [usize; 2]) -> Motion {
    let (plan, shape) = (subject.plan, subject.field.shape());
    let mut y = row[1..=shape.state()].to_vec();
    y.extend_from_slice(&plan.start[shape.state()..]);
    let mut rate = vec![0.0; y.len()];
    subject.field.rate(row[0], &y, &mut rate);
    let moving: Vec<Dual<f64>> = y.iter().zip(&rate).map(|(y, r)| Dual::new(*y, *r)).collect();
    let mut rates = vec![Dual::constant(0.0); y.len()];
    subject.tangents.rate(Dual::new(row[0], 1.0), &moving, &mut rates);
    let twice = |(y, r): (&Dual<f64>, &Dual<f64>)| Dual::new(*y, Dual::new(y.slope, r.slope));
    let state: Vec<Dual<Dual<f64>>> = moving.iter().zip(&rates).map(twice).collect();
    let t = Dual::new(Dual::new(row[0], 1.0), Dual::new(1.0, 0.0));
    let observed = if columns.iter().any(|k| *k > shape.state()) {
        let values = plan.values.map(|x| Dual::constant(Dual::constant(*x)));
        Observes::observed(plan.system, values, &plan.layout, t, &state)
    } else {
        vec![]
    };
    let column =
        columns.map(|k| if k > shape.state() { observed[k - 1 - shape.state()] } else { state[k - 1] });
    Motion {
        place: column.map(|q| q.value.value),
        velocity: column.map(|q| q.value.slope),
        acceleration: column.map(|q| q.slope.slope),
    }
}
