//! A plan carried out.

use crate::plan::{Plan, Step, column};
use crate::satellites;
use precess_integrate::{Drive, Failure, Pace, Report, Samples, Source, Tolerance, Watched, drive};
use precess_system::{Bind, Column, ColumnKind, Columns, Field, Occurrence, Quantity, Trajectory};
use std::cell::RefCell;
use std::ops::ControlFlow;

/// What a result has cost, and which program made it; from what, [`scenario_toml`](crate::scenario_toml) tells.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Provenance {
    /// Version of Precess.
    pub version: String,
    /// Accepted steps.
    pub steps: u64,
    /// Rejected steps.
    pub rejections: u64,
    /// Evaluations of the equations.
    pub evaluations: u64,
}

/// What came out of a run.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Outcome {
    /// The samples and events.
    pub trajectory: Trajectory,
    /// Where they come from.
    pub provenance: Provenance,
    /// The name of the watched event that ended the run.
    pub stopped_by: Option<String>,
    /// Why the run ended before its time; the samples up to then are right.
    pub failure: Option<Failure>,
}

/// A plan's system, ready to be driven from any start.
pub(crate) struct Runner<'a> {
    plan: &'a Plan,
    samples: Samples,
    field: Box<dyn Field<f64>>,
}

impl<'a> Runner<'a> {
    pub fn new(plan: &'a Plan) -> Self {
        let field = Bind::<f64>::bind(plan.system, plan.values.clone(), &plan.layout);
        Self { plan, samples: Samples::new(plan.until, plan.every), field }
    }

    /// Over some of the plan's samples.
    pub fn over(self, samples: Samples) -> Self {
        Self { samples, ..self }
    }

    /// The system, bound.
    pub fn field(&self) -> &dyn Field<f64> {
        self.field.as_ref()
    }

    /// Drives it from a full state.
    pub fn drive(
        &self,
        start: &[f64],
        record: &mut dyn FnMut(f64, &[f64]),
        progress: &mut dyn FnMut(f64) -> ControlFlow<()>,
    ) -> Report {
        let plan = self.plan;
        let directions: Vec<_> = plan.layout.events.iter().map(|e| e.direction).collect();
        let watches = watched(plan, self.field.as_ref());
        let job = Drive {
            field: self.field.as_ref(),
            method: plan.method,
            options: plan.options.clone(),
            start,
            samples: self.samples,
            pace: pace(plan),
            directions: &directions,
            watches: &watches,
        };
        explained(plan, drive(&job, record, progress))
    }
}

/// Runs a plan. `progress` is told the time now and then and may end the run.
pub fn run(plan: &Plan, progress: &mut dyn FnMut(f64) -> ControlFlow<()>) -> Outcome {
    let runner = Runner::new(plan);
    let field = &runner.field;
    let mut trajectory = Trajectory { columns: columns(plan), ..Trajectory::default() };
    let state = plan.layout.shape().state();
    let mut observed = vec![0.0; plan.layout.observables.len()];
    let width = trajectory.columns.len();
    let by_parts = satellites::of(plan).and_then(|parts| satellites::run(plan, &parts, width, progress));
    let report = if let Some((report, mut numbers)) = by_parts {
        for row in numbers.chunks_mut(width) {
            let (t, (y, out)) = (row[0], row[1..].split_at_mut(state));
            field.observe(t, y, out);
        }
        trajectory.numbers = numbers;
        explained(plan, report)
    } else {
        let mut record = |t: f64, y: &[f64]| {
            field.observe(t, y, &mut observed);
            trajectory.numbers.push(t);
            trajectory.numbers.extend_from_slice(&y[..state]);
            trajectory.numbers.extend_from_slice(&observed);
        };
        runner.drive(&plan.start, &mut record, progress)
    };
    trajectory.events = report
        .events
        .into_iter()
        .map(|event| Occurrence {
            name: match event.source {
                Source::System(k) => plan.layout.events[k].name.clone(),
                Source::Watch(k) => plan.watches[k].name.clone(),
            },
            t: event.t,
            state: event.state[..state].to_vec(),
        })
        .collect();
    Outcome {
        trajectory,
        provenance: Provenance {
            version: env!("CARGO_PKG_VERSION").into(),
            steps: report.steps,
            rejections: report.rejections,
            evaluations: report.evaluations,
        },
        stopped_by: report.stopped_by.map(|k| plan.watches[k].name.clone()),
        failure: report.failure,
    }
}

/// A failure in the words of the system, where it knows what happened.
fn explained(plan: &Plan, mut report: Report) -> Report {
    let lost = matches!(
        report.failure,
        Some(Failure::Diverged { .. } | Failure::StepTooSmall { .. } | Failure::TooSlow { .. })
    );
    if lost && let Some(what) = plan.system.trouble(&plan.values, &plan.layout, report.end, &report.state) {
        report.failure = Some(Failure::Trouble { t: report.end, what });
    }
    report
}

/// Cyclic angles and resting modes stay out of the error norm: nothing depends on an angle that no equation holds.
pub(crate) fn pace(plan: &Plan) -> Pace {
    match plan.step {
        Step::Fixed(dt) => Pace::Fixed(dt),
        Step::Adaptive { rtol, atol } => {
            let shape = plan.layout.shape();
            let mut skip = plan.structure.cyclic.clone();
            skip.resize(shape.state(), false);
            skip.extend(&plan.structure.resting);
            Pace::Adaptive(Tolerance { rtol, atol, skip })
        }
    }
}

/// The columns of the result.
pub fn columns(plan: &Plan) -> Columns {
    let (layout, state) = (plan.layout.clone(), plan.layout.shape().state());
    let invariants: Vec<bool> = (0..layout.observables.len()).map(|k| plan.is_invariant(k)).collect();
    Columns::new(plan.width(), move |k| {
        let Quantity { name, unit, .. } = column(&layout, k);
        let kind = match k {
            0 => ColumnKind::Time,
            k if k <= state => ColumnKind::State,
            k if invariants[k - state - 1] => ColumnKind::Invariant,
            _ => ColumnKind::Signal,
        };
        Column { name, unit, kind }
    })
}

/// A column of the result as a function of time and full state.
pub(crate) fn quantity<'a>(
    plan: &'a Plan,
    field: &'a dyn Field<f64>,
    column: usize,
) -> impl Fn(f64, &[f64]) -> f64 + 'a {
    let state = plan.layout.shape().state();
    let observed = RefCell::new(vec![0.0; plan.layout.observables.len()]);
    move |t: f64, y: &[f64]| match column {
        0 => t,
        k if k <= state => y[k - 1],
        k => {
            let mut observed = observed.borrow_mut();
            field.observe(t, y, &mut observed);
            observed[k - state - 1]
        }
    }
}

/// The watched quantities as functions of the state.
fn watched<'a>(plan: &'a Plan, field: &'a dyn Field<f64>) -> Vec<Watched<'a>> {
    let watch = |watch: &'a crate::plan::Watch| {
        let quantity = quantity(plan, field, watch.column);
        let function = move |t: f64, y: &[f64]| quantity(t, y) - watch.value;
        Watched { function: Box::new(function), direction: watch.direction, stop: watch.stop }
    };
    plan.watches.iter().map(watch).collect()
}
