//! Every number gives the same: lanes and derivatives to the bit, twice the digits to rounding.

use crate::{Any, cases, cases::Case, cases::everything, finds, holds_for_all, within};
use precess_scalar::{DoubleDouble, Dual, Isa, Lanes, Narrow, Traced, Wide, Widest, with_lanes};
use precess_system::{AnySystem, Bind, Field, List, Values};

/// With twice the digits, the outcome may differ as if the inputs were off by this part.
const BOUND: f64 = 1e-13;

pub fn law(system: Any) -> Result<(), String> {
    for group in cases::cases(system)? {
        let plain: Vec<Vec<f64>> = group.iter().map(|case| plain(system, case)).collect();
        for isa in Isa::available() {
            with_lanes!(isa, S => lanes::<S>(system, &group, &plain))?;
        }
        for (case, expected) in group.iter().zip(&plain) {
            dual(system, case, expected)?;
            double_double(system, case, expected)?;
            traced(system, case, expected)?;
        }
    }
    Ok(())
}

fn plain(system: Any, case: &Case) -> Vec<f64> {
    let (field, y) = case.bind(system, |x| x);
    everything(&*field, case.t, &y)
}

/// The first number that is not the same to the bit.
fn same_bits(kind: &str, case: &Case, found: &[f64], expected: &[f64]) -> Result<(), String> {
    let differs = |(a, b): (&f64, &f64)| !a.is_finite() || a.to_bits() != b.to_bits();
    let place = found.iter().zip(expected).position(differs);
    place.map_or(Ok(()), |k| {
        let name = &case.names()[k];
        Err(format!("{name} is {} with {kind}, {} with a plain number", found[k], expected[k]))
    })
}

/// A block of cases side by side, each with its own parameters.
fn lanes<S: Lanes>(system: Any, group: &[Case], expected: &[Vec<f64>]) -> Result<(), String>
where
    dyn AnySystem: Bind<S>,
{
    // There may be fewer cases than lanes: the rest repeats them.
    for first in (0..group.len()).step_by(S::LANES) {
        let case = |lane: usize| (first + lane) % group.len();
        let lanes = |get: &dyn Fn(&Case) -> f64| S::from_lanes(|lane| get(&group[case(lane)]));
        let block = &group[first..];
        let first = &block[0].values;
        let values = Values {
            numbers: (0..first.numbers.len()).map(|i| lanes(&|c| c.values.numbers[i])).collect(),
            lists: (first.lists.iter().enumerate())
                .map(|(k, list)| List {
                    width: list.width,
                    items: (0..list.items.len()).map(|i| lanes(&|c| c.values.lists[k].items[i])).collect(),
                })
                .collect(),
            choices: first.choices.clone(),
        };
        let y: Vec<S> = (0..block[0].y.len()).map(|i| lanes(&|c| c.y[i])).collect();
        let field = Bind::<S>::bind(system, values, &block[0].layout);
        let found = everything(&*field, lanes(&|c| c.t), &y);
        for lane in 0..S::LANES {
            let found: Vec<f64> = found.iter().map(|x| x.lanes()[lane]).collect();
            same_bits(&format!("{} lanes", S::LANES), &group[case(lane)], &found, &expected[case(lane)])?;
        }
    }
    Ok(())
}

fn dual(system: Any, case: &Case, expected: &[f64]) -> Result<(), String> {
    let (field, y) = case.bind(system, |x| Dual::new(x, 1.0));
    let found: Vec<f64> = everything(&*field, Dual::new(case.t, 1.0), &y).iter().map(|x| x.value).collect();
    same_bits("a dual number", case, &found, expected)
}

/// The recorded expression, replayed.
fn traced(system: Any, case: &Case, expected: &[f64]) -> Result<(), String> {
    let found = case.tape(system).evaluate(&case.inputs());
    same_bits("a recorded expression", case, &found, expected)
}

