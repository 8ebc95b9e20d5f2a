//! What basins, and each part of them, begin with: a judge, who depends on scenario and grid alone, and the starts.

use super::chase::{Fate, chase};
use super::companions::Care;
use super::ground::Ground;
use super::judge::Judge;
use super::{Attractor, BasinsSpec, Listed, settle, tell};
use crate::error::{Error, input};
use crate::grid::grid;
use crate::plan::{Plan, Step};
use crate::scenario::Scenario;
use crate::value::Value;
use crate::workers::Workers;
use precess_integrate::Kind as Steps;
use std::ops::ControlFlow;

/// Lengths of the card's run that a motion has to settle.
const PATIENCE: f64 = 5.0;
/// Starts that are followed to their ends before the others, to find attractors.
const SCOUTS: usize = 200;

/// Scenario and grid, with the attractors that are known before every start has been followed.
pub struct Court {
    pub(super) judge: Judge,
    /// The full states of all starts, the first axis running fastest.
    pub(super) starts: Vec<f64>,
    /// Whether somebody ended the work before the attractors were known.
    pub(super) interrupted: bool,
}

impl Court {
    /// Finds what there is to be found without following every start.
    ///
    /// # Errors
    /// As [`super::basins`].
    pub fn new(
        scenario: &Scenario,
        spec: &BasinsSpec,
        workers: Workers,
        progress: &mut dyn FnMut(f64) -> ControlFlow<()>,
    ) -> Result<Self, Error> {
        let plan = patient(scenario)?;
        if spec.axes.is_empty() {
            return input("basins need a grid of starts, such as --grid x=-2:2:200 --grid y=-2:2:200");
        }
        if plan.until <= 0.0 {
            return input(format!("the end must be above zero here, not {}", plan.until));
        }
        let starts = grid(&plan, &spec.axes)?;
        let mut ground = Ground::new(plan, &starts)?;
        let plan = &mut ground.plan;
        match ground.period {
            // Motions are judged at whole periods.
            Some(period) => {
                plan.every = period;
                plan.until = (plan.until / period).ceil() * period;
            }
            None if matches!(plan.step, Step::Adaptive { .. }) => plan.every = plan.until,
            None => {}
        }
        let mut court = Self { judge: Judge::new(ground)?, starts, interrupted: false };
        if court.judge.wells.is_empty() {
            let scouts = scouts(&court.starts, court.judge.ground.plan.start.len());
            let ends = chase(&court.judge, &scouts, Care::Once, workers, &mut |_| progress(0.0));
            court.interrupted = ends.contains(&Fate::Interrupted);
            settle(&mut court.judge, ends);
        }
        Ok(court)
    }

    /// The plan of each start.
    pub fn plan(&self) -> &Plan {
        &self.judge.ground.plan
    }

    /// Whether somebody ended the work before the attractors were known; then no start is followed.
    pub fn interrupted(&self) -> bool {
        self.interrupted
    }

    /// The attractors that are known, in the order of their states; those that differ by whole turns are one.
    pub fn attractors(&self) -> Vec<Attractor> {
        tell(&self.judge, &[], Listed::Known).attractors
    }

    /// The labels of some starts, given by their full states: the number of an attractor that is known, or a negative one.
    pub fn labels(
        &self,
        starts: &[f64],
        care: Care,
        workers: Workers,
        progress: &mut dyn FnMut(f64) -> ControlFlow<()>,
    ) -> Vec<i32> {
        tell(&self.judge, &self.fates(starts, care, workers, progress), Listed::Known).labels
    }

    /// The fates of some starts: nobody follows them where the work has been interrupted before.
    pub(super) fn fates(
        &self,
        starts: &[f64],
        care: Care,
        workers: Workers,
        progress: &mut dyn FnMut(f64) -> ControlFlow<()>,
    ) -> Vec<Fate> {
        let members = starts.len() / self.plan().start.len();
        if self.interrupted || members == 0 {
            return vec![Fate::Interrupted; members];
        }
        chase(&self.judge, starts, care, workers, &mut |done| progress(done as f64 / members as f64))
    }
}

/// The plan, with time to settle and a tolerance that chaos does not spoil.
fn patient(scenario: &Scenario) -> Result<Plan, Error> {
    let plan = Plan::new(scenario)?;
    let mut patient = scenario.clone();
    let given = |name: &str| scenario.run.iter().any(|(n, _)| n == name);
    if !given("until") {
        patient.run.push(("until".into(), Value::number(PATIENCE * plan.card.defaults.until)));
    }
    for name in ["rtol", "atol"] {
        if plan.method.card().kind == Steps::Adaptive && !given(name) {
            patient.run.push((name.into(), Value::number(1e-12)));
        }
    }
    Plan::new(&patient)
}

/// Starts from all over the grid, one in so many.
fn scouts(starts: &[f64], full: usize) -> Vec<f64> {
    let members = starts.len() / full;
    // A stride that has nothing to do with the columns.
    let stride = members.div_ceil(SCOUTS) | 1;
    starts.chunks(full).step_by(stride).flatten().copied().collect()
}
