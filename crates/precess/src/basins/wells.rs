//! Wells of a potential, and how high one has to climb to leave them.
//!
//! A motion whose energy sinks and has sunk below the lowest pass of the well it is in never leaves it. Minima are found
//! by descending; a pass by filling the well on a grid until it overflows, cell by cell from the lowest on, and then by
//! Newton's method from the highest cell of the way out; grids are made finer until two passes agree.

use super::ground::{Ground, turned};
use super::matrix::{is_positive, jacobian};
use std::cmp::Reverse;
use std::collections::btree_map::Entry;
use std::collections::{BTreeMap, BinaryHeap};

/// This share of a well's depth below the pass is left unused: it covers errors of the energy and of the pass.
const MARGIN: f64 = 1e-3;
/// Cells that are filled before a well counts as one without a pass that matters.
const MOST_CELLS: usize = 40_000;
/// Water that has run so many times the range of the starts finds no bottom.
const FARTHEST: f64 = 1e3;
/// Points along a line that leads down.
const ALONG: usize = 32;
/// Two passes that agree to this share of the depth are one.
const AGREE: f64 = 1e-8;

pub(super) struct Well {
    /// The coordinates of its lowest point, in the first turn.
    pub place: Vec<f64>,
    pub floor: f64,
    /// Below this energy nothing leaves.
    pub pass: f64,
    /// The coordinates of the pass; none where the filling did not overflow.
    pub saddle: Option<Vec<f64>>,
    /// Where the slope has doubled: the scale of each coordinate.
    unit: Vec<f64>,
}

/// The minima that descents from all over the range of the starts reach.
pub(super) fn minima(ground: &Ground) -> Vec<Vec<f64>> {
    let d = ground.coordinates;
    let side = match d {
        1 => 64_usize,
        2 => 12,
        _ => 5,
    };
    let mut found: Vec<Vec<f64>> = vec![];
    let count = (0..d).fold(1, |count, _| count * side);
    for mut index in 0..count {
        let mut q = vec![];
        for &(low, high) in &ground.range[..d] {
            q.push(low + (high - low) * ((index % side) as f64 + 0.5) / side as f64);
            index /= side;
        }
        if let Some(q) = descend(ground, &q, &ground.unit[..d], 0.05) {
            add(ground, &mut found, &q);
        }
    }
    found
}

/// Adds a minimum that is new; both are told by their images in the first turn.
pub(super) fn add(ground: &Ground, found: &mut Vec<Vec<f64>>, q: &[f64]) -> bool {
    let q = ground.first_turn(q);
    let known = |p: &Vec<f64>| {
        let turns = ground.turns_between(p, &q);
        ground.distance(&turned(p, &turns), &q) < 1e-6
    };
    let new = !found.iter().any(known);
    if new {
        found.push(q);
    }
    new
}

/// Downhill in steps of at most `h` units (longer ones far from the starts) to a minimum; none where there is none.
pub(super) fn descend(ground: &Ground, q: &[f64], unit: &[f64], h: f64) -> Option<Vec<f64>> {
    let size = |d: &[f64]| {
        d.iter().zip(unit).fold(0.0, |most, (d, u)| if (d / u).abs() > most { (d / u).abs() } else { most })
    };
    let middle: Vec<f64> = ground.range[..q.len()].iter().map(|(low, high)| 0.5 * (low + high)).collect();
    let (mut q, mut length) = (q.to_vec(), h);
    let mut height = ground.potential(&q);
    for step in 0..1000 {
        let turns = ground.turns_between(&middle, &q);
        let far = ground.distance(&turned(&middle, &turns), &q);
        if far > FARTHEST {
            return None;
        }
        let h = if far > 1.0 { h * far } else { h };
        let force = ground.force(&q);
        let strength = size(&force);
        if !strength.is_finite() || !height.is_finite() {
            return None;
        }
        if (length < 0.1 * h || step % 16 == 15 || strength == 0.0)
            && let Some(root) = ground.root(&q, &|q| Some(ground.force(q)))
        {
            let way: Vec<f64> = root.iter().zip(&q).map(|(a, b)| a - b).collect();
            if size(&way) <= h
                && ground.potential(&root) <= height + 1e-12 * height.abs()
                && is_minimum(ground, &root)
            {
                return Some(root);
            }
        }
        if strength == 0.0 || length < 1e-12 {
            return None;
        }
        let next: Vec<f64> = q.iter().zip(&force).map(|(q, f)| q + f / strength * length).collect();
        let lower = ground.potential(&next);
        if lower < height {
            (q, height) = (next, lower);
            length = if 2.0 * length < h { 2.0 * length } else { h };
        } else {
            length *= 0.5;
        }
    }
    None
}

