//! What is to be run: a system or a scenario file, and what the command line sets on top.

use crate::args::Subject;
use crate::failure::{Failure, reason};
use precess::value::{self, Value};
use precess::{Error, Scenario};
use std::io::Read;

/// The scenario of a subject.
pub fn scenario(subject: &Subject, method: Option<&str>) -> Result<Scenario, Failure> {
    let name = &subject.name;
    let is_file = name == "-" || name.contains(['/', '\\']) || name.to_lowercase().ends_with(".toml");
    let mut scenario =
        if is_file { Scenario::parse(&read(name)?).map_err(|e| e.at(name))? } else { Scenario::of(name) };
    if let Some(method) = method {
        // The file's settings may be for another method; those of the command line, below, are for this one.
        scenario = scenario.by(method)?;
    }
    for given in &subject.parameters {
        let (name, value) = assignment(given)?;
        Scenario::set(&mut scenario.parameters, name, value);
    }
    for given in &subject.initial {
        let (name, value) = assignment(given)?;
        Scenario::set(&mut scenario.start, name, value);
    }
    let settings = [
        ("dt", &subject.dt),
        ("rtol", &subject.rtol),
        ("atol", &subject.atol),
        ("until", &subject.until),
        ("every", &subject.every),
    ];
    for (name, text) in settings {
        if let Some(text) = text {
            let value = value::parse(text).map_err(|e| e.at(&format!("--{name}")))?;
            Scenario::set(&mut scenario.run, name, value);
        }
    }
    Ok(scenario)
}

/// `NAME=VALUE`.
pub fn assignment(text: &str) -> Result<(&str, Value), Failure> {
    let Some((name, value)) = text.split_once('=') else {
        return Err(Failure::Wrong(format!("'{text}' is no NAME=VALUE, such as theta=0.1")));
    };
    let value = value::parse(value).map_err(|e| e.at(name.trim()))?;
    Ok((name.trim(), value))
}

fn read(name: &str) -> Result<String, Failure> {
    let unreadable = |e: &std::io::Error| Failure::Wrong(format!("cannot read '{name}': {}", reason(e)));
    let mut bytes = vec![];
    // One byte more than a scenario may have is enough to refuse it: a device never ends.
    let most = Scenario::LARGEST as u64 + 1;
    if name == "-" {
        std::io::stdin().take(most).read_to_end(&mut bytes).map_err(|e| unreadable(&e))?;
    } else {
        match std::fs::File::open(name).and_then(|file| file.take(most).read_to_end(&mut bytes)) {
            Ok(_) => {}
            // A scenario that comes with the program needs no file.
            Err(error) => match precess::scenarios::find(name) {
                Some(built_in) => return Ok(built_in.into()),
                None => return Err(unreadable(&error)),
            },
        }
    }
    let text = String::from_utf8(bytes);
    text.map_err(|_| Failure::from(Error::Input("that is no text (UTF-8)".into()).at(name)))
}
