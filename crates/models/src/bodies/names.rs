//! The shapes by name, with the sizes that each takes.

use super::{Solid, cone, cylinder, egg, ellipsoid, profile, sphere, truncated_sphere};

/// A size that a shape takes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Size {
    /// Name.
    pub name: &'static str,
    /// Unit.
    pub unit: &'static str,
    /// Where nobody gives it; none where it must be given.
    pub default: Option<f64>,
    /// It may be zero, or negative.
    pub any: bool,
    /// Meaning, in English and French.
    pub text: (&'static str, &'static str),
}

/// A length that must be given.
pub(super) const fn length(name: &'static str, en: &'static str, fr: &'static str) -> Size {
    Size { name, unit: "m", default: None, any: false, text: (en, fr) }
}
/// A number that is zero where nobody gives it.
pub(super) const fn optional(
    name: &'static str,
    unit: &'static str,
    en: &'static str,
    fr: &'static str,
) -> Size {
    Size { name, unit, default: Some(0.0), any: true, text: (en, fr) }
}

/// What there is to say of a shape.
pub struct BodyCard {
    /// Identifier.
    pub id: &'static str,
    /// Title, in English and French.
    pub title: (&'static str, &'static str),
    /// Where the formulas come from.
    pub source: &'static str,
    /// The sizes it takes, besides `density` or `mass`.
    pub sizes: &'static [Size],
    /// It has a volume, so that it may be given by its density.
    pub volume: bool,
    /// It takes a list of radii.
    pub radii: bool,
    /// The body with a density of 1, or a mass of 1 where it has no volume.
    pub(super) build: fn(&[f64], &[f64]) -> Result<Solid, String>,
}

/// Every shape.
pub const SHAPES: &[BodyCard] = &[
    sphere::SPHERE,
    cylinder::CYLINDER,
    cylinder::BAR,
    cylinder::DISC,
    cone::CONE,
    truncated_sphere::TRUNCATED_SPHERE,
    ellipsoid::ELLIPSOID,
    egg::EGG,
    profile::PROFILE,
    profile::SMOOTH_PROFILE,
];

/// The names of all shapes, for a sentence.
fn shapes() -> String {
    SHAPES.iter().map(|s| s.id).collect::<Vec<_>>().join(", ")
}

/// The body of this shape: its sizes by name, with `density` or `mass`, and a list of radii for a profile.
///
/// # Errors
/// One sentence: what is unknown, missing, or makes no body.
pub fn named(shape: &str, given: &[(&str, f64)], radii: &[f64]) -> Result<Solid, String> {
    let card = SHAPES.iter().find(|card| card.id == shape);
    let card = card.ok_or_else(|| format!("there is no shape '{shape}'; there are {}", shapes()))?;
    let known: Vec<&str> = card.sizes.iter().map(|size| size.name).collect();
    for (name, x) in given {
        if !known.contains(name) && !["density", "mass"].contains(name) {
            let lists = if card.radii { ", radii" } else { "" };
            let sizes = known.join(", ");
            return Err(format!("a {shape} has no {name}: it takes density or mass, {sizes}{lists}"));
        }
        if !x.is_finite() {
            return Err(format!("{name} must be a finite number, not {x}"));
        }
    }
    if !card.radii && !radii.is_empty() {
        return Err(format!("a {shape} takes no list of radii; profile does"));
    }
    let find = |name: &str| given.iter().rev().find(|(n, _)| *n == name).map(|(_, x)| *x);
    let mut sizes = vec![];
    for size in card.sizes {
        let value = find(size.name).or(size.default);
        let value = value.ok_or_else(|| format!("a {shape} needs its {} ({})", size.name, size.text.0))?;
        if !size.any && value <= 0.0 {
            return Err(format!("{} must be above zero, not {value}", size.name));
        }
        sizes.push(value);
    }
    let body = (card.build)(&sizes, radii)?;
    let factor = match (find("density"), find("mass")) {
        (Some(_), Some(_)) => {
            return Err("density and mass are both given: one follows from the other".into());
        }
        (Some(_), None) if !card.volume => {
            return Err(format!("a {shape} has no volume: give its mass, not a density"));
        }
        (Some(density), None) => above_zero("density", density)?,
        (None, Some(mass)) => above_zero("mass", mass)? / body.mass,
        (None, None) if card.volume => return Err(format!("a {shape} needs a density or a mass")),
        (None, None) => return Err(format!("a {shape} needs a mass")),
    };
    let body = body.heavier(factor);
    let finite = body.mass > 0.0 && body.inertia.iter().flatten().all(|x| x.is_finite());
    if finite { Ok(body) } else { Err(format!("the mass of this {shape} is not a finite number above zero")) }
}

fn above_zero(name: &str, x: f64) -> Result<f64, String> {
    if x > 0.0 { Ok(x) } else { Err(format!("the {name} of a body must be above zero, not {x}")) }
}
