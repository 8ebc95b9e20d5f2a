//! How wide an interval of confidence is, in standard errors.

/// For a probability of 95 %: with the uncertainties known, or judged from a scatter with so many degrees of freedom.
pub fn quantile(freedom: Option<usize>) -> f64 {
    freedom.map_or(NORMAL, |freedom| student(freedom as f64))
}

/// The 97.5 % point of the normal distribution.
const NORMAL: f64 = 1.959_963_984_540_054;

/// That of Student's, by the expansion about the normal one (Abramowitz and Stegun 26.7.5); within 2 % from three
/// degrees of freedom on, exact for one and two.
fn student(freedom: f64) -> f64 {
    if freedom < 1.5 {
        return 12.706_204_736_174_7;
    }
    if freedom < 2.5 {
        return 4.302_652_729_749_46;
    }
    let z = NORMAL;
    let (z3, z5) = (z * z * z, z * z * z * z * z);
    let z7 = z5 * z * z;
    let z9 = z7 * z * z;
    let one = (z3 + z) / 4.0;
    let two = (5.0 * z5 + 16.0 * z3 + 3.0 * z) / 96.0;
    let three = (3.0 * z7 + 19.0 * z5 + 17.0 * z3 - 15.0 * z) / 384.0;
    let four = (79.0 * z9 + 776.0 * z7 + 1482.0 * z5 - 1920.0 * z3 - 945.0 * z) / 92160.0;
    z + (one + (two + (three + four / freedom) / freedom) / freedom) / freedom
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn students_distribution_has_its_tabulated_points() {
        for (freedom, wanted) in
            [(1.0, 12.7062), (2.0, 4.3027), (5.0, 2.5706), (10.0, 2.2281), (30.0, 2.0423)]
        {
            let found = student(freedom);
            assert!((found / wanted - 1.0).abs() < 1e-3, "{freedom}: {found} is not {wanted}");
        }
        assert!((student(3.0) / 3.1824 - 1.0).abs() < 0.02);
    }
}
