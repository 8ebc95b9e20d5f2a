//! Which lanes deserve a look: cheap enough to be asked after every step, in all lanes at once.

use super::judge::{Hold, Judge, NEAR};
use super::matrix::Matrix;
use super::traps::Meeting;
use precess_integrate::Stepped;
use precess_scalar::{Kernel, Lanes};
use precess_system::Field;
use std::f64::consts::TAU;

/// Adding and subtracting it rounds a double to a whole number: above it doubles have no digits after the point.
const WHOLE: f64 = 1.5 * (1_u64 << 52) as f64;

/// What is asked.
pub(super) struct Gate<S> {
    /// The energy's place among the observables, and below what it gets interesting.
    energy: Option<(usize, f64)>,
    near: Vec<Near<S>>,
    /// Coordinates that escape, and beyond what.
    far: Vec<(usize, f64)>,
    turning: Vec<bool>,
    observed: Vec<S>,
    offset: Vec<S>,
}

/// A neighbourhood: a form below a size.
struct Near<S> {
    centre: Vec<S>,
    per_unit: Vec<S>,
    form: Vec<Vec<S>>,
    size: f64,
}

impl<S: Lanes> Gate<S> {
    pub fn new(judge: &Judge) -> Self {
        let ground = &judge.ground;
        let numbers = |row: &[f64]| row.iter().map(|x| S::from(*x)).collect::<Vec<S>>();
        let mut near = vec![];
        for attractor in &judge.attractors {
            let Hold::Traps(traps) = &attractor.hold else { continue };
            for trap in traps {
                let (form, size): (Matrix, f64) = match trap.meeting {
                    Meeting::Strobe => continue,
                    Meeting::Always => (trap.p.clone(), trap.size),
                    // Any form that holds the surroundings in which the section is looked at.
                    Meeting::Section(..) => (one(trap.p.len()), NEAR * NEAR),
                };
                near.push(Near {
                    centre: numbers(&trap.centre),
                    per_unit: ground.unit.iter().map(|unit| S::from(1.0 / unit)).collect(),
                    form: form.iter().map(|row| numbers(row)).collect(),
                    size,
                });
            }
        }
        let energy = ground.energy.filter(|_| !judge.wells.is_empty()).map(|k| (k, judge.highest_pass));
        let escapes = (0..ground.coordinates).filter(|&i| !ground.turning[i] && judge.far.is_finite());
        Self {
            energy,
            near,
            far: escapes.map(|i| (i, judge.far)).collect(),
            turning: ground.turning.clone(),
            observed: vec![S::from(0.0); ground.plan.layout.observables.len()],
            offset: vec![S::from(0.0); ground.size],
        }
    }

    /// The lanes that deserve a look.
    pub fn ask(&mut self, field: &dyn Field<S>, stepped: &Stepped<S>) -> u32 {
        S::enter(Question { gate: self, field, t: stepped.t, y: stepped.y }) & stepped.accepted
    }
}

fn one(n: usize) -> Matrix {
    (0..n).map(|i| (0..n).map(|j| if i == j { 1.0 } else { 0.0 }).collect()).collect()
}

struct Question<'a, S> {
    gate: &'a mut Gate<S>,
    field: &'a dyn Field<S>,
    t: &'a S,
    y: &'a [S],
}

impl<S: Lanes> Kernel for Question<'_, S> {
    type Output = u32;

    #[inline(always)]
    fn run(self) -> u32 {
        let Self { gate, field, t, y } = self;
        let mut lanes = 0;
        if let Some((k, pass)) = gate.energy {
            field.observe(*t, y, &mut gate.observed);
            lanes |= S::truth(gate.observed[k].below(pass));
        }
        for &(i, far) in &gate.far {
            lanes |= S::truth(y[i].abs().above(far));
        }
        for near in &gate.near {
            for (i, z) in gate.offset.iter_mut().enumerate() {
                let mut offset = y[i] - near.centre[i];
                if gate.turning.get(i) == Some(&true) {
                    offset = offset - (offset / TAU + WHOLE - WHOLE) * TAU;
                }
                *z = offset * near.per_unit[i];
            }
            let mut sum = S::from(0.0);
            for (row, z) in near.form.iter().zip(&gate.offset) {
                for (p, other) in row.iter().zip(&gate.offset) {
                    sum = sum + *z * *p * *other;
                }
            }
            // The judge computes the same a little differently: what is on the edge is looked at.
            lanes |= S::truth(sum.below(near.size * 1.001));
        }
        lanes
    }
}
