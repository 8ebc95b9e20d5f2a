//! A card is complete: texts in both languages, sound names, defaults that run, views of what exists.

use crate::{Any, cases::everything, finds, holds_for_all};
use precess_system::{Card, Default, Given, ObservableKind, Quantity, Text, Values, View, parse_unit};
use std::collections::HashSet;
use std::path::Path;

pub fn law(system: Any) -> Result<(), String> {
    let card = system.card();
    texts(&card)?;
    names(&card)?;
    quantities(&card)?;
    views(&card)?;
    defaults(system, &card)
}

fn require(condition: bool, fault: impl FnOnce() -> String) -> Result<(), String> {
    if condition { Ok(()) } else { Err(fault()) }
}

/// Every quantity of a card, starts included.
fn all(card: &Card) -> impl Iterator<Item = &Quantity> {
    let coordinates = card.coordinates.iter().map(|c| &c.quantity);
    let parameters = card.parameters.iter().map(|p| &p.quantity);
    let observables = card.observables.iter().map(|o| &o.quantity);
    coordinates.chain(parameters).chain(observables).chain(&card.starts)
}

fn texts(card: &Card) -> Result<(), String> {
    let of_card = [("the title", &card.title), ("the description", &card.about)].into_iter();
    let of_card = of_card.map(|(name, text)| (name.to_string(), text));
    let of_quantities = all(card).map(|q| (q.name.clone(), &q.text));
    let of_events = card.events.iter().map(|e| (e.name.clone(), &e.text));
    let texts: Vec<(String, &Text)> = of_card.chain(of_quantities).chain(of_events).collect();
    for (name, text) in texts {
        require(!text.is_incomplete(), || format!("the text of {name} is missing in a language"))?;
    }
    require(!card.source.is_empty(), || "no source is given".into())
}

fn is_identifier(name: &str) -> bool {
    name.starts_with(|c: char| c.is_ascii_alphabetic())
        && name.chars().all(|c| c.is_ascii_alphanumeric() || c == '_')
}

fn names(card: &Card) -> Result<(), String> {
    require(is_identifier(card.id) && card.id == card.id.to_lowercase(), || {
        format!("the id {} is not written in small letters", card.id)
    })?;
    let mut seen = HashSet::from(["t".to_string()]);
    let velocities = card.coordinates.iter().map(|c| c.velocity().name);
    let observables = card.observables.iter().map(|o| o.quantity.name.clone());
    let parameters = card.parameters.iter().map(|p| p.quantity.name.clone());
    let coordinates = card.coordinates.iter().map(|c| c.quantity.name.clone());
    for name in coordinates.chain(velocities).chain(parameters).chain(observables) {
        require(is_identifier(&name), || format!("{name} is not an identifier"))?;
        require(seen.insert(name.clone()), || format!("{name} names two things"))?;
    }
    for event in &card.events {
        require(is_identifier(&event.name), || format!("the event {} is not an identifier", event.name))?;
    }
    Ok(())
}

fn quantities(card: &Card) -> Result<(), String> {
    for quantity in all(card) {
        parse_unit(&quantity.unit).map_err(|e| format!("{}: {e}", quantity.name))?;
    }
    for parameter in &card.parameters {
        let name = &parameter.quantity.name;
        let numbers = match &parameter.default {
            Default::Number(x) => std::slice::from_ref(x),
            Default::List { fields, items } => {
                require(!items.is_empty() && items.len() % fields.len() == 0, || {
                    format!("{name} has a broken item")
                })?;
                items.as_slice()
            }
            Default::Choice(options) => {
                require(!options.is_empty(), || format!("{name} offers no choice"))?;
                &[]
            }
        };
        let inside = numbers.iter().all(|&x| parameter.quantity.range.contains(x));
        require(inside, || format!("the default of {name} lies outside its range"))?;
    }
    for observable in &card.observables {
        let ObservableKind::Invariant { when_zero } = &observable.kind else { continue };
        for name in when_zero {
            let known = card.parameters.iter().any(|p| p.quantity.name == *name);
            require(known, || {
                format!("{} depends on {name}, which is no parameter", observable.quantity.name)
            })?;
        }
    }
    Ok(())
}

