//! The seam where a system's type is forgotten and the number's is kept.

use crate::{Card, Given, Layout, Satellites, Shape, State, System, Values};
#[cfg(feature = "tangents")]
use precess_scalar::Dual;
use precess_scalar::{Abreast, Dependence, Kernel, Narrow, Scalar, Traced, Wide, Widest};
#[cfg(feature = "laws")]
use precess_scalar::{DoubleDouble, Unit};
use std::collections::HashMap;
use std::sync::OnceLock;

/// A system with its parameters, as a first-order field over one kind of number.
///
/// `y` is the full state of [`Shape`]: coordinates, velocities, modes.
pub trait Field<S: Scalar>: Send + Sync {
    /// The sizes of a state.
    fn shape(&self) -> &Shape;
    /// The rate of every number of the state. There may be several rows of states (see [`Shape`]).
    fn rate(&self, t: S, y: &[S], dy: &mut [S]);
    /// The observables.
    fn observe(&self, t: S, y: &[S], out: &mut [S]);
    /// The Lagrangian, where there is one.
    fn lagrangian(&self, t: S, y: &[S]) -> Option<S>;
    /// The closed form: the full state at time `t` from the one at time `from`, where the system is solvable. There may
    /// be several rows.
    fn solution(&self, from: S, start: &[S], t: S, y: &mut [S]);
    /// The accelerations of [`System::drift`], in the places of the velocities, and whether there are any. There may be
    /// several rows.
    fn drift(&self, _t: S, _y: &[S], _dy: &mut [S]) -> bool {
        false
    }
    /// The event functions.
    fn crossings(&self, t: S, y: &[S], out: &mut [S]);
    /// Applies an event to the state.
    fn jump(&self, event: usize, t: S, y: &mut [S]);
    /// The same field over several of its numbers at once, where this machine has lanes for them.
    fn abreast(&self) -> Option<&dyn Field<S::Abreast>> {
        None
    }
}

/// A system and the parameters it runs with.
struct Bound<M, S: Scalar> {
    system: M,
    values: Values<S>,
    shape: Shape,
    /// Made where somebody asks for it.
    abreast: OnceLock<Box<dyn Field<S::Abreast>>>,
}

impl<M, S: Scalar> Bound<M, S> {
    fn new(system: M, values: Values<S>, layout: &Layout) -> Self {
        Self { system, values, shape: layout.shape(), abreast: OnceLock::new() }
    }

    #[inline(always)]
    fn state<'a>(&'a self, t: S, y: &'a [S]) -> State<'a, S> {
        let (coordinates, rest) = y.split_at(self.shape.coordinates);
        let (velocities, modes) = rest.split_at(self.shape.second.len());
        State { t, coordinates, velocities, modes, values: &self.values }
    }
}

/// What is evaluated.
const RATE: u8 = 0;
const OBSERVABLES: u8 = 1;
const CROSSINGS: u8 = 2;

/// An evaluation at a point, compiled for the instructions of its number.
struct Evaluation<'a, M, S: Scalar, const WHAT: u8> {
    bound: &'a Bound<M, S>,
    /// By reference: code outside copies a register piece by piece, and a load of the whole then waits for them all.
    t: &'a S,
    y: &'a [S],
    out: &'a mut [S],
}

impl<M: System, S: Scalar, const WHAT: u8> Kernel for Evaluation<'_, M, S, WHAT> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        let Self { bound, t, y, out } = self;
        match WHAT {
            RATE => bound.rates(*t, y, out),
            OBSERVABLES => bound.system.observe(&bound.state(*t, y), out),
            _ => bound.system.crossings(&bound.state(*t, y), out),
        }
    }
}

/// The accelerations of the positions, compiled for the instructions of their number.
struct Drift<'a, M, S: Scalar> {
    bound: &'a Bound<M, S>,
    t: &'a S,
    y: &'a [S],
    dy: &'a mut [S],
}

