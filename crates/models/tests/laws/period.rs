//! A period in time is one: after it the equations are the same, and sooner they are not.

use crate::{Any, cases, cases::Case, finds, holds_for_all, within};
use precess_scalar::Scalar;
use precess_system::{State, System, Values, card, coordinate, number};

/// Phases of a drive lose digits with the number of turns behind them.
const BOUND: f64 = 1e-12;

pub fn law(system: Any) -> Result<(), String> {
    for case in cases::cases(system)?.iter().flatten() {
        let Some(period) = system.period(&case.values).filter(|p| p.is_finite()) else { continue };
        // No time at which a sine or a cosine is the same half a period later.
        let at = |share: f64| rates(system, case, period * share);
        let now = at(0.3);
        let size = now.iter().fold(1.0, |most: f64, x| most.larger(x.abs()));
        let apart = |later: &[f64]| {
            now.iter().zip(later).fold(0.0, |most: f64, (a, b)| most.larger((a - b).abs() / size))
        };
        let (whole, part) = (apart(&at(1.3)), apart(&at(0.67)));
        if !within(whole, BOUND) {
            return Err(format!("after a period of {period} the equations differ by {whole:e}"));
        }
        if within(part, BOUND) && precess_system::structure(system, &case.values, &case.layout).time_enters {
            return Err(format!("the equations are the same long before their period of {period}"));
        }
    }
    Ok(())
}

fn rates(system: Any, case: &Case, later: f64) -> Vec<f64> {
    let (field, y) = case.bind(system, |x| x);
    let mut rates = vec![0.0; y.len()];
    field.rate(later, &y, &mut rates);
    rates
}

#[test]
fn every_period_is_one() {
    holds_for_all(law);
}

/// x'' = sin(w t), which says that its period is as long as P says.
#[derive(Clone)]
struct Driven<const HALVES: u32>;
impl<const HALVES: u32> System for Driven<HALVES> {
    fn card(&self) -> precess_system::Card {
        card("driven", "d", "d")
            .coordinate(coordinate("x", "", "x", "x"))
            .parameter(number("w", "", 2.0, "w", "w").positive())
    }
    fn equations<S: Scalar>(&self, s: &State<S>, highest: &mut [S]) {
        let [w] = s.p();
        highest[0] = (w * s.t).sin();
    }
    fn period(&self, values: &Values<f64>) -> Option<f64> {
        Some(std::f64::consts::PI * f64::from(HALVES) / values.numbers[0])
    }
}

#[test]
fn a_wrong_period_is_found() {
    assert_eq!(law(&Driven::<2>), Ok(()));
    finds(&law(&Driven::<1>), &["after a period"]);
}
