//! What a card calls constant is: its derivative along the flow vanishes at random states.

use crate::{Any, cases, cases::Case, finds, holds_for_all, within};
use precess_scalar::Dual;
use precess_system::{Card, Default, Field, ObservableKind};

/// The derivative may be this part of the sum of its terms' sizes: some hundred roundings.
const BOUND: f64 = 1e-13;

pub fn law(system: Any) -> Result<(), String> {
    for mut group in cases::cases(system)? {
        for k in 0..group[0].layout.observables.len() {
            let observable = group[0].layout.observables[k].clone();
            let ObservableKind::Invariant { when_zero } = &observable.kind else { continue };
            let name = &observable.quantity.name;
            let mut moved = false;
            for case in &mut group {
                let drawn = case.values.clone();
                set_to_zero(&system.card(), case, when_zero);
                let (slope, size) = along_the_flow(system, case, k);
                case.values = drawn;
                if !within(slope, BOUND * size) {
                    return Err(format!(
                        "{name} is not constant: {slope:e} along the flow, of terms of {size:e}"
                    ));
                }
                moved |= size > 0.0;
            }
            if !moved {
                return Err(format!("{name} is constant for nothing that moves enters it"));
            }
        }
    }
    Ok(())
}

pub fn set_to_zero(card: &Card, case: &mut Case, names: &[&str]) {
    for name in names {
        if let Some(x) = case.values.number_mut(card, name) {
            *x = 0.0;
        } else {
            let lists = card.parameters.iter().filter(|p| matches!(p.default, Default::List { .. }));
            let place = lists.into_iter().position(|p| p.quantity.name == *name);
            case.values.lists[place.expect("the card's law knows the names")].items.fill(0.0);
        }
    }
}

/// The derivative of observable `k` along the flow, and the sum of the sizes of its terms.
fn along_the_flow(system: Any, case: &Case, k: usize) -> (f64, f64) {
    let rate = case.rate(system);
    let (field, y) = case.bind(system, Dual::constant);
    let derivative = |t_dot: f64, y_dot: &dyn Fn(usize) -> f64| {
        let moving: Vec<Dual<f64>> =
            y.iter().enumerate().map(|(i, x)| Dual::new(x.value, y_dot(i))).collect();
        observed(&*field, Dual::new(case.t, t_dot), &moving, k)
    };
    let slope = derivative(1.0, &|i| rate[i]);
    let terms = (0..y.len()).map(|j| derivative(0.0, &|i| if i == j { rate[i] } else { 0.0 }).abs());
    (slope, terms.sum::<f64>() + derivative(1.0, &|_| 0.0).abs())
}

fn observed(field: &dyn Field<Dual<f64>>, t: Dual<f64>, y: &[Dual<f64>], k: usize) -> f64 {
    let mut out = vec![Dual::constant(0.0); field.shape().observables];
    field.observe(t, y, &mut out);
    out[k].slope
}

#[test]
fn invariants_are_constant_along_the_flow() {
    holds_for_all(law);
}

mod faulty {
    use precess_scalar::Scalar;
    use precess_system::{Card, State, System, card, coordinate, number};

    /// A damped spring: (what is called its energy, whether only without friction).
    #[derive(Clone)]
    pub struct Damped(pub f64, pub bool);

    impl System for Damped {
        fn card(&self) -> Card {
            let when: &[&'static str] = if self.1 { &["r"] } else { &[] };
            card("damped", "Damped spring", "Ressort amorti")
                .coordinate(coordinate("x", "", "place", "place"))
                .parameter(number("r", "", 0.0, "friction", "frottement"))
                .invariant_if("energy", "", when, "energy", "énergie")
        }
        fn equations<S: Scalar>(&self, s: &State<S>, highest: &mut [S]) {
            let ([x], [v], [r]) = (s.q(), s.v(), s.p());
            highest[0] = -x - r * v;
        }
        fn observe<S: Scalar>(&self, s: &State<S>, out: &mut [S]) {
            let ([x], [v]) = (s.q(), s.v());
            out[0] = (x * x + v * v) * self.0 + x * (1.0 - self.0) * v;
        }
    }

    /// An observable that never changes because it looks at nothing.
    #[derive(Clone)]
    pub struct Blind;

    impl System for Blind {
        fn card(&self) -> Card {
            Damped(1.0, true).card()
        }
        fn equations<S: Scalar>(&self, s: &State<S>, highest: &mut [S]) {
            Damped(1.0, true).equations(s, highest);
        }
        fn observe<S: Scalar>(&self, _s: &State<S>, out: &mut [S]) {
            out[0] = S::from(0.0);
        }
    }
}

#[test]
fn the_law_finds_what_is_not_constant() {
    use faulty::{Blind, Damped};
    law(&Damped(1.0, true)).expect("the energy of the free spring passes");
    finds(&law(&Damped(1.0, false)), &["energy is not constant"]);
    // One part in 10^10 of something else is seen.
    finds(&law(&const { Damped(1.0 - 1e-10, true) }), &["energy is not constant"]);
    finds(&law(&Blind), &["nothing that moves"]);
}
