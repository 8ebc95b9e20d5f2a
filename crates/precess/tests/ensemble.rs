//! Ensembles: grids, failures of single members, interruption. (That members have the bits of runs is in `golden.rs`.)

use precess::integrate::Failure;
use precess::scalar::Isa;
use precess::value::Value;
use precess::{Axis, EventSpec, Keep, Members, Plan, Scenario, Workers, ensemble, grid, run};
use std::ops::ControlFlow;

fn plan(system: &str, method: &str, settings: &[(&str, f64)]) -> Plan {
    let mut scenario = Scenario::of(system);
    scenario.method = Some(method.into());
    scenario.run = settings.iter().map(|(name, x)| ((*name).into(), Value::number(*x))).collect();
    Plan::new(&scenario).expect("a plan")
}

fn axis(name: &str, low: f64, high: f64, points: usize) -> Axis {
    Axis { name: name.into(), low, high, points }
}

/// The same in every instruction set, by one thread and by three.
fn everywhere(plan: &Plan, starts: &[f64], keep: Keep) -> Members {
    let mut all = Isa::available().into_iter().flat_map(|isa| [1, 3].map(|threads| Workers { isa, threads }));
    let run = |workers| {
        ensemble(plan, starts, keep, workers, &mut |_| ControlFlow::Continue(())).expect("no watches")
    };
    let first = run(all.next().expect("scalar is everywhere"));
    for workers in all {
        let members = run(workers);
        let bits = |members: &Members| members.numbers.iter().map(|x| x.to_bits()).collect::<Vec<_>>();
        assert_eq!(bits(&members), bits(&first), "{workers:?}");
        assert_eq!(members.failures, first.failures, "{workers:?}");
    }
    first
}

/// What the member's run alone says.
fn alone(plan: &Plan, start: &[f64]) -> Option<Failure> {
    run(&Plan { start: start.to_vec(), ..plan.clone() }, &mut |_| ControlFlow::Continue(())).failure
}

fn fails_as_alone(plan: &Plan, starts: &[f64]) -> Members {
    let members = everywhere(plan, starts, Keep::Last);
    let full = plan.start.len();
    for (k, start) in starts.chunks(full).enumerate() {
        let failure =
            members.failures.iter().find(|(member, _)| *member == k).map(|(_, failure)| failure.clone());
        assert_eq!(failure, alone(plan, start), "member {k}");
        assert_eq!(failure.is_none(), members.member(k).iter().all(|x| x.is_finite()), "member {k}");
    }
    members
}

#[test]
fn the_first_axis_runs_fastest_and_both_ends_are_there() {
    let plan = plan("magnetic_pendulum", "rk4", &[]);
    let starts = grid(&plan, &[axis("x", -1.0, 1.0, 3), axis("y_dot", 0.5, 0.7, 2)]).expect("a grid");
    let places: Vec<_> = starts.chunks(4).map(|s| (s[0], s[1], s[2], s[3])).collect();
    let expected = [(-1.0, 0.5), (0.0, 0.5), (1.0, 0.5), (-1.0, 0.7), (0.0, 0.7), (1.0, 0.7)];
    assert_eq!(places, expected.map(|(x, v)| (x, 0.0, 0.0, v)));
}

#[test]
fn a_grid_that_makes_no_sense_is_one_sentence() {
    let plan = plan("magnetic_pendulum", "rk4", &[]);
    let refusal = |axes: &[Axis]| grid(&plan, axes).expect_err("no grid").to_string();
    assert!(refusal(&[axis("z", 0.0, 1.0, 2)]).contains("no start of magnetic_pendulum 'z'"));
    assert!(refusal(&[axis("x", 0.0, 1.0, 0)]).contains("no points"));
    assert!(refusal(&[axis("x", 0.0, f64::NAN, 2)]).contains("cannot start at NaN"));
    assert!(refusal(&[axis("x", 0.0, 1.0, usize::MAX), axis("y", 0.0, 1.0, 2)]).contains("too many"));
}

