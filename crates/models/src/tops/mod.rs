mod contact;
mod euler_angles;
pub mod free_body;
pub mod gyroscope;
mod gyroscope_card;
pub mod gyroscope_integrals;
pub mod gyroscope_rolling;
pub mod heavy_top;
mod lagrange;
mod phase;
mod poinsot;
pub mod rolling_top;
pub mod symmetric_body;
pub mod tippe_top_rolling;
mod truncated_sphere;

/// Whether some body has these principal moments of inertia about its centre of mass: none exceeds the sum of the others.
///
/// # Errors
/// One sentence: which does.
pub(crate) fn possible_inertia(moments: [f64; 3]) -> Result<(), String> {
    let [i1, i2, i3] = moments;
    for (a, b, c, name) in [(i1, i2, i3, "i1"), (i2, i3, i1, "i2"), (i3, i1, i2, "i3")] {
        // A flat body has equality, which rounding may just miss.
        if a > (b + c) * (1.0 + 1e-12) {
            return Err(format!(
                "no body has these moments of inertia: {name} = {a} exceeds the sum {} of the two others",
                b + c
            ));
        }
    }
    Ok(())
}
