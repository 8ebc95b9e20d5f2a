//! Bodies and starts that make no sense, each in a sentence.

use super::body::Body;
use super::measure::height;
use super::top::Top;
use crate::rotation::dot;
use precess_scalar::Scalar;
use precess_system::State;

/// Whether body and attitude at the start can be.
pub(super) fn check(top: &Top, s: &State<f64>) -> Result<(), String> {
    let seen = top.see(s);
    let body = &seen.body;
    possible(body)?;
    if body.radius < 0.0 || body.axes.iter().any(|&a| a < 0.0) {
        return Err("the body is not convex: radius and axes of its support must not be below zero".into());
    }
    let reach = [0, 1, 2].map(|i| body.axes[i] * seen.touch.gamma[i]);
    let longest = body.axes.iter().fold(0.0, |a: f64, &b| a.larger(b));
    if longest > 0.0 && dot(reach, reach).sqrt() < 1e-9 * longest {
        return Err(
            "a flat face lies on the table: only contacts in a point are modelled, so tilt it a little"
                .into(),
        );
    }
    let [height, _] = height(&seen);
    if height <= 0.0 {
        return Err(format!(
            "the centre of mass would start {height} m above the table, that is not above it: the body reaches no \
             farther down in this attitude"
        ));
    }
    Ok(())
}

/// Whether a body of some shape has this inertia: positive, and no moment above the sum of the two others.
fn possible(body: &Body<f64>) -> Result<(), String> {
    let [[d1, o12, o13], [_, d2, o23], [_, _, d3]] = body.inertia;
    // The second moments of mass, half the trace minus the inertia, must not be negative; a flat body has zero.
    let half = (d1 + d2 + d3) / 2.0;
    let (m1, m2, m3) = (half - d1, half - d2, half - d3);
    let slack = -1e-12 * half;
    let minors = [m1 * m2 - o12 * o12, m1 * m3 - o13 * o13, m2 * m3 - o23 * o23];
    let determinant = m1 * minors[2] - o12 * (o12 * m3 + o13 * o23) - o13 * (o12 * o23 + o13 * m2);
    let sound = [m1, m2, m3].iter().all(|&m| m >= slack)
        && minors.iter().all(|&m| m >= slack * half)
        && determinant >= slack * half * half
        && d1 > 0.0
        && d2 > 0.0
        && d3 > 0.0;
    if sound {
        return Ok(());
    }
    Err("no body has this inertia: its moments must be positive, and none may exceed the sum of the two others \
         (products of inertia included)"
        .into())
}
