pub mod free_body;
pub mod gyroscope;
pub mod tippe_top_rolling;

use precess_scalar::Scalar;

/// Refuses a start on the singularity of the Euler angles, where psi and phi are the same rotation.
fn refuse_vertical(theta: f64) -> Result<(), String> {
    if Scalar::sin(theta).abs() > 1e-12 {
        return Ok(());
    }
    Err(format!(
        "theta = {theta} puts the axis on the vertical, where Euler angles are singular: tilt it a little, or \
         use a model written in quaternions, such as heavy_top"
    ))
}
