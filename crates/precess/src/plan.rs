//! A plan: a scenario held against the cards, complete and ready to run.

use crate::error::{Error, input, unknown};
use crate::family::{FamilyMember, members};
use crate::scenario::{EnsembleSpec, FigureSpec, Scenario};
use crate::value::Value;
use crate::{catalogue, panel, resolve};
use precess_integrate::{AnyMethod, Kind, Needs, Options};
use precess_scalar::{Tape, Taylor};
use precess_system::{
    AnySystem, Bind, Card, Direction, Given, Layout, ObservableKind, Quantity, Structure, Values,
};
use std::sync::Arc;

/// How the method steps.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Step {
    /// Steps of this length.
    Fixed(f64),
    /// Steps chosen by the error, relative and absolute tolerance.
    Adaptive {
        /// Relative tolerance.
        rtol: f64,
        /// Absolute tolerance.
        atol: f64,
    },
}

/// A watched crossing.
#[derive(Clone, Debug, PartialEq)]
pub struct Watch {
    /// Name in the report.
    pub name: String,
    /// Column (time, state, observables) that is watched.
    pub column: usize,
    /// The value it passes through.
    pub value: f64,
    /// Which way.
    pub direction: Direction,
    /// The run ends here.
    pub stop: bool,
}

/// A panel of the picture, held against the run's quantities.
#[derive(Clone, Debug, PartialEq)]
pub struct PanelPlan {
    /// As it was asked for.
    pub spec: FigureSpec,
    /// Range of the horizontal axis.
    pub x_range: Option<(f64, f64)>,
    /// Range of the vertical axis.
    pub y_range: Option<(f64, f64)>,
    /// Only this part of the time.
    pub between: Option<(f64, f64)>,
    /// Times that the panel asks for.
    pub at: Vec<f64>,
    /// Marked points of the plane.
    pub marks: Vec<[f64; 2]>,
}

/// A run that is fully determined.
#[derive(Clone)]
pub struct Plan {
    /// Heading.
    pub title: String,
    /// The system.
    pub system: &'static dyn AnySystem,
    /// Its card.
    pub card: Card,
    /// Its quantities with these parameters.
    pub layout: Layout,
    /// What its equations depend on with these parameters.
    pub structure: Structure,
    /// Its parameters.
    pub values: Values<f64>,
    /// The full state at the start.
    pub start: Vec<f64>,
    /// The method.
    pub method: &'static dyn AnyMethod,
    /// Its options.
    pub options: Options,
    /// Its steps.
    pub step: Step,
    /// End time; negative runs backwards.
    pub until: f64,
    /// Time between samples, positive.
    pub every: f64,
    /// Watched crossings.
    pub watches: Vec<Watch>,
    /// Its name in legends; may be empty.
    pub label: String,
    /// Trajectories that are drawn beside it.
    pub members: Vec<FamilyMember>,
    /// Panels of the picture, as the scenario gives them.
    pub panels: Vec<PanelPlan>,
    /// The ensemble that the scenario asks for besides; its panel runs it.
    pub ensemble: Option<EnsembleSpec>,
}

/// More samples than this do not fit a table that anybody reads.
const MOST_SAMPLES: f64 = 1e8;
/// More numbers than this fit no memory: 16 GB.
const MOST_NUMBERS: f64 = 2e9;
/// More steps than this take years.
const MOST_STEPS: f64 = 1e14;
/// A relative difference between the equations and the Lagrangian's that no rounding makes.
const BESIDE: f64 = 1e-9;

impl Plan {
    /// Holds a scenario against the cards.
    ///
    /// # Errors
    /// One sentence: what is wrong, where, the nearest right thing.
    pub fn new(scenario: &Scenario) -> Result<Self, Error> {
        let system = catalogue::system(&scenario.system)?;
        let card = system.card();
        let values = resolve::parameters(&card, &scenario.parameters)?;
        let (layout, start) = resolve::start(system, &card, &values, &scenario.start)?;
        let structure = precess_system::structure(system, &values, &layout);
        let printed = as_printed(system, &values, &layout, &start);
        let usual = if printed { AS_PRINTED } else { card.defaults.method };
        let method = catalogue::method(scenario.method.as_deref().unwrap_or(usual))?;
        if printed && method.card().id != AS_PRINTED {
            return input(format!(
                "with these parameters {} is stepped as in its source, by {AS_PRINTED} alone, not by '{}'",
                card.id,
                method.card().id
            ));
        }
        let mut plan = Self {
            title: if scenario.title.is_empty() { card.title.en.clone() } else { scenario.title.clone() },
            until: card.defaults.until,
            every: f64::NAN,
            step: Step::Fixed(card.defaults.dt),
            options: Options::default(),
            watches: vec![],
            ensemble: scenario.ensemble.clone(),
            label: scenario.label.clone(),
            members: vec![],
            panels: vec![],
            system,
            card,
            layout,
            structure,
            values,
            start,
            method,
        };
        plan.check_method()?;
        if catalogue::FIRST {
            // None of what follows is asked for there, nor is it in the program.
            plan.read_run(&scenario.run)?;
            return Ok(plan);
        }
        plan.record_equations()?;
        plan.read_run(&scenario.run)?;
        if plan.method.card().needs == Needs::ClosedForm && !scenario.events.is_empty() {
            return input(format!(
                "method '{}' jumps from sample to sample and meets no event on the way: watch them by dop853",
                plan.method.card().id
            ));
        }
        plan.watches = scenario.events.iter().map(|e| resolve::watch(&plan, e)).collect::<Result<_, _>>()?;
        plan.members = members(scenario)?;
        plan.panels = scenario.figures.iter().map(|f| panel::panel(&plan, f)).collect::<Result<_, _>>()?;
        Ok(plan)
    }

