//! Dense output between the ends of a step.

mod toys;

use precess_integrate::Options;
use precess_scalar::{DoubleDouble, Scalar};
use toys::{Known, method, methods, pendulum, stepper, take};

type Dd = DoubleDouble;

/// The largest error at interior points of one step of length `h`, against fine steps.
fn interior_error(id: &str, h: f64) -> f64 {
    let field = pendulum(0.1);
    let start = [Dd::from(1.2), Dd::from(0.3)];
    let (t, h) = (Dd::from(0.0), Dd::from(h));
    let mut end = start;
    // The ends are exact up to the method's own error: take them from the finest method, so that only the
    // polynomial between them is measured.
    let mut steps = stepper::<Dd>(method(id), &field, &Options::default());
    take(&mut *steps, &field, t, &start, h, &mut end).expect("converges");
    let dense = steps.dense(&field, t, &start, h, &end);
    let mut worst = 0.0;
    for k in 1..16 {
        let inside = h * (f64::from(k) / 16.0);
        let (mut exact, mut y) = (start, start);
        let mut fine = stepper::<Dd>(method("dop853"), &field, &Options::default());
        toys::walk(fine.as_mut(), &field, t, &mut exact, inside / 32.0, 32);
        dense.at(inside, &mut y);
        for (a, b) in y.iter().zip(&exact) {
            worst = (*a - *b).abs().to_f64().larger(worst);
        }
    }
    worst
}

#[test]
fn its_error_falls_with_the_declared_power_of_the_step() {
    // The local error of a polynomial of order p goes with h^(p + 1); the cubic's with h^4.
    for (id, power) in [("rk4", 4.0), ("dopri5", 5.0), ("dop853", 8.0)] {
        let errors: Vec<f64> = (4..8).map(|k| interior_error(id, Scalar::powi(0.5, k))).collect();
        let slope = Scalar::ln(errors[0] / errors[3]) / (3.0 * std::f64::consts::LN_2);
        println!("{id}: {slope:.3}");
        assert!((slope - power).abs() < 0.1, "{id}: {slope}");
    }
}

#[test]
fn the_ends_are_the_very_numbers_of_the_step() {
    let field = pendulum(0.0);
    let mut state = 1_u64;
    let mut random = || {
        state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (state >> 11) as f64 / 9007199254740992.0
    };
    for m in methods() {
        for _ in 0..100 {
            let (t, h) = (10.0 * random(), 0.3 * random());
            let (start, mut end) = ([random(), random() - 0.5], [0.0; 2]);
            let mut steps = stepper::<f64>(method(m.id), &field, &field.options());
            take(&mut *steps, &field, t, &start, h, &mut end).expect("converges");
            let stop = t + h;
            let dense = steps.dense(&field, t, &start, h, &end).ending(stop);
            let mut y = [0.0; 2];
            dense.at(t, &mut y);
            assert_eq!(y, start, "{}", m.id);
            dense.at(stop, &mut y);
            assert_eq!(y, end, "{}", m.id);
        }
    }
}
