//! The answer to a periodic drive: amplitude and phase once the motion has settled.

use crate::flow::{Flow, Stopped};
use crate::linear::{drive, forcing, linear};
use crate::matrix::Matrix;
use precess_scalar::Scalar;

/// A settled oscillation at the frequency of the drive.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Response {
    /// Angular frequency of the drive.
    pub omega: f64,
    /// Amplitude of the fundamental.
    pub amplitude: f64,
    /// How far it lags behind the drive, in [0, 2 pi).
    pub lag: f64,
    /// Half the distance from the lowest to the highest point: the amplitude, where there is nothing but the
    /// fundamental.
    pub swing: f64,
}

impl Response {
    /// From the cosine and sine parts of motion and drive.
    pub(crate) fn of(omega: f64, motion: [f64; 2], drive: [f64; 2]) -> Self {
        let angle = |[cos, sin]: [f64; 2]| Scalar::atan2(sin, cos);
        let lag = angle(motion) - angle(drive);
        let lag = lag - (lag / std::f64::consts::TAU).floor() * std::f64::consts::TAU;
        let amplitude = Scalar::hypot(motion[0], motion[1]);
        Self { omega, amplitude, lag, swing: amplitude }
    }
}

/// Samples of a period.
const SAMPLES: f64 = 128.0;
/// Periods over which the settled motion is measured: a subharmonic of order two, three or four averages out.
const MEASURED: f64 = 12.0;

/// The settled oscillation of a coordinate, from a full state that moves along (so that a sweep follows a branch). A
/// linear system is put onto its periodic orbit at once, any other one is left to itself for `settle` periods.
///
/// # Errors
/// Where the integration cannot go on.
pub fn response(
    flow: &Flow,
    state: &mut [f64],
    period: f64,
    settle: f64,
    coordinate: usize,
) -> Result<Response, Stopped> {
    if linear(flow).is_some() {
        periodic_orbit(flow, state, period)?;
    } else if settle > 0.0 {
        flow.advance(0.0, state, settle.ceil() * period)?;
    }
    let omega = std::f64::consts::TAU / period;
    let (mut motion, mut low, mut high) = ([0.0; 2], f64::INFINITY, f64::NEG_INFINITY);
    let start = state.to_vec();
    let mut record = |t: f64, y: &[f64]| {
        state.copy_from_slice(y);
        let x = y[coordinate];
        (low, high) = (Scalar::smaller(low, x), Scalar::larger(high, x));
        // The last sample is the first of the next period.
        if t < (MEASURED - 0.5 / SAMPLES) * period {
            let (sin, cos) = Scalar::sin_cos(omega * t);
            motion[0] += x * cos;
            motion[1] += x * sin;
        }
    };
    let report = flow.run(0.0, &start, (MEASURED * period, period / SAMPLES), &[], &mut record);
    if let Some(failure) = report.failure {
        return Err(failure);
    }
    let motion = motion.map(|sum| sum * 2.0 / (SAMPLES * MEASURED));
    let parts = forcing(flow, period);
    Ok(Response { swing: (high - low) * 0.5, ..Response::of(omega, motion, drive(flow, &parts, coordinate)) })
}

/// The exact answer, where the equations are linear.
pub fn exact_response(flow: &Flow, period: f64, coordinate: usize) -> Option<Response> {
    linear(flow)?.steady(flow, period, coordinate)
}

/// Newton's method on the map over a period: the state from which the motion closes. One step does for a linear
/// system.
///
/// # Errors
/// Where the integration cannot go on. A state that does not close is left as near as it came.
pub(crate) fn periodic_orbit(flow: &Flow, state: &mut [f64], period: f64) -> Result<Matrix, Stopped> {
    let size = flow.size();
    let mut before = f64::INFINITY;
    loop {
        let mut end = state.to_vec();
        let map = flow.derivative(0.0, &mut end, period)?;
        let gap: Vec<f64> = (0..size).map(|i| state[i] - end[i]).collect();
        let distance = crate::frame::dot(&gap, &gap).sqrt();
        let mut minus = map.clone();
        minus.numbers.iter_mut().for_each(|x| *x = -*x);
        (0..size).for_each(|i| minus.set(i, i, 1.0 + minus.at(i, i)));
        // x' = x - (1 - M)^-1 (x - P(x)); the end is where it comes no nearer any more.
        let Some(step) = minus.solve(&gap).filter(|_| distance < before * 0.5 && distance > 0.0) else {
            return Ok(map);
        };
        before = distance;
        state.iter_mut().zip(&step).for_each(|(x, d)| *x -= d);
    }
}
