//! Units add up: the equations run on dimensions.

use crate::{Any, cases, cases::Case, finds, holds_for_all};
use precess_scalar::{Dimension, Unit};
use precess_system::{Bind, Default, Order, Values, parse_unit};

pub fn law(system: Any) -> Result<(), String> {
    // Which numbers were drawn does not matter, only how many of them.
    for group in cases::cases(system)? {
        let case = &group[0];
        let units = Units::of(system, case)?;
        adds_up(system, case, &units).map_err(|fault| match culprit(system, case, &units) {
            Some(expression) => format!("{fault}: {expression}"),
            None => fault,
        })?;
    }
    Ok(())
}

/// The first expression whose units do not add up.
fn culprit(system: Any, case: &Case, units: &Units) -> Option<String> {
    let tape = case.tape(system);
    let lists = units.values.lists.iter().flat_map(|list| &list.items);
    let inputs = [Unit::of(units.time)].into_iter();
    let inputs: Vec<Unit> =
        inputs.chain(units.state.iter().chain(&units.values.numbers).chain(lists).copied()).collect();
    let mut culprit = None;
    Unit::clash();
    tape.evaluate_with(&inputs, |node, _| {
        if Unit::clash().is_some() && culprit.is_none() {
            culprit = Some(node);
        }
    });
    culprit.map(|node| tape.text_of(node, &case.input_names(system)))
}

fn adds_up(system: Any, case: &Case, units: &Units) -> Result<(), String> {
    let field = Bind::<Unit>::bind(system, units.values.clone(), &case.layout);
    let (t, y) = (Unit::of(units.time), &units.state);

    let mut rates = y.clone();
    no_clash("before")?;
    field.rate(t, y, &mut rates);
    no_clash("the equations")?;
    for ((coordinate, i), rate) in case.layout.coordinates.iter().zip(0..).zip(&rates) {
        let velocity = field.shape().pairs().find(|p| p.0 == i).map(|p| p.1);
        let (order, rate) =
            (if coordinate.order == Order::Second { 2 } else { 1 }, velocity.map_or(*rate, |v| rates[v]));
        let own = y[i].dimension().unwrap_or_default();
        agree(
            &format!("the highest derivative of {}", coordinate.quantity.name),
            rate,
            own.over(units.time.power(order)),
        )?;
    }

    let mut observables = vec![Unit::from(0.0); case.layout.observables.len()];
    field.observe(t, y, &mut observables);
    no_clash("the observables")?;
    let mut energy = None;
    for (value, observable) in observables.iter().zip(&case.layout.observables) {
        let declared = dimension(&observable.quantity.unit)?;
        agree(&observable.quantity.name, *value, declared)?;
        if observable.quantity.name == "energy" {
            energy = Some(declared);
        }
    }
    let lagrangian = field.lagrangian(t, y);
    no_clash("the Lagrangian")?;
    if let (Some(lagrangian), Some(energy)) = (lagrangian, energy) {
        agree("the Lagrangian", lagrangian, energy)?;
    }
    if system.solvable(&case.values, &case.layout, &case.y).is_ok() {
        let mut end = y.clone();
        field.solution(t, y, t, &mut end);
        no_clash("the closed form")?;
        for ((x, start), quantity) in end.iter().zip(y).zip(case.layout.state()) {
            agree(&format!("{} in closed form", quantity.name), *x, start.dimension().unwrap_or_default())?;
        }
    }
    events_add_up(&*field, t, y, case)
}

fn events_add_up(
    field: &dyn precess_system::Field<Unit>,
    t: Unit,
    y: &[Unit],
    case: &Case,
) -> Result<(), String> {
    let mut crossings = vec![Unit::from(0.0); case.layout.events.len()];
    field.crossings(t, y, &mut crossings);
    no_clash("the event functions")?;
    for (k, event) in case.layout.events.iter().enumerate() {
        let mut after = y.to_vec();
        field.jump(k, t, &mut after);
        no_clash(&event.name)?;
        for (a, b) in after.iter().zip(y) {
            agree(&format!("the state after {}", event.name), *a, b.dimension().unwrap_or_default())?;
        }
    }
    Ok(())
}

/// The dimensions of all that an equation sees.
struct Units {
    values: Values<Unit>,
    state: Vec<Unit>,
    /// A second, or a pure number where the whole card is without units.
    time: Dimension,
}

