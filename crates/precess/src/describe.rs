//! A system's equations as text, from the definition that is integrated.

use precess_scalar::{Notation, Tape};
use precess_system::{AnySystem, Card, Default, Layout, Order, Quantity, Rates, Values};
use std::cell::Cell;

/// The equations of a system, printed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Equations {
    /// Names given to expressions that occur several times: (name, expression).
    pub definitions: Vec<(String, String)>,
    /// (left-hand side, right-hand side), one a coordinate.
    pub equations: Vec<(String, String)>,
}

/// Prints the equations of a system with its default lists.
pub fn equations(system: &dyn AnySystem, notation: Notation) -> Equations {
    let card = system.card();
    let values = Values::defaults(&card);
    // Of a swarm, one.
    let values = system.satellites(&values, 1).map_or(values, |parts| parts.values);
    let layout = system.layout(&values, &precess_system::Given::default());
    let tape = record(system, &values, &layout);
    let printed = tape.simplified().print(&names(&card, &values, &layout, notation), notation);
    let left = layout.coordinates.iter().map(|c| match notation {
        Notation::Latex => c.highest_symbol(),
        Notation::Text => format!("{}{}", c.quantity.name, if c.order == Order::Second { "''" } else { "'" }),
    });
    Equations { definitions: printed.definitions, equations: left.zip(printed.outputs).collect() }
}

/// The equations as a tape: inputs are time, the full state, the numeric parameters, the lists' items.
pub fn record(system: &dyn AnySystem, values: &Values<f64>, layout: &Layout) -> Tape {
    let shape = layout.shape();
    let full = shape.full();
    let parameters = values.numbers.len() + values.lists.iter().map(|l| l.items.len()).sum::<usize>();
    Tape::record(1 + full + parameters, |x| {
        let next = Cell::new(1 + full);
        let traced = values.map(|_| x[next.replace(next.get() + 1)]);
        let (dy, _) = Rates::rates(system, traced, layout, x[0], &x[1..=full]);
        // An acceleration stands in its velocity's place, the rate of a first-order coordinate in its own.
        let place = |i: usize| shape.pairs().find(|p| p.0 == i).map_or(i, |p| p.1);
        (0..shape.coordinates).map(|i| dy[place(i)]).collect()
    })
}

fn names(card: &Card, values: &Values<f64>, layout: &Layout, notation: Notation) -> Vec<String> {
    let latex = notation == Notation::Latex;
    let name = |q: &Quantity| if latex { q.symbol.clone() } else { q.name.clone() };
    let mut names = vec!["t".to_string()];
    for quantity in layout.state() {
        let prime = quantity.name.strip_suffix("_dot").filter(|_| !latex);
        names.push(prime.map_or_else(|| name(&quantity), |stem| format!("{stem}'")));
    }
    names.extend(
        (0..layout.modes).map(|k| if latex { format!("\\sigma_{{{k}}}") } else { format!("mode{k}") }),
    );
    names.extend(parameter_names(card, values, notation));
    names
}

/// The names of the numeric parameters, then of the lists' items: the order of the inputs of [`record`].
pub fn parameter_names(card: &Card, values: &Values<f64>, notation: Notation) -> Vec<String> {
    let latex = notation == Notation::Latex;
    let name = |q: &Quantity| if latex { q.symbol.clone() } else { q.name.clone() };
    let numbers = card.parameters.iter().filter(|p| matches!(p.default, Default::Number(_)));
    let mut names: Vec<String> = numbers.map(|p| name(&p.quantity)).collect();
    let lists = card.parameters.iter().filter_map(|p| match &p.default {
        Default::List { fields, .. } => Some((&p.quantity, *fields)),
        _ => None,
    });
    for ((quantity, fields), list) in lists.zip(&values.lists) {
        for k in 0..list.items.len() / list.width {
            names.extend(fields.iter().map(|field| match (latex, fields.len()) {
                (true, 1) => format!("{}_{{{k}}}", quantity.symbol),
                (true, _) if field.len() == 1 => format!("{field}_{{{k}}}"),
                (true, _) => format!("\\mathrm{{{field}}}_{{{k}}}"),
                (false, 1) => format!("{}[{k}]", quantity.name),
                (false, _) => format!("{}[{k}].{field}", quantity.name),
            }));
        }
    }
    names
}
