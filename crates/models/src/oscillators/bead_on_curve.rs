//! A bead that slides along a wire in a vertical plane: the ball on the curve of P's figures 6, 7 and 12.
//!
//!     s'' = -g y'(x) / sqrt(1 + y'(x)^2) - b s'
//!     x'  = s' / sqrt(1 + y'(x)^2)
//!
//! s is the arc length from x = 0 (T, appendix B: the one degree of freedom of a car on a roller coaster), and the wire's
//! profile y(x) a polynomial and a sum of waves a cos(k x). x belongs to s, and is carried along so that nobody has to
//! invert an arc length. A ball on a potential's curve has *not* the motion x'' = -U'(x): that is its limit where the
//! curve is flat.

use super::polynomial::value_and_slope;
use precess_scalar::Scalar;
use precess_system::{Card, Given, State, System, Values, card, coordinate, list, number, rows};

/// See the module.
#[derive(Clone)]
pub struct BeadOnCurve;

impl System for BeadOnCurve {
    fn card(&self) -> Card {
        card("bead_on_curve", "Bead on a wire", "Perle sur un fil")
            .about(
                "A bead on a wire of any profile: it oscillates in a valley or passes the hills, as its energy says.",
                "Une perle sur un fil de profil quelconque : elle oscille dans une vallée ou passe les bosses, selon son \
                 énergie.",
            )
            .source("T, appendix B; P, sections 4 and 5, figures 6, 7 and 12")
            .coordinate(coordinate("s", "", "arc length along the wire from x = 0", "abscisse curviligne depuis x = 0").start(BEGINNING))
            .coordinate(coordinate("x", "", "horizontal position", "position horizontale").first_order().start(1.0))
            .parameter(
                list("profile", "", &[0.0, 0.0, 0.5], "height of the wire: coefficients of a polynomial in x, the constant first", "hauteur du fil : coefficients d'un polynôme en x, la constante d'abord")
                    .at_most(64),
            )
            .parameter(rows("waves", &["amplitude", "wavenumber"], &[[0.0, 1.0]], "waves added to the height: a cos(k x)", "ondulations ajoutées à la hauteur : a cos(k x)").at_most(64))
            .parameter(number("g", "", 1.0, "gravity", "pesanteur"))
            .parameter(number("b", "", 0.0, "friction", "frottement"))
            .invariant_if("energy", "", &["b"], "energy per mass", "énergie par unité de masse")
            .signal("kinetic", "", "kinetic energy per mass", "énergie cinétique par unité de masse")
            .signal("potential", "", "potential energy per mass", "énergie potentielle par unité de masse")
            .signal("y", "", "height", "hauteur")
            .signal("slope", "", "slope of the wire", "pente du fil")
            .path_view("x", "y")
            .phase_view("s", "s_dot")
            .time_view(&["s"])
            .run(20.0, 0.001)
    }

    #[inline(always)]
    fn equations<S: Scalar>(&self, s: &State<S>, highest: &mut [S]) {
        let ([_s, x], [v], [g, b]) = (s.q(), s.v(), s.p());
        let (_, slope) = wire(s.list(0), s.rows(1), x);
        let stretch = (slope.squared() + 1.0).sqrt();
        highest.copy_from_slice(&[-(g * slope / stretch) - b * v, v / stretch]);
    }

    #[inline(always)]
    fn observe<S: Scalar>(&self, s: &State<S>, out: &mut [S]) {
        let ([_s, x], [v], [g]) = (s.q(), s.v(), s.p());
        let (y, slope) = wire(s.list(0), s.rows(1), x);
        let (kinetic, potential) = (v.squared() * 0.5, g * y);
        out.copy_from_slice(&[kinetic + potential, kinetic, potential, y, slope]);
    }

    /// s and x are one thing: whichever is given sets the other. Where both are given, s counts from elsewhere.
    fn start(&self, given: &Given, values: &Values<f64>, y: &mut [f64]) -> Result<(), String> {
        let waves = values.lists[1].items.as_chunks().0;
        let length = |x: f64| arc_length(&values.lists[0].items, waves, x);
        match (given.get("s"), given.get("x")) {
            (Some(s), None) => y[1] = place(length, s)?,
            (Some(_), Some(_)) => {}
            (None, _) => y[0] = length(y[1]),
        }
        Ok(())
    }
}

/// The arc length of y = x^2 / 2 from 0 to 1: (sqrt 2 + ln(1 + sqrt 2)) / 2.
const BEGINNING: f64 = 1.1477935746963;

/// Height and slope of the wire.
#[inline(always)]
fn wire<S: Scalar>(profile: &[S], waves: &[[S; 2]], x: S) -> (S, S) {
    let (mut height, mut slope) = value_and_slope(profile, x);
    for &[amplitude, wavenumber] in waves {
        let (sin, cos) = (wavenumber * x).sin_cos();
        height = height + amplitude * cos;
        slope = slope - amplitude * wavenumber * sin;
    }
    (height, slope)
}

/// The arc length from 0 to x: Simpson's rule on pieces that are short beside any bend of a sensible wire.
fn arc_length(profile: &[f64], waves: &[[f64; 2]], x: f64) -> f64 {
    const PIECES: u32 = 4096;
    let h = x / f64::from(PIECES);
    let speed = |x: f64| (1.0 + wire(profile, waves, x).1.squared()).sqrt();
    let piece = |k: u32| {
        let from = h * f64::from(k);
        speed(from) + 4.0 * speed(from + 0.5 * h) + speed(from + h)
    };
    (0..PIECES).map(piece).sum::<f64>() * h / 6.0
}

/// The x at this arc length, by bisection; |x| is at most |s|.
fn place(length: impl Fn(f64) -> f64, s: f64) -> Result<f64, String> {
    // Up to rounding, on a flat wire.
    let reaches = length(s).abs() >= s.abs() * (1.0 - 1e-9);
    if !reaches {
        return Err(format!("no place on the wire has the arc length {s} from x = 0"));
    }
    let (mut near, mut far) = (0.0, s);
    loop {
        let middle = near + (far - near) * 0.5;
        if middle == near || middle == far {
            return Ok(middle);
        }
        if length(middle).abs() < s.abs() { near = middle } else { far = middle }
    }
}
