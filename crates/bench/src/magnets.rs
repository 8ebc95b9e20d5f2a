//! Program 7.5 of P: a pendulum over three magnets from every point of a square, step by step as P's own loop does it.
//!
//! A step has three roots, each followed by a division, and little else: the divider of the machine bounds it (see
//! [`limits`](crate::limits)).

use crate::clock::shortest;
use crate::lanes::{run, same_bits};
use crate::peer::Answer;
use crate::positions::{largest_distance, settled, twins};
use crate::{Column, Error, Kind, Settings, Table, limits};
use precess::scalar::Isa;
use precess::{Axis, Members, Plan, Scenario, grid};

/// The exercise; the number of steps is set beside it.
const EXERCISE: &str = r#"
precess = 1
[system]
id = "magnetic_pendulum"
parameters = { c = 4, r = 0.2, d = 0.1 }
[start]
x_dot = 0
y_dot = 0
[run]
method = "euler_taylor"
dt = 1e-4
"#;
const DT: f64 = 1e-4;
/// Roots followed by divisions in a step.
const ROOTS: f64 = 3.0;

fn plan(steps: u32) -> Result<Plan, Error> {
    let until = f64::from(steps) * DT;
    Ok(Plan { until, every: until, ..Plan::new(&Scenario::parse(EXERCISE)?)? })
}

/// The points of the square, x running fastest: the order of the peers.
fn square(plan: &Plan, side: usize) -> Result<Vec<f64>, Error> {
    let axis = |name: &str| Axis { name: name.into(), low: -2.0, high: 2.0, points: side };
    Ok(grid(plan, &[axis("x"), axis("y")])?)
}

/// Final positions: pairs x, y.
fn positions(members: &Members) -> Vec<[f64; 2]> {
    members.numbers.chunks(members.state).map(|state| [state[0], state[1]]).collect()
}

/// The shortest times, in seconds, and what came out.
struct Raced {
    /// Ours by one thread, ours by two, the peers.
    times: [Vec<f64>; 3],
    ours: Vec<[f64; 2]>,
    theirs: Vec<Answer>,
}

/// All take turns: every set of registers by one thread and by two, and every peer.
fn race(settings: &Settings, progress: &mut dyn FnMut(&str)) -> Result<Raced, Error> {
    let (isas, peers, effort) = (&settings.isas, &settings.peers, settings.effort);
    let plan = plan(effort.steps)?;
    let starts = square(&plan, effort.side)?;
    let plain = run(&plan, &starts, isas[0], 1)?.1;
    let mut theirs = vec![Answer::default(); peers.len()];
    let ours = isas.len();
    let mut best = shortest(effort.rounds, 2 * ours + peers.len(), |k| {
        if let Some(peer) = k.checked_sub(2 * ours) {
            progress(&format!("magnets: {}", peers[peer].name));
            theirs[peer] = peers[peer].run(effort.side, effort.steps)?;
            return Ok(theirs[peer].seconds);
        }
        let (isa, threads) = (isas[k % ours], 1 + k / ours);
        progress(&format!("magnets: {}", isa.name()));
        let (taken, members) = run(&plan, &starts, isa, threads)?;
        same_bits("magnets", isa, &members, &plain)?;
        Ok(taken)
    })?;
    let peers = best.split_off(2 * ours);
    let two = best.split_off(ours);
    Ok(Raced { times: [best, two, peers], ours: positions(&plain), theirs })
}

/// The exercise, and how close to the limit of the machine.
pub fn measure(settings: &Settings, progress: &mut dyn FnMut(&str)) -> Result<Vec<Table>, Error> {
    progress("magnets: limits");
    let limits = limits::roots_then_divisions(settings)?;
    let raced = race(settings, progress)?;
    let (side, steps) = (settings.effort.side, settings.effort.steps);
    let title = format!("{side} x {side} starts, {steps} steps, a point and step, ratio to plain numbers");
    let columns = vec![
        Column::new("ratio", "to scalar", Kind::Ratio),
        Column::new("two_threads_ratio", "two threads to one", Kind::Ratio),
        Column::new("share", "of the limit", Kind::Share),
        Column::new("ns", "ns", Kind::Number),
    ];
    let mut table = Table::new("magnets", title, columns);
    let [one, two, _] = &raced.times;
    for (k, isa) in settings.isas.iter().enumerate() {
        let ns = nanoseconds(settings, one[k]);
        let cells = [one[0] / one[k], one[k] / two[k], ROOTS / limits[k] / ns, ns];
        table.row(isa.name(), cells.map(Some));
    }
    table.notes.push(format!("The limit: {ROOTS} roots, each followed by a division, on one core."));
    table.notes.push("Every set of registers gives the same bits.".into());
    if settings.peers.is_empty() {
        return Ok(vec![table]);
    }
    Ok(vec![table, against_peers(settings, &raced)])
}

fn nanoseconds(settings: &Settings, seconds: f64) -> f64 {
    let points = (settings.effort.side * settings.effort.side) as f64;
    seconds * 1e9 / (points * f64::from(settings.effort.steps))
}

fn against_peers(settings: &Settings, raced: &Raced) -> Table {
    let peers = &settings.peers;
    let ratio = |isa: &Isa| Column::new(format!("{}_ratio", isa.name()), isa.name(), Kind::Ratio);
    let mut columns: Vec<Column> = settings.isas.iter().map(ratio).collect();
    columns.push(Column::new("ns", "ns", Kind::Number));
    columns.push(Column::new("distance", "distance", Kind::Distance));
    let title = "how many times as fast as other programs these lanes are, all on one thread";
    let mut table = Table::new("peers", title, columns);
    let mut counted = vec![true; raced.ours.len()];
    if let Some((one, other)) = twins(peers) {
        counted = settled(&raced.theirs[one].positions, &raced.theirs[other].positions);
        table.notes.push(format!(
            "Distance: the largest between final positions, at the {} of {} points where {} and {} agree to 1e-12.",
            counted.iter().filter(|counted| **counted).count(),
            counted.len(),
            peers[one].name,
            peers[other].name
        ));
    } else {
        table.notes.push("Distance: the largest between final positions.".into());
    }
    let [ours, _, theirs] = &raced.times;
    for ((peer, answer), time) in peers.iter().zip(&raced.theirs).zip(theirs) {
        let distance = largest_distance(&raced.ours, &answer.positions, &counted);
        let ratios = ours.iter().map(|ours| time / ours);
        table.row(&peer.name, ratios.chain([nanoseconds(settings, *time), distance]).map(Some));
        table.notes.push(format!("{}: {}.", peer.name, answer.title));
    }
    table
}
