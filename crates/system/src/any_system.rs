//! A system whose type is forgotten: it makes fields over every kind of number in use.

use crate::bound::Bound;
#[cfg(feature = "tangents")]
use crate::field::Observes;
use crate::{Bind, Card, Given, Layout, Rates, Satellites, System, Values};
#[cfg(feature = "tangents")]
use precess_scalar::Dual;
use precess_scalar::{Dependence, Narrow, Traced, Wide, Widest};
#[cfg(feature = "laws")]
use precess_scalar::{DoubleDouble, Unit};
use std::collections::HashMap;

/// The numbers that only the laws compute with so far. They are left out of the programs: each is every system once
/// more, which a browser would have to load.
#[cfg(feature = "laws")]
pub trait LawNumbers: Bind<Dual<Dual<f64>>> + Bind<DoubleDouble> + Bind<Unit> + Bind<Traced> {}
/// The numbers of the laws, without the feature `laws`: none.
#[cfg(not(feature = "laws"))]
pub trait LawNumbers {}
impl<M: System> LawNumbers for M {}

/// The numbers of the analyses: a state with a direction in which it moves, and observables with two. A face that offers none leaves it out.
#[cfg(feature = "tangents")]
pub trait TangentNumbers: Bind<Dual<f64>> + Observes<Dual<Dual<f64>>> {}
/// The number of the analyses, without the feature `tangents`: none.
#[cfg(not(feature = "tangents"))]
pub trait TangentNumbers {}
impl<M: System> TangentNumbers for M {}

/// A system whose type is forgotten: it makes fields over every kind of number.
pub trait AnySystem:
    Send
    + Sync
    + LawNumbers
    + TangentNumbers
    + Bind<f64>
    + Bind<Narrow>
    + Bind<Wide>
    + Bind<Widest>
    + Rates<Dependence>
    + Rates<Traced>
{
    /// See [`System::card`].
    fn card(&self) -> Card;
    /// The folder in which the system's file lies (`pendulums`): what it stands with in a catalogue.
    fn family(&self) -> &'static str;
    /// See [`System::layout`].
    fn layout(&self, values: &Values<f64>, given: &Given) -> Layout;
    /// The full state at the start: the card's, then what is given by name, then the modes.
    ///
    /// # Errors
    /// One sentence, where the starts or the parameters make no sense together.
    fn start(&self, values: &Values<f64>, layout: &Layout, given: &Given) -> Result<Vec<f64>, String>;
    /// See [`System::trouble`]; at a full state.
    fn trouble(&self, values: &Values<f64>, layout: &Layout, t: f64, y: &[f64]) -> Option<String>;
    /// See [`System::satellites`].
    fn satellites(&self, values: &Values<f64>, count: usize) -> Option<Satellites>;
    /// See [`System::solvable`]; from a full state.
    ///
    /// # Errors
    /// One sentence: why the motion has no closed form.
    fn solvable(&self, values: &Values<f64>, layout: &Layout, start: &[f64]) -> Result<(), String>;
    /// See [`System::period`].
    fn period(&self, values: &Values<f64>) -> Option<f64>;
}

impl<M: System> AnySystem for M {
    fn card(&self) -> Card {
        System::card(self)
    }

    fn family(&self) -> &'static str {
        std::any::type_name::<M>().split("::").nth(1).unwrap_or_default()
    }

    fn period(&self, values: &Values<f64>) -> Option<f64> {
        System::period(self, values)
    }

    fn layout(&self, values: &Values<f64>, given: &Given) -> Layout {
        System::layout(self, values, given)
    }

    fn trouble(&self, values: &Values<f64>, layout: &Layout, t: f64, y: &[f64]) -> Option<String> {
        let bound = Bound::new(self.clone(), values.clone(), layout);
        System::trouble(self, &bound.state(t, y))
    }

    fn satellites(&self, values: &Values<f64>, count: usize) -> Option<Satellites> {
        System::satellites(self, values, count)
    }

    fn solvable(&self, values: &Values<f64>, layout: &Layout, start: &[f64]) -> Result<(), String> {
        if cfg!(feature = "first") {
            return Err("closed forms are not in this program".into());
        }
        let bound = Bound::new(self.clone(), values.clone(), layout);
        System::solvable(self, &bound.state(0.0, start))
    }

    fn start(&self, values: &Values<f64>, layout: &Layout, given: &Given) -> Result<Vec<f64>, String> {
        let mut y = layout.start();
        let size = layout.shape().state();
        if !given.0.is_empty() {
            // A map, for there may be a million names; it is asked, not walked.
            let named: HashMap<&str, f64> =
                given.0.iter().rev().map(|(name, x)| (name.as_str(), *x)).collect();
            for (place, quantity) in y.iter_mut().zip(layout.starts()) {
                *place = named.get(quantity.name.as_str()).copied().unwrap_or(*place);
            }
        }
        System::start(self, given, values, &mut y[..size])?;
        let bound = Bound::new(self.clone(), values.clone(), layout);
        let (state, modes) = y.split_at_mut(size);
        let at_start = bound.state(0.0, state);
        self.check(&at_start)?;
        self.start_modes(&at_start, modes);
        Ok(y)
    }
}
