//! Small systems of the tests' own, and a walk of equal steps over any number.
#![allow(dead_code, reason = "each test uses its own share")]

pub mod run;

use precess_integrate::{
    AnyMethod, METHODS, MethodCard, Needs, NoConvergence, Options, Step, Stepper, Steps,
};
use precess_scalar::{Scalar, Tape};
use precess_system::{Field, Second, Shape};
use std::sync::Arc;

/// A system's equations, over every number.
pub trait Toy: Send + Sync {
    fn rate<S: Scalar>(&self, t: S, y: &[S], dy: &mut [S]);
    fn solution<S: Scalar>(&self, _from: S, _start: &[S], _t: S, _y: &mut [S]) {
        panic!("this toy has no closed form");
    }
    fn crossings<S: Scalar>(&self, _t: S, _y: &[S], _out: &mut [S]) {}
    fn jump<S: Scalar>(&self, _event: usize, _t: S, _y: &mut [S]) {}
}

/// A toy with its shape.
pub struct Bound<T> {
    toy: T,
    shape: Shape,
}

/// `second` coordinates with velocities, then `first` without, and `events`.
pub fn bind<T: Toy>(toy: T, second: usize, first: usize, events: usize) -> Bound<T> {
    let shape = Shape {
        coordinates: second + first,
        second: Second::of((0..second + first).map(|i| i < second)),
        attitudes: vec![],
        modes: 0,
        observables: 0,
        events,
        rows: 1,
    };
    Bound { toy, shape }
}

/// A field whose equations can be written down.
pub trait Known: Field<f64> {
    /// The defaults, and the equations.
    fn options(&self) -> Options;
}
impl<T: Toy> Known for Bound<T> {
    fn options(&self) -> Options {
        let full = self.shape.full();
        let tape = Tape::record(1 + full, |x| {
            let mut rates = x[1..].to_vec();
            self.toy.rate(x[0], &x[1..], &mut rates);
            rates
        });
        Options { equations: Some(Arc::new(tape)), ..Options::default() }
    }
}

impl<T> Bound<T> {
    /// Gathers each row, and scatters what comes of it.
    fn each_row<S: Scalar>(&self, from: &[S], to: &mut [S], act: impl Fn(&[S], &mut [S])) {
        let full = self.shape.full();
        let shape = self.shape.with_rows(from.len() / full);
        for row in 0..shape.rows {
            let own: Vec<S> = (0..full).map(|j| from[shape.place(row, j)]).collect();
            let mut out = own.clone();
            act(&own, &mut out);
            for (j, x) in out.into_iter().enumerate() {
                to[shape.place(row, j)] = x;
            }
        }
    }
}

impl<T: Toy, S: Scalar> Field<S> for Bound<T> {
    fn shape(&self) -> &Shape {
        &self.shape
    }
    fn rate(&self, t: S, y: &[S], dy: &mut [S]) {
        self.each_row(y, dy, |own, rates| self.toy.rate(t, own, rates));
    }
    fn solution(&self, from: S, start: &[S], t: S, y: &mut [S]) {
        self.each_row(start, y, |own, then| self.toy.solution(from, own, t, then));
    }
    fn crossings(&self, t: S, y: &[S], out: &mut [S]) {
        self.toy.crossings(t, y, out);
    }
    fn jump(&self, event: usize, t: S, y: &mut [S]) {
        self.toy.jump(event, t, y);
    }
    fn abreast(&self) -> Option<&dyn Field<S::Abreast>> {
        S::is_abreast().then_some(self)
    }
}

/// `x'' = -omega^2 x`.
pub struct Harmonic(pub f64);
impl Toy for Harmonic {
    fn rate<S: Scalar>(&self, _t: S, y: &[S], dy: &mut [S]) {
        dy[0] = y[1];
        dy[1] = -(y[0] * (self.0 * self.0));
    }
    fn solution<S: Scalar>(&self, from: S, start: &[S], t: S, y: &mut [S]) {
        let (sin, cos) = ((t - from) * self.0).sin_cos();
        y[0] = start[0] * cos + start[1] * sin / self.0;
        y[1] = start[1] * cos - start[0] * sin * self.0;
    }
}
pub fn harmonic(omega: f64) -> Bound<Harmonic> {
    bind(Harmonic(omega), 1, 0, 0)
}