    /// All columns of the result in order: time, state, observables.
    pub fn columns(&self) -> Vec<Quantity> {
        (0..self.width()).map(|k| self.column(k)).collect()
    }

    /// One of them.
    pub fn column(&self, k: usize) -> Quantity {
        column(&self.layout, k)
    }

    /// How many there are.
    pub fn width(&self) -> usize {
        1 + self.layout.state_size() + self.layout.observables.len()
    }

    /// Whether the `k`-th observable ought to stay constant with these parameters.
    pub fn is_invariant(&self, k: usize) -> bool {
        match &self.layout.observables[k].kind {
            ObservableKind::Signal => false,
            ObservableKind::Invariant { when_zero } => {
                when_zero.iter().all(|name| self.values.number(&self.card, name) == Some(0.0))
            }
        }
    }

    /// The starts as the user may name them back.
    pub fn given(&self) -> Given {
        let names = self.layout.starts().map(|q| q.name);
        Given(names.zip(self.start.iter().copied()).collect())
    }

    fn check_method(&self) -> Result<(), Error> {
        let card = self.method.card();
        let id = self.card.id;
        match card.needs {
            Needs::ClosedForm => return self.check_closed_form(),
            Needs::Separable if !self.structure.separable() => {}
            _ => return Ok(()),
        }
        let why = if self.structure.hybrid {
            format!("{id} has events")
        } else if self.structure.second_order {
            format!("in {id} a velocity enters the acceleration (friction set to zero may help)")
        } else {
            format!("{id} has coordinates of first order")
        };
        let fits = catalogue::methods().iter().map(|m| m.card());
        let fits: Vec<&str> = fits.filter(|m| m.needs == Needs::Any).map(|m| m.id).collect();
        input(format!(
            "method '{}' needs accelerations that depend on positions alone, and {why}: these fit: {}",
            card.id,
            fits.join(", ")
        ))
    }

    fn check_closed_form(&self) -> Result<(), Error> {
        let (id, method) = (self.card.id, self.method.card().id);
        let why = match self.system.solvable(&self.values, &self.layout, &self.start) {
            _ if self.structure.hybrid => "the system has events".into(),
            Err(why) => why,
            Ok(()) => return Ok(()),
        };
        input(format!("method '{method}' needs a closed form of {id}, and {why}: dop853 integrates it"))
    }

    /// For methods that need them: anew wherever a parameter has changed.
    pub(crate) fn record_equations(&mut self) -> Result<(), Error> {
        let tape = match self.method.card().needs {
            Needs::Any | Needs::Separable | Needs::ClosedForm => return Ok(()),
            Needs::Expression => self.expression()?,
            Needs::Lagrangian => self.momenta()?,
        };
        self.options.equations = Some(Arc::new(tape));
        Ok(())
    }

    fn expression(&self) -> Result<Tape, Error> {
        let tape = precess_system::expression(self.system, &self.values, &self.layout);
        match Taylor::<f64>::new(&tape, 1) {
            Ok(_) => Ok(tape),
            Err(what) => input(format!(
                "method '{}' needs equations that have a power series, and those of {} contain {what}: dop853 takes \
                 any (friction set to zero may help)",
                self.method.card().id,
                self.card.id
            )),
        }
    }

    fn momenta(&self) -> Result<Tape, Error> {
        let (method, id) = (self.method.card().id, self.card.id);
        let Some(momenta) = precess_system::momenta(self.system, &self.values, &self.layout) else {
            return input(format!(
                "method '{method}' needs a Lagrangian, and {id} has none: implicit_midpoint takes any system"
            ));
        };
        let rates = precess_system::expression(self.system, &self.values, &self.layout);
        // At the start and beside it, since a body at rest shows no friction.
        for shift in [0.0, 0.1, -0.2] {
            let y: Vec<f64> = self.start.iter().map(|x| x + shift).collect();
            if precess_system::beside_the_lagrangian(&rates, &momenta, &y) > BESIDE {
                return input(format!(
                    "method '{method}' needs forces that are all in the Lagrangian, and in {id} there are others: \
                     implicit_midpoint takes any system (friction set to zero may help)"
                ));
            }
        }
        Ok(momenta)
    }

