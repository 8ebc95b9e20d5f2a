//! A lane gives the bits of the plain number, whatever its neighbours do.

mod toys;

use precess_integrate::{METHODS, Needs, Options};
use precess_scalar::Batch;
use precess_system::Field;
use toys::{method, mixed, pendulum, stepper};

const W: usize = 8;

fn check(id: &str, field: &(impl Field<f64> + Field<Batch<W>>), size: usize) {
    let options = Options::default();
    let start = |lane: usize, i: usize| 0.3 + 0.1 * lane as f64 - 0.25 * i as f64;
    let step = |lane: usize| 0.02 * (1 + lane) as f64;
    let mut wide: Vec<Batch<W>> = (0..size).map(|i| Batch(std::array::from_fn(|l| start(l, i)))).collect();
    let (mut out, h) = (wide.clone(), Batch(std::array::from_fn(step)));
    let mut steps = stepper::<Batch<W>>(method(id), field, &options);
    let mut t = Batch::splat(0.0);
    let mut errors = vec![];
    for _ in 0..50 {
        steps.step(field, t, &wide, h, &mut out).expect("converges");
        errors.push(steps.error(h, &vec![Batch::splat(1e8); size]));
        steps.accept();
        wide.copy_from_slice(&out);
        t = t + h;
    }
    for lane in 0..W {
        let mut y: Vec<f64> = (0..size).map(|i| start(lane, i)).collect();
        let (mut out, mut t) = (y.clone(), 0.0);
        let mut steps = stepper::<f64>(method(id), field, &options);
        for wide in &errors {
            steps.step(field, t, &y, step(lane), &mut out).expect("converges");
            let error = steps.error(step(lane), &vec![1e8; size]);
            assert_eq!(error.to_bits(), wide.0[lane].to_bits(), "{id}, the estimate, lane {lane}");
            steps.accept();
            y.copy_from_slice(&out);
            t += step(lane);
        }
        for (x, wide) in y.iter().zip(&wide) {
            assert_eq!(x.to_bits(), wide.0[lane].to_bits(), "{id}, lane {lane}");
        }
    }
}

#[test]
fn every_method_gives_the_same_bits_in_a_lane_and_alone() {
    for m in METHODS.iter().map(|m| m.card()) {
        if m.needs == Needs::Any {
            check(m.id, &mixed(), 3);
        }
        check(m.id, &pendulum(0.0), 2);
    }
}
