//! What holds a pendulum or lets it go: a string that goes slack, dry friction that sticks.
//!
//! The string, in polar coordinates about the pivot, while it is slack (c is what the air does per mass and speed):
//!
//!     r'' = r theta'^2 + g cos theta - c r'      theta'' = -(2 r' theta' + g sin theta) / r - c theta'
//!     c = b + (b2 / l) |velocity|
//!
//! It is caught where r comes to l: r' becomes zero and m r'^2 / 2 is lost, theta' stays. Where the string would have to push
//! at once, it stays slack. The dry friction of the pivot acts while the string is taut; at a turning point it holds where
//! (g / l) |sin theta| is no more than it.

use precess_scalar::Scalar;
use precess_system::{Direction, Event, Given, Layout, Observable, ObservableKind, State, Text, Values};
use precess_system::{coordinate, quantity};

/// The choice `string = true`.
pub(super) const STRING: usize = 1;

/// The modes: which way it slips (0: held), whether the string is slack, the energy lost in jerks, in units of m g l (a mode is
/// a pure number).
#[derive(Clone, Copy)]
pub(super) struct Hold<S> {
    pub slip: S,
    slack: S,
    lost: S,
}

/// Events in order.
const TURNS: usize = 0;
const SLACKENS: usize = 1;

/// Adds what a string or dry friction needs.
pub(super) fn layout(mut layout: Layout, values: &Values<f64>) -> Layout {
    let (string, dry) = (values.choices[0] == STRING, values.numbers[5] > 0.0);
    let event = |name: &str, direction, en: &str, fr: &str| Event {
        name: name.into(),
        direction,
        text: Text::new(en, fr),
    };
    if string || dry {
        layout.modes = 3;
        layout.events = vec![event("turns", Direction::Falling, "it stops", "il s'arrête")];
    }
    if string {
        let r = coordinate("r", "m", "distance from the pivot", "distance au pivot");
        layout.coordinates.push(r.not_negative().start(values.numbers[1]));
        layout.events.extend([
            event("slackens", Direction::Falling, "the string goes slack", "le fil se détend"),
            event("caught", Direction::Rising, "the string is taut again", "le fil se retend"),
        ]);
        let kind = std::mem::replace(&mut layout.observables[0].kind, ObservableKind::Signal);
        let observable =
            |name, unit, en, fr, kind| Observable { quantity: quantity(name, unit, en, fr), kind };
        layout.observables.extend([
            observable(
                "lost",
                "J",
                "energy lost in jerks",
                "énergie perdue dans les à-coups",
                ObservableKind::Signal,
            ),
            observable("account", "J", "energy, and what was lost", "énergie et ce qui est perdu", kind),
            observable(
                "slack",
                "",
                "1 while the string is slack",
                "1 tant que le fil est détendu",
                ObservableKind::Signal,
            ),
        ]);
    }
    layout
}

/// A string starts stretched, or slack with a given r.
pub(super) fn start(given: &Given, values: &Values<f64>, y: &mut [f64]) -> Result<(), String> {
    if values.choices[0] != STRING {
        return Ok(());
    }
    let (l, g) = (values.numbers[1], values.numbers[2]);
    if g == 0.0 {
        return Err("without gravity nothing slackens a string: set g, or leave string away".into());
    }
    if given.get("r").is_none() {
        y[1] = l;
    }
    match (y[1], y[3]) {
        (r, _) if r > l => Err(format!("the string is {l} m long: the mass cannot start at r = {r} m")),
        (r, _) if r <= 0.0 => Err(format!("r is a distance above zero, not {r} m")),
        (r, r_dot) if r == l && r_dot > 0.0 => {
            Err("a taut string lets nothing move outwards: r_dot must be 0".into())
        }
        _ => Ok(()),
    }
}

pub(super) fn start_modes(s: &State<f64>, modes: &mut [f64]) {
    if modes.is_empty() {
        return;
    }
    let w = s.velocities[0];
    modes[0] = if w == 0.0 { freed(s) } else { w.sign() };
    if let (&[_, r], &[_, r_dot]) = (s.coordinates, s.velocities) {
        let [_m, l] = s.p();
        let slack = r < l || r_dot < 0.0 || pull(s) < 0.0;
        modes[1] = f64::from(u8::from(slack));
    }
}

