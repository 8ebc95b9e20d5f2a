//! Neighbourhoods of attractors that nothing leaves.
//!
//! About a fixed point, or a point of a periodic motion on a section, a quadratic form z.p z that shrinks under the
//! linear motion (Lyapunov's equation) shrinks under the whole one as long as z is small: how small is found by trying
//! the boundary and the inside in many directions. That is a numerical check, not interval arithmetic.

use super::ground::{Ground, turned};
use super::matrix::{Matrix, form, is_positive, jacobian, of_flow, of_map, solve};
use crate::random::Random;

/// Directions in which a neighbourhood is tried, and the sizes in each.
const DIRECTIONS: usize = 60;
const SHELLS: [f64; 4] = [1.0, 0.75, 0.5, 0.25];
/// The form must shrink by this share of what the linear motion gives.
const SHARE: f64 = 0.1;
/// Iterations of a map that look for a periodic point.
const MOST_ITERATIONS: usize = 200;
/// The longest cycle, in periods of the drive.
const MOST_PERIODS: usize = 8;
/// Larger states are not tried.
const MOST_NUMBERS: usize = 12;

/// How a motion meets the neighbourhood.
#[derive(Clone, Debug)]
pub(super) enum Meeting {
    /// At any time.
    Always,
    /// At whole periods of the drive.
    Strobe,
    /// When it passes a plane with this normal, within a time.
    Section(Vec<f64>, f64),
}

/// A neighbourhood that nothing leaves.
#[derive(Clone, Debug)]
pub(super) struct Trap {
    pub centre: Vec<f64>,
    /// The form, in units of the ground.
    pub p: Matrix,
    /// The largest value of the form inside.
    pub size: f64,
    pub meeting: Meeting,
}

type Map<'m> = dyn Fn(&[f64]) -> Option<Vec<f64>> + 'm;

impl Trap {
    /// A state from the centre, in units, at the image that lies nearest; and the turns to it.
    fn offset(&self, ground: &Ground, y: &[f64]) -> (Vec<f64>, Vec<i32>) {
        let turns = ground.turns_between(&self.centre, y);
        let centre = turned(&self.centre, &turns);
        (y.iter().zip(&centre).zip(&ground.unit).map(|((y, c), unit)| (y - c) / unit).collect(), turns)
    }

    /// The turns to the image whose neighbourhood holds a state.
    pub fn holds(&self, ground: &Ground, y: &[f64]) -> Option<Vec<i32>> {
        let inside = |y: &[f64]| {
            let (z, turns) = self.offset(ground, y);
            (form(&self.p, &z) < self.size).then_some(turns)
        };
        match &self.meeting {
            Meeting::Always | Meeting::Strobe => inside(y),
            Meeting::Section(normal, time) => {
                let turns = ground.turns_between(&self.centre, y);
                let centre = turned(&self.centre, &turns);
                let passages = ground.passages(y, *time, &centre, normal);
                passages.first().and_then(|(_, y)| inside(y))
            }
        }
    }

    /// The same for a motion that may be anywhere on a cycle: within a period it passes the plane.
    pub fn meets(&self, ground: &Ground, y: &[f64]) -> Option<Vec<i32>> {
        let Meeting::Section(normal, time) = &self.meeting else { return None };
        let turns = ground.turns_between(&self.centre, y);
        let centre = turned(&self.centre, &turns);
        let passages = ground.passages(y, *time, &centre, normal);
        let inside = |y: &Vec<f64>| form(&self.p, &self.offset(ground, y).0) < self.size;
        passages.iter().any(|(_, y)| inside(y)).then_some(turns)
    }

