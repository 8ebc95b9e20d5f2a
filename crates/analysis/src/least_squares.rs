//! Non-linear least squares: the parameters for which a model comes nearest to data.
//!
//! Levenberg and Marquardt's method: (J^T J + mu D) h = -J^T r with D the largest diagonal of J^T J so far, which
//! makes it independent of the parameters' units (More 1978); mu follows the ratio of the gained to the promised
//! (Madsen, Nielsen, Tingleff, *Methods for non-linear least squares problems*, 2004, section 3.2).

/// Residuals over their uncertainties, and their derivatives: one list for each parameter.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Model {
    /// What is left between model and data.
    pub residuals: Vec<f64>,
    /// For each parameter, the derivative of every residual.
    pub slopes: Vec<Vec<f64>>,
}

/// The nearest model.
#[derive(Clone, Debug, PartialEq)]
pub struct Outcome {
    /// The parameters.
    pub parameters: Vec<f64>,
    /// The sum of the squares that is left.
    pub squares: f64,
    /// The inverse of J^T J there: the covariance, where the residuals are in units of their uncertainty.
    pub covariance: Vec<Vec<f64>>,
    /// Models that were computed.
    pub models: u32,
}

/// The data do not determine this parameter: nothing depends on it, or only together with others.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Undetermined(pub usize);

const MOST_MODELS: u32 = 200;
/// A promised gain below this share of the squares is none.
const NO_GAIN: f64 = 1e-14;
/// Nor is a step below this share of every parameter.
const NO_STEP: f64 = 1e-14;
/// With more damping than this no step helps.
const MOST_DAMPING: f64 = 1e16;
/// A pivot below this share of its diagonal is zero but for rounding.
const NO_PIVOT: f64 = 1e-14;

/// A model at parameters: `None` where they make no sense; an error of its own ends the search.
pub type Asked<'a, E> = &'a mut dyn FnMut(&[f64]) -> Result<Option<Model>, E>;

/// Finds the parameters.
///
/// # Errors
/// The model's.
pub fn least_squares<E>(start: &[f64], model: Asked<E>) -> Result<Result<Outcome, Undetermined>, E> {
    let mut parameters = start.to_vec();
    let Some(mut here) = model(&parameters)? else { return Ok(Err(Undetermined(0))) };
    let mut squares = sum(&here.residuals);
    let (mut damping, mut raise, mut models) = (1e-3, 2.0, 1);
    let mut scale = vec![0.0; parameters.len()];
    loop {
        let (normal, gradient) = equations(&here);
        for (k, scale) in scale.iter_mut().enumerate() {
            *scale = if normal[k][k] > *scale { normal[k][k] } else { *scale };
        }
        if let Some(k) = scale.iter().position(|s| *s == 0.0) {
            return Ok(Err(Undetermined(k)));
        }
        let damped = |damping: f64| {
            let mut normal = normal.clone();
            for (k, row) in normal.iter_mut().enumerate() {
                row[k] += damping * scale[k];
            }
            normal
        };
        // Tries steps until one is taken, or none is worth it.
        let taken = loop {
            let Ok(root) = cholesky(&damped(damping)) else {
                damping *= 10.0;
                if damping > MOST_DAMPING {
                    break None;
                }
                continue;
            };
            let step = solve(&root, &gradient.iter().map(|g| -g).collect::<Vec<_>>());
            let each = step.iter().zip(&gradient).zip(&scale);
            let promised = each.fold(0.0, |sum, ((h, g), d)| sum + h * (damping * d * h - g));
            let small = step.iter().zip(&parameters).all(|(h, p)| h.abs() <= NO_STEP * p.abs());
            if small || promised <= NO_GAIN * squares || models >= MOST_MODELS || damping > MOST_DAMPING {
                break None;
            }
            let tried: Vec<f64> = parameters.iter().zip(&step).map(|(p, h)| p + h).collect();
            models += 1;
            let there = model(&tried)?.filter(|m| sum(&m.residuals).is_finite());
            let gained = there.as_ref().map_or(-1.0, |m| (squares - sum(&m.residuals)) / promised);
            if let (Some(there), true) = (there, gained > 0.0) {
                let twist = 2.0 * gained - 1.0;
                let less = 1.0 - twist * twist * twist;
                damping *= if less > 1.0 / 3.0 { less } else { 1.0 / 3.0 };
                raise = 2.0;
                break Some((tried, there));
            }
            damping *= raise;
            raise *= 2.0;
        };
        let Some((tried, there)) = taken else {
            return Ok(cholesky(&normal).map(|root| Outcome {
                covariance: inverse(&root),
                parameters,
                squares,
                models,
            }));
        };
        (parameters, here) = (tried, there);
        squares = sum(&here.residuals);
    }
}

fn sum(residuals: &[f64]) -> f64 {
    residuals.iter().fold(0.0, |sum, r| sum + r * r)
}

/// J^T J and J^T r.
fn equations(model: &Model) -> (Vec<Vec<f64>>, Vec<f64>) {
    let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).fold(0.0, |sum, (x, y)| sum + x * y);
    let row = |a: &Vec<f64>| model.slopes.iter().map(|b| dot(a, b)).collect();
    (
        model.slopes.iter().map(row).collect(),
        model.slopes.iter().map(|slope| dot(slope, &model.residuals)).collect(),
    )
}

