//! A wheel with eight buckets under a stream of water (P, exercise 8).
//!
//! Bucket i hangs at the angle `theta_i = theta + i pi / 4` from the downward vertical; M is all the water.
//!
//!     theta'' = -k (sum of m_i sin theta_i) / M - gamma theta' / M      the wheel rests while M <= threshold
//!     m_i'    = inflow           for the bucket under the stream (within `window` of the top)
//!             = -evaporation     for every other bucket that holds more than `floor`
//!             = 0                at the floor, and for the last bucket that the stream has touched
//!
//! A bucket that passes `capacity` empties at once and goes on filling. Between these events everything is
//! smooth: what each bucket does is a mode that changes at events alone, so a method of any order keeps its
//! order. P's program is Euler-Cromer with dt = 0.001, which adds 1/9 to a bucket each step: inflow 1000/9;
//! 20 pixels of water are full, 40/9 a pixel: capacity 800/9; 1/180 evaporates each step: 50/9 a unit of time.
//!
//! P gives no units: all numbers are pure here. `malkus_waterwheel` is the wheel with infinitely many leaking
//! buckets; this one is driven by the emptying of the full ones.

use super::noria_card::{self, BUCKETS};
use precess_scalar::Scalar;
use precess_system::{Card, State, System};
use std::f64::consts::PI;

/// See the module.
#[derive(Clone)]
pub struct Noria;

/// What a bucket does: its mode.
const EVAPORATING: f64 = -1.0;
const RESTING: f64 = 0.0;
/// The last one the stream has touched, which P spares from evaporation.
const SPARED: f64 = 1.0;
const FILLING: f64 = 2.0;

/// Places in the full state: theta, the masses, `theta_dot`, a mode a bucket, whether the wheel turns.
const MASS: usize = 1;
const VELOCITY: usize = MASS + BUCKETS;
const MODE: usize = VELOCITY + 1;
const TURNING: usize = MODE + BUCKETS;

/// The events in the order of the card: in groups of one a bucket, then those of the wheel.
const ENTERS: usize = 0;
const LEAVES: usize = 1;
const FULL: usize = 2;
const DRY: usize = 3;
const GROUPS: usize = 4;
/// After the groups: the wheel carries enough water to turn, or no longer.
const SETS_OFF: usize = GROUPS * BUCKETS;
const HALTS: usize = SETS_OFF + 1;

/// The eight masses of water.
#[inline(always)]
fn masses<S: Scalar>(s: &State<S>) -> [S; BUCKETS] {
    let [_theta, m0, m1, m2, m3, m4, m5, m6, m7] = s.q();
    [m0, m1, m2, m3, m4, m5, m6, m7]
}

/// Bucket i from the downward vertical.
#[inline(always)]
fn angle<S: Scalar>(s: &State<S>, bucket: usize) -> S {
    s.coordinates[0] + bucket as f64 * (PI / 4.0)
}

/// Added from the first bucket on.
#[inline(always)]
fn sum<S: Scalar>(numbers: [S; BUCKETS]) -> S {
    numbers[1..].iter().fold(numbers[0], |sum, &x| sum + x)
}

/// The moment of the water's weight about the axle: the sum of `m_i sin theta_i`.
#[inline(always)]
fn moment<S: Scalar>(s: &State<S>) -> S {
    let masses = masses(s);
    sum(std::array::from_fn(|i| masses[i] * angle(s, i).sin()))
}

/// Above zero while the bucket is under the stream: `cos(theta_i - pi) - cos(window)`.
#[inline(always)]
fn under_stream<S: Scalar>(s: &State<S>, bucket: usize) -> S {
    let [_k, _gamma, _inflow, _capacity, _evaporation, _floor, window] = s.p();
    -angle(s, bucket).cos() - window.cos()
}

/// Whether a mode is a given one; modes are whole numbers.
#[inline(always)]
fn is<S: Scalar>(mode: S, one: f64) -> S::Mask {
    (mode - one).abs().lt(S::from(0.5))
}

/// The mode of a bucket that the stream no longer spares.
#[inline(always)]
fn dry_or_not<S: Scalar>(mass: S, floor: S) -> S {
    S::select(mass.gt(floor), S::from(EVAPORATING), S::from(RESTING))
}

/// A wheel that does not turn stands still.
#[inline(always)]
fn halt<S: Scalar>(y: &mut [S]) {
    y[TURNING] = S::from(0.0);
    y[VELOCITY] = S::from(0.0);
}