    /// The largest neighbourhood in which `shrinks` holds; none where it holds nowhere.
    fn grow(mut self, ground: &Ground, shrinks: &dyn Fn(&[f64], f64) -> bool) -> Option<Self> {
        let mut random = Random::new(5);
        let n = self.centre.len();
        let directions: Vec<Vec<f64>> =
            (0..DIRECTIONS).map(|_| (0..n).map(|_| random.between(-1.0, 1.0)).collect()).collect();
        let plane = match &self.meeting {
            Meeting::Section(normal, _) => Some(normal.clone()),
            _ => None,
        };
        let mut radius = 1.0;
        for _ in 0..30 {
            let all = directions.iter().all(|direction| {
                let mut z = direction.clone();
                if let Some(normal) = &plane {
                    // Into the plane: the normal belongs to the state, z is in units.
                    let across = |z: &[f64]| {
                        z.iter().zip(&ground.unit).zip(normal).fold(0.0, |s, ((z, u), n)| s + z * u * n)
                    };
                    let own: Vec<f64> = normal.iter().zip(&ground.unit).map(|(n, u)| n * u).collect();
                    let factor = across(&z) / own.iter().fold(0.0, |s, x| s + x * x);
                    for (z, own) in z.iter_mut().zip(&own) {
                        *z -= factor * own;
                    }
                }
                let length = form(&self.p, &z).sqrt();
                SHELLS.iter().all(|shell| {
                    let scale = shell * radius / length;
                    let scaled: Vec<f64> = z.iter().map(|z| z * scale).collect();
                    let square = scaled.iter().fold(0.0, |sum, z| sum + z * z);
                    let y: Vec<f64> = self
                        .centre
                        .iter()
                        .zip(&scaled)
                        .zip(&ground.unit)
                        .map(|((c, z), u)| c + z * u)
                        .collect();
                    shrinks(&y, square)
                })
            });
            if all {
                self.size = radius * radius;
                return Some(self);
            }
            radius *= 0.5;
        }
        None
    }
}

/// The fixed point near a state that attracts, with its trap.
pub(super) fn fixed_point(ground: &Ground, y: &[f64]) -> Option<(Vec<f64>, Vec<Trap>)> {
    if y.len() > MOST_NUMBERS {
        return None;
    }
    let rate = |y: &[f64]| Some(ground.rate(0.0, y));
    let centre = ground.root(y, &rate).filter(|centre| ground.distance(centre, y) < 0.1)?;
    let a = jacobian(&centre, &ground.unit, 1e-6, rate)?;
    let a = in_units(ground, &a);
    let p = of_flow(&a).filter(is_positive)?;
    let trap = Trap { centre: centre.clone(), p, size: 0.0, meeting: Meeting::Always };
    let shrinks = |y: &[f64], square: f64| {
        let (z, _) = trap.offset(ground, y);
        let rate: Vec<f64> = ground.rate(0.0, y).iter().zip(&ground.unit).map(|(f, u)| f / u).collect();
        let slope = trap.p.iter().zip(&rate).fold(0.0, |sum, (row, f)| sum + 2.0 * f * dot(row, &z));
        slope <= -SHARE * square
    };
    let trap = trap.clone().grow(ground, &shrinks)?;
    Some((centre, vec![trap]))
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).fold(0.0, |sum, (a, b)| sum + a * b)
}

/// A matrix that takes states to rates or states, for states in units.
fn in_units(ground: &Ground, a: &Matrix) -> Matrix {
    let unit = &ground.unit;
    a.iter().zip(unit).map(|(row, u)| row.iter().zip(unit).map(|(a, v)| a * v / u).collect()).collect()
}

/// The trap of a fixed point of a map.
fn trap_of_map(ground: &Ground, centre: &[f64], map: &Map, meeting: Meeting) -> Option<Trap> {
    let m = in_units(ground, &jacobian(centre, &ground.unit, 1e-6, map)?);
    let p = of_map(&m).filter(is_positive)?;
    let trap = Trap { centre: centre.to_vec(), p, size: 0.0, meeting };
    let shrinks = |y: &[f64], square: f64| {
        let value = |y: &[f64]| form(&trap.p, &trap.offset(ground, y).0);
        map(y).is_some_and(|next| value(&next) <= value(y) - SHARE * square)
    };
    trap.clone().grow(ground, &shrinks)
}

