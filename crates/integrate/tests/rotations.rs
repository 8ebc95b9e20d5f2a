//! What the midpoint rule on rotations keeps, and that its roundings do not add up.

mod toys;

use precess_integrate::Options;
use precess_scalar::Scalar;
use precess_system::{Field, Second, Shape};
use toys::{method, stepper, walk};

/// A heavy symmetric top on a fixed point: T's cone, at 60 rad/s.
struct Top(Shape);

const MASS_G_D: f64 = 0.039_269_908_169_872_42 * 9.81 * 0.1125;
const I3: f64 = 2.945_243_112_740_432_4e-5;
const I1: f64 = 4.786_020_058_203_201_5e-5 + 0.039_269_908_169_872_42 * 0.1125 * 0.1125;

impl Top {
    fn new() -> Self {
        let attitudes = vec![0];
        Self(Shape {
            coordinates: 7,
            second: Second::These(vec![]),
            attitudes,
            modes: 0,
            observables: 0,
            events: 0,
            rows: 1,
        })
    }
}

impl<S: Scalar> Field<S> for Top {
    fn shape(&self) -> &Shape {
        &self.0
    }
    fn rate(&self, _t: S, y: &[S], dy: &mut [S]) {
        let &[w, a, b, c, o1, o2, o3] = y else { panic!("seven numbers") };
        dy[0] = -(a * o1 + b * o2 + c * o3) * 0.5;
        dy[1] = (w * o1 + b * o3 - c * o2) * 0.5;
        dy[2] = (w * o2 + c * o1 - a * o3) * 0.5;
        dy[3] = (w * o3 + a * o2 - b * o1) * 0.5;
        let [across, upwards] = [(a * c - w * b) * 2.0, (b * c + w * a) * 2.0];
        dy[4] = (o2 * o3 * (I1 - I3) + upwards * MASS_G_D) / I1;
        dy[5] = (-(o1 * o3 * (I1 - I3)) - across * MASS_G_D) / I1;
        dy[6] = S::from(0.0);
    }
}

/// Energy, `L_Az` and the square of the quaternion's length.
fn constants(y: &[f64]) -> [f64; 3] {
    let &[w, a, b, c, o1, o2, o3] = y else { panic!("seven numbers") };
    let gamma = [(a * c - w * b) * 2.0, (b * c + w * a) * 2.0, w * w - a * a - b * b + c * c];
    let kinetic = (I1 * (o1 * o1 + o2 * o2) + I3 * o3 * o3) * 0.5;
    let momentum = I1 * (o1 * gamma[0] + o2 * gamma[1]) + I3 * o3 * gamma[2];
    [kinetic + MASS_G_D * gamma[2], momentum, w * w + a * a + b * b + c * c]
}

/// Over so many steps: the largest departures of the constants, relative, and the slopes of straight lines through them.
fn departures(steps: u32) -> [[f64; 2]; 3] {
    let top = Top::new();
    let mut steps_of = stepper::<f64>(method("lie_midpoint"), &top, &Options::default());
    let (sin, cos) = Scalar::sin_cos(std::f64::consts::PI / 12.0);
    let mut y = [cos, sin, 0.0, 0.0, 0.0, 0.0, 60.0];
    let (first, parts) = (constants(&y), 1000);
    let mut found = [[0.0; 2]; 3];
    for k in 1..=parts {
        walk(&mut *steps_of, &top, 0.0, &mut y, 1e-3, steps / parts);
        for ((found, now), first) in found.iter_mut().zip(constants(&y)).zip(first) {
            let (off, t) = (now / first - 1.0, f64::from(k) / f64::from(parts) - 0.5);
            found[0] = off.abs().larger(found[0]);
            found[1] += 12.0 * off * t / f64::from(parts);
        }
    }
    found.map(|[largest, slope]| [largest, slope / f64::from(steps)])
}

/// By the slope a million steps show what ten million would come to: 1e-12 and no more.
#[test]
fn roundings_do_not_add_up() {
    for ([largest, slope], name) in departures(1_000_000).into_iter().zip(["energy", "L_Az", "length"]) {
        println!("{name}: {largest:.1e}, {slope:.1e} a step");
        assert!(largest < 3e-13 && slope.abs() < 1e-19, "{name}: {largest:e}, {slope:e} a step");
    }
}

#[test]
#[ignore = "ten million steps take twenty seconds"]
fn ten_million_steps_keep_the_constants() {
    for ([largest, slope], name) in departures(10_000_000).into_iter().zip(["energy", "L_Az", "length"]) {
        println!("{name}: {largest:.1e}, {slope:.1e} a step");
        assert!(largest < 1e-12, "{name}: {largest:e}, {slope:e} a step");
    }
}
