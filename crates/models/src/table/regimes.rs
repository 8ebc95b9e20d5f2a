//! Sliding, rolling, flying: what changes the regime of a body with a dry (`coulomb`) or a free contact.
//!
//! The modes are the regime and a direction d of slip (`friction.rs`). All event functions fall through zero:
//!
//!     sticks   u.d                   the slip passes to the other side of d: it has come to rest, or only turned
//!     slips    mu N - |f needed|     rolling needs more friction than there is
//!     jams     denominator - 1/(100 m)   the push grows without bound (Painleve's paradox); reported, nothing more
//!     lifts    N, or -N past a jam   the table would have to pull            (where the contact is free;
//!     lands    z - h(-gamma)         the body is back on the table            z is a coordinate then)
//!
//! A contact at rest sticks if the friction that rolling needs is at most mu N; if not it slips against that force. One
//! that lands with a rebound too low to be seen (a millionth of G's height) stays down. A slip and a flight begin at zero:
//! what rounding makes of that is no event, so `sticks` and `lands` have an allowance.

use super::body::length;
use super::friction::COULOMB;
use super::impact::{blow, turn};
use super::measure::height;
use super::slider::Slider;
use super::top::Seen;
use crate::rotation::{cross, dot, quotient};
use precess_scalar::Scalar;
use precess_system::{
    Card, Direction, Event, Given, Layout, ObservableKind, State, Text, Values, coordinate,
};

/// The regimes.
pub(super) const SLIDES: f64 = 0.0;
pub(super) const ROLLS: f64 = 1.0;
pub(super) const FLIES: f64 = 2.0;

/// The events in order.
const STICKS: usize = 0;
const SLIPS: usize = 1;
const JAMS: usize = 2;
/// Only where the contact is free.
const LIFTS: usize = 3;
const LANDS: usize = 4;
const EVENTS: [(&str, &str, &str); 5] = [
    ("sticks", "the slip comes to rest, or turns", "le glissement s'arrête, ou tourne"),
    (
        "slips",
        "rolling needs more friction than there is",
        "le roulement demande plus de frottement qu'il n'y en a",
    ),
    (
        "jams",
        "the table's push grows without bound (Painlevé)",
        "la poussée de la table croît sans limite (Painlevé)",
    ),
    ("lifts", "the body lifts off", "le corps décolle"),
    ("lands", "the body lands", "le corps retombe"),
];

/// Where the contact slips less than this share of the velocities about, it is at rest.
const AT_REST: f64 = 1e-7;
/// Of a slip, or a height above the table, this share is rounding.
const ROUNDING: f64 = 1e-12;
/// A rebound to less than this share of G's height is none.
const REBOUND: f64 = 1e-6;
/// A height above the table less than this share of G's is none.
const TOUCHES: f64 = 1e-9;

/// Whether a mode is a given one; modes are whole numbers.
#[inline(always)]
pub(super) fn is<S: Scalar>(mode: S, one: f64) -> S::Mask {
    (mode - one).abs().lt(S::from(0.5))
}

/// Whether the contact is free, so that z is a coordinate.
#[inline(always)]
pub(super) fn is_free<S>(values: &Values<S>) -> bool {
    values.choices[1] == 1
}

/// With the height as a coordinate, and with modes and events, where there are any.
pub(super) fn layout(card: &Card, values: &Values<f64>) -> Layout {
    let mut layout = Layout::of(card);
    if is_free(values) {
        let (en, fr) = ("centre of mass, height", "centre de masse, hauteur");
        layout.coordinates.push(coordinate("z", "m", en, fr));
        for observable in &mut layout.observables {
            match observable.quantity.name.as_str() {
                "z" => observable.quantity.name = "height".into(),
                // A blow takes some.
                "energy" => observable.kind = ObservableKind::Signal,
                _ => {}
            }
        }
    }
    if is_free(values) || values.choices[0] == COULOMB {
        layout.modes = 3;
        let event = |(name, en, fr): (&str, &str, &str)| {
            let text = Text::new(en, fr);
            Event { name: name.into(), direction: Direction::Falling, text }
        };
        let events = if is_free(values) { EVENTS.len() } else { LIFTS };
        layout.events = EVENTS.map(event)[..events].into();
    }
    layout
}

