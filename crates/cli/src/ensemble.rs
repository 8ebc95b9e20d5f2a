//! `precess ensemble`: many members, in lanes and threads, with a checkpoint.

use crate::args;
use crate::failure::Failure;
use crate::list;
use crate::output::{Output, suffix};
use crate::progress::{Progress, listen};
use crate::run::{finish_plot, open_plot, unknown_suffix};
use crate::subject::{assignment, scenario};
use npyz::WriterBuilder;
use npyz::zip::write::FileOptions;
use precess::survey::{Checkpoint, Survey};
use precess::value::shortest;
use precess::{Scenario, Workers};
use std::io::{self, BufWriter, Seek, Write};
use std::path::{Path, PathBuf};
use std::time::Instant;

/// More members than this are asked about.
const MANY: usize = 2_000_000;

/// Runs an ensemble.
pub fn ensemble(arguments: &args::Ensemble) -> Result<(), Failure> {
    let subject = &arguments.analysis.subject;
    let mut scenario = scenario(subject, arguments.analysis.method.as_deref())?;
    for given in &arguments.analysis.options {
        let (name, value) = assignment(given)?;
        Scenario::set(&mut scenario.run, name, value);
    }
    let folder = Path::new(&subject.name).parent().unwrap_or(Path::new(""));
    let survey = Survey::new(&scenario, folder)?;
    let workers = Workers::chosen()?;
    if survey.members() > MANY && !arguments.yes {
        return Err(too_many(&survey, workers)?);
    }
    let place = subject.output.as_deref().filter(|path| *path != Path::new("-"));
    let nothing_else = subject.output.is_none() && subject.plot.is_none() && !arguments.hash;
    let to_standard_output = nothing_else || subject.output.is_some() && place.is_none();
    let (file, mut checkpoint) = match place {
        None => (None, scratch()?),
        Some(path) if ["csv", "npz"].contains(&suffix(path).as_str()) => {
            let output = Output::create(path)?;
            (Some((output, suffix(path))), Checkpoint::open(&beside(path), &survey.text())?)
        }
        Some(path) => return Err(unknown_suffix(path, "csv or npz")),
    };
    if to_standard_output && arguments.hash {
        return Err(Failure::Wrong(
            "--hash and a table would both write to standard output: choose one".into(),
        ));
    }

    let plot = subject.plot.as_deref().map(open_plot).transpose()?;
    if plot.is_some() {
        survey.has_map()?;
    }

    let began = Instant::now();
    let mut progress = Progress::new(1.0, subject.quiet, &listen());
    let (all, mut reached) = (survey.members(), 0);
    let done = survey.run(&mut checkpoint, workers, &mut |members| {
        reached = members;
        progress.at(members as f64 / all as f64)
    });
    progress.finish();
    if !done? {
        let sentence = match place {
            Some(path) => format!("the same command goes on from '{}'", beside(path).display()),
            None => "with -o FILE.npz it could have gone on later".into(),
        };
        return Err(Failure::Failed(format!("interrupted after {reached} of {all} members: {sentence}")));
    }

    if to_standard_output {
        let mut out = BufWriter::new(io::stdout().lock());
        let written = csv(&mut out, &survey, &mut checkpoint).and_then(|()| out.flush());
        written.map_err(|e| Failure::of_writing("standard output", &e))?;
    }
    match file {
        Some((output, suffix)) if suffix == "npz" => {
            output.finish(|file| npz(file, &survey, &mut checkpoint))?;
        }
        Some((output, _)) => output.finish(|file| csv(file, &survey, &mut checkpoint))?,
        None => {}
    }
    if let Some(plot) = plot {
        finish_plot(&survey.figure(&mut checkpoint)?, plot)?;
    }
    if arguments.hash {
        list::print(&format!("{}\n", survey.hash(&mut checkpoint)?))?;
    }
    if !subject.quiet {
        let lost = survey.lost(&mut checkpoint)?;
        let _ = writeln!(
            io::stderr(),
            "  {all} members of {} by {} in {:.2} s{}",
            survey.plan.card.id,
            survey.plan.method.card().id,
            began.elapsed().as_secs_f64(),
            if lost == 0 {
                String::new()
            } else {
                format!(", {lost} of which did not arrive (status below zero)")
            }
        );
    }
    checkpoint.remove();
    Ok(())
}

/// The checkpoint of an output file.
fn beside(path: &Path) -> PathBuf {
    let mut name = path.file_name().unwrap_or_default().to_os_string();
    name.push(".checkpoint");
    path.with_file_name(name)
}

/// A checkpoint without a name, which goes away with the program: what nobody keeps need not fit the memory either.
fn scratch() -> Result<Checkpoint, Failure> {
    let file = tempfile::tempfile().map_err(|e| Failure::of_writing("a temporary file", &e))?;
    Ok(Checkpoint::scratch(file))
}

/// What a very large ensemble would cost, from its first members.
fn too_many(survey: &Survey, workers: Workers) -> Result<Failure, Failure> {
    let began = Instant::now();
    let tried = survey.pilot(workers)?;
    let members = survey.members();
    let hours =
        began.elapsed().as_secs_f64() * members as f64 / tried as f64 / workers.threads as f64 / 3600.0;
    let bytes = 8.0 * members as f64 * survey.columns.len() as f64;
    Ok(Failure::Wrong(format!(
        "{members} members would take about {hours:.1} hours and {:.1} GB of disk: --yes goes on",
        2.0 * bytes / 1e9
    )))
}

fn failed(error: &precess::Error) -> io::Error {
    io::Error::other(error.to_string())
}

fn csv(out: &mut impl Write, survey: &Survey, checkpoint: &mut Checkpoint) -> io::Result<()> {
    writeln!(out, "{}", survey.columns.join(","))?;
    let mut written = Ok(());
    let mut row = |numbers: &[f64]| {
        if written.is_ok() {
            let row: Vec<String> = numbers.iter().map(|x| shortest(*x)).collect();
            written = writeln!(out, "{}", row.join(","));
        }
    };
    survey.rows(checkpoint, &mut row).map_err(|e| failed(&e))?;
    written
}

/// One array a column, read from the checkpoint chunk by chunk; `scenario`, `version`.
fn npz(out: &mut (impl Write + Seek), survey: &Survey, checkpoint: &mut Checkpoint) -> io::Result<()> {
    let mut archive = npyz::npz::NpzWriter::new(out);
    let mut count = 0;
    survey.rows(checkpoint, &mut |_| count += 1).map_err(|e| failed(&e))?;
    for (k, name) in survey.columns.iter().enumerate() {
        let mut array =
            archive.array(name, FileOptions::default())?.default_dtype().shape(&[count]).begin_nd()?;
        let mut written = Ok(());
        let mut row = |numbers: &[f64]| {
            if written.is_ok() {
                written = array.push(&numbers[k]);
            }
        };
        survey.rows(checkpoint, &mut row).map_err(|e| failed(&e))?;
        written?;
        array.finish()?;
    }
    for (name, text) in [("scenario", survey.toml()), ("version", env!("CARGO_PKG_VERSION").into())] {
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
