//! Units of measure as text: `kg m^2/s`, `deg`, `min`.

use precess_scalar::Dimension;
use std::fmt;

/// A unit that cannot be read.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct UnitError(pub String);

impl fmt::Display for UnitError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "'{}' is no unit known here", self.0)
    }
}
impl std::error::Error for UnitError {}

/// Name, size in SI units, powers of kilogram, metre, second.
const UNITS: [(&str, f64, [i16; 3]); 31] = [
    ("1", 1.0, [0, 0, 0]),
    ("rad", 1.0, [0, 0, 0]),
    ("deg", std::f64::consts::PI / 180.0, [0, 0, 0]),
    ("°", std::f64::consts::PI / 180.0, [0, 0, 0]),
    ("turn", std::f64::consts::TAU, [0, 0, 0]),
    ("rev", std::f64::consts::TAU, [0, 0, 0]),
    ("%", 0.01, [0, 0, 0]),
    ("kg", 1.0, [1, 0, 0]),
    ("g", 1e-3, [1, 0, 0]),
    ("mg", 1e-6, [1, 0, 0]),
    ("t", 1e3, [1, 0, 0]),
    ("m", 1.0, [0, 1, 0]),
    ("km", 1e3, [0, 1, 0]),
    ("dm", 0.1, [0, 1, 0]),
    ("cm", 0.01, [0, 1, 0]),
    ("mm", 1e-3, [0, 1, 0]),
    ("s", 1.0, [0, 0, 1]),
    ("ms", 1e-3, [0, 0, 1]),
    ("min", 60.0, [0, 0, 1]),
    ("h", 3600.0, [0, 0, 1]),
    ("d", 86400.0, [0, 0, 1]),
    ("yr", 31_557_600.0, [0, 0, 1]),
    ("Hz", 1.0, [0, 0, -1]),
    ("rpm", std::f64::consts::TAU / 60.0, [0, 0, -1]),
    ("N", 1.0, [1, 1, -2]),
    ("J", 1.0, [1, 2, -2]),
    ("mJ", 1e-3, [1, 2, -2]),
    ("kJ", 1e3, [1, 2, -2]),
    ("W", 1.0, [1, 2, -3]),
    ("kN", 1e3, [1, 1, -2]),
    ("Pa", 1.0, [1, -1, -2]),
];

/// Reads a unit: factors separated by spaces or `*`, everything after a `/` divides, `^` raises.
///
/// Gives the size of the unit in SI units and its dimension.
///
/// # Errors
/// The word that is no unit.
pub fn parse_unit(text: &str) -> Result<(f64, Dimension), UnitError> {
    let (mut size, mut dimension) = (1.0, Dimension::NONE);
    for (k, part) in text.split('/').enumerate() {
        let part = part.trim().trim_start_matches('(').trim_end_matches(')');
        if part.is_empty() && (k > 0 || text.contains('/')) {
            return Err(UnitError(text.into()));
        }
        for word in part.split([' ', '*', '·']).filter(|w| !w.is_empty()) {
            let (name, power) = word.split_once('^').unwrap_or((word, "1"));
            let power: i32 = power.parse().map_err(|_| UnitError(word.into()))?;
            if !(-9..=9).contains(&power) {
                return Err(UnitError(word.into()));
            }
            let power = if k == 0 { power } else { -power };
            let unit = UNITS.iter().find(|(n, ..)| *n == name).ok_or_else(|| UnitError(word.into()))?;
            size *= precess_scalar::Scalar::powi(unit.1, power);
            let [kilogram, metre, second] = unit.2;
            dimension = dimension.times(Dimension::new(kilogram, metre, second).power(power));
        }
    }
    Ok((size, dimension))
}