fn double_double(system: Any, case: &Case, expected: &[f64]) -> Result<(), String> {
    let (field, y) = case.bind(system, DoubleDouble::from);
    let found = everything(&*field, DoubleDouble::from(case.t), &y);
    let sensitivity = sensitivity(system, case);
    for (k, (exact, plain)) in found.iter().zip(expected).enumerate() {
        let error = (*exact - DoubleDouble::from(*plain)).to_f64();
        if !within(error, BOUND * (plain.abs() + sensitivity[k])) {
            let name = &case.names()[k];
            return Err(format!(
                "{name} is {plain} with a plain number, off by {error:e} from twice the digits"
            ));
        }
    }
    Ok(())
}

/// For each outcome the sum over the inputs (time, state, parameters) of |derivative| |input|.
fn sensitivity(system: Any, case: &Case) -> Vec<f64> {
    let inputs = 1 + case.y.len() + case.values.numbers.len();
    let inputs = inputs + case.values.lists.iter().map(|list| list.items.len()).sum::<usize>();
    let mut total: Vec<f64> = vec![];
    for moving in 0..inputs {
        let next = std::cell::Cell::new(0);
        let lift = |x: f64| Dual::new(x, if next.replace(next.get() + 1) == moving { x } else { 0.0 });
        let t = lift(case.t);
        let values = case.values.map(|&x| lift(x));
        let y: Vec<Dual<f64>> = case.y.iter().map(|&x| lift(x)).collect();
        let field: Box<dyn Field<Dual<f64>>> = Bind::bind(system, values, &case.layout);
        let slopes = everything(&*field, t, &y);
        total.resize(slopes.len(), 0.0);
        for (sum, outcome) in total.iter_mut().zip(slopes) {
            *sum += outcome.slope.abs();
        }
    }
    total
}

#[test]
fn every_number_gives_the_same() {
    holds_for_all(law);
}

mod faulty {
    use precess_scalar::Scalar;
    use precess_system::{Card, State, System, card, coordinate};
    use std::any::TypeId;

    /// A spring that looks at what it computes with: one kind of number sees another stiffness.
    #[derive(Clone)]
    pub struct Peeking {
        pub at: fn() -> TypeId,
        pub error: f64,
    }

    impl System for Peeking {
        fn card(&self) -> Card {
            card("peeking", "Peeking", "Curieux").coordinate(coordinate("x", "", "place", "place"))
        }
        fn equations<S: Scalar>(&self, s: &State<S>, highest: &mut [S]) {
            let error = if TypeId::of::<S>() == (self.at)() { self.error } else { 0.0 };
            highest[0] = -s.coordinates[0] * (1.0 + error);
        }
    }
}

#[test]
fn the_law_finds_a_number_that_differs() {
    use faulty::Peeking;
    use std::any::TypeId;
    const LAST_BIT: f64 = f64::EPSILON;
    let rate = "rate of x_dot";
    law(&Peeking { at: TypeId::of::<()>, error: 0.0 }).expect("the sound spring passes");
    for isa in Isa::available().into_iter().filter(|isa| isa.lanes() > 1) {
        let at = match isa {
            Isa::Narrow => TypeId::of::<Narrow>,
            Isa::Wide => TypeId::of::<Wide>,
            _ => TypeId::of::<Widest>,
        };
        let lanes = format!("{} lanes", isa.lanes());
        finds(&law(Box::leak(Box::new(Peeking { at, error: LAST_BIT }))), &[rate, &lanes]);
    }
    finds(&law(&Peeking { at: TypeId::of::<Dual<f64>>, error: LAST_BIT }), &[rate, "a dual number"]);
    finds(&law(&Peeking { at: TypeId::of::<Traced>, error: LAST_BIT }), &[rate, "a recorded expression"]);
    finds(&law(&Peeking { at: TypeId::of::<DoubleDouble>, error: 1e-12 }), &[rate, "twice the digits"]);
}
