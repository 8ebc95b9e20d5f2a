//! Small systems to hold the methods against.
#![allow(dead_code, missing_docs)]

use precess_integrate::{AnyMethod, METHODS, Needs};
use precess_scalar::Scalar;
use precess_system::{
    Bind, Card, Direction, Field, Given, Layout, State, System, Values, card, coordinate, number,
};

pub fn method(id: &str) -> &'static dyn AnyMethod {
    *METHODS.iter().find(|m| m.card().id == id).expect("a known method")
}

pub fn needs_separable(method: &dyn AnyMethod) -> bool {
    method.card().needs == Needs::Separable
}

/// A field over any number, with the system's defaults.
pub fn field<S: Scalar>(system: &(impl System + Bind<S>)) -> Box<dyn Field<S>> {
    let values = Values::defaults(&System::card(system)).map(|x| S::from(*x));
    let layout = System::layout(system, &Values::defaults(&System::card(system)), &Given::default());
    Bind::<S>::bind(system, values, &layout)
}

pub fn layout(system: &impl System) -> Layout {
    Layout::of(&System::card(system))
}

fn plain(id: &'static str) -> Card {
    card(id, id, id)
}

/// x'' = -omega^2 x.
#[derive(Clone)]
pub struct Oscillator;
impl System for Oscillator {
    fn card(&self) -> Card {
        plain("oscillator")
            .coordinate(coordinate("x", "", "", "").start(1.0))
            .parameter(number("omega", "", 1.0, "", ""))
    }
    fn equations<S: Scalar>(&self, s: &State<S>, highest: &mut [S]) {
        let ([x], [omega]) = (s.q(), s.p());
        highest[0] = -(omega * omega * x);
    }
}

/// A pendulum pushed by a force that depends on time, with friction where `friction` is not zero.
#[derive(Clone)]
pub struct Driven {
    pub friction: f64,
}
impl System for Driven {
    fn card(&self) -> Card {
        plain("driven").coordinate(coordinate("x", "", "", "").start(1.2).start_dot(0.3))
    }
    fn equations<S: Scalar>(&self, s: &State<S>, highest: &mut [S]) {
        let ([x], [v]) = (s.q(), s.v());
        highest[0] = -x.sin() - v * self.friction + (s.t * 1.3).cos() * 0.5;
    }
}

/// A pendulum with g = l = 1, from rest.
#[derive(Clone)]
pub struct Pendulum {
    pub start: f64,
}
impl System for Pendulum {
    fn card(&self) -> Card {
        plain("pendulum").coordinate(coordinate("theta", "", "", "").start(self.start))
    }
    fn equations<S: Scalar>(&self, s: &State<S>, highest: &mut [S]) {
        let [theta] = s.q();
        highest[0] = -theta.sin();
    }
}

/// A body about a fixed centre, on an ellipse of eccentricity 1/2.
#[derive(Clone)]
pub struct Kepler;
impl System for Kepler {
    fn card(&self) -> Card {
        plain("kepler")
            .coordinate(coordinate("x", "", "", "").start(0.5))
            .coordinate(coordinate("y", "", "", "").start_dot(1.732_050_807_568_877_2))
    }
    fn equations<S: Scalar>(&self, s: &State<S>, highest: &mut [S]) {
        let [x, y] = s.q();
        let square = x * x + y * y;
        let cube = square * square.sqrt();
        highest.copy_from_slice(&[-(x / cube), -(y / cube)]);
    }
}

/// A second-order coordinate that a first-order one follows: mixed order.
#[derive(Clone)]
pub struct Mixed;
impl System for Mixed {
    fn card(&self) -> Card {
        plain("mixed")
            .coordinate(coordinate("x", "", "", "").start(1.0))
            .coordinate(coordinate("z", "", "", "").first_order().start(0.2))
    }
    fn equations<S: Scalar>(&self, s: &State<S>, highest: &mut [S]) {
        let ([x, z], [v]) = (s.q(), s.v());
        highest.copy_from_slice(&[-x - v * 0.1 + z * 0.2, x - z * 0.5]);
    }
}

/// x'' = x^2: goes to infinity in finite time.
#[derive(Clone)]
pub struct BlowUp;
impl System for BlowUp {
    fn card(&self) -> Card {
        plain("blow_up").coordinate(coordinate("x", "", "", "").start(1.0).start_dot(1.0))
    }
    fn equations<S: Scalar>(&self, s: &State<S>, highest: &mut [S]) {
        let [x] = s.q();
        highest[0] = x * x;
    }
}

/// A ball that bounces on the floor and keeps a share of its speed.
#[derive(Clone)]
pub struct Ball {
    pub kept: f64,
}
impl System for Ball {
    fn card(&self) -> Card {
        plain("ball").coordinate(coordinate("y", "", "", "").start(1.0)).event(
            "bounce",
            Direction::Falling,
            "",
            "",
        )
    }
    fn equations<S: Scalar>(&self, _: &State<S>, highest: &mut [S]) {
        highest[0] = S::from(-2.0);
    }
    fn crossings<S: Scalar>(&self, s: &State<S>, out: &mut [S]) {
        out[0] = s.q::<1>()[0];
    }
    fn jump<S: Scalar>(&self, _: usize, s: &State<S>, y: &mut [S]) {
        let [v] = s.v();
        y[0] = S::from(0.0);
        y[1] = -(v * self.kept);
    }
}
