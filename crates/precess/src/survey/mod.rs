//! Ensembles too large for a table in memory: members are worked out, run and reduced chunk by chunk.
//!
//! A chunk has the same members whatever the machine, and its numbers are written to a checkpoint as soon as they are
//! there. What was killed goes on from it, and ends with the same bits.

mod checkpoint;
mod classes;
mod members;

use crate::canonical::scenario_toml;
use crate::ensemble::ensemble;
use crate::error::{Error, input};
use crate::grid::starts;
use crate::hash::Hasher;
use crate::members::Keep;
use crate::plan::Plan;
use crate::run::Runner;
use crate::scenario::{Kept, Scenario};
use crate::workers::{Workers, spread};
use classes::Sorter;
use members::Roll;
use precess_integrate::Failure;
use precess_system::Field;
use std::ops::{ControlFlow, Range};
use std::path::Path;

pub use checkpoint::Checkpoint;

/// Members of a chunk: the same on every machine, since a checkpoint knows them by the chunk.
const CHUNK: usize = 512;

/// An ensemble that is ready to run.
pub struct Survey {
    scenario: Scenario,
    /// The run that its members differ from.
    pub plan: Plan,
    roll: Roll,
    keep: Kept,
    sorter: Option<Sorter>,
    /// The names of the columns: what varies, then what is kept, then the class.
    pub columns: Vec<String>,
}

/// How a member ended, in the column `status`.
fn status(failure: Option<&Failure>) -> f64 {
    match failure {
        None => 0.0,
        Some(Failure::Interrupted { .. }) => -1.0,
        Some(_) => -3.0,
    }
}

impl Survey {
    /// Holds the `[ensemble]` of a scenario against its cards; files are looked for beside `folder`.
    ///
    /// # Errors
    /// One sentence: what makes no sense, and where.
    pub fn new(scenario: &Scenario, folder: &Path) -> Result<Self, Error> {
        let Some(spec) = &scenario.ensemble else {
            return input(
                "there is no [ensemble] in this scenario, such as [ensemble] with grid = { x = \"-2:2:200\" }",
            );
        };
        let plan = Plan::new(scenario)?;
        let watches = !plan.watches.is_empty();
        if watches != matches!(spec.keep, Kept::Passage | Kept::Section) {
            let keep = spec.keep.name();
            return input(if watches {
                format!("keep = \"{keep}\" watches no [[event]]: keep = \"passage\" and \"section\" do")
            } else {
                format!("keep = \"{keep}\" needs an [[event]] to watch, such as when = \"x = 0\"")
            });
        }
        let roll = Roll::new(&plan, spec, folder)?;
        let state = plan.layout.state().into_iter().map(|q| q.name);
        let own: Vec<String> = match spec.keep {
            Kept::Last => state.chain(["status".into()]).collect(),
            Kept::Passage => ["t".into()].into_iter().chain(state).chain(["status".into()]).collect(),
            Kept::Section => ["member".into(), "t".into()].into_iter().chain(state).collect(),
            Kept::Extremes => {
                let names = plan.columns().into_iter().skip(1).map(|q| q.name);
                let pairs = names.flat_map(|name| [format!("{name}_min"), format!("{name}_max")]);
                pairs.chain(["status".into()]).collect()
            }
        };
        // What a member starts with stands beside its end: other names.
        let varied = roll.names.iter().map(|name| format!("start_{name}"));
        let mut columns: Vec<String> = varied.chain(own).collect();
        let sorter = spec
            .classes
            .as_ref()
            .map(|classes| Sorter::new(&plan, classes, spec.keep, &columns))
            .transpose()?;
        columns.extend(sorter.is_some().then(|| "class".into()));
        Ok(Self { scenario: scenario.clone(), plan, roll, keep: spec.keep, sorter, columns })
    }

    /// How many members there are.
    pub fn members(&self) -> usize {
        self.roll.count
    }

    fn chunks(&self) -> usize {
        self.members().div_ceil(CHUNK)
    }

    fn range(&self, chunk: usize) -> Range<usize> {
        let end = (chunk + 1) * CHUNK;
        chunk * CHUNK..if end < self.members() { end } else { self.members() }
    }

