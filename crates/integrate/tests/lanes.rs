//! A lane gives the bits of the plain number, whatever its neighbours do, in whatever row.

mod toys;

use precess_integrate::{AnyMethod, Block, Kind, Pace, Samples, Tolerance};
use precess_integrate::{Needs, Options, Steps};
use precess_scalar::{Isa, Lanes, with_lanes};
use precess_system::Field;
use toys::{Known, harmonic, method, methods, mixed, pendulum, stepper, take};

/// Steps of different lengths in different lanes, with their estimates of the error.
fn check_steps<S: Lanes>(id: &str, field: &(impl Known + Field<S>), size: usize)
where
    dyn AnyMethod: Steps<S>,
{
    let options = field.options();
    let start = |lane: usize, i: usize| 0.3 + 0.1 * lane as f64 - 0.25 * i as f64;
    let length = |lane: usize| 0.02 * (1 + lane) as f64;
    let mut wide: Vec<S> = (0..size).map(|i| S::from_lanes(|lane| start(lane, i))).collect();
    let (mut out, h) = (wide.clone(), S::from_lanes(length));
    let mut steps = stepper::<S>(method(id), field, &options);
    let mut t = S::from(0.0);
    let mut errors = vec![];
    for _ in 0..50 {
        take(&mut *steps, field, t, &wide, h, &mut out).expect("converges");
        errors.push(steps.error(h, &vec![S::from(1e8); size]));
        steps.accept(S::always());
        wide.copy_from_slice(&out);
        t = t + h;
    }
    for lane in 0..S::LANES {
        let mut y: Vec<f64> = (0..size).map(|i| start(lane, i)).collect();
        let (mut out, mut t) = (y.clone(), 0.0);
        let mut steps = stepper::<f64>(method(id), field, &options);
        for wide in &errors {
            take(&mut *steps, field, t, &y, length(lane), &mut out).expect("converges");
            let error = steps.error(length(lane), &vec![1e8; size]);
            assert_eq!(error.to_bits(), wide.lanes()[lane].to_bits(), "{id}, the estimate, lane {lane}");
            steps.accept(true);
            y.copy_from_slice(&out);
            t += length(lane);
        }
        for (x, wide) in y.iter().zip(&wide) {
            assert_eq!(x.to_bits(), wide.lanes()[lane].to_bits(), "{id}, lane {lane}");
        }
    }
}

fn check_every_method<S: Lanes>()
where
    dyn AnyMethod: Steps<S>,
{
    check_steps::<S>("exact", &harmonic(1.3), 2);
    check_block::<S>("exact", &harmonic(1.3), 2);
    for m in methods() {
        if m.needs != Needs::Separable {
            check_steps::<S>(m.id, &mixed(), 3);
            check_block::<S>(m.id, &mixed(), 3);
        }
        check_steps::<S>(m.id, &pendulum(0.0), 2);
        check_block::<S>(m.id, &pendulum(0.0), 2);
    }
}

#[test]
fn every_method_gives_the_same_bits_in_a_lane_and_alone() {
    for isa in Isa::available() {
        with_lanes!(isa, S => check_every_method::<S>());
    }
}

fn pace(id: &str) -> Pace {
    match method(id).card().kind {
        Kind::Fixed => Pace::Fixed(0.04),
        Kind::Adaptive => Pace::Adaptive(Tolerance { rtol: 1e-9, atol: 1e-9, skip: vec![] }),
    }
}

/// The last states of trajectories from a block.
fn ends<S: Lanes>(id: &str, field: &dyn Field<S>, options: &Options, starts: &[f64], size: usize) -> Vec<u64>
where
    dyn AnyMethod: Steps<S>,
{
    let (method, samples) = (method(id), Samples::new(1.0, 0.3));
    let pace = &pace(id);
    let block = Block { field, method, options: options.clone(), samples, pace };
    let mut ends = vec![0; starts.len()];
    let mut record = |_, trajectory: usize, y: &[f64]| {
        for (i, x) in y.iter().enumerate() {
            ends[trajectory * size + i] = x.to_bits();
        }
    };
    block.run(starts, &mut record);
    ends
}

/// Full blocks, blocks with a single trajectory, and all between: rows and left-over lanes change no bit.
fn check_block<S: Lanes>(id: &str, field: &(impl Known + Field<S>), size: usize)
where
    dyn AnyMethod: Steps<S>,
{
    // With adaptive steps a lane takes the next start as soon as it is free: more of them than there are lanes.
    let rows = if method(id).card().kind == Kind::Adaptive { 3 } else { 1 };
    let most = rows * Block::<S>::capacity(&pace(id), Field::<S>::shape(field));
    let options = field.options();
    let starts: Vec<f64> = (0..most * size).map(|i| 0.2 + 0.37 * (i % 5) as f64 - 0.01 * i as f64).collect();
    let alone: Vec<u64> =
        starts.chunks(size).flat_map(|start| ends::<f64>(id, field, &options, start, size)).collect();
    for count in [1, 2, S::LANES, S::LANES + 1, most - 1, most] {
        let count = count.clamp(1, most);
        let together = ends::<S>(id, field, &options, &starts[..count * size], size);
        assert_eq!(together, alone[..count * size], "{id}, {count} in {} lanes", S::LANES);
    }
}