/// The lower triangle L with A = L L^T; the parameter whose pivot is nothing but rounding where there is none.
fn cholesky(a: &[Vec<f64>]) -> Result<Vec<Vec<f64>>, Undetermined> {
    let n = a.len();
    let mut root = vec![vec![0.0; n]; n];
    for i in 0..n {
        for j in 0..=i {
            let rest = (0..j).fold(a[i][j], |rest, k| rest - root[i][k] * root[j][k]);
            if i > j {
                root[i][j] = rest / root[j][j];
            } else if rest > NO_PIVOT * a[i][i] {
                root[i][i] = rest.sqrt();
            } else {
                return Err(Undetermined(i));
            }
        }
    }
    Ok(root)
}

/// L L^T x = b.
fn solve(root: &[Vec<f64>], b: &[f64]) -> Vec<f64> {
    let n = b.len();
    let mut x = b.to_vec();
    for i in 0..n {
        x[i] = (0..i).fold(x[i], |rest, k| rest - root[i][k] * x[k]) / root[i][i];
    }
    for i in (0..n).rev() {
        x[i] = (i + 1..n).fold(x[i], |rest, k| rest - root[k][i] * x[k]) / root[i][i];
    }
    x
}

fn inverse(root: &[Vec<f64>]) -> Vec<Vec<f64>> {
    let unit = |k: usize| (0..root.len()).map(|i| if i == k { 1.0 } else { 0.0 }).collect::<Vec<f64>>();
    (0..root.len()).map(|k| solve(root, &unit(k))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use precess_scalar::Scalar;
    use std::convert::Infallible;

    /// Misra1a of NIST's reference data (dental research, monomolecular adsorption): y = b1 (1 - exp(-b2 x)).
    const MISRA: [[f64; 2]; 14] = [
        [10.07, 77.6],
        [14.73, 114.9],
        [17.94, 141.1],
        [23.93, 190.8],
        [29.61, 239.9],
        [35.18, 289.0],
        [40.02, 332.8],
        [44.82, 378.4],
        [50.76, 434.8],
        [55.05, 477.3],
        [61.01, 536.8],
        [66.40, 593.1],
        [75.47, 689.1],
        [81.78, 760.0],
    ];

    fn misra(p: &[f64]) -> Model {
        let decay = |x: f64| Scalar::exp(-p[1] * x);
        Model {
            residuals: MISRA.iter().map(|[y, x]| p[0] * (1.0 - decay(*x)) - y).collect(),
            slopes: vec![
                MISRA.iter().map(|[_, x]| 1.0 - decay(*x)).collect(),
                MISRA.iter().map(|[_, x]| p[0] * x * decay(*x)).collect(),
            ],
        }
    }

    fn found(start: &[f64], model: &dyn Fn(&[f64]) -> Option<Model>) -> Result<Outcome, Undetermined> {
        let Ok(outcome) = least_squares::<Infallible>(start, &mut |p| Ok(model(p)));
        outcome
    }

    #[test]
    fn a_reference_problem_gives_its_certified_digits() {
        for start in [[500.0, 0.0001], [250.0, 0.0005]] {
            let found = found(&start, &|p| Some(misra(p))).expect("determined");
            let near = |x: f64, wanted: f64, digits: f64| {
                assert!((x / wanted - 1.0).abs() < digits, "{x} is not {wanted}");
            };
            near(found.parameters[0], 2.3894212918e2, 1e-8);
            near(found.parameters[1], 5.5015643181e-4, 1e-8);
            near(found.squares, 1.2455138894e-1, 1e-9);
            let variance = found.squares / 12.0;
            near((variance * found.covariance[0][0]).sqrt(), 2.7070075241, 1e-7);
            near((variance * found.covariance[1][1]).sqrt(), 7.2668688436e-6, 1e-7);
            assert!(found.models < 60, "{} models", found.models);
        }
    }

    #[test]
    fn what_data_do_not_determine_is_named() {
        let idle = |p: &[f64]| {
            let mut model = misra(p);
            model.slopes.push(vec![0.0; MISRA.len()]);
            Some(model)
        };
        assert_eq!(found(&[250.0, 0.0005, 1.0], &idle), Err(Undetermined(2)));
        // The same parameter under two names.
        let twice = |p: &[f64]| {
            let mut model = misra(&[p[0] + p[2], p[1]]);
            model.slopes.push(model.slopes[0].clone());
            Some(model)
        };
        assert_eq!(found(&[150.0, 0.0005, 100.0], &twice), Err(Undetermined(2)));
    }

    #[test]
    fn a_step_out_of_the_model_is_taken_back() {
        let bounded = |p: &[f64]| (p[1] > 0.0 && p[1] < 0.01).then(|| misra(p));
        let found = found(&[20.0, 0.009], &bounded).expect("determined");
        assert!((found.parameters[0] - 238.94).abs() < 0.01);
    }
}
