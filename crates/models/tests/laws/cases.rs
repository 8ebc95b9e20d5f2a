//! Random parameters and states of a system, in every layout it has.

use crate::{Any, draw::Draw};
use precess_scalar::{Scalar, Tape, Traced};
use precess_system::{AnySystem, Bind, Default, Field, Given, Layout, Range, Values};

/// Parameters and a state.
pub struct Case {
    pub values: Values<f64>,
    pub layout: Layout,
    pub t: f64,
    /// The full state, modes included.
    pub y: Vec<f64>,
}

/// How many cases are drawn in each layout: a multiple of the widest batch.
const DRAWN: usize = 16;
const SEED: u64 = 2020;

/// Random cases, grouped by layout: as it is, with longer lists, in space where a z makes it so, and with
/// every option of every choice.
pub fn cases(system: Any) -> Result<Vec<Vec<Case>>, String> {
    let card = system.card();
    let plain = Values::defaults(&card);
    let mut longer = plain.clone();
    let longest = card.parameters.iter().filter(|p| matches!(p.default, Default::List { .. }));
    for (list, parameter) in longer.lists.iter_mut().zip(longest) {
        // A vector has three components and no more.
        if list.items.len() / list.width + 2 <= parameter.longest {
            let more: Vec<f64> = list.items.iter().copied().cycle().take(2 * list.width).collect();
            list.items.extend(more);
        }
    }
    let mut variants = vec![(plain.clone(), Given::default())];
    if !plain.lists.is_empty() {
        variants.push((longer, Given(vec![("z0".into(), 0.1)])));
    }
    let choices = card.parameters.iter().filter_map(|p| match p.default {
        Default::Choice(options) => Some(options.len()),
        _ => None,
    });
    for (k, options) in choices.enumerate() {
        for option in 1..options {
            let mut values = plain.clone();
            values.choices[k] = option;
            variants.push((values, Given::default()));
        }
    }
    let mut draw = Draw(SEED);
    variants.iter().map(|(values, given)| drawn(system, values, given, &mut draw)).collect()
}

fn drawn(system: Any, values: &Values<f64>, given: &Given, draw: &mut Draw) -> Result<Vec<Case>, String> {
    let mut refusal = String::new();
    let mut cases = vec![];
    // Some draws make no sense (a body without a possible shape); most must.
    for _ in 0..40 * DRAWN {
        match one(system, values, given, draw) {
            Ok(case) => cases.push(case),
            Err(reason) => refusal = reason,
        }
        if cases.len() == DRAWN {
            return Ok(cases);
        }
    }
    Err(format!("hardly any random start is accepted; the last refusal: {refusal}"))
}

fn one(system: Any, values: &Values<f64>, given: &Given, draw: &mut Draw) -> Result<Case, String> {
    let card = system.card();
    let mut values = values.clone();
    let numeric = card.parameters.iter().filter(|p| matches!(p.default, Default::Number(_)));
    for (x, parameter) in values.numbers.iter_mut().zip(numeric) {
        *x = near(*x, parameter.quantity.range, draw);
    }
    let lists = card.parameters.iter().filter(|p| matches!(p.default, Default::List { .. }));
    for (list, _) in values.lists.iter_mut().zip(lists).filter(|(_, p)| !p.structural) {
        for x in &mut list.items {
            *x = near(*x, Range::ANY, draw);
        }
    }
    let layout = system.layout(&values, given);
    let starts = layout.starts().zip(layout.start()).map(|(quantity, start)| {
        let size = 1.5 * (1.0 + start.abs());
        let low = if quantity.range.low < 0.0 { -size } else { quantity.range.low };
        (quantity.name, draw.between(low, size))
    });
    let starts = Given(starts.collect());
    let y = system.start(&values, &layout, &starts)?;
    Ok(Case { values, layout, t: draw.between(0.0, 5.0), y })
}

/// A value near the default, but never zero: so every term of an equation counts.
fn near(default: f64, range: Range, draw: &mut Draw) -> f64 {
    let value = if default == 0.0 { draw.between(0.1, 1.0) } else { default * draw.between(0.5, 1.5) };
    if range.contains(value) { value } else { default }
}

