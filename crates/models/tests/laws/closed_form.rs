//! Where a system has a closed form, it begins at its start and satisfies the equations, to rounding; by every number.

use crate::{Any, cases, cases::Case, finds, holds_for_all, within};
use precess_scalar::{Dual, Isa, Lanes, with_lanes};
use precess_system::{AnySystem, Bind, Default};

/// The residual may be this part of the largest rate.
const BOUND: f64 = 1e-11;

pub fn law(system: Any) -> Result<(), String> {
    for group in cases::cases(system)? {
        let solvable: Vec<Case> =
            group.into_iter().filter_map(|mut case| solvable(system, &mut case).then_some(case)).collect();
        for (k, case) in solvable.iter().enumerate() {
            // Forth and back in time.
            let end = case.t + [0.7, -1.3, 4.1, -3.7][k % 4];
            begins_at_its_start(system, case)?;
            satisfies_the_equations(system, case, end)?;
            for isa in Isa::available() {
                with_lanes!(isa, S => same_bits::<S>(system, case, end))?;
            }
        }
    }
    Ok(())
}

/// Whether the case is solvable, at least without what is not there by default (friction, softening).
fn solvable(system: Any, case: &mut Case) -> bool {
    let has = |case: &Case| system.solvable(&case.values, &case.layout, &case.y).is_ok();
    if !has(case) {
        let card = system.card();
        let defaults = card.parameters.iter().filter_map(|p| match p.default {
            Default::Number(x) => Some(x),
            _ => None,
        });
        for (x, default) in case.values.numbers.iter_mut().zip(defaults) {
            *x = if default == 0.0 { 0.0 } else { *x };
        }
    }
    has(case)
}

fn solve(system: Any, case: &Case, end: f64) -> Vec<f64> {
    let (field, start) = case.bind(system, |x| x);
    let mut y = start.clone();
    field.solution(case.t, &start, end, &mut y);
    y
}

fn begins_at_its_start(system: Any, case: &Case) -> Result<(), String> {
    let names = case.layout.state().into_iter().map(|q| q.name);
    for ((name, x), start) in names.zip(solve(system, case, case.t)).zip(&case.y) {
        if !within(x - start, 1e-14 * (1.0 + start.abs())) {
            return Err(format!("the closed form has {name} = {x} at the start, not {start}"));
        }
    }
    Ok(())
}

fn satisfies_the_equations(system: Any, case: &Case, end: f64) -> Result<(), String> {
    let (field, start) = case.bind(system, Dual::constant);
    let mut y = start.clone();
    field.solution(Dual::constant(case.t), &start, Dual::new(end, 1.0), &mut y);
    let mut rate = y.clone();
    let state: Vec<_> = y.iter().map(|x| Dual::constant(x.value)).collect();
    field.rate(Dual::constant(end), &state, &mut rate);
    let largest =
        rate.iter().fold(0.0, |most: f64, x| if x.value.abs() > most { x.value.abs() } else { most });
    let names = case.layout.state().into_iter().map(|q| q.name);
    for ((name, x), rate) in names.zip(&y).zip(&rate) {
        if !within(x.slope - rate.value, BOUND * (1.0 + largest)) {
            return Err(format!(
                "the closed form has the rate {} of {name} where the equations ask for {}",
                x.slope, rate.value
            ));
        }
    }
    Ok(())
}

fn same_bits<S: Lanes>(system: Any, case: &Case, end: f64) -> Result<(), String>
where
    dyn AnySystem: Bind<S>,
{
    // The other lanes are a little earlier, so that all take their own way.
    let (field, start) = case.bind(system, S::from);
    let mut y = start.clone();
    let time = |lane: usize| end - 0.01 * lane as f64;
    field.solution(S::from(case.t), &start, S::from_lanes(time), &mut y);
    for lane in 0..S::LANES {
        for (wide, x) in y.iter().zip(solve(system, case, time(lane))) {
            if wide.lanes()[lane].to_bits() != x.to_bits() {
                return Err(format!("the closed form is {} in a lane, {x} alone", wide.lanes()[lane]));
            }
        }
    }
    Ok(())
}

#[test]
fn closed_forms_satisfy_the_equations() {
    holds_for_all(law);
}

#[test]
fn these_have_closed_forms() {
    const SOLVABLE: [&str; 11] = [
        "harmonic_oscillator",
        "spring",
        "planar_oscillator",
        "driven_oscillator",
        "car_suspension",
        "pendulum",
        "foucault_pendulum",
        "n_body",
        "gyroscope",
        "gyroscope_rolling",
        "free_body",
    ];
    for id in SOLVABLE {
        let system = *precess_models::ALL.iter().find(|s| s.card().id == id).expect("it is listed");
        let cases = cases::cases(system).expect("cases");
        let count =
            cases.into_iter().flatten().filter_map(|mut case| solvable(system, &mut case).then_some(()));
        assert!(count.count() >= 16, "{id} is hardly ever solvable");
    }
}

mod faulty {
    use precess_scalar::Scalar;
    use precess_system::{Card, State, System, card, coordinate, number};

    /// A falling stone whose closed form is too fast, or begins elsewhere.
    #[derive(Clone)]
    pub struct Stone {
        pub pull: f64,
        pub ahead: f64,
    }

    impl System for Stone {
        fn card(&self) -> Card {
            card("stone", "Stone", "Pierre")
                .coordinate(coordinate("x", "m", "place", "place"))
                .parameter(number("g", "m/s^2", 1.0, "gravity", "pesanteur"))
        }
        fn equations<S: Scalar>(&self, s: &State<S>, highest: &mut [S]) {
            [highest[0]] = s.p();
        }
        fn solvable(&self, _start: &State<f64>) -> Result<(), String> {
            Ok(())
        }
        fn solution<S: Scalar>(&self, start: &State<S>, t: S, q: &mut [S], v: &mut [S]) {
            let ([x], [w], [g]) = (start.q(), start.v(), start.p());
            let time = t - start.t;
            q[0] = x + (w + g * time * (0.5 * self.pull)) * time + self.ahead;
            v[0] = w + g * time * self.pull;
        }
    }
}

#[test]
fn the_law_finds_a_wrong_closed_form() {
    use faulty::Stone;
    law(&Stone { pull: 1.0, ahead: 0.0 }).expect("the sound stone passes");
    finds(&law(&Stone { pull: 1.0 + 1e-9, ahead: 0.0 }), &["rate", "x_dot"]);
    finds(&law(&Stone { pull: 1.0, ahead: 1e-9 }), &["at the start"]);
}
