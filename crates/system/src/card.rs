//! What a system says of itself: names, units, defaults, texts, source.

use crate::quantity::quantity;
use crate::{Coordinate, Parameter, Quantity, Text};

/// Which way an event function passes through zero.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Direction {
    /// From below to above.
    Rising,
    /// From above to below.
    Falling,
    /// Either way.
    Either,
}

/// Something that happens to a hybrid system where one of its event functions passes through zero.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Event {
    /// ASCII identifier (`bucket_full`).
    pub name: String,
    /// Which way.
    pub direction: Direction,
    /// What happens.
    pub text: Text,
}

/// Whether an observable ought to stay constant.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum ObservableKind {
    /// It moves.
    Signal,
    /// It stays constant where all the named parameters vanish (always, where none is named).
    Invariant {
        /// Parameters that must be zero.
        when_zero: Vec<&'static str>,
    },
}

/// A quantity computed from the state.
#[derive(Clone, Debug, PartialEq)]
pub struct Observable {
    /// Name, unit, meaning.
    pub quantity: Quantity,
    /// Signal or invariant.
    pub kind: ObservableKind,
}

/// A picture that shows what the system is about.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum View {
    /// Quantities against time.
    Time(Vec<&'static str>),
    /// Pairs of quantities against one another; equal scales where both are lengths.
    Plane {
        /// Pairs (horizontal, vertical).
        pairs: Vec<(String, String)>,
        /// One unit across is as long as one unit up.
        equal_scales: bool,
    },
}

/// What a run does when nobody says otherwise.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Defaults {
    /// Method id.
    pub method: &'static str,
    /// End time.
    pub until: f64,
    /// Step of the fixed-step methods.
    pub dt: f64,
}

/// A start that the state does not hold.
#[derive(Clone, Debug, PartialEq)]
pub struct Held {
    /// Name, unit, meaning.
    pub quantity: Quantity,
    /// Where nobody gives it.
    pub start: f64,
}

/// All that is known of a system but its equations.
#[derive(Clone, Debug, PartialEq)]
pub struct Card {
    /// ASCII identifier, the same in every face.
    pub id: &'static str,
    /// Title.
    pub title: Text,
    /// What it is and what to notice, in a sentence or two.
    pub about: Text,
    /// Book, paper, section, equation numbers.
    pub source: &'static str,
    /// Coordinates in order.
    pub coordinates: Vec<Coordinate>,
    /// Number of modes.
    pub modes: usize,
    /// Starts that the state does not hold (a rate that fixes a constant of the motion): the first modes keep them.
    pub held: Vec<Held>,
    /// Parameters in order.
    pub parameters: Vec<Parameter>,
    /// Observables in order.
    pub observables: Vec<Observable>,
    /// Further names by which a start may be given (Euler angles of a quaternion).
    pub starts: Vec<Quantity>,
    /// Events in order.
    pub events: Vec<Event>,
    /// Pictures, the most telling first.
    pub views: Vec<View>,
    /// Defaults of a run.
    pub defaults: Defaults,
}

/// The beginning of a card; the rest is added to it.
pub fn card(id: &'static str, en: &str, fr: &str) -> Card {
    Card {
        id,
        title: Text::new(en, fr),
        about: Text::default(),
        source: "",
        coordinates: vec![],
        modes: 0,
        held: vec![],
        parameters: vec![],
        observables: vec![],
        starts: vec![],
        events: vec![],
        views: vec![],
        defaults: Defaults { method: "dop853", until: 10.0, dt: 0.001 },
    }
}

impl Card {
    /// What it is and what to notice.
    #[must_use]
    pub fn about(mut self, en: &str, fr: &str) -> Self {
        self.about = Text::new(en, fr);
        self
    }
    /// Where the equations come from.
    #[must_use]
    pub fn source(mut self, source: &'static str) -> Self {
        self.source = source;
        self
    }
    /// Adds a coordinate.
    #[must_use]
    pub fn coordinate(mut self, coordinate: Coordinate) -> Self {
        self.coordinates.push(coordinate);
        self
    }
    /// Declares modes: numbers behind the scenes, which rest between events unless [`System::mode_rates`] moves them.
    ///
    /// [`System::mode_rates`]: crate::System::mode_rates
    #[must_use]
    pub fn modes(mut self, modes: usize) -> Self {
        self.modes = modes;
        self
    }
    /// Adds a parameter.
    #[must_use]
    pub fn parameter(mut self, parameter: Parameter) -> Self {
        self.parameters.push(parameter);
        self
    }
    /// Adds an observable that moves.
    #[must_use]
    pub fn signal(mut self, name: &str, unit: &str, en: &str, fr: &str) -> Self {
        let quantity = quantity(name, unit, en, fr);
        self.observables.push(Observable { quantity, kind: ObservableKind::Signal });
        self
    }
    /// Adds an observable that stays constant.
    #[must_use]
    pub fn invariant(self, name: &str, unit: &str, en: &str, fr: &str) -> Self {
        self.invariant_if(name, unit, &[], en, fr)
    }
    /// Adds an observable that stays constant where the named parameters vanish.
    #[must_use]
    pub fn invariant_if(
        mut self,
        name: &str,
        unit: &str,
        when_zero: &[&'static str],
        en: &str,
        fr: &str,
    ) -> Self {
        let kind = ObservableKind::Invariant { when_zero: when_zero.to_vec() };
        self.observables.push(Observable { quantity: quantity(name, unit, en, fr), kind });
        self
    }
    /// Adds a further name by which a start may be given.
    #[must_use]
    pub fn start(mut self, name: &str, unit: &str, en: &str, fr: &str) -> Self {
        self.starts.push(quantity(name, unit, en, fr));
        self
    }
    /// Adds a start that the state does not hold: the next mode keeps it, so that a run can be written down.
    #[must_use]
    pub fn held(mut self, name: &str, unit: &str, start: f64, en: &str, fr: &str) -> Self {
        self.held.push(Held { quantity: quantity(name, unit, en, fr), start });
        self.start(name, unit, en, fr)
    }
    /// Adds an event.
    #[must_use]
    pub fn event(mut self, name: &str, direction: Direction, en: &str, fr: &str) -> Self {
        self.events.push(Event { name: name.into(), direction, text: Text::new(en, fr) });
        self
    }
    /// Adds a picture of quantities against time.
    #[must_use]
    pub fn time_view(mut self, names: &[&'static str]) -> Self {
        self.views.push(View::Time(names.to_vec()));
        self
    }
    /// Adds a picture of one quantity against another (a phase portrait).
    #[must_use]
    pub fn phase_view(self, x: &str, y: &str) -> Self {
        self.plane(vec![(x.into(), y.into())], false)
    }
    /// Adds a picture of a path in a plane, both axes to the same scale.
    #[must_use]
    pub fn path_view(self, x: &str, y: &str) -> Self {
        self.plane(vec![(x.into(), y.into())], true)
    }
    fn plane(mut self, pairs: Vec<(String, String)>, equal_scales: bool) -> Self {
        self.views.push(View::Plane { pairs, equal_scales });
        self
    }
    /// End of a run and step of the fixed-step methods, unless the user says otherwise.
    #[must_use]
    pub fn run(mut self, until: f64, dt: f64) -> Self {
        self.defaults.until = until;
        self.defaults.dt = dt;
        self
    }
}
