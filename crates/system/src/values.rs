//! The values of a system's parameters, resolved against its card.

use crate::{Card, Default};

/// A list parameter: items of `width` numbers each, stored one after another.
#[derive(Clone, Debug, PartialEq)]
pub struct List<S> {
    /// Numbers per item.
    pub width: usize,
    /// All numbers, item by item.
    pub items: Vec<S>,
}

/// Parameter values, each kind in the order of the card.
#[derive(Clone, Debug, PartialEq)]
pub struct Values<S> {
    /// The numeric parameters.
    pub numbers: Vec<S>,
    /// The list parameters.
    pub lists: Vec<List<S>>,
    /// The choices, as indices into their options.
    pub choices: Vec<usize>,
}

impl Values<f64> {
    /// The defaults of a card.
    pub fn defaults(card: &Card) -> Self {
        let mut values = Self { numbers: vec![], lists: vec![], choices: vec![] };
        for parameter in &card.parameters {
            match &parameter.default {
                Default::Number(x) => values.numbers.push(*x),
                Default::List { fields, items } => {
                    values.lists.push(List { width: fields.len(), items: items.clone() });
                }
                Default::Choice(_) => values.choices.push(0),
            }
        }
        values
    }
    /// The numeric parameter of this name.
    pub fn number(&self, card: &Card, name: &str) -> Option<f64> {
        self.numbers.get(Self::index(card, name)?).copied()
    }
    /// A numeric parameter to set, by name.
    pub fn number_mut(&mut self, card: &Card, name: &str) -> Option<&mut f64> {
        self.numbers.get_mut(Self::index(card, name)?)
    }
    fn index(card: &Card, name: &str) -> Option<usize> {
        let numbers = card.parameters.iter().filter(|p| matches!(p.default, Default::Number(_)));
        numbers.into_iter().position(|p| p.quantity.name == name)
    }
}

impl<S> Values<S> {
    /// The same values in another number.
    pub fn map<T>(&self, f: impl Fn(&S) -> T) -> Values<T> {
        let lists = self.lists.iter();
        Values {
            numbers: self.numbers.iter().map(&f).collect(),
            lists: lists.map(|l| List { width: l.width, items: l.items.iter().map(&f).collect() }).collect(),
            choices: self.choices.clone(),
        }
    }
}