/// Second derivatives of the potential.
fn curvature(ground: &Ground, q: &[f64]) -> Option<Vec<Vec<f64>>> {
    let slope = |q: &[f64]| {
        Some(jacobian(q, &ground.unit, 1e-4, |q| Some(vec![ground.potential(q)]))?.swap_remove(0))
    };
    jacobian(q, &ground.unit, 1e-4, slope)
}

fn is_minimum(ground: &Ground, q: &[f64]) -> bool {
    curvature(ground, q).is_some_and(|c| is_positive(&c))
}

impl Well {
    /// The well of a minimum among others.
    pub fn new(ground: &Ground, place: &[f64], others: &[Vec<f64>]) -> Option<Self> {
        let curvature = curvature(ground, place)?;
        let unit: Vec<f64> = (0..place.len()).map(|i| 1.0 / curvature[i][i].sqrt()).collect();
        let floor = ground.potential(place);
        let mut well = Self { place: place.to_vec(), floor, pass: f64::NAN, saddle: None, unit };
        let mut h = well.nearest(ground, others) / 8.0;
        let mut last: Option<(f64, Option<Vec<f64>>)> = None;
        for _ in 0..6 {
            let found = well.fill(ground, h)?;
            let agree = last.as_ref().is_some_and(|(pass, saddle)| {
                saddle.is_some() && found.1.is_some() && (pass - found.0).abs() <= AGREE * (found.0 - floor)
            });
            // Where nothing overflows, the lower of two fillings is safe; otherwise an overflow counts more.
            let lower =
                last.filter(|(pass, saddle)| saddle.is_some() == found.1.is_some() && *pass < found.0);
            let both_dry = found.1.is_none() && well.pass.is_finite();
            let best = lower.unwrap_or(found);
            well.pass = best.0;
            well.saddle.clone_from(&best.1);
            if agree || both_dry {
                break;
            }
            last = Some(best);
            h *= 0.5;
        }
        well.pass -= MARGIN * (well.pass - floor);
        Some(well)
    }

    fn units(&self, a: &[f64], b: &[f64]) -> f64 {
        a.iter().zip(b).zip(&self.unit).fold(0.0, |most, ((a, b), unit)| {
            let x = (a - b).abs() / unit;
            if x > most { x } else { most }
        })
    }

    /// The way to the nearest other minimum (or its own next image), in units; the range of the starts where there is none.
    fn nearest(&self, ground: &Ground, others: &[Vec<f64>]) -> f64 {
        let mut least = f64::INFINITY;
        for other in others {
            for shift in -1..=1 {
                let turns: Vec<i32> =
                    ground.turning.iter().map(|&turning| i32::from(turning) * shift).collect();
                let far = self.units(&turned(other, &turns), &self.place);
                if far > 1e-6 && far < least {
                    least = far;
                }
            }
        }
        if least.is_finite() {
            return least;
        }
        let sides = ground.range.iter().zip(&self.unit).map(|((low, high), unit)| (high - low) / unit);
        sides.fold(0.0, |most, side| if side > most { side } else { most })
    }

    /// Fills the well in cells of `h` units: the height where it overflows, and the saddle there; the height of the
    /// filling where it does not.
    fn fill(&self, ground: &Ground, h: f64) -> Option<(f64, Option<Vec<f64>>)> {
        let d = self.place.len();
        let at = |cell: &[i32]| -> Vec<f64> {
            (0..d).map(|i| self.place[i] + h * self.unit[i] * f64::from(cell[i])).collect()
        };
        let origin = vec![0; d];
        let mut parent: BTreeMap<Vec<i32>, Vec<i32>> = BTreeMap::from([(origin.clone(), origin.clone())]);
        let mut rim = BinaryHeap::from([Reverse((Height(self.floor), origin))]);
        let mut level = self.floor;
        while let Some(Reverse((Height(height), cell))) = rim.pop() {
            if parent.len() > MOST_CELLS {
                return Some((level, None));
            }
            if height < level - 1e-9 * (level - self.floor) && self.leaves(ground, &at(&cell), h) {
                return Some(self.overflow(ground, h, level, &cell, &parent, &at));
            }
            level = if height > level { height } else { level };
            for neighbour in neighbours(&cell) {
                let Entry::Vacant(place) = parent.entry(neighbour) else { continue };
                let height = ground.potential(&at(place.key()));
                if height.is_nan() {
                    return None;
                }
                rim.push(Reverse((Height(height), place.key().clone())));
                place.insert(cell.clone());
            }
        }
        None
    }

