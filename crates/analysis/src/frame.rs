//! Frames of tangent vectors, made orthonormal in a fixed order of operations.

/// The product of two vectors, summed in the order of the components.
pub(crate) fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).fold(0.0, |sum, (x, y)| sum + x * y)
}

/// Makes the vectors orthonormal, one after another (modified Gram-Schmidt, twice: "twice is enough", Kahan), and
/// gives the diagonal of R: how much each stuck out of the space of those before.
pub(crate) fn orthonormalise(vectors: &mut [Vec<f64>]) -> Vec<f64> {
    let mut diagonal = vec![];
    for k in 0..vectors.len() {
        let (done, rest) = vectors.split_at_mut(k);
        let own = &mut rest[0];
        for _ in 0..2 {
            for other in done.iter() {
                let share = dot(own, other);
                own.iter_mut().zip(other).for_each(|(x, y)| *x -= share * y);
            }
        }
        let length = dot(own, own).sqrt();
        for x in own.iter_mut() {
            *x /= length;
        }
        diagonal.push(length);
    }
    diagonal
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_skew_frame_becomes_orthonormal_and_keeps_its_volume() {
        let mut frame = vec![vec![1.0, 1e-9, 0.0], vec![1.0, 0.0, 1e-9], vec![1.0, 0.0, 0.0]];
        let diagonal = orthonormalise(&mut frame);
        for i in 0..3 {
            for j in 0..3 {
                let wanted = if i == j { 1.0 } else { 0.0 };
                assert!((dot(&frame[i], &frame[j]) - wanted).abs() < 1e-14);
            }
        }
        // |det| of the frame is 1e-18; the third vector keeps seven of its digits.
        let volume = diagonal.iter().product::<f64>();
        assert!((volume - 1e-18).abs() < 1e-24, "{volume}");
    }
}
