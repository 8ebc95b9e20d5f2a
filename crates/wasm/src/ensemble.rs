//! A scenario's text and its starts to an ensemble.

use crate::kept::Kept;
use crate::run::plan;
use crate::{memory, report};
use precess::scalar::Isa;
use precess::{Axis, Keep, Plan, Workers, combinations, grid};
use std::ops::ControlFlow;

/// What the host asks for.
pub struct Request<'a> {
    /// The scenario (TOML).
    pub scenario: &'a str,
    /// Names of initial values, one a line.
    pub names: &'a str,
    /// The values of each start in the order of the names, or the axes.
    pub numbers: &'a [f64],
    /// Whether the numbers are axes: six for each name, see [`Side`].
    pub grid: bool,
    /// Whether every sample is kept.
    pub samples: bool,
    /// Whether one number is computed at a time, not a register of them.
    pub plain: bool,
}

/// A side of a tile: of an axis's points those numbered `first`, `first + stride` and so on. A picture that is first
/// coarse and then refined needs each point once, and a start has the same bits in whatever tile it is asked for.
pub struct Side {
    pub axis: Axis,
    first: usize,
    stride: usize,
    count: usize,
}

/// Numbers that a failure takes, at most.
const FAILURE: f64 = 6.0;

/// Runs a scenario from many starts. `watch` is told how many members are done and says whether to go on.
pub fn ensemble(request: &Request, watch: &mut dyn FnMut(f64) -> bool) -> Result<(Kept, String), String> {
    let plan = plan(request.scenario)?;
    let names: Vec<&str> = request.names.lines().collect();
    let fits = |members| fits(&plan, request, members);
    let starts = if request.grid {
        let sides = sides(&names, request.numbers)?;
        tile(&plan, &names, &sides, fits)
    } else {
        list(&plan, &names, request.numbers, fits)
    }?;
    let workers = Workers { isa: if request.plain { Isa::Scalar } else { Isa::best() }, threads: 1 };
    let keep = if request.samples { Keep::Samples } else { Keep::Last };
    let mut progress = |done: usize| {
        if watch(done as f64) { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
    };
    let members =
        precess::ensemble(&plan, &starts, keep, workers, &mut progress).map_err(|e| e.to_string())?;
    let report = report::ensemble(&plan, &members).to_string();
    Ok((Kept::from(members), report))
}

/// Starts one by one.
fn list(
    plan: &Plan,
    names: &[&str],
    numbers: &[f64],
    fits: impl FnOnce(f64) -> Result<(), String>,
) -> Result<Vec<f64>, String> {
    if names.is_empty() || numbers.is_empty() || !numbers.len().is_multiple_of(names.len()) {
        return Err(format!("{} numbers are no values of {}", numbers.len(), names.join(", ")));
    }
    fits((numbers.len() / names.len()) as f64)?;
    let mut rows = numbers.chunks(names.len()).map(<[f64]>::to_vec);
    precess::starts(plan, names, &mut rows).map_err(|e| e.to_string())
}

/// The sides of a tile, from six numbers for each name.
pub fn sides(names: &[&str], numbers: &[f64]) -> Result<Vec<Side>, String> {
    let (sixes, rest) = numbers.as_chunks();
    if names.is_empty() || sixes.len() != names.len() || !rest.is_empty() {
        return Err(format!("{} numbers are no axes of {}", numbers.len(), names.join(", ")));
    }
    names.iter().zip(sixes).map(|(name, six)| side(name, six)).collect()
}

/// Starts on a tile of a grid. The first axis runs fastest.
pub fn tile(
    plan: &Plan,
    names: &[&str],
    sides: &[Side],
    fits: impl FnOnce(f64) -> Result<(), String>,
) -> Result<Vec<f64>, String> {
    // The corner of the whole grid tells of wrong names, values and axes without points.
    let corner =
        sides.iter().map(|side| Axis { points: usize::from(side.axis.points > 0), ..side.axis.clone() });
    grid(plan, &corner.collect::<Vec<_>>()).map_err(|e| e.to_string())?;
    for Side { axis, first, stride, count } in sides {
        let last =
            count.checked_sub(1).and_then(|n| n.checked_mul(*stride)).and_then(|n| n.checked_add(*first));
        if last.is_none_or(|last| last >= axis.points) {
            return Err(format!(
                "of the {} points of {} there are no {count} from number {first} on, {stride} apart",
                axis.points, axis.name
            ));
        }
    }
    fits(sides.iter().map(|side| side.count as f64).product())?;
    let values = |Side { axis, first, stride, count }: &Side| {
        (0..*count).map(|k| axis.value(first + stride * k)).collect()
    };
    let sides: Vec<Vec<f64>> = sides.iter().map(values).collect();
    precess::starts(plan, names, &mut combinations(&sides)).map_err(|e| e.to_string())
}

fn side(name: &str, &[low, high, points, first, stride, count]: &[f64; 6]) -> Result<Side, String> {
    for x in [points, first, stride, count] {
        if x.fract() != 0.0 || !(0.0..=f64::from(u32::MAX)).contains(&x) {
            return Err(format!("the points along {name} are counted by whole numbers, not by {x}"));
        }
    }
    let axis = Axis { name: name.into(), low, high, points: points as usize };
    Ok(Side { axis, first: first as usize, stride: stride as usize, count: count as usize })
}

/// Whether starts and results find room; the results are put together from those of the blocks.
fn fits(plan: &Plan, request: &Request, members: f64) -> Result<(), String> {
    let kept = if request.samples { plan.until.abs() / plan.every + 2.0 } else { 1.0 };
    let start = plan.start.len() as f64;
    memory::fits(members * (start + 2.0 * kept * start + FAILURE), || {
        let hint = if request.samples { ", make 'every' longer, or keep the ends alone" } else { "" };
        format!("{members} starts do not fit into the memory of this page: take smaller tiles{hint}")
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::kept::Table;

    const MAGNETS: &str = "precess = 1\n[system]\nid = \"magnetic_pendulum\"\n[run]\nmethod = \"rk4\"\ndt = 0.01\n\
                           until = 1\nevery = 0.5\n";
    const GRID: Request = Request {
        scenario: MAGNETS,
        names: "x\ny",
        numbers: &[-1.0, 1.0, 5.0, 0.0, 1.0, 5.0, -2.0, 2.0, 3.0, 0.0, 1.0, 3.0],
        grid: true,
        samples: false,
        plain: false,
    };

    fn done(request: &Request) -> Kept {
        ensemble(request, &mut |_| true).unwrap_or_else(|sentence| panic!("{sentence}")).0
    }
    fn refusal(request: &Request) -> String {
        ensemble(request, &mut |_| true).err().expect("a refusal")
    }

    #[test]
    fn a_grid_is_the_grid_of_the_library() {
        let plan = plan(MAGNETS).expect("a scenario");
        let axis = |name: &str, low, high, points| Axis { name: name.into(), low, high, points };
        let starts = grid(&plan, &[axis("x", -1.0, 1.0, 5), axis("y", -2.0, 2.0, 3)]).expect("a grid");
        let names = ["x", "y"];
        let sides = sides(&names, GRID.numbers).expect("sides");
        assert_eq!(tile(&plan, &names, &sides, |_| Ok(())), Ok(starts.clone()));
        let values: Vec<f64> = starts.chunks(4).flat_map(|start| [start[0], start[1]]).collect();
        assert_eq!(list(&plan, &names, &values, |_| Ok(())), Ok(starts));
    }

    #[test]
    fn a_tile_has_the_numbers_of_the_whole() {
        let whole = done(&GRID);
        let odd = [-1.0, 1.0, 5.0, 1.0, 2.0, 2.0, -2.0, 2.0, 3.0, 2.0, 1.0, 1.0];
        let part = done(&Request { numbers: &odd, ..GRID });
        let whole: Vec<&[f64]> = whole.table(Table::Numbers).chunks(4).collect();
        assert_eq!(part.table(Table::Numbers), [whole[11], whole[13]].concat());
    }

    #[test]
    fn failures_are_listed_and_told() {
        let fast = MAGNETS.replace("0.01", "0.5");
        let numbers = [1.7e308, 1.7e308, 0.0, 1.0];
        let (scenario, names) = (fast.as_str(), "x\nx_dot");
        let request = Request { scenario, names, numbers: &numbers, grid: false, samples: true, ..GRID };
        let kept = done(&request);
        assert_eq!(kept.table(Table::Times), [0.0, 0.5, 1.0]);
        assert_eq!(kept.table(Table::Failed), [0.0]);
        assert!(kept.failure(0).is_some_and(|sentence| sentence.contains("no longer finite")));
        assert_eq!(kept.failure(1), None);
        assert_eq!(kept.hash(2), None);
    }

    #[test]
    fn work_that_is_ended_leaves_interrupted_members() {
        let (kept, report) = ensemble(&GRID, &mut |done| done < 1.0).expect("an ensemble");
        assert!(report.contains("\"members\":15,"), "{report}");
        // All fifteen fit into one block, so none is left.
        assert_eq!(kept.table(Table::Failed).len(), if Isa::best().lanes() > 1 { 0 } else { 7 });
    }

    #[test]
    fn what_makes_no_sense_is_refused() {
        let with = |numbers: &[f64]| refusal(&Request { numbers, ..GRID });
        let numbers = |k: usize, x: f64| {
            let mut numbers = GRID.numbers.to_vec();
            numbers[k] = x;
            numbers
        };
        assert_eq!(with(&[1.0]), "1 numbers are no axes of x, y");
        assert_eq!(with(&numbers(2, 0.0)), "the grid along x has no points");
        assert_eq!(with(&numbers(2, 2.5)), "the points along x are counted by whole numbers, not by 2.5");
        assert_eq!(with(&numbers(1, f64::NAN)), "x cannot start at NaN");
        assert_eq!(with(&numbers(3, 1.0)), "of the 5 points of x there are no 5 from number 1 on, 1 apart");
        let huge = [-1.0, 1.0, 1e6, 0.0, 1.0, 1e6, -2.0, 2.0, 1e6, 0.0, 1.0, 1e6];
        assert!(with(&huge).starts_with("1000000000000 starts do not fit"), "{}", with(&huge));
        assert!(refusal(&Request { names: "x\nz", ..GRID }).contains("no start of magnetic_pendulum 'z'"));
        let listed = Request { numbers: &[1.0, 2.0, 3.0], grid: false, ..GRID };
        assert_eq!(refusal(&listed), "3 numbers are no values of x, y");
        assert_eq!(refusal(&Request { numbers: &[1.0, f64::INFINITY], ..listed }), "y cannot start at inf");
        let watched = format!("{MAGNETS}[[event]]\nname = \"there\"\nwhen = \"x = 0\"\n");
        assert!(refusal(&Request { scenario: &watched, ..GRID }).contains("watches no events"));
    }
}
