//! Taylor's method: the solution's power series at each step, as far as its term of order 20.
//!
//! The series comes from the recorded equations by recurrences (see [`Taylor`](precess_scalar::Taylor)). Its radius of
//! convergence tells how far a step may go, so a step is as long as the last two terms allow (A. Jorba, M. Zou, *Experimental
//! Mathematics* 14, 99, 2005); one that is too long needs no new series. The method for the highest accuracy: to 1e-15 it needs
//! few steps, and the state inside a step is as accurate as at its end.

use crate::controller::norm;
use crate::{Dense, Kind, Method, MethodCard, Needs, NoConvergence, Options, Step, Stepper};
use precess_scalar::{Scalar, Taylor as Series};
use precess_system::{Field, Shape};

/// See the module.
pub struct Taylor;

static CARD: MethodCard = MethodCard {
    id: "taylor",
    title: ("Taylor, order 20", "Taylor, ordre 20"),
    about: (
        "Adaptive, of order 20: the solution's own power series, for the highest accuracy.",
        "Adaptative, d'ordre 20 : la série entière de la solution elle-même, pour la plus haute précision.",
    ),
    order: ORDER as u32,
    kind: Kind::Adaptive,
    needs: Needs::Expression,
    symplectic: false,
    reversible: false,
    source: "A. Jorba, M. Zou, Experimental Mathematics 14, 99 (2005)",
    options: &[],
};

/// For tolerances from 1e-10 to 1e-15, orders from 13 to 18 would cost least; a longer series takes longer steps.
const ORDER: u8 = 20;

impl Method for Taylor {
    fn card(&self) -> &'static MethodCard {
        &CARD
    }
    type Steps<S: Scalar> = Steps<S>;

    fn stepper<S: Scalar>(&self, shape: &Shape, options: &Options) -> Steps<S> {
        let full = shape.full();
        let equations = options.equations.as_ref().filter(|tape| tape.inputs() == full + 1);
        let series = equations.and_then(|tape| Series::new(tape, ORDER.into()).ok());
        Steps {
            rows: series.map_or(vec![], |series| vec![series; shape.rows]),
            places: shape.places(),
            known: false,
            terms: vec![S::from(0.0); shape.size()],
            evaluations: 0,
        }
    }
}

/// The series, and whether they are those of the step's start.
pub struct Steps<S: Scalar> {
    /// A series a row. None without equations: the steps end in NaN (a [`drive`](crate::drive) refuses such a run).
    rows: Vec<Series<S>>,
    /// Where the numbers of each row stand.
    places: Vec<Vec<usize>>,
    known: bool,
    /// A row's state, or the terms of one order.
    terms: Vec<S>,
    /// A coefficient of all rates counts as an evaluation.
    evaluations: u64,
}

impl<S: Scalar> Steps<S> {
    /// The terms of an order, of all rows.
    #[inline(always)]
    fn terms(&mut self, order: u8, power: S) -> &[S] {
        for (series, places) in self.rows.iter().zip(&self.places) {
            for (i, &place) in places.iter().enumerate() {
                self.terms[place] = series.of(i)[usize::from(order)] * power;
            }
        }
        &self.terms
    }

    #[inline(always)]
    fn expand(&mut self, t: S, y: &[S]) {
        for (series, places) in self.rows.iter_mut().zip(&self.places) {
            for (term, &place) in self.terms.iter_mut().zip(places) {
                *term = y[place];
            }
            series.expand(t, &self.terms[..places.len()]);
        }
        self.evaluations += u64::from(ORDER);
        self.known = true;
    }
}

impl<S: Scalar> Stepper<S> for Steps<S> {
    #[inline(always)]
    fn step(&mut self, step: &mut Step<S>) -> Result<(), NoConvergence> {
        if !self.known {
            self.expand(step.t, step.y);
        }
        step.out.fill(S::from(f64::NAN));
        for (series, places) in self.rows.iter().zip(&self.places) {
            for (i, &place) in places.iter().enumerate() {
                let (y, rest) = series.of(i).split_at(1);
                let sum = rest.iter().rev().fold(S::from(0.0), |sum, c| sum * step.h + *c);
                step.out[place] = y[0] + step.h * sum;
            }
        }
        Ok(())
    }

    /// The larger of the last two terms: one of them may be missing by symmetry.
    #[inline(always)]
    fn error(&mut self, h: S, weights: &[S]) -> S {
        let power = h.powi(i32::from(ORDER) - 1);
        let before = norm(self.terms(ORDER - 1, power), weights);
        norm(self.terms(ORDER, power * h), weights).larger(before)
    }

    #[inline(always)]
    fn dense(&mut self, _field: &dyn Field<S>, t: S, y: &[S], h: S, end: &[S]) -> Dense<S> {
        let mut power = S::from(1.0);
        let terms = (1..=ORDER).map(|order| {
            power = power * h;
            self.terms(order, power).to_vec()
        });
        let terms = terms.collect();
        Dense::series(t, h, y, end, terms)
    }

    #[inline(always)]
    fn accept(&mut self, accepted: S::Mask) {
        // A lane that tries again finds its own series anew, with the same bits.
        self.known = S::all(!accepted);
    }

    fn restart(&mut self) {
        self.known = false;
    }

    fn evaluations(&self) -> u64 {
        self.evaluations
    }
}