impl<M: System, S: Scalar> Kernel for Drift<'_, M, S> {
    type Output = bool;

    #[inline(always)]
    fn run(self) -> bool {
        let Self { bound, t, y, dy } = self;
        let shape = &bound.shape;
        let (coordinates, modes) = (shape.coordinates, shape.modes);
        let rows = y.len() / shape.full();
        let (q, rest) = y.split_at(rows * coordinates);
        let (v, m) = rest.split_at(rows * shape.second.len());
        let mut differs = shape.is_second_order();
        for row in 0..rows {
            if differs {
                let own = row * coordinates..(row + 1) * coordinates;
                let (coordinates, velocities) = (&q[own.clone()], &v[own.clone()]);
                let modes = &m[row * modes..][..modes];
                let state = State { t: *t, coordinates, velocities, modes, values: &bound.values };
                differs = bound.system.drift(&state, &mut dy[q.len()..][own]);
            }
        }
        differs
    }
}

/// The closed form, compiled for the instructions of its number.
struct Solution<'a, M, S: Scalar> {
    bound: &'a Bound<M, S>,
    from: &'a S,
    start: &'a [S],
    t: &'a S,
    y: &'a mut [S],
}

impl<M: System, S: Scalar> Kernel for Solution<'_, M, S> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        let Self { bound, from, start, t, y } = self;
        let shape = &bound.shape;
        let (coordinates, second, modes) = (shape.coordinates, shape.second.len(), shape.modes);
        let rows = y.len() / shape.full();
        let (q, rest) = start.split_at(rows * coordinates);
        let (v, m) = rest.split_at(rows * second);
        let (q_out, rest) = y.split_at_mut(rows * coordinates);
        let (v_out, m_out) = rest.split_at_mut(rows * second);
        m_out.copy_from_slice(m);
        for row in 0..rows {
            let (of_q, of_v) = (row * coordinates..(row + 1) * coordinates, row * second..(row + 1) * second);
            let (coordinates, velocities) = (&q[of_q.clone()], &v[of_v.clone()]);
            let modes = &m[row * modes..][..modes];
            let state = State { t: *from, coordinates, velocities, modes, values: &bound.values };
            bound.system.solution(&state, *t, &mut q_out[of_q], &mut v_out[of_v]);
        }
    }
}

impl<M: System, S: Scalar> Bound<M, S> {
    /// The rates of all rows.
    #[inline(always)]
    fn rates(&self, t: S, y: &[S], dy: &mut [S]) {
        let shape = &self.shape;
        let (coordinates, second) = (shape.coordinates, shape.second.len());
        let rows = if y.len() == shape.full() { 1 } else { y.len() / shape.full() };
        let (q, rest) = y.split_at(rows * coordinates);
        let (v, m) = rest.split_at(rows * second);
        let (dq, rest) = dy.split_at_mut(rows * coordinates);
        let (dv, dm) = rest.split_at_mut(rows * second);
        let straight = shape.is_second_order();
        for row in 0..rows {
            let (from, to) = (row * coordinates, (row + 1) * coordinates);
            let (q, v) = (&q[from..to], &v[row * second..][..second]);
            let modes = &m[row * shape.modes..][..shape.modes];
            let state = State { t, coordinates: q, velocities: v, modes, values: &self.values };
            // The equations give accelerations in the order of the coordinates. Where each coordinate has one, that is
            // the order of the velocities; elsewhere each moves from its coordinate's place to its velocity's.
            let highest = if straight { &mut dv[from..to] } else { &mut dq[from..to] };
            self.system.equations(&state, highest);
            let (dq, dv) = (&mut dq[from..to], &mut dv[row * second..][..second]);
            for ((&i, dv), &v) in shape.second.iter().zip(dv).zip(v) {
                if !straight {
                    *dv = dq[i];
                }
                dq[i] = v;
            }
            if modes.is_empty() {
                continue;
            }
            self.system.mode_rates(&state, &mut dm[row * shape.modes..][..shape.modes]);
        }
    }

    #[inline(always)]
    fn evaluate<const WHAT: u8>(&self, t: &S, y: &[S], out: &mut [S]) {
        S::enter(Evaluation::<M, S, WHAT> { bound: self, t, y, out });
    }
}

impl<M: System, S: Scalar> Field<S> for Bound<M, S> {
    fn shape(&self) -> &Shape {
        &self.shape
    }

    fn rate(&self, t: S, y: &[S], dy: &mut [S]) {
        self.evaluate::<RATE>(&t, y, dy);
    }

    fn observe(&self, t: S, y: &[S], out: &mut [S]) {
        self.evaluate::<OBSERVABLES>(&t, y, out);
    }