#[test]
fn a_member_that_diverges_harms_no_other() {
    // A thousand radians a step: all but the one at rest grow a thousandfold each step.
    let plan = plan("harmonic_oscillator", "euler", &[("dt", 1e3), ("until", 3e5), ("every", 1e5)]);
    let starts = grid(&plan, &[axis("x", 0.0, 1.0, 11)]).expect("a grid");
    let members = fails_as_alone(&plan, &starts);
    assert_eq!(members.failures.len(), 10);
    assert!(matches!(members.failures[0], (1, Failure::Diverged { .. })), "{:?}", members.failures[0]);
    assert_eq!(members.member(0), [0.0, 0.0]);
}

#[test]
fn a_loop_that_does_not_converge_harms_no_other() {
    let plan = plan("harmonic_oscillator", "newmark", &[("dt", 2.6), ("until", 26.0), ("every", 26.0)]);
    let starts = grid(&plan, &[axis("x", 0.0, 1.0, 7)]).expect("a grid");
    let members = fails_as_alone(&plan, &starts);
    assert_eq!(members.failures.len(), 6);
    assert!(matches!(members.failures[0], (1, Failure::NoConvergence { .. })));
}

#[test]
fn a_collision_stops_an_adaptive_member_alone() {
    // A small mass beside a large one, at rest: it falls straight in; pushed aside, it passes.
    let plan = plan("n_body", "dop853", &[("until", 3.0), ("every", 1.0), ("rtol", 1e-10), ("atol", 1e-10)]);
    let starts = grid(&plan, &[axis("y0_dot", 0.0, 0.0, 1), axis("y1_dot", 0.0, 2.0, 5)]).expect("a grid");
    let members = fails_as_alone(&plan, &starts);
    assert_eq!(members.failures.iter().map(|(k, _)| *k).collect::<Vec<_>>(), [0]);
}

#[test]
fn a_system_with_events_runs_member_by_member() {
    let plan = plan("noria", "euler_cromer", &[("dt", 0.001), ("until", 0.5), ("every", 0.1)]);
    let starts = grid(&plan, &[axis("theta", 0.1, 0.3, 3)]).expect("a grid");
    let members = everywhere(&plan, &starts, Keep::Samples);
    assert_eq!((members.times.len(), members.failures.len()), (6, 0));
    assert!((0..3).all(|k| members.member(k).iter().all(|x| x.is_finite())));
}

#[test]
fn an_interrupted_ensemble_keeps_what_is_done() {
    let plan = plan("pendulum", "rk4", &[("dt", 0.01), ("until", 0.1), ("every", 0.1)]);
    let starts = grid(&plan, &[axis("theta", 0.1, 3.0, 100)]).expect("a grid");
    let workers = Workers { isa: Isa::Scalar, threads: 1 };
    let mut told = vec![];
    let mut stop = |done| {
        told.push(done);
        if done >= 16 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    };
    let members = ensemble(&plan, &starts, Keep::Last, workers, &mut stop).expect("no watches");
    let done = *told.last().expect("progress is told");
    assert!((16..100).contains(&done) && told.is_sorted());
    assert_eq!(members.failures.len(), 100 - done);
    assert!(members.failures.iter().all(|(_, failure)| matches!(failure, Failure::Interrupted { .. })));
    assert!((0..done).all(|k| members.member(k)[0].is_finite()) && members.member(done)[0].is_nan());
}

#[test]
fn an_ensemble_that_watches_is_refused() {
    let mut scenario = Scenario::of("pendulum");
    scenario.events = vec![EventSpec { when: "theta = 0".into(), ..EventSpec::default() }];
    let plan = Plan::new(&scenario).expect("a plan");
    let refusal =
        ensemble(&plan, &plan.start, Keep::Last, Workers::all(), &mut |_| ControlFlow::Continue(()));
    assert!(refusal.expect_err("refused").to_string().contains("[[event]]"));
}
