//! The motion about a fixed centre of attraction, in closed form for every kind of orbit.
//!
//! In the universal anomaly s, dt = r ds, everything is made of four functions of s and beta = 2 mu / r - v^2 (the
//! `G_n` of Stumpff), which are sines on an ellipse, hyperbolic sines on a hyperbola and powers on a parabola:
//!
//!     t = r0 G1 + (r0 . v0) G2 + mu G3            Kepler's equation, solved for s
//!     r = r0 (1 - mu G2 / r0) + v0 (t - mu G3)
//!
//! (K. Stumpff, *Himmelsmechanik*; J. Wisdom and D. Hernandez, MNRAS 453, 3015, 2015.)

use super::n_body::in_space;
use crate::rotation::{Vector, cross, dot};
use precess_scalar::Scalar;
use precess_system::State;

/// Two bodies: their centre of mass moves straight on, and each goes round it on an orbit of the same shape.
#[inline(always)]
pub(super) fn two_bodies<S: Scalar>(start: &State<S>, t: S, q: &mut [S], v: &mut [S]) {
    let ([k], time) = (start.p(), t - start.t);
    let [first, second] = [start.list(0)[0], start.list(0)[1]];
    let both = first + second;
    let (place, velocity) = relative(start, 0, 1);
    let (place, velocity) = orbit(k * both, time, place, velocity);
    let dimensions = q.len() / 2;
    for axis in 0..dimensions {
        let (a, b) = (axis, dimensions + axis);
        let mean = |of: &[S]| (first * of[a] + second * of[b]) / both;
        let drift = mean(start.velocities);
        let centre = mean(start.coordinates) + drift * time;
        (q[a], q[b]) = (centre - place[axis] * second / both, centre + place[axis] * first / both);
        (v[a], v[b]) = (drift - velocity[axis] * second / both, drift + velocity[axis] * first / both);
    }
}

/// Whether two bodies move along one line.
pub(super) fn falls(start: &State<f64>) -> bool {
    let (place, velocity) = relative(start, 0, 1);
    cross(place, velocity) == [0.0; 3]
}

/// Semi-major axis and eccentricity of the orbit that two bodies would go on along if they were alone.
#[inline(always)]
pub(super) fn elements<S: Scalar>(s: &State<S>, i: usize, j: usize) -> [S; 2] {
    let [k] = s.p();
    let mu = k * (s.list(0)[i] + s.list(0)[j]);
    let (place, velocity) = relative(s, i, j);
    let distance = dot(place, place).sqrt();
    let (square, outward) = (dot(velocity, velocity), dot(place, velocity));
    // Towards the pericentre, as long as the eccentricity.
    let long: Vector<S> = std::array::from_fn(|axis| {
        (square / mu - S::from(1.0) / distance) * place[axis] - outward / mu * velocity[axis]
    });
    [S::from(1.0) / (S::from(2.0) / distance - square / mu), dot(long, long).sqrt()]
}

/// Body j as seen from body i.
#[inline(always)]
fn relative<S: Scalar>(start: &State<S>, i: usize, j: usize) -> (Vector<S>, Vector<S>) {
    let dimensions = start.coordinates.len() / start.list(0).len();
    let difference = |of: &[S]| {
        let [first, second] = [i, j].map(|body| in_space(of, dimensions, body));
        std::array::from_fn(|axis| second[axis] - first[axis])
    };
    (difference(start.coordinates), difference(start.velocities))
}

/// Place and velocity after a time, about a centre that attracts with mu / r^2.
#[inline(always)]
fn orbit<S: Scalar>(mu: S, time: S, place: Vector<S>, velocity: Vector<S>) -> (Vector<S>, Vector<S>) {
    // Back in time is forth with the velocity reversed.
    let backwards = time.lt(S::from(0.0));
    let turned = |v: Vector<S>| v.map(|x| S::select(backwards, -x, x));
    let start = turned(velocity);
    let orbit = Orbit::new(mu, place, start);
    let g = orbit.anomaly(time.abs());
    let r = orbit.distance(g);
    let (f_place, g_place) =
        (S::from(1.0) - mu * g[2] / orbit.start, orbit.start * g[1] + orbit.outward * g[2]);
    let (f_speed, g_speed) = (-(mu * g[1] / (r * orbit.start)), S::from(1.0) - mu * g[2] / r);
    let mix = |a: S, b: S| std::array::from_fn(|axis| a * place[axis] + b * start[axis]);
    (mix(f_place, g_place), turned(mix(f_speed, g_speed)))
}