/// `theta'' = -b theta' - sin theta`.
pub struct Pendulum(pub f64);
impl Toy for Pendulum {
    fn rate<S: Scalar>(&self, _t: S, y: &[S], dy: &mut [S]) {
        dy[0] = y[1];
        dy[1] = -(y[1] * self.0) - y[0].sin();
    }
}
pub fn pendulum(b: f64) -> Bound<Pendulum> {
    bind(Pendulum(b), 1, 0, 0)
}

/// Planar Kepler motion with unit attraction.
pub struct Kepler;
impl Toy for Kepler {
    fn rate<S: Scalar>(&self, _t: S, y: &[S], dy: &mut [S]) {
        let square = y[0] * y[0] + y[1] * y[1];
        let cube = square * square.sqrt();
        (dy[0], dy[1]) = (y[2], y[3]);
        (dy[2], dy[3]) = (-(y[0] / cube), -(y[1] / cube));
    }
}
pub fn kepler() -> Bound<Kepler> {
    bind(Kepler, 2, 0, 0)
}

/// `x'' = -x + cos t / 5`, `z' = x z`: time enters, and a coordinate of first order.
pub struct Mixed;
impl Toy for Mixed {
    fn rate<S: Scalar>(&self, t: S, y: &[S], dy: &mut [S]) {
        dy[0] = y[2];
        dy[1] = y[0] * y[1];
        dy[2] = t.cos() * 0.2 - y[0];
    }
}
pub fn mixed() -> Bound<Mixed> {
    bind(Mixed, 1, 1, 0)
}

/// A ball that falls with unit gravity and keeps a share of its speed where it bounces.
pub struct Ball(pub f64);
impl Toy for Ball {
    fn rate<S: Scalar>(&self, _t: S, y: &[S], dy: &mut [S]) {
        dy[0] = y[1];
        dy[1] = S::from(-1.0);
    }
    fn crossings<S: Scalar>(&self, _t: S, y: &[S], out: &mut [S]) {
        out[0] = y[0];
    }
    fn jump<S: Scalar>(&self, _event: usize, _t: S, y: &mut [S]) {
        y[1] = -(y[1] * self.0);
    }
}
pub fn ball(restitution: f64) -> Bound<Ball> {
    bind(Ball(restitution), 1, 0, 1)
}

/// `x'' = x^2`: at infinity after a finite time.
pub struct BlowUp;
impl Toy for BlowUp {
    fn rate<S: Scalar>(&self, _t: S, y: &[S], dy: &mut [S]) {
        dy[0] = y[1];
        dy[1] = y[0] * y[0];
    }
}
pub fn blow_up() -> Bound<BlowUp> {
    bind(BlowUp, 1, 0, 0)
}

/// The methods that run on a toy, which has no Lagrangian and, most of them, no closed form.
pub fn methods() -> impl Iterator<Item = &'static MethodCard> {
    METHODS.iter().map(|m| m.card()).filter(|m| ![Needs::Lagrangian, Needs::ClosedForm].contains(&m.needs))
}

pub fn method(id: &str) -> &'static dyn AnyMethod {
    *METHODS.iter().find(|m| m.card().id == id).expect("a method of this name")
}

/// A stepper over any number.
pub fn stepper<S: Scalar>(
    method: &dyn AnyMethod,
    field: &dyn Field<S>,
    options: &Options,
) -> Box<dyn Stepper<S>>
where
    dyn AnyMethod: Steps<S>,
{
    let forgotten: &(dyn AnyMethod + 'static) =
        METHODS.iter().find(|m| m.card().id == method.card().id).copied().expect("a method of the list");
    Steps::<S>::stepper(forgotten, field.shape(), options)
}

/// One step.
pub fn take<S: Scalar>(
    stepper: &mut dyn Stepper<S>,
    field: &dyn Field<S>,
    t: S,
    y: &[S],
    h: S,
    out: &mut [S],
) -> Result<(), NoConvergence> {
    stepper.step(&mut Step { field, t, y, h, out })
}

/// `n` equal steps of length `h`, from `t` on.
pub fn walk<S: Scalar>(stepper: &mut dyn Stepper<S>, field: &dyn Field<S>, t: S, y: &mut [S], h: S, n: u32) {
    let mut out = y.to_vec();
    for k in 0..n {
        take(stepper, field, t + h * f64::from(k), y, h, &mut out).expect("the step converges");
        stepper.accept(S::always());
        y.copy_from_slice(&out);
    }
}