/// What a contact does next: at rest it sticks or slips, or moves on as it does.
struct Settled<S: Scalar> {
    /// Regime and direction of slip.
    modes: [S; 3],
    /// Nothing slips: the velocity of G along the table is to be this one.
    rests: S::Mask,
    velocity: [S; 2],
}

/// The velocities about: what a slip is small against.
#[inline(always)]
fn about<S: Scalar>(s: &State<S>, seen: &Seen<S>) -> S {
    let ([vx, vy], swing) = (s.v(), cross(seen.omega, seen.touch.r));
    let fall = (seen.felt[1] * height(seen)[0]).abs();
    length([vx, vy]) + dot(swing, swing).sqrt() + fall.sqrt()
}

impl Slider {
    /// The event functions; zero where an event cannot happen.
    #[inline(always)]
    pub(super) fn watch<S: Scalar>(&self, s: &State<S>, out: &mut [S]) {
        let Some(&[regime, dx, dy]) = s.modes.first_chunk() else { return };
        let seen = self.0.see(s);
        let (friction, _) = self.friction(s);
        let zero = S::from(0.0);
        let [ux, uy] = Self::slip(&seen, s);
        let acts = self.acts(s, &seen);
        let [fx, fy, normal] = acts.force;
        let (slides, rolls, flies) = (is(regime, SLIDES), is(regime, ROLLS), is(regime, FLIES));
        out.fill(zero);
        if friction.law == COULOMB {
            out[STICKS] = S::select(slides, ux * dx + uy * dy + about(s, &seen) * ROUNDING, zero);
            out[SLIPS] = S::select(rolls, friction.mu * normal - length([fx, fy]), zero);
        }
        // What has lifted off no longer presses: friction would pass to the other side there, and the denominator jump.
        let press = S::select(acts.denominator.lt(zero), -normal, normal);
        let mut spare = acts.denominator - S::from(0.01) / seen.body.mass;
        if is_free(s.values) {
            spare = S::select(zero.lt(press), spare, S::from(1.0) / seen.body.mass);
            out[LIFTS] = S::select(flies, zero, press);
            let touching = height(&seen)[0];
            out[LANDS] = S::select(flies, s.coordinates[9] - touching * (1.0 - ROUNDING), zero);
        }
        out[JAMS] = S::select(slides, spare, zero);
    }

    /// What an event does to the state.
    #[inline(always)]
    pub(super) fn change<S: Scalar>(&self, event: usize, s: &State<S>, y: &mut [S]) {
        let (n, modes) = (s.coordinates.len(), s.coordinates.len() + s.velocities.len());
        match event {
            LIFTS => {
                [y[9], y[n + 2]] = height(&self.0.see(s));
                y[modes] = S::from(FLIES);
            }
            STICKS | SLIPS | LANDS => {
                let stays = if event == LANDS { self.strike(s, y) } else { S::always() };
                let before = y.to_vec();
                let struck = State { coordinates: &before[..n], velocities: &before[n..modes], ..*s };
                self.settle(&struck, y, event != SLIPS);
                for (now, before) in y.iter_mut().zip(&before) {
                    *now = S::select(stays, *now, *before);
                }
            }
            _ => {}
        }
    }

    /// The blow of a landing; whether it leaves the body on the table.
    #[inline(always)]
    fn strike<S: Scalar>(&self, s: &State<S>, y: &mut [S]) -> S::Mask {
        let seen = self.0.see(s);
        let (friction, restitution) = self.friction(s);
        let [touching, rising] = height(&seen);
        let [ux, uy] = Self::slip(&seen, s);
        let down = s.velocities[2] - rising;
        let blow = blow(&seen, [ux, uy, down], friction.mu, restitution);
        let n = s.coordinates.len();
        for (i, turned) in turn(&seen, blow).into_iter().enumerate() {
            y[4 + i] = y[4 + i] + turned;
            y[n + i] = y[n + i] + blow[i] / seen.body.mass;
        }
        y[9] = touching;
        let up = restitution * down;
        (up * up).le(seen.felt[1].abs() * touching * (2.0 * REBOUND))
    }

