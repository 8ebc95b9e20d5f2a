//! Cards as JSON: all that a card says, under the card's own names.

use crate::scenario::takes_body;
use crate::{Scenario, catalogue, equations, scenarios};
use precess_integrate::{Kind, MethodCard, Needs};
use precess_scalar::Notation;
use precess_system::{
    AnySystem, Default, Given, Observable, ObservableKind, Order, Quantity, Text, Values, View,
};
use serde_json::{Value, json};

fn text(text: &Text) -> Value {
    json!({ "en": text.en, "fr": text.fr })
}

fn quantity(q: &Quantity) -> Value {
    json!({ "name": q.name, "symbol": q.symbol, "unit": q.unit, "text": text(&q.text) })
}

/// A quantity with something more said of it.
fn with(q: &Quantity, more: &Value) -> Value {
    let mut value = quantity(q);
    if let (Some(map), Some(more)) = (value.as_object_mut(), more.as_object()) {
        map.extend(more.clone());
    }
    value
}

fn observable(o: &Observable) -> Value {
    match &o.kind {
        ObservableKind::Signal => with(&o.quantity, &json!({ "kind": "signal" })),
        ObservableKind::Invariant { when_zero } => {
            with(&o.quantity, &json!({ "kind": "invariant", "when_zero": when_zero }))
        }
    }
}

/// A view as pairs (horizontal, vertical), whatever its kind.
fn view(view: &View) -> Value {
    match view {
        View::Time(names) => {
            let pairs: Vec<_> = names.iter().map(|name| ("t", name)).collect();
            json!({ "pairs": pairs, "equal_scales": false })
        }
        View::Plane { pairs, equal_scales } => json!({ "pairs": pairs, "equal_scales": equal_scales }),
    }
}

/// A system: its card and its equations.
pub fn system(system: &dyn AnySystem) -> Value {
    let card = system.card();
    let layout = system.layout(&Values::defaults(&card), &Given::default());
    let coordinates = layout.coordinates.iter().map(|c| match c.order {
        Order::First => with(&c.quantity, &json!({ "order": 1, "start": c.start })),
        Order::Second => {
            with(&c.quantity, &json!({ "order": 2, "start": c.start, "start_dot": c.start_dot }))
        }
    });
    let parameters = card.parameters.iter().map(|p| {
        let range = p.quantity.range;
        let bound = |x: f64| if x.is_finite() { json!(x) } else { Value::Null };
        let more = match &p.default {
            Default::Number(x) => {
                json!({ "default": x, "low": bound(range.low), "high": bound(range.high), "open": range.open })
            }
            Default::List { fields, items } if fields.len() == 1 => json!({ "default": items }),
            Default::List { fields, items } => {
                json!({ "fields": fields, "default": items.chunks(fields.len()).collect::<Vec<_>>() })
            }
            Default::Choice(options) => json!({ "default": options[0], "choices": options }),
        };
        with(&p.quantity, &more)
    });
    let latex = equations(system, Notation::Latex);
    json!({
        "id": card.id,
        "family": system.family(),
        "title": text(&card.title),
        "about": text(&card.about),
        "source": card.source,
        "takes_body": takes_body(card.id),
        "coordinates": coordinates.collect::<Vec<_>>(),
        "state": layout.quantities().map(|q| q.name).collect::<Vec<_>>(),
        "parameters": parameters.collect::<Vec<_>>(),
        "observables": layout.observables.iter().map(observable).collect::<Vec<_>>(),
        "starts": card.starts.iter().map(quantity).collect::<Vec<_>>(),
        "events": layout.events.iter().map(|e| json!({ "name": e.name, "text": text(&e.text) })).collect::<Vec<_>>(),
        "views": card.views.iter().map(view).collect::<Vec<_>>(),
        "equations": { "definitions": latex.definitions, "equations": latex.equations },
        "defaults": { "method": card.defaults.method, "until": card.defaults.until, "dt": card.defaults.dt },
    })
}

/// Every system.
pub fn systems() -> Value {
    catalogue::systems().iter().map(|s| system(*s)).collect()
}

/// Every method.
pub fn methods() -> Value {
    let method = |card: &MethodCard| {
        let options = card.options.iter().map(|o| {
            json!({ "name": o.name, "default": o.default, "low": o.low, "high": o.high,
                    "text": { "en": o.text.0, "fr": o.text.1 } })
        });
        json!({
            "id": card.id,
            "title": { "en": card.title.0, "fr": card.title.1 },
            "about": { "en": card.about.0, "fr": card.about.1 },
            "order": card.order,
            "adaptive": card.kind == Kind::Adaptive,
            "separable_only": card.needs == Needs::Separable,
            "closed_form_only": card.needs == Needs::ClosedForm,
            "symplectic": card.symplectic,
            "reversible": card.reversible,
            "source": card.source,
            "options": options.collect::<Vec<_>>(),
        })
    };
    catalogue::methods().iter().map(|m| method(m.card())).collect()
}

/// A scenario that comes with the program: its file's name, its title, and what to notice.
pub fn scenario(file: &str, text: &str) -> Value {
    let Scenario { title, text: words, .. } = Scenario::parse(text).unwrap_or_default();
    json!({
        "file": file,
        "title": title,
        "title_fr": words.title_fr,
        "note": { "en": words.note, "fr": words.note_fr },
    })
}

/// Every scenario that comes with the program.
pub fn all_scenarios() -> Value {
    scenarios::all().into_iter().map(|(file, text)| scenario(file, text)).collect()
}
