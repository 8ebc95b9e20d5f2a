//! `precess compare`: several methods on the same start, side by side.

use crate::args::Compare;
use crate::failure::Failure;
use crate::list;
use crate::output::{Output, suffix};
use crate::progress::{Progress, listen};
use crate::run::{finish_plot, open_plot, unknown_suffix};
use crate::subject::scenario;
use precess::figure::{Curve, Figure, Panel};
use precess::integrate::Failure::Interrupted;
use precess::value::shortest;
use precess::{Comparison, Contender, Plan, departures};
use std::fmt::Write as _;
use std::io::Write;
use std::path::Path;

/// Compares.
pub fn compare(arguments: &Compare) -> Result<(), Failure> {
    let scenario = scenario(&arguments.subject, None)?;
    let until = Plan::new(&scenario.for_reference())?.until;
    let (mut to_standard_output, mut file) = (false, None);
    match arguments.subject.output.as_deref() {
        None => {}
        Some(path) if path == Path::new("-") => to_standard_output = true,
        Some(path) if suffix(path) == "csv" => file = Some(Output::create(path)?),
        Some(path) => return Err(unknown_suffix(path, "csv")),
    }
    let plot = arguments.subject.plot.as_deref().map(open_plot).transpose()?;

    let stop = listen();
    let quiet = arguments.subject.quiet;
    let mut bar: Option<(String, Progress)> = None;
    let comparison = precess::compare(&scenario, &arguments.methods, &mut |method, t| {
        if bar.as_ref().is_none_or(|(name, _)| name != method) {
            if let Some((_, old)) = bar.take() {
                old.finish();
            }
            bar = Some((method.to_string(), Progress::new(until, quiet, &stop)));
        }
        bar.as_mut().map_or(std::ops::ControlFlow::Continue(()), |(_, progress)| progress.at(t))
    })?;
    if let Some((_, progress)) = bar {
        progress.finish();
    }

    let interrupted = comparison.contenders.iter().find_map(|c| match &c.outcome.failure {
        Some(failure @ Interrupted { .. }) => Some(format!("{}: {failure}", c.method)),
        _ => None,
    });
    if let Some(sentence) = interrupted {
        return Err(Failure::Failed(sentence));
    }

    let table = csv(&comparison);
    if to_standard_output {
        list::print(&table)?;
    } else if !quiet {
        list::print(&text(&comparison))?;
    }
    if let Some(output) = file {
        output.finish(|file| file.write_all(table.as_bytes()))?;
    }
    if let Some(plot) = plot {
        finish_plot(&figure(&scenario.system, &comparison), plot)?;
    }
    let all_failed = comparison.contenders.iter().all(|c| c.outcome.failure.is_some());
    if all_failed { Err(Failure::Failed("every method failed".into())) } else { Ok(()) }
}

fn names(comparison: &Comparison) -> Vec<&str> {
    comparison.contenders.first().map_or(vec![], |c| c.drifts.iter().map(|d| d.name.as_str()).collect())
}

/// One row a method: the error, the relative drift of each invariant (absolute where it starts at zero), the cost.
fn csv(comparison: &Comparison) -> String {
    let mut out = String::from("method,error");
    for name in names(comparison) {
        let _ = write!(out, ",drift_{name}");
    }
    out.push_str(",steps,evaluations,seconds\n");
    for c in &comparison.contenders {
        let _ = write!(out, "{},{}", c.method, shortest(c.error));
        for drift in &c.drifts {
            let _ = write!(out, ",{}", shortest(drift.relative().unwrap_or(drift.largest)));
        }
        let cost = &c.outcome.provenance;
        let _ = writeln!(out, ",{},{},{}", cost.steps, cost.evaluations, shortest(c.time.as_secs_f64()));
    }
    out
}

fn text(comparison: &Comparison) -> String {
    let mut out = format!("{:<14} {:>9}", "method", "error");
    let names = names(comparison);
    let width = |name: &str| name.len().max(9) + 6;
    for name in &names {
        let _ = write!(out, " {:>1$}", format!("drift {name}"), width(name));
    }
    let _ = writeln!(out, " {:>11} {:>11}", "evaluations", "time");
    for c in &comparison.contenders {
        let _ = write!(out, "{:<14} {:>9.1e}", c.method, c.error);
        for (drift, name) in c.drifts.iter().zip(&names) {
            let _ = write!(out, " {:>1$.1e}", drift.relative().unwrap_or(drift.largest), width(name));
        }
        let evaluations = c.outcome.provenance.evaluations;
        let _ = writeln!(out, " {evaluations:>11} {:>9.2} ms{}", c.time.as_secs_f64() * 1e3, remark(c));
    }
    let _ = writeln!(
        out,
        "\nerror: largest distance from dop853 at 1e-14 at a sample, each number relative to its largest size;\n\
         the reference itself is good to about {:.0e}. drift: relative to the start.",
        comparison.floor
    );
    out
}

fn remark(contender: &Contender) -> String {
    contender
        .outcome
        .failure
        .as_ref()
        .map_or(String::new(), |f| format!("  ended at t = {} s", shortest(f.time())))
}

/// The drift of each invariant, one curve a method.
fn figure(system: &str, comparison: &Comparison) -> Figure {
    let panels = names(comparison).into_iter().map(|name| Panel {
        title: format!("Drift of {name}, relative to the start"),
        x_label: "t [s]".into(),
        logarithmic: true,
        curves: comparison.contenders.iter().filter_map(|c| curve(c, name)).collect(),
        ..Panel::default()
    });
    Figure { title: format!("Methods on {system}"), panels: panels.collect(), ..Figure::default() }
}

fn curve(contender: &Contender, name: &str) -> Option<Curve> {
    let trajectory = &contender.outcome.trajectory;
    let values = trajectory.column(name)?;
    Some(Curve {
        label: contender.method.clone(),
        x: trajectory.column("t")?,
        y: departures(&values),
        ..Curve::default()
    })
}