    /// A scenario that gives the same ensemble.
    pub fn toml(&self) -> String {
        scenario_toml(&self.plan)
    }

    /// All that decides the numbers, as a text: what a checkpoint is held against.
    pub fn text(&self) -> String {
        let (version, members) = (env!("CARGO_PKG_VERSION"), self.roll.digest());
        format!("version = \"{version}\"\n{}members = \"{members}\"\n", self.toml())
    }

    /// Runs the first chunk for nothing, to see how long that takes; gives its members.
    ///
    /// # Errors
    /// Where a member's parameters or start make no sense.
    pub fn pilot(&self, workers: Workers) -> Result<usize, Error> {
        self.chunk(self.range(0), Workers { threads: 1, ..workers })?;
        Ok(self.range(0).len())
    }

    /// SHA-256 of all rows.
    ///
    /// # Errors
    /// Where the checkpoint cannot be read.
    pub fn hash(&self, checkpoint: &mut Checkpoint) -> Result<String, Error> {
        let mut hasher = Hasher::default();
        self.rows(checkpoint, &mut |row| row.iter().for_each(|x| hasher.add(*x)))?;
        Ok(hasher.hex())
    }

    /// Members that did not arrive.
    ///
    /// # Errors
    /// Where the checkpoint cannot be read.
    pub fn lost(&self, checkpoint: &mut Checkpoint) -> Result<usize, Error> {
        let Some(place) = self.columns.iter().position(|name| name == "status") else { return Ok(0) };
        let mut lost = 0;
        self.rows(checkpoint, &mut |row| lost += usize::from(row[place] < 0.0))?;
        Ok(lost)
    }

    /// Runs all chunks that the checkpoint lacks. `progress` is told how many members are done and may end the work: what is
    /// done then stays in the checkpoint. True where all is done.
    ///
    /// # Errors
    /// Where a member's parameters or start make no sense, or the checkpoint cannot be written.
    pub fn run(
        &self,
        checkpoint: &mut Checkpoint,
        workers: Workers,
        progress: &mut dyn FnMut(usize) -> ControlFlow<()>,
    ) -> Result<bool, Error> {
        let missing: Vec<usize> = (0..self.chunks()).filter(|k| !checkpoint.has(*k)).collect();
        let done_before: usize =
            (0..self.chunks()).filter(|k| checkpoint.has(*k)).map(|k| self.range(k).len()).sum();
        let (mut done, mut error) = (done_before, None);
        let alone = Workers { threads: 1, ..workers };
        let work = |k: usize| self.chunk(self.range(missing[k]), alone);
        spread(workers.threads, missing.len(), &work, &mut |k, rows: Result<Vec<f64>, Error>| {
            let kept = rows.and_then(|rows| checkpoint.keep(missing[k], &rows));
            if let Err(e) = kept {
                error = Some(e);
                return ControlFlow::Break(());
            }
            done += self.range(missing[k]).len();
            progress(done)
        });
        match error {
            Some(error) => Err(error),
            None => Ok((0..self.chunks()).all(|k| checkpoint.has(k))),
        }
    }

    /// All rows in the order of the members, a chunk at a time.
    ///
    /// # Errors
    /// Where the checkpoint cannot be read.
    pub fn rows(&self, checkpoint: &mut Checkpoint, take: &mut dyn FnMut(&[f64])) -> Result<(), Error> {
        for k in 0..self.chunks() {
            let numbers = checkpoint.read(k)?;
            numbers.chunks(self.columns.len()).for_each(&mut *take);
        }
        Ok(())
    }

    /// The rows of some members: groups of those with the same parameters, in lanes.
    fn chunk(&self, members: Range<usize>, workers: Workers) -> Result<Vec<f64>, Error> {
        let values: Vec<Vec<f64>> = members.clone().map(|member| self.roll.values(member)).collect();
        let mut rows = vec![];
        let mut first = members.start;
        for group in values.chunk_by(|a, b| self.roll.alike(a, b)) {
            let at = |e: Error| e.at(&format!("from member {first} on"));
            let plan = Plan::new(&self.roll.scenario(&self.scenario, &group[0])).map_err(at)?;
            let names: Vec<&str> = self.roll.starts(&group[0]).map(|(name, _)| name).collect();
            let mut each = group.iter().map(|values| self.roll.starts(values).map(|(_, x)| x).collect());
            let starts = starts(&plan, &names, &mut each).map_err(at)?;
            self.group(&plan, &starts, group, first, workers, &mut rows)?;
            first += group.len();
        }
        Ok(rows)
    }