impl Units {
    fn of(system: Any, case: &Case) -> Result<Self, String> {
        let card = system.card();
        let of = |text: &String| dimension(text);
        let parameters = card.parameters.iter().map(|p| of(&p.quantity.unit));
        let parameters = parameters.collect::<Result<Vec<_>, _>>()?;
        let state = case.layout.state().iter().map(|q| of(&q.unit)).collect::<Result<Vec<_>, _>>()?;
        let observables = case.layout.observables.iter().map(|o| of(&o.quantity.unit));
        let observables = observables.collect::<Result<Vec<_>, _>>()?;
        let bare = parameters.iter().chain(&state).chain(&observables).all(|&d| d == Dimension::NONE);
        let time = if bare { Dimension::NONE } else { Dimension::new(0, 0, 1) };

        let units = |is: fn(&Default) -> bool| {
            let chosen = card.parameters.iter().zip(&parameters).filter(move |(p, _)| is(&p.default));
            chosen.map(|(_, &d)| Unit::of(d))
        };
        let mut values = case.values.map(|_| Unit::from(0.0));
        values.numbers = units(|d| matches!(d, Default::Number(_))).collect();
        for (list, unit) in values.lists.iter_mut().zip(units(|d| matches!(d, Default::List { .. }))) {
            list.items.fill(unit);
        }
        // A mode has the dimension of what it holds.
        let modes = std::iter::repeat_n(Unit::from(0.0), case.layout.modes);
        let state = state.into_iter().map(Unit::of).chain(modes).collect();
        Ok(Self { values, state, time })
    }
}

fn dimension(text: &str) -> Result<Dimension, String> {
    parse_unit(text).map(|(_, dimension)| dimension).map_err(|e| e.to_string())
}

fn no_clash(place: &str) -> Result<(), String> {
    Unit::clash().map_or(Ok(()), |(a, b)| Err(format!("in {place}, {a} meets {b}")))
}

/// A literal zero agrees with everything.
fn agree(name: &str, value: Unit, declared: Dimension) -> Result<(), String> {
    match value.dimension() {
        Some(dimension) if dimension != declared => {
            Err(format!("{name} is in {dimension}, not in {declared}"))
        }
        _ => Ok(()),
    }
}

#[test]
fn units_add_up() {
    holds_for_all(law);
}

mod faulty {
    use precess_scalar::Scalar;
    use precess_system::{Card, State, System, card, coordinate, number};

    /// A spring with a fault of one's choice.
    #[derive(Clone)]
    pub struct Spring(pub Fault);

    #[derive(Clone, PartialEq)]
    pub enum Fault {
        None,
        ForceForAcceleration,
        WrongSum,
        WrongEnergy,
    }

    impl System for Spring {
        fn card(&self) -> Card {
            card("spring", "Spring", "Ressort")
                .coordinate(coordinate("x", "m", "place", "place"))
                .parameter(number("m", "kg", 1.0, "mass", "masse"))
                .parameter(number("k", "kg/s^2", 1.0, "stiffness", "raideur"))
                .invariant("energy", "J", "energy", "énergie")
        }
        fn equations<S: Scalar>(&self, s: &State<S>, highest: &mut [S]) {
            let ([x], [v], [m, k]) = (s.q(), s.v(), s.p());
            highest[0] = match self.0 {
                Fault::ForceForAcceleration => -(k * x),
                Fault::WrongSum => -(k / m * (x + v)),
                _ => -(k / m * x),
            };
        }
        fn observe<S: Scalar>(&self, s: &State<S>, out: &mut [S]) {
            let ([x], [v], [m, k]) = (s.q(), s.v(), s.p());
            out[0] = if self.0 == Fault::WrongEnergy {
                v * v + k / m * x * x
            } else {
                (m * v * v + k * x * x) * 0.5
            };
        }
    }
}

#[test]
fn the_law_finds_a_wrong_unit() {
    use faulty::{Fault, Spring};
    law(&Spring(Fault::None)).expect("the sound spring passes");
    finds(&law(&Spring(Fault::ForceForAcceleration)), &["derivative of x", "kg m s^-2"]);
    finds(&law(&Spring(Fault::WrongSum)), &["equations", "m meets m s^-1", "x + x_dot"]);
    finds(&law(&Spring(Fault::WrongEnergy)), &["energy", "m^2 s^-2"]);
}
