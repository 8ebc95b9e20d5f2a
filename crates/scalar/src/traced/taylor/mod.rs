//! The Taylor coefficients of the solution of a differential equation, from its recorded right-hand side.
//!
//! With `x_k` the coefficient of `t^k`, each operation gives its coefficient `k` from those of its operands up to `k`: a product
//! is a convolution, and a function follows from the differential equation that it solves (R. E. Moore, *Interval
//! Analysis*, 1966; A. Jorba, M. Zou, *Experimental Mathematics* 14, 99, 2005). The equation itself then gives the
//! next coefficient of the state, `y_{k+1} = f_k / (k + 1)`, so that all orders cost little more than a square of their number.
//!
//! A choice between cases is made at the start and holds: where cases change, a step must end. Products with derivatives are written with the series of `t x'`, whose coefficients are `k x_k`.

mod coefficient;
mod rule;
mod translate;

use super::Tape;
use crate::Scalar;
use coefficient::{later, zeroth};
use rule::{Condition, Rule};
use translate::Rules;

/// The Taylor coefficients of a solution.
#[derive(Clone, Debug)]
pub struct Taylor<S: Scalar> {
    rules: Vec<Rule>,
    /// Row after row, each with all coefficients of one operation.
    coefficients: Vec<S>,
    /// Whether the condition of a row holds.
    holds: Vec<S::Mask>,
    terms: usize,
    /// The rows of time and the state, and those that give the state's rates.
    inputs: Vec<usize>,
    outputs: Vec<usize>,
}

impl<S: Scalar> Taylor<S> {
    /// For `y' = f(t, y)`, recorded with the inputs `t, y` and the outputs `f`, up to the coefficient of `t^order`.
    ///
    /// # Errors
    /// The function that has no Taylor series: an absolute value, a sign, the larger or smaller of two.
    ///
    /// # Panics
    /// If the tape does not have one output for each input but the first.
    pub fn new(tape: &Tape, order: usize) -> Result<Self, &'static str> {
        assert_eq!(tape.inputs, tape.outputs.len() + 1, "a rate for each number of the state");
        let mut rules = Rules::default();
        let smooth = tape.beside_conditions();
        let inputs = (0..tape.inputs).map(|_| rules.push(Rule::Input)).collect();
        for (&node, smooth) in tape.nodes.iter().zip(smooth) {
            let at = rules.translate(node, smooth)?;
            rules.place.push(at);
        }
        let outputs = tape.outputs.iter().map(|&at| rules.place[at as usize]).collect();
        let terms = order + 1;
        let coefficients = vec![S::from(0.0); rules.rules.len() * terms];
        let holds = vec![!S::always(); rules.rules.len()];
        Ok(Self { rules: rules.rules, coefficients, holds, terms, inputs, outputs })
    }

    /// Expands the solution that is at `y` at time `t`.
    ///
    /// # Panics
    /// If the state is not of the recorded size.
    #[inline(always)]
    pub fn expand(&mut self, t: S, y: &[S]) {
        assert_eq!(y.len(), self.outputs.len(), "a state of another size");
        let terms = self.terms;
        let time = self.inputs[0] * terms;
        self.coefficients[time] = t;
        if terms > 1 {
            self.coefficients[time + 1] = S::from(1.0);
        }
        for (&row, y) in self.inputs[1..].iter().zip(y) {
            self.coefficients[row * terms] = *y;
        }
        for k in 0..terms - 1 {
            self.order(k);
            for (&row, &rate) in self.inputs[1..].iter().zip(&self.outputs) {
                self.coefficients[row * terms + k + 1] = self.coefficients[rate * terms + k] / (k + 1) as f64;
            }
        }
    }

    /// The coefficients of number `i` of the state, from that of `t^0` on.
    pub fn of(&self, i: usize) -> &[S] {
        &self.coefficients[self.inputs[i + 1] * self.terms..][..self.terms]
    }

    /// Coefficient `k` of every operation.
    #[inline(always)]
    fn order(&mut self, k: usize) {
        let terms = self.terms;
        for (row, rule) in self.rules.iter().enumerate() {
            let from = |row: usize| &self.coefficients[row * terms..][..terms];
            let value = match *rule {
                Rule::Condition(condition) if k == 0 => {
                    self.holds[row] = self.condition(condition);
                    None
                }
                Rule::Choice(mask, a, b) => Some(S::select(self.holds[mask], from(a)[k], from(b)[k])),
                rule if k == 0 => zeroth(rule, &from),
                rule => later(rule, row, k, &from),
            };
            if let Some(value) = value {
                self.coefficients[row * terms + k] = value;
            }
        }
    }
}

impl<S: Scalar> Taylor<S> {
    #[inline(always)]
    fn condition(&self, condition: Condition) -> S::Mask {
        let at = |row: usize| self.coefficients[row * self.terms];
        let holds = |row: usize| self.holds[row];
        match condition {
            Condition::Less(a, b) => at(a).lt(at(b)),
            Condition::LessOrEqual(a, b) => at(a).le(at(b)),
            Condition::And(a, b) => holds(a) & holds(b),
            Condition::Or(a, b) => holds(a) | holds(b),
            Condition::Not(a) => !holds(a),
        }
    }
}