    /// Adds the class of the row that ends here, where members are sorted.
    fn sort(&self, plan: &Plan, field: &dyn Field<f64>, rows: &mut Vec<f64>) {
        if let Some(sorter) = &self.sorter {
            let class = sorter.class(plan, field, &rows[rows.len() + 1 - self.columns.len()..]);
            rows.push(class);
        }
    }

    fn group(
        &self,
        plan: &Plan,
        starts: &[f64],
        values: &[Vec<f64>],
        first: usize,
        workers: Workers,
        rows: &mut Vec<f64>,
    ) -> Result<(), Error> {
        let mut go_on = |_| ControlFlow::Continue(());
        match self.keep {
            Kept::Last | Kept::Extremes => {
                let keep = if self.keep == Kept::Last { Keep::Last } else { Keep::Samples };
                let members = ensemble(plan, starts, keep, workers, &mut go_on)?;
                let mut failures = members.failures.iter().peekable();
                let runner = Runner::new(plan);
                for (k, values) in values.iter().enumerate() {
                    let failure = failures.next_if(|(member, _)| *member == k).map(|(_, failure)| failure);
                    rows.extend(values);
                    if self.keep == Kept::Last {
                        rows.extend(members.member(k));
                    } else {
                        let times = members.times.iter().copied();
                        extremes(
                            plan,
                            runner.field(),
                            times.zip(members.member(k).chunks(members.state)),
                            rows,
                        );
                    }
                    rows.push(status(failure));
                    self.sort(plan, runner.field(), rows);
                }
            }
            Kept::Passage | Kept::Section => {
                let mut plan = plan.clone();
                for watch in &mut plan.watches {
                    watch.stop = self.keep == Kept::Passage;
                }
                let runner = Runner::new(&plan);
                let state = plan.layout.shape().state();
                for (k, (start, values)) in starts.chunks(plan.start.len()).zip(values).enumerate() {
                    let report = runner.drive(start, &mut |_, _| {}, &mut |_| ControlFlow::Continue(()));
                    let watched = report
                        .events
                        .iter()
                        .filter(|e| matches!(e.source, precess_integrate::Source::Watch(_)));
                    if self.keep == Kept::Section {
                        for event in watched {
                            rows.extend(values);
                            rows.extend([(first + k) as f64, event.t]);
                            rows.extend(&event.state[..state]);
                        }
                        continue;
                    }
                    rows.extend(values);
                    match watched.into_iter().next() {
                        Some(event) => {
                            rows.push(event.t);
                            rows.extend(&event.state[..state]);
                        }
                        None => rows.extend(std::iter::repeat_n(f64::NAN, state + 1)),
                    }
                    rows.push(status(report.failure.as_ref()));
                    self.sort(&plan, runner.field(), rows);
                }
            }
        }
        Ok(())
    }
}

/// The smallest and the largest value of each quantity; NaN where there is no number.
fn extremes<'a>(
    plan: &Plan,
    field: &dyn Field<f64>,
    samples: impl Iterator<Item = (f64, &'a [f64])>,
    rows: &mut Vec<f64>,
) {
    let mut observed = vec![0.0; plan.layout.observables.len()];
    let mut ends = vec![[f64::NAN; 2]; plan.width() - 1];
    for (t, state) in samples.filter(|(_, state)| state.iter().all(|x| x.is_finite())) {
        // Modes rest at their start where there are any: observables of a hybrid system may see them.
        let mut full = plan.start.clone();
        full[..state.len()].copy_from_slice(state);
        field.observe(t, &full, &mut observed);
        for ([low, high], &x) in ends.iter_mut().zip(state.iter().chain(&observed)) {
            *low = if x < *low || low.is_nan() { x } else { *low };
            *high = if x > *high || high.is_nan() { x } else { *high };
        }
    }
    rows.extend(ends.into_iter().flatten());
}
