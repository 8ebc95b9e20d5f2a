//! The work that `web/bench` times in the browser, done natively with registers of the same width.

use precess::scalar::Isa;
use precess::{Axis, Keep, Plan, Scenario, Workers, ensemble, grid};
use std::error::Error;
use std::ops::ControlFlow;
use std::time::Instant;

/// Arguments: the file of the scenario, points along an axis, what to compute in (`sse2`, `scalar`). Prints the seconds
/// as JSON, and the hash of every member.
fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [file, points, isa] = arguments.as_slice() else {
        return Err("usage: exercise_7_5 SCENARIO POINTS REGISTERS".into());
    };
    let plan = Plan::new(&Scenario::parse(&std::fs::read_to_string(file)?)?)?;
    let points = points.parse()?;
    let axis = |name: &str| Axis { name: name.into(), low: -2.0, high: 2.0, points };
    let starts = grid(&plan, &[axis("x"), axis("y")])?;
    let workers = Workers { isa: Isa::named(isa)?, threads: 1 };
    let begun = Instant::now();
    let members = ensemble(&plan, &starts, Keep::Last, workers, &mut |_| ControlFlow::Continue(()))?;
    let seconds = begun.elapsed().as_secs_f64();
    let hashes: Vec<String> = (0..points * points).map(|k| members.hash(k)).collect();
    println!("{{\"seconds\":{seconds},\"hashes\":{hashes:?}}}");
    Ok(())
}
