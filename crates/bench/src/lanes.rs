//! The same trajectories in every set of registers: how long they take, and that they are the same.

use crate::clock::{repeats, seconds, shortest};
use crate::{Error, Settings};
use precess::scalar::Isa;
use precess::{Keep, Members, Plan, Step, Workers, ensemble};
use std::ops::ControlFlow;

/// As many trajectories as a block of the widest registers of all machines holds.
const MEMBERS: usize = 128;

/// Runs an ensemble, and tells how long it took.
pub fn run(plan: &Plan, starts: &[f64], isa: Isa, threads: usize) -> Result<(f64, Members), Error> {
    let mut members = Err(precess::Error::Input(String::new()));
    let taken = seconds(|| {
        let workers = Workers { isa, threads };
        members = ensemble(plan, starts, Keep::Last, workers, &mut |_| ControlFlow::Continue(()));
    });
    Ok((taken, members?))
}

/// Makes sure that two results are the same to the last bit.
pub fn same_bits(what: &str, isa: Isa, ours: &Members, plain: &Members) -> Result<(), Error> {
    let bits = |members: &Members| members.numbers.iter().map(|x| x.to_bits()).collect::<Vec<_>>();
    if bits(ours) == bits(plain) {
        return Ok(());
    }
    Err(Error::Failed(format!("{what}: {} lanes give other bits than plain numbers", isa.name())))
}

/// Nanoseconds a trajectory and step in each of these sets of registers; the first one holds plain numbers.
pub fn nanoseconds(plan: &Plan, isas: &[Isa], settings: &Settings) -> Result<Vec<f64>, Error> {
    let Step::Fixed(dt) = plan.step else {
        return Err(Error::Failed(format!("{}: only steps of fixed length run in lanes", plan.card.id)));
    };
    let starts = neighbours(plan);
    let of = |steps: u32| {
        let until = f64::from(steps) * dt;
        Plan { until, every: until, ..plan.clone() }
    };
    let time = |steps| Ok(run(&of(steps), &starts, isas[0], 1)?.0);
    let steps = repeats(settings.effort.spell, time)?;
    let plan = of(steps);
    let plain = run(&plan, &starts, isas[0], 1)?.1;
    let best = shortest(settings.effort.rounds, isas.len(), |k| {
        let (taken, members) = run(&plan, &starts, isas[k], 1)?;
        same_bits(&format!("{} by {}", plan.card.id, plan.method.card().id), isas[k], &members, &plain)?;
        Ok(taken)
    })?;
    Ok(best.iter().map(|s| s * 1e9 / (MEMBERS as f64 * f64::from(steps))).collect())
}

/// The plan's own start and others near it.
fn neighbours(plan: &Plan) -> Vec<f64> {
    let near = |member: usize| plan.start.iter().map(move |x| x * (1.0 + 1e-4 * member as f64));
    (0..MEMBERS).flat_map(near).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_single_other_bit_is_noticed() {
        let plain = Members { state: 2, times: vec![1.0], numbers: vec![0.0, 0.3], failures: vec![] };
        assert_eq!(same_bits("a test", Isa::Narrow, &plain, &plain), Ok(()));
        for numbers in [vec![-0.0, 0.3], vec![0.0, f64::from_bits(0.3_f64.to_bits() + 1)]] {
            let other = Members { numbers, ..plain.clone() };
            let error = same_bits("a test", Isa::Narrow, &other, &plain).expect_err("they differ");
            assert!(matches!(error, Error::Failed(_)), "{error}");
        }
    }
}
