//! A system by its id, with its defaults but for what a test says.
// Each test uses a part of it.
#![allow(dead_code)]

use precess_system::{AnySystem, Default, Field, Given, Layout, Values};

/// A system ready to be evaluated.
pub struct Ready {
    pub system: &'static dyn AnySystem,
    pub values: Values<f64>,
    pub layout: Layout,
}

pub fn ready(id: &str) -> Ready {
    let system = *precess_models::ALL.iter().find(|s| s.card().id == id).expect("the list has this system");
    let values = Values::defaults(&system.card());
    let layout = system.layout(&values, &Given::default());
    Ready { system, values, layout }
}

pub fn given(starts: &[(&str, f64)]) -> Given {
    Given(starts.iter().map(|&(name, x)| (name.to_string(), x)).collect())
}

impl Ready {
    pub fn set(&mut self, name: &str, value: f64) {
        *self.values.number_mut(&self.system.card(), name).expect("the card has this parameter") = value;
    }
    /// Chooses an option; the layout may be another then.
    pub fn choose(&mut self, name: &str, option: &str) {
        let card = self.system.card();
        let choices = card.parameters.iter().filter_map(|p| match p.default {
            Default::Choice(options) => Some((&p.quantity.name, options)),
            _ => None,
        });
        let (k, (_, options)) =
            choices.enumerate().find(|(_, (n, _))| *n == name).expect("the card has this choice");
        self.values.choices[k] = options.iter().position(|o| *o == option).expect("one of the options");
        self.layout = self.system.layout(&self.values, &Given::default());
    }
    pub fn value(&self, name: &str) -> f64 {
        self.values.number(&self.system.card(), name).expect("the card has this parameter")
    }
    pub fn start(&self, starts: &[(&str, f64)]) -> Result<Vec<f64>, String> {
        self.system.start(&self.values, &self.layout, &given(starts))
    }
    pub fn field(&self) -> Box<dyn Field<f64>> {
        self.system.bind(self.values.clone(), &self.layout)
    }
    pub fn rate(&self, y: &[f64]) -> Vec<f64> {
        let mut rate = vec![0.0; y.len()];
        self.field().rate(0.0, y, &mut rate);
        rate
    }
    pub fn observe(&self, y: &[f64], name: &str) -> f64 {
        let mut out = vec![0.0; self.layout.observables.len()];
        self.field().observe(0.0, y, &mut out);
        let place = self.layout.observables.iter().position(|o| o.quantity.name == name);
        out[place.expect("the card has this observable")]
    }
}
