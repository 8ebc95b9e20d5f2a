//! The written equations are those of the Lagrangian: the Euler-Lagrange equations by dual numbers.
//!
//!     sum over j of L_{v_i v_j} a_j + L_{v_i q_j} v_j, + L_{v_i t} - L_{q_i} = 0

use crate::{Any, cases, cases::Case, finds, holds_for_all, invariants::set_to_zero, within};
use precess_scalar::Dual;
use precess_system::{Bind, Field, ObservableKind};

/// The residual may be this part of the sum of its terms' sizes.
const BOUND: f64 = 1e-13;

type Second = Dual<Dual<f64>>;

pub fn law(system: Any) -> Result<(), String> {
    for mut group in cases::cases(system)? {
        for case in &mut group {
            without_losses(system, case);
            let (field, y) = case.bind(system, |x| Dual::constant(Dual::constant(x)));
            let t = Dual::constant(Dual::constant(case.t));
            if field.lagrangian(t, &y).is_none() {
                return Ok(());
            }
            if !field.shape().is_second_order() {
                return Err("a Lagrangian needs a velocity for every coordinate".into());
            }
            let rate = case.rate(system);
            for (i, coordinate) in case.layout.coordinates.iter().enumerate() {
                let (residual, size) = euler_lagrange(&*field, case, &rate, i);
                if !within(residual, BOUND * size) {
                    let name = &coordinate.quantity.name;
                    return Err(format!(
                        "the equation of {name} is not the Lagrangian's: a residual of {residual:e} among terms of {size:e}"
                    ));
                }
            }
        }
    }
    Ok(())
}

/// The losses are set to zero: the parameters that the energy's condition names and that the Lagrangian does not know.
/// (Those of a drive, or of a friction that it does know, stay.)
fn without_losses(system: Any, case: &mut Case) {
    let energy = case.layout.observables.iter().find(|o| o.quantity.name == "energy");
    let Some(ObservableKind::Invariant { when_zero }) = energy.map(|o| o.kind.clone()) else { return };
    let losses = when_zero.into_iter().filter(|name| !is_known_to_the_lagrangian(system, case, name));
    set_to_zero(&system.card(), case, &losses.collect::<Vec<_>>());
}

/// Whether the Lagrangian changes with this numeric parameter.
fn is_known_to_the_lagrangian(system: Any, case: &Case, name: &str) -> bool {
    let mut values = case.values.map(|&x| Dual::constant(x));
    let card = system.card();
    let place = (0..values.numbers.len()).find(|&k| {
        let mut moved = case.values.clone();
        moved.numbers[k] = f64::NAN;
        moved.number(&card, name).is_some_and(f64::is_nan)
    });
    let Some(place) = place else { return false };
    values.numbers[place].slope = 1.0;
    let field: Box<dyn Field<Dual<f64>>> = Bind::bind(system, values, &case.layout);
    let y: Vec<_> = case.y.iter().map(|&x| Dual::constant(x)).collect();
    field.lagrangian(Dual::constant(case.t), &y).is_some_and(|l| l.slope != 0.0)
}

/// The residual of the equation of coordinate `i`, and the sum of the sizes of its terms.
fn euler_lagrange(field: &dyn Field<Second>, case: &Case, rate: &[f64], i: usize) -> (f64, f64) {
    let velocity = field.shape().coordinates + i;
    // d/d(y_by), then the derivative along (t_dot, y_dot).
    let second = |by: usize, t_dot: f64, y_dot: &dyn Fn(usize) -> f64| {
        let seed = |j: usize, x: f64| {
            Dual::new(Dual::new(x, y_dot(j)), Dual::constant(f64::from(u8::from(j == by))))
        };
        let y: Vec<Second> = case.y.iter().enumerate().map(|(j, &x)| seed(j, x)).collect();
        let t = Dual::constant(Dual::new(case.t, t_dot));
        field.lagrangian(t, &y).map_or(Dual::constant(0.0), |l| l.slope)
    };
    let momentum_rate = second(velocity, 1.0, &|j| rate[j]).slope;
    let force = second(i, 0.0, &|_| 0.0).value;
    let terms =
        (0..case.y.len()).map(|k| second(velocity, 0.0, &|j| if j == k { rate[j] } else { 0.0 }).slope.abs());
    let size = terms.sum::<f64>() + second(velocity, 1.0, &|_| 0.0).slope.abs() + force.abs();
    (momentum_rate - force, size)
}

#[test]
fn lagrangians_give_the_written_equations() {
    holds_for_all(law);
}

mod faulty {
    use precess_scalar::Scalar;
    use precess_system::{Card, State, System, card, coordinate, number};

    /// Three masses on a line, held together in pairs by springs; a pair may be lost, or a driving term.
    #[derive(Clone)]
    pub struct Three {
        pub pairs: &'static [(usize, usize)],
        pub driven: f64,
    }

    impl Three {
        pub const SOUND: Self = Self { pairs: &[(0, 1), (0, 2), (1, 2)], driven: 1.0 };
    }

    impl System for Three {
        fn card(&self) -> Card {
            let card = card("three", "Three springs", "Trois ressorts")
                .parameter(number("k", "", 1.0, "stiffness", "raideur"))
                .invariant_if("energy", "", &[], "energy", "énergie");
            ["x0", "x1", "x2"]
                .into_iter()
                .fold(card, |card, x| card.coordinate(coordinate(x, "", "place", "place")))
        }
        fn equations<S: Scalar>(&self, s: &State<S>, highest: &mut [S]) {
            let (x, [k]) = (s.q::<3>(), s.p());
            highest.fill(s.t.sin() * self.driven);
            for &(i, j) in self.pairs {
                highest[i] = highest[i] + k * (x[j] - x[i]);
                highest[j] = highest[j] + k * (x[i] - x[j]);
            }
        }
        fn lagrangian<S: Scalar>(&self, s: &State<S>) -> Option<S> {
            let (x, v, [k]) = (s.q::<3>(), s.v::<3>(), s.p());
            let mut l = S::from(0.0);
            for i in 0..3 {
                // The momentum v + cos t changes by a - sin t.
                l = l + v[i] * v[i] * 0.5 + v[i] * s.t.cos();
                for j in i + 1..3 {
                    l = l - k * (x[i] - x[j]).squared() * 0.5;
                }
            }
            Some(l)
        }
    }

    /// A first-order system has no Lagrangian of this kind.
    #[derive(Clone)]
    pub struct FirstOrder;

    impl System for FirstOrder {
        fn card(&self) -> Card {
            card("first", "First", "Premier").coordinate(coordinate("x", "", "place", "place").first_order())
        }
        fn equations<S: Scalar>(&self, s: &State<S>, highest: &mut [S]) {
            highest.copy_from_slice(s.coordinates);
        }
        fn lagrangian<S: Scalar>(&self, s: &State<S>) -> Option<S> {
            Some(s.coordinates[0])
        }
    }
}

#[test]
fn the_law_finds_equations_of_another_system() {
    use faulty::{FirstOrder, Three};
    const LOST: Three = Three { pairs: &[(0, 1), (1, 2)], ..Three::SOUND };
    const NOT_DRIVEN: Three = Three { driven: 0.0, ..Three::SOUND };
    const HARDLY_WRONG: Three = Three { driven: 1.0 + 1e-10, ..Three::SOUND };
    law(&Three::SOUND).expect("the sound system passes");
    finds(&law(&LOST), &["equation of x0"]);
    finds(&law(&NOT_DRIVEN), &["equation of x0"]);
    finds(&law(&HARDLY_WRONG), &["equation of x"]);
    finds(&law(&FirstOrder), &["needs a velocity"]);
}
