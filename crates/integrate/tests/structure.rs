//! What the cards claim: symplectic, reversible, the same bits in every lane.

mod common;

use common::{Driven, Kepler, Mixed, Oscillator, Pendulum, field, layout, method, needs_separable};
use precess_integrate::{METHODS, Options, Steps};
use precess_scalar::{Batch, Dual, Scalar};
use precess_system::System;

/// The Jacobian of one step by dual numbers, column by column.
fn jacobian(id: &str, options: &Options, system: &impl System, h: f64) -> Vec<Vec<f64>> {
    let field = field::<Dual<f64>>(system);
    let start = layout(system).start();
    let columns = (0..start.len()).map(|k| {
        let mut stepper = Steps::<Dual<f64>>::stepper(method(id), field.shape(), options);
        let seed = |(i, x): (usize, &f64)| Dual::new(*x, if i == k { 1.0 } else { 0.0 });
        let y: Vec<Dual<f64>> = start.iter().enumerate().map(seed).collect();
        let mut next = y.clone();
        stepper.step(field.as_ref(), Dual::from(0.3), &y, Dual::from(h), &mut next).expect("a small step");
        next.iter().map(|d| d.slope).collect()
    });
    columns.collect()
}

/// The largest entry of J^T Omega J - Omega, with positions first and velocities after.
fn defect(columns: &[Vec<f64>]) -> f64 {
    let n = columns.len() / 2;
    let form = |a: &[f64], b: &[f64]| (0..n).map(|i| a[i] * b[n + i] - a[n + i] * b[i]).sum::<f64>();
    let mut worst = 0.0;
    for (i, a) in columns.iter().enumerate() {
        for (j, b) in columns.iter().enumerate() {
            let omega = if j == i + n {
                1.0
            } else if i == j + n {
                -1.0
            } else {
                0.0
            };
            worst = Scalar::larger((form(a, b) - omega).abs(), worst);
        }
    }
    worst
}

#[test]
fn symplectic_methods_keep_the_symplectic_form_and_no_other_does() {
    for candidate in METHODS {
        let card = candidate.card();
        for defect in [
            defect(&jacobian(card.id, &Options::default(), &Driven { friction: 0.0 }, 0.1)),
            defect(&jacobian(card.id, &Options::default(), &Kepler, 0.1)),
        ] {
            if card.symplectic {
                assert!(defect < 1e-14, "{}: {defect:e}", card.id);
            } else if card.order < 8 {
                // At order 8 the defect of one step is near the rounding.
                assert!(defect > 1e-12, "{}: {defect:e}", card.id);
            }
        }
    }
}

#[test]
fn the_share_alpha_makes_three_methods() {
    let step = |id: &str, alpha: f64| {
        jacobian(id, &Options { alpha, ..Options::default() }, &Driven { friction: 0.2 }, 0.1)
    };
    assert_eq!(step("euler_taylor", 0.0), step("euler", 0.5));
    let (one, cromer) = (step("euler_taylor", 1.0), step("euler_cromer", 0.5));
    for (a, b) in one.concat().iter().zip(cromer.concat()) {
        assert!((a - b).abs() < 1e-15, "{a} {b}");
    }
}

/// P's "improved Euler" multiplies areas of the phase plane by 1 + (omega h)^2 / 2: it gains energy.
#[test]
fn euler_taylor_expands_the_phase_plane() {
    let h = 0.1;
    let j = jacobian("euler_taylor", &Options::default(), &Oscillator, h);
    let determinant = j[0][0] * j[1][1] - j[0][1] * j[1][0];
    assert!((determinant - (1.0 + h * h / 2.0)).abs() < 1e-15, "{determinant}");
}

#[test]
fn reversible_methods_undo_their_steps() {
    let system = Driven { friction: 0.0 };
    let (field, start) = (field::<f64>(&system), layout(&system).start());
    for candidate in METHODS {
        let card = candidate.card();
        let mut stepper = Steps::<f64>::stepper(
            *candidate,
            field.shape(),
            &Options { epsilon: 1e-15, ..Options::default() },
        );
        let (mut there, mut back) = (start.clone(), start.clone());
        let h = 0.125;
        stepper.step(field.as_ref(), 0.0, &start, h, &mut there).expect("converges");
        stepper.restart();
        stepper.step(field.as_ref(), h, &there, -h, &mut back).expect("converges");
        let distance = start.iter().zip(&back).map(|(a, b)| (a - b).abs()).fold(0.0, Scalar::larger);
        let undone = distance < 1e-14;
        if card.order < 8 {
            assert_eq!(undone, card.reversible, "{}: {distance:e}", card.id);
        }
    }
}

#[test]
fn lanes_give_the_bits_of_single_numbers() {
    fn check(system: &impl System, separable: bool) {
        let (plain, lanes) = (field::<f64>(system), field::<Batch<8>>(system));
        let start = layout(system).start();
        for candidate in METHODS.iter().filter(|m| separable || !needs_separable(**m)) {
            let mut wide = Steps::<Batch<8>>::stepper(*candidate, lanes.shape(), &Options::default());
            let spread = |lane: usize, x: f64| x * (1.0 + 0.1 * lane as f64);
            // Every lane has its own start, time and step.
            let h: [f64; 8] = std::array::from_fn(|lane| 0.01 * (lane + 1) as f64);
            let mut y: Vec<Batch<8>> =
                start.iter().map(|x| Batch(std::array::from_fn(|lane| spread(lane, *x)))).collect();
            let mut next = y.clone();
            let mut t = Batch([0.0; 8]);
            for _ in 0..20 {
                wide.step(lanes.as_ref(), t, &y, Batch(h), &mut next).expect("small steps");
                wide.accept();
                std::mem::swap(&mut y, &mut next);
                t = t + Batch(h);
            }
            for lane in 0..8 {
                let mut single = Steps::<f64>::stepper(*candidate, plain.shape(), &Options::default());
                let mut alone: Vec<f64> = start.iter().map(|x| spread(lane, *x)).collect();
                let (mut next, mut t) = (alone.clone(), 0.0);
                for _ in 0..20 {
                    single.step(plain.as_ref(), t, &alone, h[lane], &mut next).expect("small steps");
                    single.accept();
                    std::mem::swap(&mut alone, &mut next);
                    t += h[lane];
                }
                let seen: Vec<u64> = y.iter().map(|x| x.0[lane].to_bits()).collect();
                let bits: Vec<u64> = alone.iter().map(|x| x.to_bits()).collect();
                assert_eq!(seen, bits, "{} in lane {lane}", candidate.card().id);
            }
        }
    }
    check(&Driven { friction: 0.2 }, false);
    check(&Pendulum { start: 1.0 }, true);
    check(&Kepler, true);
    check(&Mixed, false);
}

/// T 5.3: on an oscillator the loop converges for omega h < sqrt(6) = 2.449 only.
#[test]
fn the_loop_of_newmark_diverges_for_long_steps() {
    let (field, start) = (field::<f64>(&Oscillator), layout(&Oscillator).start());
    let mut end = start.clone();
    let mut step = |h: f64| {
        let mut stepper = Steps::<f64>::stepper(method("newmark"), field.shape(), &Options::default());
        stepper.step(field.as_ref(), 0.0, &start, h, &mut end)
    };
    assert!(step(2.0).is_ok());
    assert!(step(2.46).is_err());
}