    /// Whether a place leads elsewhere.
    fn leaves(&self, ground: &Ground, q: &[f64], h: f64) -> bool {
        descend(ground, q, &self.unit, h).is_none_or(|end| self.units(&end, &self.place) > 1e-4)
    }

    /// The pass on the way from the floor to a cell beyond.
    fn overflow(
        &self,
        ground: &Ground,
        h: f64,
        level: f64,
        cell: &[i32],
        parent: &BTreeMap<Vec<i32>, Vec<i32>>,
        at: &dyn Fn(&[i32]) -> Vec<f64>,
    ) -> (f64, Option<Vec<f64>>) {
        let mut here = cell.to_vec();
        let mut highest = (f64::NEG_INFINITY, here.clone());
        while parent[&here] != here {
            let height = ground.potential(&at(&here));
            if height > highest.0 {
                highest = (height, here.clone());
            }
            here.clone_from(&parent[&here]);
        }
        let top = at(&highest.1);
        let saddle = ground.root(&top, &|q| Some(ground.force(q))).filter(|saddle| {
            let height = ground.potential(saddle);
            self.units(saddle, &top) < 4.0 * h
                && height <= level
                && height > self.floor
                && !is_minimum(ground, saddle)
        });
        match saddle {
            Some(saddle) => (ground.potential(&saddle), Some(saddle)),
            // No smooth pass: well below the lowest cells of the way out.
            None => (self.floor + 0.9 * (level - self.floor), None),
        }
    }

    /// How far the nearest image of its lowest point is.
    pub fn distance(&self, ground: &Ground, q: &[f64]) -> f64 {
        let turns = ground.turns_between(&self.place, q);
        ground.distance(&turned(&self.place, &turns), q)
    }

    /// The turns to the image of this well that holds a motion of this energy at a place: below the pass, with a straight
    /// line that leads down all the way. None where that is not so.
    pub fn holds(&self, ground: &Ground, q: &[f64], energy: f64) -> Option<Vec<i32>> {
        let sunk = energy < self.pass;
        if !sunk {
            return None;
        }
        let turns = ground.turns_between(&self.place, q);
        let floor = turned(&self.place, &turns);
        let mut last = ground.potential(q);
        for k in 1..=ALONG {
            let s = k as f64 / ALONG as f64;
            let between: Vec<f64> = q.iter().zip(&floor).map(|(q, f)| q + (f - q) * s).collect();
            let height = ground.potential(&between);
            // Below the pass is not enough: a flat hilltop may hide between two points that are.
            let falls = height <= last + 1e-12 * (self.pass - self.floor);
            if !falls {
                return None;
            }
            last = height;
        }
        Some(turns)
    }

    /// The same for a place from which water runs down to `end`.
    pub fn drains(&self, ground: &Ground, end: &[f64], energy: f64) -> Option<Vec<i32>> {
        let turns = ground.turns_between(&self.place, end);
        let here = self.units(&turned(&self.place, &turns), end) < 1e-4;
        (here && energy < self.pass).then_some(turns)
    }
}

fn neighbours(cell: &[i32]) -> Vec<Vec<i32>> {
    let count = cell.iter().fold(1, |count, _| count * 3);
    let neighbour = |mut index: i32| {
        let shift = |x: &i32| {
            let shifted = x + index % 3 - 1;
            index /= 3;
            shifted
        };
        cell.iter().map(shift).collect()
    };
    (0..count).map(neighbour).collect()
}

/// A height that can be put in order.
#[derive(PartialEq)]
struct Height(f64);
impl Eq for Height {}
impl PartialOrd for Height {
    fn partial_cmp(&self, other: &Self) -> Option<std::cmp::Ordering> {
        Some(self.cmp(other))
    }
}
impl Ord for Height {
    fn cmp(&self, other: &Self) -> std::cmp::Ordering {
        self.0.total_cmp(&other.0)
    }
}