    fn read_run(&mut self, run: &[(String, Value)]) -> Result<(), Error> {
        let method = self.method.card();
        let (mut dt, mut rtol, mut atol, mut every) = (None, None, None, None);
        for (name, value) in run {
            let number = |unit: &str| value.in_unit(unit).map_err(|e| e.at(name));
            match name.as_str() {
                "dt" => dt = Some(number("s")?),
                "every" => every = Some(number("s")?),
                "until" => self.until = number("s")?,
                "rtol" => rtol = Some(number("")?),
                "atol" => atol = Some(number("")?),
                option => {
                    let Some(known) = method.options.iter().find(|o| o.name == option) else {
                        let fixed = ["method", "dt", "rtol", "atol", "until", "every"];
                        let known = fixed.into_iter().chain(method.options.iter().map(|o| o.name));
                        return Err(unknown("setting", option, known).at(&format!("run by {}", method.id)));
                    };
                    let x = number("")?;
                    if !(known.low <= x && x <= known.high) {
                        return input(format!(
                            "{option} lies between {} and {}, not at {x}",
                            known.low, known.high
                        ));
                    }
                    self.options.set(option, x);
                }
            }
        }
        self.step = match method.kind {
            Kind::Fixed if rtol.is_some() || atol.is_some() => {
                return input(format!(
                    "method '{}' takes steps of fixed length: give dt, not rtol or atol",
                    method.id
                ));
            }
            Kind::Fixed => Step::Fixed(positive("dt", dt.unwrap_or(self.card.defaults.dt))?),
            Kind::Adaptive if dt.is_some() => {
                return input(format!(
                    "method '{}' chooses its own steps: give rtol and atol, not dt",
                    method.id
                ));
            }
            Kind::Adaptive => tolerances(rtol.unwrap_or(1e-10), atol.unwrap_or(1e-10))?,
        };
        self.check_times(every)?;
        if method.needs == Needs::ClosedForm && dt.is_none() {
            // Steps cost time there, and give nothing.
            self.step = Step::Fixed(self.every);
        }
        Ok(())
    }

    fn check_times(&mut self, every: Option<f64>) -> Result<(), Error> {
        let until = self.until;
        if !until.is_finite() {
            return input(format!("until is a time, not {until}"));
        }
        self.every = match every {
            Some(every) => positive("every", every)?,
            None if until == 0.0 => 1.0,
            None => until.abs() / 1000.0,
        };
        if every.is_some() && self.every > until.abs() && until != 0.0 {
            return input(format!("every ({} s) is longer than the run ({} s)", self.every, until.abs()));
        }
        let samples = until.abs() / self.every;
        if samples > MOST_SAMPLES {
            return input(format!(
                "{samples:.1e} samples are too many: make 'every' longer (at most 1e8 samples)"
            ));
        }
        let numbers = samples * (1 + self.layout.shape().state()) as f64;
        if numbers > MOST_NUMBERS {
            return input(format!(
                "the samples would be {numbers:.1e} numbers, which fit no memory: make 'every' longer"
            ));
        }
        if let Step::Fixed(dt) = self.step {
            let steps = until.abs() / dt;
            if steps > MOST_STEPS {
                return input(format!("{steps:.1e} steps of {dt} s would take years: make dt longer"));
            }
        }
        Ok(())
    }
}

/// What stands in column `k` of the result: the time, then the state, then the observables.
pub(crate) fn column(layout: &Layout, k: usize) -> Quantity {
    let state = layout.state_size();
    match k {
        0 => precess_system::quantity("t", "s", "time", "temps"),
        k if k <= state => layout.quantity(k - 1),
        k => layout.observables[k - state - 1].quantity.clone(),
    }
}

/// The one method whose steps a source's program may vary.
const AS_PRINTED: &str = "euler_taylor";

/// Whether the parameters ask for a step that the system's source takes, and its equations do not.
fn as_printed(system: &dyn AnySystem, values: &Values<f64>, layout: &Layout, start: &[f64]) -> bool {
    let field = Bind::<f64>::bind(system, values.clone(), layout);
    field.drift(0.0, start, &mut vec![0.0; start.len()])
}

fn positive(name: &str, x: f64) -> Result<f64, Error> {
    if x.is_finite() && x > 0.0 { Ok(x) } else { input(format!("{name} must be above zero, not {x}")) }
}

fn tolerances(rtol: f64, atol: f64) -> Result<Step, Error> {
    for (name, x) in [("rtol", rtol), ("atol", atol)] {
        if !(x.is_finite() && (0.0..=1.0).contains(&x)) {
            return input(format!("{name} lies between 0 and 1, not at {x}"));
        }
    }
    if rtol < 1e-15 && atol == 0.0 {
        return input("rtol below 1e-15 needs an atol above zero: no f64 is more accurate than that");
    }
    Ok(Step::Adaptive { rtol, atol })
}