    fn crossings(&self, t: S, y: &[S], out: &mut [S]) {
        self.evaluate::<CROSSINGS>(&t, y, out);
    }

    fn drift(&self, t: S, y: &[S], dy: &mut [S]) -> bool {
        S::enter(Drift { bound: self, t: &t, y, dy })
    }

    fn solution(&self, from: S, start: &[S], t: S, y: &mut [S]) {
        if cfg!(not(feature = "first")) {
            S::enter(Solution { bound: self, from: &from, start, t: &t, y });
        }
    }

    fn lagrangian(&self, t: S, y: &[S]) -> Option<S> {
        // Only the laws ask for it.
        if cfg!(feature = "laws") { self.system.lagrangian(&self.state(t, y)) } else { None }
    }

    fn jump(&self, event: usize, t: S, y: &mut [S]) {
        let before = y.to_vec();
        self.system.jump(event, &self.state(t, &before), y);
    }

    fn abreast(&self) -> Option<&dyn Field<S::Abreast>> {
        let make = || -> Box<dyn Field<S::Abreast>> {
            let values = self.values.map(|x| S::Abreast::spread(*x));
            let (system, shape) = (self.system.clone(), self.shape.clone());
            Box::new(Bound { system, values, shape, abreast: OnceLock::new() })
        };
        S::is_abreast().then(|| &**self.abreast.get_or_init(make))
    }
}

/// Makes a field over one kind of number.
pub trait Bind<S: Scalar> {
    /// The system with these parameters; `layout` is the one that [`AnySystem::layout`] gave for them.
    fn bind(&self, values: Values<S>, layout: &Layout) -> Box<dyn Field<S>>;
}

impl<M: System, S: Scalar> Bind<S> for M {
    fn bind(&self, values: Values<S>, layout: &Layout) -> Box<dyn Field<S>> {
        Box::new(Bound::new(self.clone(), values, layout))
    }
}

/// Evaluates a system's equations once: all that is asked of numbers that look at equations (what they depend on, how
/// they are written) instead of computing with them. A whole [`Field`] of each would be compiled for nothing.
pub trait Rates<S: Scalar> {
    /// The rates of a full state, and the event functions there.
    fn rates(&self, values: Values<S>, layout: &Layout, t: S, y: &[S]) -> (Vec<S>, Vec<S>);
    /// The Lagrangian, where there is one.
    fn lagrangian(&self, values: Values<S>, layout: &Layout, t: S, y: &[S]) -> Option<S>;
}

impl<M: System, S: Scalar> Rates<S> for M {
    fn rates(&self, values: Values<S>, layout: &Layout, t: S, y: &[S]) -> (Vec<S>, Vec<S>) {
        let bound = Bound::new(self.clone(), values, layout);
        let mut rates = vec![S::from(0.0); y.len()];
        bound.rates(t, y, &mut rates);
        let mut crossings = vec![S::from(0.0); bound.shape.events];
        self.crossings(&bound.state(t, y), &mut crossings);
        (rates, crossings)
    }

    fn lagrangian(&self, values: Values<S>, layout: &Layout, t: S, y: &[S]) -> Option<S> {
        if cfg!(feature = "first") {
            return None;
        }
        let bound = Bound::new(self.clone(), values, layout);
        System::lagrangian(self, &bound.state(t, y))
    }
}

/// Observes a state once, on a number that no method integrates with.
#[cfg(feature = "tangents")]
pub trait Observes<S: Scalar> {
    /// The observables of a full state.
    fn observed(&self, values: Values<S>, layout: &Layout, t: S, y: &[S]) -> Vec<S>;
}

#[cfg(feature = "tangents")]
impl<M: System, S: Scalar> Observes<S> for M {
    fn observed(&self, values: Values<S>, layout: &Layout, t: S, y: &[S]) -> Vec<S> {
        let bound = Bound::new(self.clone(), values, layout);
        let mut out = vec![S::from(0.0); bound.shape.observables];
        self.observe(&bound.state(t, y), &mut out);
        out
    }
}

/// The numbers that only the laws compute with so far. They are left out of the programs: each is every system once
/// more, which a browser would have to load.
#[cfg(feature = "laws")]
pub trait LawNumbers: Bind<Dual<Dual<f64>>> + Bind<DoubleDouble> + Bind<Unit> + Bind<Traced> {}
/// The numbers of the laws, without the feature `laws`: none.
#[cfg(not(feature = "laws"))]
pub trait LawNumbers {}
impl<M: System> LawNumbers for M {}