    /// Puts a body in contact into the regime it takes, exactly on the constraints of that regime.
    #[inline(always)]
    fn settle<S: Scalar>(&self, s: &State<S>, y: &mut [S], may_stick: bool) {
        let seen = self.0.see(s);
        let (n, modes) = (s.coordinates.len(), s.coordinates.len() + s.velocities.len());
        let settled = self.settled(s, &seen, may_stick);
        for i in 0..2 {
            y[n + i] = S::select(settled.rests, settled.velocity[i], y[n + i]);
        }
        if is_free(s.values) {
            [y[9], y[n + 2]] = height(&seen);
        }
        y[modes..].copy_from_slice(&settled.modes);
    }

    #[inline(always)]
    fn settled<S: Scalar>(&self, s: &State<S>, seen: &Seen<S>, may_stick: bool) -> Settled<S> {
        let zero = S::from(0.0);
        let (friction, _) = self.friction(s);
        let [ux, uy] = Self::slip(seen, s);
        let swing = cross(seen.omega, seen.touch.r);
        let slip = length([ux, uy]);
        let rolling = Self::rolling(seen);
        let [fx, fy, push] = rolling.force;
        let needed = length([fx, fy]);
        let never = S::always() & !S::always();
        let dry = friction.law == COULOMB;
        let rests = if dry { slip.le(about(s, seen) * AT_REST) } else { never };
        let direction =
            [(ux, fx), (uy, fy)].map(|(u, f)| S::select(rests, -quotient(f, needed), quotient(u, slip)));
        let sticks = if may_stick { rests & needed.le(friction.mu * push) & zero.lt(push) } else { never };
        let mut regime = S::select(sticks, S::from(ROLLS), S::from(SLIDES));
        if is_free(s.values) {
            let sliding = self.sliding(s, seen, direction).force[2];
            let pulls = S::select(sticks, push, sliding).le(zero);
            regime = S::select(pulls, S::from(FLIES), regime);
        }
        let velocity = [-dot(seen.rows[0], swing), -dot(seen.rows[1], swing)];
        Settled { modes: [regime, direction[0], direction[1]], rests, velocity }
    }

    /// The regime at the start.
    pub(super) fn first_regime(&self, s: &State<f64>, modes: &mut [f64]) {
        if modes.is_empty() {
            return;
        }
        let seen = self.0.see(s);
        let [height, rise] = height(&seen);
        let flies = is_free(s.values)
            && (s.coordinates[9] > height * (1.0 + TOUCHES)
                || s.velocities[2] > rise + TOUCHES * (rise.abs() + s.velocities[2].abs()));
        let settled = self.settled(s, &seen, true).modes;
        modes.copy_from_slice(&if flies { [FLIES, settled[1], settled[2]] } else { settled });
    }

    /// Sets z and its velocity where they are not given.
    ///
    /// # Errors
    /// Where the body would start below the table, or move into it.
    pub(super) fn put_on_the_table(
        &self,
        given: &Given,
        values: &Values<f64>,
        y: &mut [f64],
    ) -> Result<(), String> {
        if !is_free(values) {
            return Ok(());
        }
        let (coordinates, velocities) = y.split_at(10);
        let seen = self.0.see(&State { t: 0.0, coordinates, velocities, modes: &[], values });
        let [height, rise] = height(&seen);
        let z = given.get("z").unwrap_or(height);
        if z < height * (1.0 - TOUCHES) {
            return Err(format!(
                "the body would start below the table: in this attitude it touches at z = {height} m, not at {z} m \
                 (leave z out, and it is set so)"
            ));
        }
        let touches = z <= height * (1.0 + TOUCHES);
        let z_dot = given.get("z_dot").unwrap_or(if touches { rise } else { 0.0 });
        if touches && z_dot < rise - TOUCHES * (rise.abs() + z_dot.abs()) {
            return Err(format!(
                "the contact point would start into the table: with this angular velocity z_dot is {rise} m/s where the \
                 body touches, not {z_dot} m/s (leave z_dot out, and it is set so)"
            ));
        }
        (y[9], y[12]) = (z, z_dot);
        Ok(())
    }
}