impl Case {
    /// The system over another number, and this case's state in it.
    pub fn bind<S: Scalar>(&self, system: Any, lift: impl Fn(f64) -> S) -> (Box<dyn Field<S>>, Vec<S>)
    where
        dyn AnySystem: Bind<S>,
    {
        let field = Bind::<S>::bind(system, self.values.map(|&x| lift(x)), &self.layout);
        (field, self.y.iter().map(|&x| lift(x)).collect())
    }

    /// The rate of the full state.
    pub fn rate(&self, system: Any) -> Vec<f64> {
        let (field, y) = self.bind(system, |x| x);
        let mut rate = y.clone();
        field.rate(self.t, &y, &mut rate);
        rate
    }

    /// What [`everything`] gives, name by name.
    pub fn names(&self) -> Vec<String> {
        let state = self.layout.state().into_iter().map(|q| q.name);
        let modes = (0..self.layout.modes).map(|k| format!("mode {k}"));
        let state: Vec<String> = state.chain(modes).collect();
        let rates = state.iter().map(|name| format!("the rate of {name}"));
        let observables = self.layout.observables.iter().map(|o| o.quantity.name.clone());
        let events = self.layout.events.iter().map(|e| format!("the event function {}", e.name));
        let jumps = self
            .layout
            .events
            .iter()
            .flat_map(|event| state.iter().map(move |name| format!("{name} after {}", event.name)));
        let lagrangian = "the Lagrangian".to_string();
        rates.chain(observables).chain(events).chain(jumps).chain([lagrangian]).collect()
    }
}

impl Case {
    /// All that an equation sees: time, the state, the numeric parameters, the items of the lists.
    pub fn inputs(&self) -> Vec<f64> {
        let lists = self.values.lists.iter().flat_map(|list| &list.items);
        [self.t].iter().chain(&self.y).chain(&self.values.numbers).chain(lists).copied().collect()
    }

    /// The names of the inputs.
    pub fn input_names(&self, system: Any) -> Vec<String> {
        let card = system.card();
        let state = self.layout.state().into_iter().map(|q| q.name);
        let modes = (0..self.layout.modes).map(|k| format!("mode{k}"));
        let numbers = card.parameters.iter().filter(|p| matches!(p.default, Default::Number(_)));
        let lists = card.parameters.iter().filter(|p| matches!(p.default, Default::List { .. }));
        let items = lists
            .zip(&self.values.lists)
            .flat_map(|(p, list)| (0..list.items.len()).map(|k| format!("{}{k}", p.quantity.name)));
        let numbers = numbers.map(|p| p.quantity.name.clone());
        ["t".to_string()].into_iter().chain(state).chain(modes).chain(numbers).chain(items).collect()
    }

    /// All that the system computes, as an expression in the inputs.
    pub fn tape(&self, system: Any) -> Tape {
        let (numbers, full) = (self.values.numbers.len(), self.y.len());
        Tape::record(self.inputs().len(), |x| {
            let (state, parameters) = x[1..].split_at(full);
            let (first, rest) = parameters.split_at(numbers);
            let mut values = self.values.map(|_| Traced::from(0.0));
            values.numbers = first.to_vec();
            let items = values.lists.iter_mut().flat_map(|list| &mut list.items);
            items.zip(rest).for_each(|(item, &input)| *item = input);
            let field = Bind::<Traced>::bind(system, values, &self.layout);
            everything(&*field, x[0], state)
        })
    }
}

/// All that a system computes: rates, observables, event functions, the state after each event, the
/// Lagrangian (zero where there is none).
pub fn everything<S: Scalar>(field: &dyn Field<S>, t: S, y: &[S]) -> Vec<S> {
    let (shape, zero) = (field.shape(), S::from(0.0));
    let mut rates = vec![zero; y.len()];
    let mut observables = vec![zero; shape.observables];
    let mut events = vec![zero; shape.events];
    field.rate(t, y, &mut rates);
    field.observe(t, y, &mut observables);
    field.crossings(t, y, &mut events);
    let jumps = (0..shape.events).flat_map(|event| {
        let mut after = y.to_vec();
        field.jump(event, t, &mut after);
        after
    });
    let jumps: Vec<S> = jumps.collect();
    let lagrangian = field.lagrangian(t, y).unwrap_or(zero);
    [rates, observables, events, jumps, vec![lagrangian]].concat()
}