/// A periodic motion of a driven system near a state at a whole period: a point and a trap for each period.
pub(super) fn driven_cycle(ground: &Ground, y: &[f64], period: f64) -> Option<(Vec<f64>, Vec<Trap>)> {
    if y.len() > MOST_NUMBERS {
        return None;
    }
    let mut periods = 0;
    let mut here = y.to_vec();
    // How often it takes to come back.
    for n in 1..=MOST_PERIODS {
        here = ground.advance(&here, period)?;
        let turns = ground.turns_between(y, &here);
        if ground.distance(&turned(y, &turns), &here) < 0.02 {
            periods = n;
            break;
        }
    }
    let map = |y: &[f64]| {
        let mut here = y.to_vec();
        for _ in 0..periods {
            here = ground.advance(&here, period)?;
        }
        // A motion that runs round has come back when only turns have been added.
        let turns: Vec<i32> = ground.turns_between(y, &here).iter().map(|n| -n).collect();
        Some(turned(&here, &turns))
    };
    if periods == 0 {
        return None;
    }
    let moved = |y: &[f64]| Some(map(y)?.iter().zip(y).map(|(a, b)| a - b).collect::<Vec<f64>>());
    let mut centre = newton(ground, y, &moved).filter(|centre| ground.distance(centre, y) < 0.1)?;
    let mut traps = vec![];
    let first = centre.clone();
    for _ in 0..periods {
        traps.push(trap_of_map(ground, &centre, &map, Meeting::Strobe)?);
        centre = ground.advance(&centre, period)?;
    }
    Some((first, traps))
}

/// Newton's method for a map that is expensive and good to about twelve digits.
fn newton(ground: &Ground, y: &[f64], moved: &Map) -> Option<Vec<f64>> {
    let mut y = y.to_vec();
    for _ in 0..12 {
        let residual = moved(&y)?;
        let step = solve(jacobian(&y, &ground.unit, 1e-6, moved)?, residual)?;
        for (y, step) in y.iter_mut().zip(&step) {
            *y -= step;
        }
        if ground.distance(&step, &vec![0.0; step.len()]) < 1e-11 {
            return Some(y);
        }
    }
    None
}

/// A cycle of a system without a drive near a state: a point of it and a trap on the plane across the motion there.
pub(super) fn free_cycle(ground: &Ground, y: &[f64], longest: f64) -> Option<(Vec<f64>, Vec<Trap>)> {
    if y.len() > MOST_NUMBERS {
        return None;
    }
    // Across the motion, in units; as a normal of states it is divided by the units once more.
    let rate = ground.rate(0.0, y);
    let normal: Vec<f64> = rate.iter().zip(&ground.unit).map(|(f, u)| f / (u * u)).collect();
    let returning = |y: &[f64], time: f64, plane: &[f64]| {
        let passages = ground.passages(y, time, plane, &normal);
        passages.into_iter().find(|(_, end)| ground.distance(end, plane) < 0.3)
    };
    let mut here = y.to_vec();
    let mut time = longest;
    for _ in 0..MOST_ITERATIONS {
        let (took, next) = returning(&here, time, y)?;
        let moved = ground.distance(&next, &here);
        // The first return tells the period; the others look no further than they need.
        time = 1.5 * took;
        here = next;
        if moved < 1e-10 {
            break;
        }
        if moved > 0.3 {
            return None;
        }
    }
    let centre = here;
    let map = |y: &[f64]| returning(y, time, &centre).map(|(_, end)| end);
    if ground.distance(&map(&centre)?, &centre) > 1e-9 {
        return None;
    }
    let trap = trap_of_map(ground, &centre, &map, Meeting::Section(normal.clone(), time))?;
    Some((centre.clone(), vec![trap]))
}
