//! `precess run`: a system or a scenario, to a table, a picture, a hash.

use crate::args::Run;
use crate::failure::Failure;
use crate::output::{Output, suffix};
use crate::progress::{Progress, listen};
use crate::subject::{assignment, scenario};
use crate::{draw, list, summary, table};
use precess::{Outcome, Plan, Scenario, hash, picture, spelt_out};
use std::io::{self, BufWriter, Write};
use std::ops::ControlFlow;
use std::path::Path;
use std::time::Instant;

/// Where the results go. Files are opened before the run, so that an unwritable one is found out at once.
struct Targets {
    table: Option<Table>,
    plot: Option<(Output, String)>,
    save: Option<Output>,
}

enum Table {
    StandardOutput,
    Csv(Output),
    Npz(Output),
}

/// Runs.
pub fn run(arguments: &Run) -> Result<(), Failure> {
    let mut scenario = scenario(&arguments.subject, arguments.method.as_deref())?;
    for given in &arguments.options {
        let (name, value) = assignment(given)?;
        Scenario::set(&mut scenario.run, name, value);
    }
    let plan = Plan::new(&scenario)?;
    let targets = open(arguments)?;

    let began = Instant::now();
    let quiet = arguments.subject.quiet;
    let mut progress = Progress::new(plan.until, quiet, &listen());
    let outcome = precess::run(&plan, &mut |t| progress.at(t));
    let time = began.elapsed();

    write(&plan, &outcome, targets, &mut |share| progress.at(share * plan.until))?;
    progress.finish();
    if arguments.hash {
        list::print(&format!("{}\n", hash(&outcome.trajectory)))?;
    }
    if !quiet {
        let _ = io::stderr().write_all(summary::summary(&plan, &outcome, time).as_bytes());
    }
    match outcome.failure {
        Some(failure) => Err(Failure::Failed(format!("{failure}; the samples up to then are kept"))),
        None => Ok(()),
    }
}

fn open(arguments: &Run) -> Result<Targets, Failure> {
    let subject = &arguments.subject;
    let table = match &subject.output {
        None => None,
        Some(path) if path == Path::new("-") => {
            if arguments.hash {
                return Err(Failure::Wrong(
                    "--hash and -o - would both write to standard output: choose one".into(),
                ));
            }
            Some(Table::StandardOutput)
        }
        Some(path) => Some(match suffix(path).as_str() {
            "csv" => Table::Csv(Output::create(path)?),
            "npz" => Table::Npz(Output::create(path)?),
            _ => return Err(unknown_suffix(path, "csv or npz")),
        }),
    };
    let plot = subject.plot.as_deref().map(open_plot).transpose()?;
    let save = arguments.save.as_deref().map(Output::create).transpose()?;
    Ok(Targets { table, plot, save })
}

/// Opens a picture file and tells its format.
pub fn open_plot(path: &Path) -> Result<(Output, String), Failure> {
    let suffix = suffix(path);
    if !["svg", "png"].contains(&suffix.as_str()) {
        return Err(unknown_suffix(path, "svg or png"));
    }
    Ok((Output::create(path)?, suffix))
}

pub fn unknown_suffix(path: &Path, known: &str) -> Failure {
    Failure::Wrong(format!("'{}' has no suffix that is known here: {known}", path.display()))
}

/// Draws a figure into an open file.
pub fn finish_plot(
    figure: &precess::figure::Figure,
    (output, suffix): (Output, String),
) -> Result<(), Failure> {
    let picture = if suffix == "png" {
        draw::png(figure).map_err(Failure::Failed)?
    } else {
        draw::svg(figure).into_bytes()
    };
    output.finish(|file| file.write_all(&picture))
}

fn write(
    plan: &Plan,
    outcome: &Outcome,
    targets: Targets,
    progress: &mut dyn FnMut(f64) -> ControlFlow<()>,
) -> Result<(), Failure> {
    match targets.table {
        None => {}
        Some(Table::StandardOutput) => {
            let mut out = BufWriter::new(io::stdout().lock());
            let written = table::csv(&mut out, &outcome.trajectory).and_then(|()| out.flush());
            written.map_err(|e| Failure::of_writing("standard output", &e))?;
        }
        Some(Table::Csv(output)) => output.finish(|file| table::csv(file, &outcome.trajectory))?,
        Some(Table::Npz(output)) => output.finish(|file| table::npz(file, plan, &outcome.trajectory))?,
    }
    if let Some(plot) = targets.plot {
        finish_plot(&picture(plan, &outcome.trajectory, progress)?, plot)?;
    }
    if let Some(output) = targets.save {
        output.finish(|file| write!(file, "{}", spelt_out(plan)))?;
    }
    Ok(())
}