/// What the shape of an orbit depends on.
struct Orbit<S> {
    mu: S,
    /// The distance at the start.
    start: S,
    /// Place times velocity at the start.
    outward: S,
    /// Minus twice the energy.
    beta: S,
    /// No point of the orbit from here on is nearer.
    nearest: S,
}

/// The most steps towards the anomaly; a few dozen are the worst that was found.
const MOST: u32 = 100;

impl<S: Scalar> Orbit<S> {
    #[inline(always)]
    fn new(mu: S, place: Vector<S>, velocity: Vector<S>) -> Self {
        let start = dot(place, place).sqrt();
        let (outward, square) = (dot(place, velocity), dot(velocity, velocity));
        let beta = mu * 2.0 / start - square;
        let moment = start * start * square - outward * outward;
        let moment = moment.larger(S::from(0.0));
        let pericentre = moment / (mu + (mu * mu - beta * moment).larger(S::from(0.0)).sqrt());
        let nearest = S::select(outward.lt(S::from(0.0)), pericentre, start);
        Self { mu, start, outward, beta, nearest }
    }

    #[inline(always)]
    fn distance(&self, g: [S; 4]) -> S {
        self.start * g[0] + self.outward * g[1] + self.mu * g[2]
    }

    #[inline(always)]
    fn time(&self, g: [S; 4]) -> S {
        self.start * g[1] + self.outward * g[2] + self.mu * g[3]
    }

    /// The G at this time (not negative): Newton's method between bounds, halving where it leads out of them or does
    /// not get nearer fast.
    #[inline(always)]
    fn anomaly(&self, time: S) -> [S; 4] {
        let zero = S::from(0.0);
        // On an ellipse the anomaly is at most one radian ahead of or behind its mean on either side.
        let bound = zero.lt(self.beta);
        let (mean, radians) = (time * self.beta / self.mu, S::from(2.0 + 1e-9) / self.beta.sqrt());
        let mut low = S::select(bound, (mean - radians).larger(zero), zero);
        let mut high = S::select(bound, mean + radians, time / self.nearest);
        let mut s = S::select(bound, mean, high);
        let mut last = high - low;
        let mut done = !S::always();
        let mut tries = 0;
        // Two free steps more give the last digits, and the slopes of a derivative.
        let mut left = None;
        loop {
            let g = functions(self.beta, s);
            let value = self.time(g) - time;
            let step = value / self.distance(g);
            let newton = s - step;
            match left {
                Some(0) => return g,
                Some(more) => (s, left) = (newton, Some(more - 1)),
                None => {
                    let below = value.lt(zero);
                    low = S::select(below, s, low);
                    high = S::select(below, high, s);
                    let fast = low.le(newton) & newton.le(high) & (step.abs() * 2.0).le(last);
                    let half = (high - low) * 0.5;
                    let next = S::select(fast, newton, low + half);
                    let length = (next - s).abs();
                    s = S::select(done, s, next);
                    last = S::select(fast, step.abs(), half);
                    done = done | length.le(next.abs() * 1e-13);
                    tries += 1;
                    left = (tries == MOST || S::all(done)).then_some(2);
                }
            }
        }
    }
}

/// G0 to G3: with x = beta s^2, the sums over k of (-x)^k s^n / (2 k + n)!.
#[inline(always)]
fn functions<S: Scalar>(beta: S, s: S) -> [S; 4] {
    let (zero, one) = (S::from(0.0), S::from(1.0));
    let x = beta * s * s;
    // Near zero by the series of the last two.
    let (mut c2, mut c3) = (zero, zero);
    for k in (1..=SERIES).rev() {
        let n = f64::from(2 * k);
        c2 = (one - x * c2) / ((n - 1.0) * n);
        c3 = (one - x * c3) / (n * (n + 1.0));
    }
    let near = [one - x * c2, s * (one - x * c3), s * s * c2, s * s * s * c3];
    let root = beta.abs().sqrt();
    let z = root * s;
    let (sin, cos) = z.sin_cos();
    let (sinh, cosh) = (z.sinh(), z.cosh());
    let ellipse = [cos, sin / root, (one - cos) / beta, (z - sin) / (beta * root)];
    let hyperbola = [cosh, sinh / root, (one - cosh) / beta, (z - sinh) / (beta * root)];
    let (small, negative) = (x.abs().lt(one), beta.lt(zero));
    std::array::from_fn(|n| S::select(small, near[n], S::select(negative, hyperbola[n], ellipse[n])))
}

/// Terms of the series: to 1e-33 for x below 1.
const SERIES: u32 = 15;