fn views(card: &Card) -> Result<(), String> {
    let mut known: HashSet<String> = card.coordinates.iter().map(|c| c.velocity().name).collect();
    known.extend(all(card).map(|q| q.name.clone()));
    let shown: Vec<String> = card
        .views
        .iter()
        .flat_map(|view| match view {
            View::Time(names) => names.iter().map(ToString::to_string).collect::<Vec<_>>(),
            View::Plane { pairs, .. } => pairs.iter().flat_map(|(x, y)| [x.clone(), y.clone()]).collect(),
        })
        .collect();
    require(!shown.is_empty(), || "no view shows anything".into())?;
    for name in shown {
        // x* stands for x0, x1, ...
        require(known.contains(&name.replace('*', "0")), || {
            format!("a view shows {name}, which does not exist")
        })?;
    }
    Ok(())
}

fn defaults(system: Any, card: &Card) -> Result<(), String> {
    let run = card.defaults;
    require(run.until > 0.0 && run.dt > 0.0 && run.dt < run.until, || "a run makes no sense".into())?;
    let values = Values::defaults(card);
    let layout = system.layout(&values, &Given::default());
    require(layout == precess_system::Layout::of(card), || {
        "the card does not show the default layout".into()
    })?;
    let y = system.start(&values, &layout, &Given::default())?;
    let field = precess_system::Bind::<f64>::bind(system, values, &layout);
    let finite = y.iter().chain(&everything(&*field, 0.0, &y)).all(|x| x.is_finite());
    require(finite, || "the defaults do not give a finite start, rates and observables".into())
}

/// The file stem is the id.
fn stands_in_its_file(system: Any) -> Result<(), String> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let file = format!("{}.rs", system.card().id);
    let families = std::fs::read_dir(folder).map_err(|e| e.to_string())?;
    let found = families.flatten().any(|family| family.path().join(&file).is_file());
    require(found, || format!("no folder of src holds {file}"))
}

#[test]
fn every_card_is_complete() {
    holds_for_all(law);
}

#[test]
fn every_system_stands_in_the_file_of_its_name() {
    holds_for_all(stands_in_its_file);
}

#[test]
fn no_id_is_used_twice() {
    let mut seen = HashSet::new();
    for system in precess_models::ALL {
        assert!(seen.insert(system.card().id), "{} is listed twice", system.card().id);
    }
}

mod faulty {
    use precess_scalar::Scalar;
    use precess_system::{Card, State, System, card, coordinate, number};

    /// A free point whose card is made by a function: sound, or with a fault.
    #[derive(Clone)]
    pub struct Point(pub fn() -> Card);

    pub fn sound() -> Card {
        card("point", "Point", "Point")
            .about("It moves.", "Il bouge.")
            .source("nobody")
            .coordinate(coordinate("x", "m", "place", "place"))
            .parameter(number("a", "m/s^2", 1.0, "acceleration", "accélération").positive())
            .signal("speed", "m/s", "speed", "vitesse")
            .time_view(&["x", "x_dot", "speed"])
    }

    impl System for Point {
        fn card(&self) -> Card {
            (self.0)()
        }
        fn equations<S: Scalar>(&self, s: &State<S>, highest: &mut [S]) {
            [highest[0]] = s.p();
        }
        fn observe<S: Scalar>(&self, s: &State<S>, out: &mut [S]) {
            let ([v], [a]) = (s.v(), s.p());
            out.fill(v / a * a);
        }
    }
}

#[test]
fn the_law_finds_a_broken_card() {
    use faulty::{Point, sound};
    use precess_system::{coordinate, number};
    law(&Point(sound)).expect("the sound card passes");
    finds(&law(&Point(|| sound().about("It moves.", " "))), &["description", "language"]);
    finds(&law(&Point(|| sound().signal("y", "m", "height", ""))), &["text of y"]);
    finds(&law(&Point(|| sound().source(""))), &["source"]);
    finds(&law(&Point(|| sound().signal("x_dot", "m/s", "speed", "vitesse"))), &["x_dot names two things"]);
    finds(&law(&Point(|| sound().signal("y", "furlong", "height", "hauteur"))), &["furlong"]);
    finds(&law(&Point(|| sound().parameter(number("b", "", 0.0, "b", "b").positive()))), &["default of b"]);
    finds(&law(&Point(|| sound().invariant_if("e", "", &["b"], "e", "e"))), &["b, which is no parameter"]);
    finds(&law(&Point(|| sound().phase_view("x", "v"))), &["shows v"]);
    finds(
        &law(&Point(|| sound().coordinate(coordinate("y", "m", "y", "y").start(f64::INFINITY)))),
        &["finite"],
    );
    finds(&stands_in_its_file(&Point(sound)), &["point.rs"]);
}
