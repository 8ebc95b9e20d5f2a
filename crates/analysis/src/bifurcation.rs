//! The attractor against a parameter: where the settled motion comes by, once a period of the drive, or at its
//! highest points where there is no drive.

use crate::flow::{Flow, Stopped};
use crate::poincare::{Section, section, strobe};
use precess_system::Direction;

/// How the settled motion is looked at.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Visit {
    /// The number of the state that is recorded.
    pub coordinate: usize,
    /// The period of the drive; `None`: where the number is highest.
    pub period: Option<f64>,
    /// Time before the first record.
    pub settle: f64,
    /// Time of recording.
    pub record: f64,
}

/// The values of the number at its visits, from a full state that moves along (so that a sweep follows a branch).
///
/// # Errors
/// Where the integration cannot go on.
pub fn visits(flow: &Flow, state: &mut [f64], visit: &Visit) -> Result<Vec<f64>, Stopped> {
    let whole = |time: f64| visit.period.map_or(time, |period| (time / period).ceil() * period);
    if visit.settle > 0.0 {
        flow.advance(0.0, state, whole(visit.settle))?;
    }
    let record = whole(visit.record);
    let (crossings, failure) = if let Some(period) = visit.period {
        // Whole periods from zero: the drive is where it was.
        strobe(flow, state, record, (period, period))
    } else {
        let full = flow.field.shape().full();
        let rate = |t: f64, y: &[f64]| {
            let mut rate = vec![0.0; full];
            flow.field.rate(t, y, &mut rate);
            rate[visit.coordinate]
        };
        let highest = Section { quantity: &rate, value: 0.0, period: None, direction: Direction::Falling };
        section(flow, state, record, &highest)
    };
    if let Some(last) = crossings.last() {
        state.copy_from_slice(&last.state);
    }
    match failure {
        Some(failure) => Err(failure),
        None => Ok(crossings.iter().map(|c| c.state[visit.coordinate]).collect()),
    }
}