/// Empties a bucket that is full; the wheel halts where too little water is left.
#[inline(always)]
fn tip<S: Scalar>(bucket: usize, capacity: S, threshold: S, y: &mut [S]) {
    let (mass, zero) = (y[MASS + bucket], S::from(0.0));
    y[MASS + bucket] = S::select(capacity.le(mass), zero, mass);
    let masses: [S; BUCKETS] = std::array::from_fn(|i| y[MASS + i]);
    let enough = sum(masses).gt(threshold);
    y[TURNING] = S::select(enough, y[TURNING], zero);
    y[VELOCITY] = S::select(enough, y[VELOCITY], zero);
}

impl System for Noria {
    fn card(&self) -> Card {
        noria_card::card_of_noria()
    }

    #[inline(always)]
    fn equations<S: Scalar>(&self, s: &State<S>, highest: &mut [S]) {
        let ([w], [k, gamma, inflow, _capacity, evaporation]) = (s.v(), s.p());
        let (zero, one) = (S::from(0.0), S::from(1.0));
        let turning = is(s.modes[BUCKETS], 1.0);
        let water = S::select(turning, sum(masses(s)), one);
        highest[0] = S::select(turning, -((k * moment(s) + gamma * w) / water), zero);
        for (rate, &mode) in highest[MASS..].iter_mut().zip(s.modes) {
            let loss = S::select(is(mode, EVAPORATING), -evaporation, zero);
            *rate = S::select(is(mode, FILLING), inflow, loss);
        }
    }

    #[inline(always)]
    fn observe<S: Scalar>(&self, s: &State<S>, out: &mut [S]) {
        out.copy_from_slice(&[sum(masses(s)), moment(s)]);
    }

    #[inline(always)]
    fn crossings<S: Scalar>(&self, s: &State<S>, out: &mut [S]) {
        let [_k, _gamma, _inflow, capacity, _evaporation, floor, _window, threshold] = s.p();
        let masses = masses(s);
        for i in 0..BUCKETS {
            let stream = under_stream(s, i);
            out[ENTERS * BUCKETS + i] = stream;
            out[LEAVES * BUCKETS + i] = stream;
            out[FULL * BUCKETS + i] = masses[i] - capacity;
            out[DRY * BUCKETS + i] = masses[i] - floor;
        }
        let enough = sum(masses) - threshold;
        out[SETS_OFF] = enough;
        out[HALTS] = enough;
    }

    #[inline(always)]
    fn jump<S: Scalar>(&self, event: usize, s: &State<S>, y: &mut [S]) {
        let [_k, _gamma, _inflow, capacity, _evaporation, floor, _window, threshold] = s.p();
        let bucket = event % BUCKETS;
        let mode = y[MODE + bucket];
        match event {
            SETS_OFF => return y[TURNING] = S::from(1.0),
            HALTS => return halt(y),
            _ => {}
        }
        match event / BUCKETS {
            ENTERS => {
                // The one before is spared no longer.
                for i in 0..BUCKETS {
                    let touched = y[MODE + i].gt(S::from(0.5));
                    y[MODE + i] = S::select(touched, dry_or_not(y[MASS + i], floor), y[MODE + i]);
                }
                y[MODE + bucket] = S::from(FILLING);
                tip(bucket, capacity, threshold, y);
            }
            LEAVES => y[MODE + bucket] = S::select(is(mode, FILLING), S::from(SPARED), mode),
            FULL => tip(bucket, capacity, threshold, y),
            DRY => y[MODE + bucket] = S::select(is(mode, EVAPORATING), S::from(RESTING), mode),
            _ => {}
        }
    }

    fn start_modes(&self, s: &State<f64>, modes: &mut [f64]) {
        let [_k, _gamma, _inflow, _capacity, _evaporation, floor, _window, threshold] = s.p();
        for (i, (mode, mass)) in modes.iter_mut().zip(masses(s)).enumerate() {
            *mode = if under_stream(s, i) > 0.0 { FILLING } else { dry_or_not(mass, floor) };
        }
        modes[BUCKETS] = f64::from(u8::from(sum(masses(s)) > threshold));
    }

    fn check(&self, s: &State<f64>) -> Result<(), String> {
        let [_k, _gamma, _inflow, capacity, _evaporation, _floor, _window, threshold] = s.p();
        if let Some((i, m)) = masses(s).into_iter().enumerate().find(|&(_, m)| m < 0.0 || m >= capacity) {
            return Err(format!(
                "bucket {i} cannot hold {m}: it starts with 0 or more, and less than {capacity}"
            ));
        }
        if sum(masses(s)) <= threshold && s.v() != [0.0] {
            return Err(
                "a wheel without water rests: theta_dot must be 0, or give the buckets some water".into()
            );
        }
        Ok(())
    }
}
