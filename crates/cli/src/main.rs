//! Precess in the terminal: a thin face over the `precess` crate.

mod analyse;
mod args;
mod basins;
mod bench;
mod body;
mod compare;
mod draw;
mod ensemble;
mod failure;
mod gallery;
mod lab;
mod list;
mod measured;
mod output;
mod progress;
mod run;
mod show;
mod subject;
mod summary;
mod table;

use args::{Command, Verb};
use clap::Parser;
use std::process::ExitCode;

fn main() -> ExitCode {
    // Clap prints its own sentence (with the nearest word) and exits with 2 on a wrong command.
    let command = Command::parse();
    let outcome = match command.verb {
        Verb::List { what, json } => list::list(what, json),
        Verb::Show { system, json, latex } => show::show(&system, json, latex),
        Verb::Body(arguments) => body::body(&arguments),
        Verb::Run(arguments) => run::run(&arguments),
        Verb::Compare(arguments) => compare::compare(&arguments),
        Verb::Trust(arguments) => analyse::trust(&arguments),
        Verb::Lyapunov(arguments) => analyse::lyapunov(&arguments),
        Verb::Poincare(arguments) => analyse::poincare(&arguments),
        Verb::Ensemble(arguments) => ensemble::ensemble(&arguments),
        Verb::Basins(arguments) => basins::basins(&arguments),
        Verb::Portrait(arguments) => analyse::portrait(&arguments),
        Verb::Response(arguments) => analyse::response(&arguments),
        Verb::Bifurcation(arguments) => analyse::bifurcation(&arguments),
        Verb::Floquet(arguments) => analyse::floquet(&arguments),
        Verb::Frenet(arguments) => analyse::frenet(&arguments),
        Verb::Gallery(arguments) => gallery::gallery(&arguments),
        Verb::Sensitivity(arguments) => analyse::sensitivity(&arguments),
        Verb::Fit(arguments) => analyse::fit(&arguments),
        Verb::Bench(arguments) => bench::bench(&arguments),
        Verb::Lab { port } => lab::lab(port),
    };
    match outcome {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => failure.report(),
    }
}