/// The numbers of the analyses: a state with a direction in which it moves, and observables with two. A face that offers none leaves it out.
#[cfg(feature = "tangents")]
pub trait TangentNumbers: Bind<Dual<f64>> + Observes<Dual<Dual<f64>>> {}
/// The number of the analyses, without the feature `tangents`: none.
#[cfg(not(feature = "tangents"))]
pub trait TangentNumbers {}
impl<M: System> TangentNumbers for M {}

/// A system whose type is forgotten: it makes fields over every kind of number.
pub trait AnySystem:
    Send
    + Sync
    + LawNumbers
    + TangentNumbers
    + Bind<f64>
    + Bind<Narrow>
    + Bind<Wide>
    + Bind<Widest>
    + Rates<Dependence>
    + Rates<Traced>
{
    /// See [`System::card`].
    fn card(&self) -> Card;
    /// The folder in which the system's file lies (`pendulums`): what it stands with in a catalogue.
    fn family(&self) -> &'static str;
    /// See [`System::layout`].
    fn layout(&self, values: &Values<f64>, given: &Given) -> Layout;
    /// The full state at the start: the card's, then what is given by name, then the modes.
    ///
    /// # Errors
    /// One sentence, where the starts or the parameters make no sense together.
    fn start(&self, values: &Values<f64>, layout: &Layout, given: &Given) -> Result<Vec<f64>, String>;
    /// See [`System::trouble`]; at a full state.
    fn trouble(&self, values: &Values<f64>, layout: &Layout, t: f64, y: &[f64]) -> Option<String>;
    /// See [`System::satellites`].
    fn satellites(&self, values: &Values<f64>) -> Option<Satellites>;
    /// See [`System::solvable`]; from a full state.
    ///
    /// # Errors
    /// One sentence: why the motion has no closed form.
    fn solvable(&self, values: &Values<f64>, layout: &Layout, start: &[f64]) -> Result<(), String>;
    /// See [`System::period`].
    fn period(&self, values: &Values<f64>) -> Option<f64>;
}

impl<M: System> AnySystem for M {
    fn card(&self) -> Card {
        System::card(self)
    }

    fn family(&self) -> &'static str {
        std::any::type_name::<M>().split("::").nth(1).unwrap_or_default()
    }

    fn period(&self, values: &Values<f64>) -> Option<f64> {
        System::period(self, values)
    }

    fn layout(&self, values: &Values<f64>, given: &Given) -> Layout {
        System::layout(self, values, given)
    }

    fn trouble(&self, values: &Values<f64>, layout: &Layout, t: f64, y: &[f64]) -> Option<String> {
        let bound = Bound::new(self.clone(), values.clone(), layout);
        System::trouble(self, &bound.state(t, y))
    }

    fn satellites(&self, values: &Values<f64>) -> Option<Satellites> {
        System::satellites(self, values)
    }

    fn solvable(&self, values: &Values<f64>, layout: &Layout, start: &[f64]) -> Result<(), String> {
        if cfg!(feature = "first") {
            return Err("closed forms are not in this program".into());
        }
        let bound = Bound::new(self.clone(), values.clone(), layout);
        System::solvable(self, &bound.state(0.0, start))
    }

    fn start(&self, values: &Values<f64>, layout: &Layout, given: &Given) -> Result<Vec<f64>, String> {
        let mut y = layout.start();
        let size = layout.shape().state();
        if !given.0.is_empty() {
            // A map, for there may be a million names; it is asked, not walked.
            let named: HashMap<&str, f64> =
                given.0.iter().rev().map(|(name, x)| (name.as_str(), *x)).collect();
            for (place, quantity) in y.iter_mut().zip(layout.starts()) {
                *place = named.get(quantity.name.as_str()).copied().unwrap_or(*place);
            }
        }
        System::start(self, given, values, &mut y[..size])?;
        let bound = Bound::new(self.clone(), values.clone(), layout);
        let (state, modes) = y.split_at_mut(size);
        let at_start = bound.state(0.0, state);
        self.check(&at_start)?;
        self.start_modes(&at_start, modes);
        Ok(y)
    }
}
