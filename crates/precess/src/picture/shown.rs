//! The trajectories of a picture: the run and the members of its families.

use super::Watcher;
use crate::figure::Stroke;
use crate::panel::RUN;
use crate::plan::Plan;
use crate::run::run;
use precess_system::Trajectory;
use std::borrow::Cow;
use std::collections::HashMap;
use std::ops::ControlFlow;

/// A trajectory with what it is called.
pub(crate) struct Shown<'a> {
    /// What it was run by.
    pub plan: &'a Plan,
    /// Its samples, in the order of time.
    pub trajectory: Cow<'a, Trajectory>,
    /// Where its columns stand, by their names. A map, for there may be a million; it is asked, not walked.
    columns: HashMap<String, usize>,
    /// Its family; `run` is the run itself.
    pub family: &'a str,
    /// Its name in legends.
    pub label: &'a str,
    /// How it is drawn, where the panel does not say.
    pub style: Stroke,
    /// Which of its quantities stands for one of the run's.
    names: &'a [(String, String)],
}

impl Shown<'_> {
    /// The column of a quantity that the run calls by this name.
    pub fn column(&self, name: &str) -> Option<usize> {
        let renamed = self.names.iter().find(|(theirs, _)| theirs == name);
        let own = renamed.map_or(name, |(_, own)| own.as_str());
        self.columns.get(own).copied()
    }

    /// The sample nearest to a time.
    pub fn sample(&self, t: f64) -> Option<&[f64]> {
        let distance = |row: &&[f64]| (row[0] - t).abs();
        self.trajectory.rows().min_by(|a, b| distance(a).total_cmp(&distance(b)))
    }
}

/// The run, then the members of its families, which are run here.
pub(super) fn all<'a>(plan: &'a Plan, trajectory: &'a Trajectory, progress: Watcher) -> Vec<Shown<'a>> {
    let mut shown = vec![Shown {
        plan,
        columns: places(trajectory),
        trajectory: Cow::Borrowed(trajectory),
        family: RUN,
        label: &plan.label,
        style: Stroke::Line,
        names: &[],
    }];
    let count = plan.members.len() as f64;
    for (k, member) in plan.members.iter().enumerate() {
        let mut share = |_: f64| progress(k as f64 / count);
        let mut trajectory = run(&member.plan, &mut share).trajectory;
        if member.both_ways {
            let back = Plan { until: -member.plan.until, ..member.plan.clone() };
            trajectory = joined(run(&back, &mut share).trajectory, trajectory);
        }
        shown.push(Shown {
            plan: &member.plan,
            columns: places(&trajectory),
            trajectory: Cow::Owned(trajectory),
            family: &member.family,
            label: &member.label,
            style: member.style.unwrap_or_default(),
            names: &member.names,
        });
        if progress(k as f64 / count) == ControlFlow::Break(()) {
            break;
        }
    }
    shown
}

fn places(trajectory: &Trajectory) -> HashMap<String, usize> {
    trajectory.columns.iter().enumerate().map(|(k, column)| (column.name, k)).collect()
}

/// Two runs from one start, one backwards, as one trajectory in the order of time.
fn joined(one: Trajectory, other: Trajectory) -> Trajectory {
    let forwards = |t: &Trajectory| t.rows().last().is_some_and(|row| row[0] > 0.0);
    let (before, after) = if forwards(&one) { (other, one) } else { (one, other) };
    let width = before.columns.len();
    let mut rows: Vec<&[f64]> = before.rows().collect();
    rows.reverse();
    rows.pop();
    let mut numbers = Vec::with_capacity(rows.len() * width + after.numbers.len());
    for row in rows {
        numbers.extend_from_slice(row);
    }
    numbers.extend_from_slice(&after.numbers);
    Trajectory { numbers, ..after }
}
