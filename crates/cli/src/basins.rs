//! `precess basins`: where each start of a grid ends.

use crate::args;
use crate::failure::Failure;
use crate::output::{Output, suffix};
use crate::progress::{Progress, listen};
use crate::run::{finish_plot, open_plot, unknown_suffix};
use crate::subject::{assignment, scenario};
use npyz::WriterBuilder;
use npyz::zip::write::FileOptions;
use precess::basins::{self, Basins, BasinsSpec};
use precess::value::shortest;
use precess::{Axis, Plan, Scenario, Workers, scenario_toml};
use std::io::{self, BufWriter, Seek, Write};
use std::ops::ControlFlow;
use std::path::Path;
use std::time::Instant;

/// More starts than this are asked about.
const MANY: usize = 4_000_000;
/// The side of a small grid whose time tells that of a large one.
const PILOT: usize = 8;

/// Basins.
pub fn basins(arguments: &args::Basins) -> Result<(), Failure> {
    let subject = &arguments.analysis.subject;
    let mut scenario = scenario(subject, arguments.analysis.method.as_deref())?;
    for given in &arguments.analysis.options {
        let (name, value) = assignment(given)?;
        Scenario::set(&mut scenario.run, name, value);
    }
    let plan = Plan::new(&scenario)?;
    let axes: Vec<Axis> = arguments.grid.iter().map(|g| Axis::parse(&plan, g)).collect::<Result<_, _>>()?;
    if axes.len() > 2 {
        return Err(Failure::Wrong(format!("a map has one or two grids, not {}", axes.len())));
    }
    let spec = BasinsSpec { axes, wrap: arguments.wrap, once: arguments.once };
    let workers = Workers::chosen()?;
    if !arguments.yes {
        refuse_many(&scenario, &spec, workers)?;
    }
    let (mut file, mut to_standard_output) = (None, subject.output.is_none() && subject.plot.is_none());
    match subject.output.as_deref() {
        None => {}
        Some(path) if path == Path::new("-") => to_standard_output = true,
        Some(path) if ["csv", "npz"].contains(&suffix(path).as_str()) => {
            file = Some((Output::create(path)?, suffix(path)));
        }
        Some(path) => return Err(unknown_suffix(path, "csv or npz")),
    }
    let plot = subject.plot.as_deref().map(open_plot).transpose()?;

    let began = Instant::now();
    let mut progress = Progress::new(1.0, subject.quiet, &listen());
    let found = basins::basins(&scenario, &spec, workers, &mut |share| progress.at(share));
    progress.finish();
    let found = found?;

    if to_standard_output {
        let mut out = BufWriter::new(io::stdout().lock());
        let written = csv(&mut out, &found).and_then(|()| out.flush());
        written.map_err(|e| Failure::of_writing("standard output", &e))?;
    }
    match file {
        Some((output, suffix)) if suffix == "npz" => output.finish(|file| npz(file, &found))?,
        Some((output, _)) => output.finish(|file| csv(file, &found))?,
        None => {}
    }
    if let Some(plot) = plot {
        finish_plot(&found.figure(), plot)?;
    }
    if !subject.quiet {
        for line in found.summary() {
            let _ = writeln!(io::stderr(), "  {line}");
        }
        let _ = writeln!(
            io::stderr(),
            "  {} starts in {:.2} s",
            found.labels.len(),
            began.elapsed().as_secs_f64()
        );
    }
    if found.interrupted {
        return Err(Failure::Failed("interrupted; the starts that were not reached are undecided".into()));
    }
    Ok(())
}

/// Very many starts need a word of consent, from somebody who knows what they cost.
fn refuse_many(scenario: &Scenario, spec: &BasinsSpec, workers: Workers) -> Result<(), Failure> {
    let members = spec.axes.iter().fold(1, |count: usize, axis| count.saturating_mul(axis.points));
    if members <= MANY {
        return Ok(());
    }
    let coarse = spec.axes.iter().map(|axis| Axis { points: PILOT, ..axis.clone() }).collect();
    let pilot = BasinsSpec { axes: coarse, ..spec.clone() };
    let began = Instant::now();
    let found = basins::basins(scenario, &pilot, workers, &mut |_| ControlFlow::Continue(()))?;
    let hours = began.elapsed().as_secs_f64() * members as f64 / found.labels.len() as f64 / 3600.0;
    let bytes = members as f64 * (8.0 * found.plan.start.len() as f64 + 80.0);
    Err(Failure::Wrong(format!(
        "{members} starts would take about {hours:.1} hours and {:.1} GB of memory: --yes goes on",
        bytes / 1e9
    )))
}

/// One row a start: its values, its label.
fn csv(out: &mut impl Write, basins: &Basins) -> io::Result<()> {
    for axis in &basins.axes {
        write!(out, "{},", axis.name)?;
    }
    writeln!(out, "label")?;
    for (k, label) in basins.labels.iter().enumerate() {
        let mut rest = k;
        for axis in &basins.axes {
            write!(out, "{},", shortest(axis.value(rest % axis.points)))?;
            rest /= axis.points;
        }
        writeln!(out, "{label}")?;
    }
    Ok(())
}

/// The axes under their names; `label` and `time`, the last axis first; `attractors`, a row each; `scenario`, `version`.
fn npz(out: &mut (impl Write + Seek), basins: &Basins) -> io::Result<()> {
    let mut archive = npyz::npz::NpzWriter::new(out);
    let mut array = |name: &str, shape: &[u64], numbers: &mut dyn Iterator<Item = f64>| -> io::Result<()> {
        let mut array =
            archive.array(name, FileOptions::default())?.default_dtype().shape(shape).begin_nd()?;
        array.extend(numbers)?;
        array.finish()
    };
    for axis in &basins.axes {
        array(&axis.name, &[axis.points as u64], &mut (0..axis.points).map(|k| axis.value(k)))?;
    }
    let shape: Vec<u64> = basins.axes.iter().rev().map(|axis| axis.points as u64).collect();
    array("time", &shape, &mut basins.times.iter().copied())?;
    let size = basins.plan.layout.shape().state() as u64;
    let states = basins.attractors.iter().flat_map(|a| a.state.iter().copied());
    array("attractors", &[basins.attractors.len() as u64, size], &mut { states })?;
    let mut labels =
        archive.array("label", FileOptions::default())?.default_dtype().shape(&shape).begin_nd()?;
    labels.extend(basins.labels.iter().copied())?;
    labels.finish()?;
    for (name, text) in
        [("scenario", scenario_toml(&basins.plan)), ("version", env!("CARGO_PKG_VERSION").into())]
    {
        let bytes = text.as_bytes();
        let mut array = archive
            .array(name, FileOptions::default())?
            .default_dtype()
            .shape(&[bytes.len() as u64])
            .begin_nd()?;
        array.extend(bytes.iter().copied())?;
        array.finish()?;
    }
    Ok(())
}
