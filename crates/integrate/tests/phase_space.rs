//! What the cards claim of phase space: symplectic, reversible; and the errata of the sources.

mod toys;

use precess_integrate::{Needs, Options};
use precess_scalar::{Dual, Scalar};
use precess_system::Field;
use toys::{harmonic, kepler, method, methods, pendulum, stepper, take};

/// The Jacobian of one step: columns by dual numbers.
fn jacobian(id: &str, options: &Options, field: &dyn Field<Dual<f64>>, y: &[f64], h: f64) -> Vec<Vec<f64>> {
    let mut columns = vec![];
    for k in 0..y.len() {
        let start: Vec<Dual<f64>> =
            y.iter().enumerate().map(|(i, x)| Dual::new(*x, if i == k { 1.0 } else { 0.0 })).collect();
        let mut end = start.clone();
        let mut steps = stepper::<Dual<f64>>(method(id), field, options);
        take(&mut *steps, field, Dual::from(0.0), &start, Dual::from(h), &mut end)
            .expect("the step converges");
        columns.push(end.iter().map(|x| x.slope).collect());
    }
    columns
}

/// The largest entry of `J^T Omega J - Omega`, positions first.
fn symplectic_defect(columns: &[Vec<f64>]) -> f64 {
    let n = columns.len() / 2;
    let omega = |a: &[f64], b: &[f64]| (0..n).fold(0.0, |sum, i| sum + (a[i] * b[n + i] - a[n + i] * b[i]));
    let mut worst = 0.0;
    for i in 0..2 * n {
        for j in 0..2 * n {
            let expected = if j == i + n {
                1.0
            } else if i == j + n {
                -1.0
            } else {
                0.0
            };
            worst = (omega(&columns[i], &columns[j]) - expected).abs().larger(worst);
        }
    }
    worst
}

#[test]
fn symplectic_where_the_card_says_so_and_nowhere_else() {
    let (pendulum, kepler) = (pendulum(0.0), kepler());
    let cases: [(&dyn Field<Dual<f64>>, &[f64]); 2] =
        [(&pendulum, &[1.1, 0.4]), (&kepler, &[0.7, 0.2, -0.3, 1.2])];
    // Taylor's series of order 20 is the solution itself, to rounding.
    for m in methods().filter(|m| m.needs != Needs::Expression) {
        for (field, y) in cases {
            // A step that is not small: a method of order 8 must show its defect too.
            let defect = symplectic_defect(&jacobian(m.id, &Options::default(), field, y, 0.5));
            println!("{:<14} {defect:.1e}", m.id);
            assert!(if m.symplectic { defect < 1e-14 } else { defect > 1e-10 }, "{}: {defect:e}", m.id);
        }
    }
}

#[test]
fn euler_taylor_has_the_determinant_that_gains_energy() {
    let (omega, h) = (1.3, 0.1);
    for alpha in [0.0, 0.25, 0.5, 1.0] {
        let options = Options { alpha, ..Options::default() };
        let j = jacobian("euler_taylor", &options, &harmonic(omega), &[0.8, -0.3], h);
        let determinant = j[0][0] * j[1][1] - j[0][1] * j[1][0];
        let expected = 1.0 + (1.0 - alpha) * (omega * h) * (omega * h);
        assert!((determinant - expected).abs() < 1e-15, "alpha {alpha}: {determinant} against {expected}");
    }
}

#[test]
fn newmark_keeps_its_determinant_off_one() {
    // T calls it symplectic (5.3, annex C); on an oscillator its map is conjugate to an area-preserving one
    // (determinant 1) but on a pendulum the area changes from step to step.
    let j = jacobian(
        "newmark",
        &Options { epsilon: 1e-15, ..Options::default() },
        &harmonic(1.0),
        &[0.8, -0.3],
        0.5,
    );
    assert!((j[0][0] * j[1][1] - j[0][1] * j[1][0] - 1.0).abs() < 1e-14);
    let defect =
        symplectic_defect(&jacobian("newmark", &Options::default(), &pendulum(0.0), &[1.1, 0.4], 0.5));
    assert!(defect > 1e-4, "{defect:e}");
}

#[test]
fn a_step_back_undoes_a_step_where_the_card_says_so_and_nowhere_else() {
    let field = pendulum(0.0);
    // Taylor's series of order 20 is the solution itself, to rounding.
    for m in methods().filter(|m| m.needs != Needs::Expression) {
        let options = Options { epsilon: 1e-15, ..Options::default() };
        let start = [1.1, 0.4];
        let (mut there, mut back) = ([0.0; 2], [0.0; 2]);
        let fresh = || stepper::<f64>(method(m.id), &field, &options);
        take(&mut *fresh(), &field, 0.0, &start, 0.5, &mut there).expect("converges");
        take(&mut *fresh(), &field, 0.5, &there, -0.5, &mut back).expect("converges");
        let off = (back[0] - start[0]).abs() + (back[1] - start[1]).abs();
        println!("{:<14} {off:.1e}", m.id);
        assert!(if m.reversible { off < 5e-15 } else { off > 1e-10 }, "{}: {off:e}", m.id);
    }
}

#[test]
fn newmarks_loop_diverges_beyond_the_root_of_six() {
    let try_step = |x: f64| {
        let field = harmonic(1.0);
        let mut end = [0.0; 2];
        let mut steps = stepper::<f64>(method("newmark"), &field, &Options::default());
        take(&mut *steps, &field, 0.0, &[1.0, 0.0], x, &mut end)
    };
    assert!(try_step(2.0).is_ok());
    assert!(try_step(2.5).is_err());
}

#[test]
fn the_share_alpha_makes_three_methods() {
    let (field, y) = (pendulum(0.0), [1.1, 0.4]);
    let step = |id: &str, alpha: f64| {
        jacobian(id, &Options { alpha, ..Options::default() }, &field, &y, 0.1).concat()
    };
    assert_eq!(step("euler_taylor", 0.0), step("euler", 0.5));
    for (one, cromer) in step("euler_taylor", 1.0).iter().zip(step("euler_cromer", 0.5)) {
        assert!((one - cromer).abs() < 1e-15, "{one} {cromer}");
    }
}
