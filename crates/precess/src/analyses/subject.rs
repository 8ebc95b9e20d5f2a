//! A plan as the analyses need it: bound to plain and to dual numbers.

pub(crate) use crate::premises::{failed, forwards, smooth};

use crate::error::{Error, input};
use crate::plan::Plan;
use crate::run::pace;
use precess_analysis::Flow;
use precess_integrate::Needs;
use precess_scalar::Dual;
use precess_system::{Bind, Direction, Field};
use std::cell::RefCell;
use std::ops::ControlFlow;

/// A plan's system, bound.
pub(crate) struct Subject<'a> {
    pub plan: &'a Plan,
    pub field: Box<dyn Field<f64>>,
    pub tangents: Box<dyn Field<Dual<f64>>>,
    pub directions: Vec<Direction>,
}

impl<'a> Subject<'a> {
    /// # Errors
    /// Where the method does not take what the analyses make of a system.
    pub fn new(plan: &'a Plan) -> Result<Self, Error> {
        let method = plan.method.card();
        if !matches!(method.needs, Needs::Any | Needs::Separable) {
            return input(format!(
                "an analysis integrates a system with its neighbours, which '{}' cannot: dop853 does",
                method.id
            ));
        }
        let (system, layout) = (plan.system, &plan.layout);
        Ok(Self {
            plan,
            field: Bind::<f64>::bind(system, plan.values.clone(), layout),
            tangents: Bind::<Dual<f64>>::bind(system, plan.values.map(|&x| Dual::from(x)), layout),
            directions: layout.events.iter().map(|e| e.direction).collect(),
        })
    }

    /// How it moves; `progress` is told the time now and then.
    pub fn flow<'b>(&'b self, progress: &'b mut dyn FnMut(f64) -> ControlFlow<()>) -> Flow<'b> {
        Flow {
            field: self.field.as_ref(),
            tangents: self.tangents.as_ref(),
            directions: &self.directions,
            method: self.plan.method,
            options: self.plan.options.clone(),
            pace: pace(self.plan),
            progress: RefCell::new(progress),
        }
    }
}

/// The period of the equations in time.
pub(crate) fn period(plan: &Plan, what: &str) -> Result<f64, Error> {
    let found = plan.system.period(&plan.values).filter(|p| p.is_finite() && *p > 0.0);
    found.map_or_else(
        || {
            input(format!(
                "{what} needs a periodic drive, and {} has none with these parameters",
                plan.card.id
            ))
        },
        Ok,
    )
}

/// The number of the state of this name, the first coordinate where none is given.
pub(crate) fn state_number(plan: &Plan, name: Option<&str>) -> Result<usize, Error> {
    let Some(name) = name else { return Ok(0) };
    let state = plan.layout.state();
    let found = state.iter().position(|q| q.name == name);
    let names = state.iter().map(|q| q.name.as_str());
    found.ok_or_else(|| crate::unknown(&format!("number of the state of {}", plan.card.id), name, names))
}