/// Distance from the pivot, and its rate.
#[inline(always)]
pub(super) fn along<S: Scalar>(s: &State<S>) -> [S; 2] {
    let [_m, l] = s.p();
    [s.coordinates.get(1).copied().unwrap_or(l), s.velocities.get(1).copied().unwrap_or(S::from(0.0))]
}

/// Which way gravity frees a pendulum at rest: 0 where dry friction holds it.
#[inline(always)]
fn freed<S: Scalar>(s: &State<S>) -> S {
    let ([theta], [_m, l, g, _b, _b2, dry]) = (s.q(), s.p());
    let pull = -(g / l * theta.sin());
    S::select(dry.lt(pull.abs()), pull.sign(), S::from(0.0))
}

/// What a taut string pulls with, per mass: below zero, it cannot.
#[inline(always)]
fn pull<S: Scalar>(s: &State<S>) -> S {
    let ([theta], [w], [_m, l, g]) = (s.q(), s.v(), s.p());
    l * w * w + g * theta.cos()
}

impl<S: Scalar> Hold<S> {
    #[inline(always)]
    pub fn of(s: &State<S>) -> Option<Self> {
        let [slip, slack, lost] = *s.modes.first_chunk()?;
        Some(Self { slip, slack, lost })
    }

    #[inline(always)]
    fn is_slack(self) -> S::Mask {
        S::from(0.5).lt(self.slack)
    }

    /// The accelerations while it is held, or flies.
    #[inline(always)]
    pub fn correct(self, s: &State<S>, highest: &mut [S]) {
        let ([theta], [w], [_m, l, g, b, b2, dry]) = (s.q(), s.v(), s.p());
        let zero = S::from(0.0);
        let held = self.slip.abs().lt(S::from(0.5)) & zero.lt(dry) & !self.is_slack();
        highest[0] = S::select(held, zero, highest[0]);
        if s.coordinates.len() > 1 {
            let [r, r_dot] = along(s);
            let (sin, cos) = theta.sin_cos();
            let speed = (r_dot * r_dot + (r * w).squared()).sqrt();
            let air = b + b2 / l * speed;
            let turning = -((r_dot * w * 2.0 + g * sin) / r) - air * w;
            let outwards = r * w * w + g * cos - air * r_dot;
            highest[0] = S::select(self.is_slack(), turning, highest[0]);
            highest[1] = S::select(self.is_slack(), outwards, zero);
        }
    }

    #[inline(always)]
    pub fn tension(self, _s: &State<S>, taut: S) -> S {
        S::select(self.is_slack(), S::from(0.0), taut)
    }

    /// Lost, the account, slack.
    #[inline(always)]
    pub fn observe(self, s: &State<S>, energy: S, out: &mut [S]) {
        if let [lost, account, slack] = out {
            let [m, l, g] = s.p();
            *lost = self.lost * m * l * g.abs();
            *account = energy + *lost;
            *slack = self.slack;
        }
    }

    #[inline(always)]
    pub fn crossings(self, s: &State<S>, out: &mut [S]) {
        let ([w], [_m, l]) = ([s.velocities[0]], s.p());
        // Held or slack: nothing falls.
        let idle = self.slip.abs().lt(S::from(0.5)) | self.is_slack();
        out[TURNS] = S::select(idle, w.abs(), self.slip * w);
        if let [_, slackens, caught] = out {
            let [r, _] = along(s);
            let pull = pull(s);
            *slackens = S::select(self.is_slack(), pull.abs(), pull);
            *caught = S::select(self.is_slack(), r - l, -l);
        }
    }

    #[inline(always)]
    pub fn jump(self, event: usize, s: &State<S>, y: &mut [S]) {
        let (zero, one) = (S::from(0.0), S::from(1.0));
        let velocity = s.coordinates.len();
        let modes = velocity + s.velocities.len();
        match event {
            TURNS => {
                y[velocity] = zero;
                y[modes] = freed(s);
            }
            SLACKENS => y[modes + 1] = one,
            _ => {
                let ([w, r_dot], [_m, l, g]) = (s.v(), s.p());
                y[1] = l;
                y[velocity + 1] = zero;
                y[modes] = w.sign();
                y[modes + 2] = self.lost + r_dot * r_dot * 0.5 / (l * g.abs());
                y[modes + 1] = S::select(zero.lt(pull(s)), zero, one);
            }
        }
    }
}
