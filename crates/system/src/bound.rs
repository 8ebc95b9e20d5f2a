//! A system and the parameters it runs with, compiled for a kind of number.

use crate::{Field, Layout, Shape, State, System, Values};
use precess_scalar::{Abreast, Kernel, Scalar};
use std::sync::OnceLock;

/// A system and the parameters it runs with.
pub(crate) struct Bound<M, S: Scalar> {
    system: M,
    values: Values<S>,
    pub shape: Shape,
    /// Made where somebody asks for it.
    abreast: OnceLock<Box<dyn Field<S::Abreast>>>,
}

impl<M, S: Scalar> Bound<M, S> {
    pub fn new(system: M, values: Values<S>, layout: &Layout) -> Self {
        Self { system, values, shape: layout.shape(), abreast: OnceLock::new() }
    }

    #[inline(always)]
    pub fn state<'a>(&'a self, t: S, y: &'a [S]) -> State<'a, S> {
        let (coordinates, rest) = y.split_at(self.shape.coordinates);
        let (velocities, modes) = rest.split_at(self.shape.velocities());
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
        let (v, m) = rest.split_at(rows * shape.velocities());
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
        let (coordinates, second, modes) = (shape.coordinates, shape.velocities(), shape.modes);
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
    pub fn rates(&self, t: S, y: &[S], dy: &mut [S]) {
        let shape = &self.shape;
        let (coordinates, second) = (shape.coordinates, shape.velocities());
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
            for (k, (dv, &v)) in dv.iter_mut().zip(v).enumerate() {
                let i = shape.second.coordinate(k);
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
