//! A body that slips: the system. Its equations are in `sliding.rs`, its regimes in `regimes.rs`.

use super::body::minus;
use super::check::check;
use super::friction::{COULOMB, Friction};
use super::measure::{Found, height, measure};
use super::parameters::card_of;
use super::regimes::{self, FLIES, ROLLS, SLIDES, is};
use super::rolling::roll;
use super::sliding::slide;
use super::top::{Seen, Top};
use crate::attitude;
use crate::inertia::{apply, solve};
use crate::rotation::{Vector, cross, dot, quaternion_rate};
use precess_scalar::Scalar;
use precess_system::{Card, Given, Layout, State, System, Values};

/// A body that slips.
#[derive(Clone)]
pub struct Slider(pub(super) &'static Top);

/// What moves the body besides gravity; force and moment along the table's axes.
pub(super) struct Acts<S> {
    pub omega_dot: Vector<S>,
    pub force: [S; 3],
    pub drill: S,
    pub denominator: S,
}

impl<S: Scalar> Acts<S> {
    #[inline(always)]
    fn select(mask: S::Mask, a: &Self, b: &Self) -> Self {
        let vector = |a: Vector<S>, b: Vector<S>| [0, 1, 2].map(|i| S::select(mask, a[i], b[i]));
        Self {
            omega_dot: vector(a.omega_dot, b.omega_dot),
            force: vector(a.force, b.force),
            drill: S::select(mask, a.drill, b.drill),
            denominator: S::select(mask, a.denominator, b.denominator),
        }
    }
}

impl Slider {
    /// Parameters of the friction, after those of body and table; and the restitution.
    #[inline(always)]
    pub(super) fn friction<S: Scalar>(&self, s: &State<S>) -> (Friction<S>, S) {
        let p = &s.values.numbers[self.0.form.count() + self.0.of_table()..];
        (Friction { law: s.choice(0), mu: p[0], epsilon: p[1], speed: p[2], spot: p[3] }, p[4])
    }

    /// The slip of the contact point along the table.
    #[inline(always)]
    pub(super) fn slip<S: Scalar>(seen: &Seen<S>, s: &State<S>) -> [S; 2] {
        let swing = cross(seen.omega, seen.touch.r);
        let [vx, vy] = s.v();
        [vx + dot(seen.rows[0], swing), vy + dot(seen.rows[1], swing)]
    }

    /// What acts while the body slides, with this direction of slip where nothing slips.
    #[inline(always)]
    pub(super) fn sliding<S: Scalar>(&self, s: &State<S>, seen: &Seen<S>, direction: [S; 2]) -> Acts<S> {
        let (friction, _) = self.friction(s);
        let slip = Self::slip(seen, s);
        let grip = if friction.law == COULOMB {
            friction.dry(slip, direction)
        } else {
            friction.grip(slip, dot(seen.touch.gamma, seen.omega))
        };
        let moving = slide(&seen.body, &seen.touch, &seen.rows, seen.omega, seen.felt[1], seen.torque, &grip);
        let pressed = moving.pressed;
        let force = [pressed * grip.k[0], pressed * grip.k[1], moving.normal];
        let drill = pressed * grip.drill;
        Acts { omega_dot: moving.omega_dot, force, drill, denominator: moving.denominator }
    }

    /// What acts while it rolls: the denominator is that of a push along the normal alone.
    #[inline(always)]
    pub(super) fn rolling<S: Scalar>(seen: &Seen<S>) -> Acts<S> {
        let rolling = roll(&seen.body, &seen.touch, seen.omega, seen.gravity(), seen.torque);
        let arm = cross(seen.touch.r, seen.touch.gamma);
        let denominator = S::from(1.0) / seen.body.mass + dot(arm, solve(seen.body.inertia, arm));
        let force = seen.on_table(rolling.force);
        Acts { omega_dot: rolling.omega_dot, force, drill: S::from(0.0), denominator }
    }

    /// What acts in the regime of the state.
    #[inline(always)]
    pub(super) fn acts<S: Scalar>(&self, s: &State<S>, seen: &Seen<S>) -> Acts<S> {
        let zero = S::from(0.0);
        let [regime, dx, dy] = s.modes.first_chunk().copied().unwrap_or([zero; 3]);
        let sliding = self.sliding(s, seen, [dx, dy]);
        if s.modes.is_empty() {
            return sliding;
        }
        let rolling = Self::rolling(seen);
        let contact = Acts::select(is(regime, ROLLS), &rolling, &sliding);
        let spin = cross(seen.omega, apply(seen.body.inertia, seen.omega));
        let free = minus(seen.torque, spin);
        let flight = Acts {
            omega_dot: solve(seen.body.inertia, free),
            force: [zero; 3],
            drill: zero,
            denominator: rolling.denominator,
        };
        Acts::select(is(regime, FLIES), &flight, &contact)
    }
}

impl System for Slider {
    fn card(&self) -> Card {
        card_of(self.0, true)
    }

    fn layout(&self, values: &Values<f64>, _given: &Given) -> Layout {
        regimes::layout(&self.card(), values)
    }

    #[inline(always)]
    fn equations<S: Scalar>(&self, s: &State<S>, highest: &mut [S]) {
        let seen = self.0.see(s);
        let acts = self.acts(s, &seen);
        highest[..4].copy_from_slice(&quaternion_rate(seen.attitude, seen.omega));
        highest[4..7].copy_from_slice(&acts.omega_dot);
        highest[7] = acts.force[0] / seen.body.mass + seen.felt[0];
        highest[8] = acts.force[1] / seen.body.mass;
        if regimes::is_free(s.values) {
            highest[9] = acts.force[2] / seen.body.mass + seen.felt[1];
        }
    }

    #[inline(always)]
    fn observe<S: Scalar>(&self, s: &State<S>, out: &mut [S]) {
        let seen = self.0.see(s);
        let acts = self.acts(s, &seen);
        let [fx, fy, _] = Self::rolling(&seen).force;
        let [touching, rising] = height(&seen);
        let (mut height, mut rise) = (touching, rising);
        if regimes::is_free(s.values) {
            let flies = is(s.modes[0], FLIES);
            (height, rise) =
                (S::select(flies, s.coordinates[9], touching), S::select(flies, s.velocities[2], rising));
        }
        let found = Found {
            place: [s.coordinates[7], s.coordinates[8]],
            velocity: s.v(),
            height,
            rise,
            slip: Self::slip(&seen, s),
            force: acts.force,
            drill: acts.drill,
            needed: (fx * fx + fy * fy).sqrt(),
            denominator: acts.denominator,
            regime: s.modes.first().copied().unwrap_or(S::from(SLIDES)),
        };
        measure(self.0, &seen, &found, out);
    }

    #[inline(always)]
    fn crossings<S: Scalar>(&self, s: &State<S>, out: &mut [S]) {
        self.watch(s, out);
    }

    #[inline(always)]
    fn jump<S: Scalar>(&self, event: usize, s: &State<S>, y: &mut [S]) {
        self.change(event, s, y);
    }

    fn start(&self, given: &Given, values: &Values<f64>, y: &mut [f64]) -> Result<(), String> {
        attitude::start(given, y)?;
        self.put_on_the_table(given, values, y)
    }

    fn start_modes(&self, s: &State<f64>, modes: &mut [f64]) {
        self.first_regime(s, modes);
    }

    fn check(&self, s: &State<f64>) -> Result<(), String> {
        check(self.0, s)
    }
}
