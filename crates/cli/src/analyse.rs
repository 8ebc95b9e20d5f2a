//! The analyses: one function a command, which asks and puts the answer where it is wanted.

use crate::args::{Analysis, Fit, Floquet, Frenet, Poincare, Portrait, Response, Sensitivity, Trust};
use crate::failure::Failure;
use crate::measured;
use crate::output::{Output, suffix};
use crate::progress::{Progress, listen};
use crate::run::{finish_plot, open_plot, unknown_suffix};
use crate::subject::{assignment, scenario};
use crate::table;
use precess::analyses::{
    self, Answer, BifurcationSpec, FloquetSpec, FrenetSpec, PoincareSpec, PortraitSpec, ResponseSpec,
};
use precess::{Error, Scenario};
use std::io::{self, BufWriter, Write};
use std::ops::ControlFlow;
use std::path::Path;

/// How far a run can be trusted.
pub fn trust(arguments: &Trust) -> Result<(), Failure> {
    let within =
        precess::value::parse(&arguments.within).and_then(|v| v.in_unit("")).map_err(|e| e.at("--within"))?;
    analyse(&arguments.analysis, &mut |scenario, progress| analyses::trust(scenario, within, progress))
}

/// The Lyapunov spectrum.
pub fn lyapunov(arguments: &Analysis) -> Result<(), Failure> {
    analyse(arguments, &mut |scenario, progress| analyses::lyapunov(scenario, progress))
}

/// A Poincaré section.
pub fn poincare(arguments: &Poincare) -> Result<(), Failure> {
    let spec = PoincareSpec {
        section: arguments.section.clone(),
        direction: arguments.direction.clone(),
        x: arguments.x.clone(),
        y: arguments.y.clone(),
    };
    analyse(&arguments.analysis, &mut |scenario, progress| analyses::poincare(scenario, &spec, progress))
}

/// A phase portrait.
pub fn portrait(arguments: &Portrait) -> Result<(), Failure> {
    let spec = PortraitSpec { windows: arguments.windows.clone(), levels: arguments.levels };
    analyse(&arguments.analysis, &mut |scenario, progress| analyses::portrait(scenario, &spec, progress))
}

/// Amplitude and lag against a parameter.
pub fn response(arguments: &Response) -> Result<(), Failure> {
    let Response { sweep, coordinate, down, .. } = arguments;
    let spec = ResponseSpec { sweep: sweep.clone(), coordinate: coordinate.clone(), down: *down };
    analyse(&arguments.analysis, &mut |scenario, progress| analyses::response(scenario, &spec, progress))
}

/// The attractor against a parameter.
pub fn bifurcation(arguments: &Response) -> Result<(), Failure> {
    let Response { sweep, coordinate, down, .. } = arguments;
    let spec = BifurcationSpec { sweep: sweep.clone(), coordinate: coordinate.clone(), down: *down };
    analyse(&arguments.analysis, &mut |scenario, progress| analyses::bifurcation(scenario, &spec, progress))
}

/// Floquet multipliers.
pub fn floquet(arguments: &Floquet) -> Result<(), Failure> {
    let spec = FloquetSpec { sweeps: arguments.sweeps.clone() };
    analyse(&arguments.analysis, &mut |scenario, progress| analyses::floquet(scenario, &spec, progress))
}

/// Moving frames along a path.
pub fn frenet(arguments: &Frenet) -> Result<(), Failure> {
    let spec = FrenetSpec { x: arguments.x.clone(), y: arguments.y.clone() };
    analyse(&arguments.analysis, &mut |scenario, progress| analyses::frenet(scenario, &spec, progress))
}

/// Derivatives of a run.
pub fn sensitivity(arguments: &Sensitivity) -> Result<(), Failure> {
    analyse(&arguments.analysis, &mut |scenario, progress| {
        analyses::sensitivity(scenario, &arguments.along, progress)
    })
}

/// A fit to measured points.
pub fn fit(arguments: &Fit) -> Result<(), Failure> {
    let data = measured::read(&arguments.data, &arguments.columns, &arguments.uncertainties)?;
    let save = arguments.save.as_deref().map(Output::create).transpose()?;
    let mut fitted = String::new();
    analyse(&arguments.analysis, &mut |scenario, progress| {
        let fit = analyses::fit(scenario, &data, &arguments.free, progress)?;
        fitted = precess::scenario_toml(&fit.plan);
        Ok(fit.answer(&data))
    })?;
    save.map_or(Ok(()), |output| output.finish(|file| file.write_all(fitted.as_bytes())))
}

type Ask<'a> = &'a mut dyn FnMut(&Scenario, &mut dyn FnMut(f64) -> ControlFlow<()>) -> Result<Answer, Error>;

/// Asks, and puts the answer where it is wanted: a table to standard output where nothing else was asked for.
fn analyse(arguments: &Analysis, ask: Ask) -> Result<(), Failure> {
    let subject = &arguments.subject;
    let mut scenario = scenario(subject, arguments.method.as_deref())?;
    for given in &arguments.options {
        let (name, value) = assignment(given)?;
        Scenario::set(&mut scenario.run, name, value);
    }
    let mut file = None;
    let mut to_standard_output = subject.output.is_none() && subject.plot.is_none();
    match subject.output.as_deref() {
        None => {}
        Some(path) if path == Path::new("-") => to_standard_output = true,
        Some(path) if ["csv", "npz"].contains(&suffix(path).as_str()) => {
            file = Some((Output::create(path)?, suffix(path)));
        }
        Some(path) => return Err(unknown_suffix(path, "csv or npz")),
    }
    let plot = subject.plot.as_deref().map(open_plot).transpose()?;

    let mut progress = Progress::new(1.0, subject.quiet, &listen());
    let answer = ask(&scenario, &mut |share| progress.at(share));
    progress.finish();
    let answer = answer?;

    if to_standard_output {
        let mut out = BufWriter::new(io::stdout().lock());
        let written = table::csv(&mut out, &answer.table).and_then(|()| out.flush());
        written.map_err(|e| Failure::of_writing("standard output", &e))?;
    }
    match file {
        Some((output, suffix)) if suffix == "npz" => {
            output.finish(|file| table::arrays(file, &answer.table, &answer.figure.scenario))?;
        }
        Some((output, _)) => output.finish(|file| table::csv(file, &answer.table))?,
        None => {}
    }
    if let Some(plot) = plot {
        finish_plot(&answer.figure, plot)?;
    }
    if !subject.quiet {
        for line in &answer.summary {
            let _ = writeln!(io::stderr(), "  {line}");
        }
    }
    match answer.failure {
        Some(why) => Err(Failure::Failed(format!("{why}; what was found up to then is kept"))),
        None => Ok(()),
    }
}
