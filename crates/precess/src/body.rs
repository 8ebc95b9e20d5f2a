//! Bodies as people write them: `cone density=100 height=0.15 radius=0.05 + sphere mass=0.1 radius=0.02 z=0.2`.

use crate::error::{Error, input, quoted, unknown};
use crate::value::{self, Value, shortest};
use precess_models::bodies::{BodyCard, SHAPES, Size, Solid, convex, named};
use serde_json::json;

pub use precess_models::bodies;

/// Where a part of a sum lies: its axes moved along those of the sum.
const PLACE: [&str; 3] = ["x", "y", "z"];

/// Every shape.
pub fn shapes() -> &'static [BodyCard] {
    SHAPES
}

/// A body read from words: a shape, then its sizes as `name=value`; a word `+` begins the next part of a sum, which
/// `x`, `y`, `z` place.
///
/// # Errors
/// One sentence: what is not understood, unknown, missing, or makes no body.
pub fn read(words: &[String]) -> Result<Solid, Error> {
    let parts: Vec<&[String]> = words.split(|word| word == "+").collect();
    let mut parts = parts.iter().map(|part| one(part));
    let Some(first) = parts.next() else { return input("no shape is given") };
    parts.try_fold(first?, |sum, part| Ok(sum.with(part?)))
}

fn one(words: &[String]) -> Result<Solid, Error> {
    let Some((shape, sizes)) = words.split_first() else {
        return input("a shape is missing: a sum is written 'cone ... + sphere ...'");
    };
    let ids = || SHAPES.iter().map(|card| card.id);
    let card = SHAPES.iter().find(|card| card.id == shape).ok_or_else(|| unknown("shape", shape, ids()))?;
    let (mut numbers, mut radii, mut place) = (vec![], vec![], [0.0; 3]);
    for word in sizes {
        let Some((name, text)) = word.split_once('=') else {
            return input(format!("{}: a size is written name=value", quoted(word)));
        };
        let at = |e: Error| e.at(name);
        let value = value::parse(text).map_err(at)?;
        if name == "radii" {
            radii = list(&value).map_err(at)?;
        } else if let Some(axis) = PLACE.iter().position(|p| *p == name) {
            place[axis] = value.in_unit("m").map_err(at)?;
        } else {
            numbers.push((name, value.in_unit(unit(card, name)?).map_err(at)?));
        }
    }
    Ok(named(card.id, &numbers, &radii).map_err(Error::Input)?.moved(place))
}

fn list(value: &Value) -> Result<Vec<f64>, Error> {
    let Value::List(items) = value else { return input("a list is needed here, such as [0.01; 0.03; 0.05]") };
    items.iter().map(|item| item.in_unit("m")).collect()
}

/// The unit of a size.
fn unit(card: &BodyCard, name: &str) -> Result<&'static str, Error> {
    let sizes = card.sizes.iter().map(|size| (size.name, size.unit));
    let lists = card.radii.then_some(("radii", "m"));
    let all =
        sizes.chain([("density", "kg/m^3"), ("mass", "kg")]).chain(lists).chain(PLACE.map(|p| (p, "m")));
    let all: Vec<_> = all.collect();
    let found = all.iter().find(|(known, _)| *known == name);
    found
        .map(|(_, unit)| *unit)
        .ok_or_else(|| unknown(&format!("size of a {}", card.id), name, all.iter().map(|(known, _)| *known)))
}

/// What there is to say about a body of this profile on a table, where it is hollow.
pub fn hollow(words: &[String]) -> Option<String> {
    let radii = words.iter().find_map(|word| word.strip_prefix("radii="))?;
    convex(&list(&value::parse(radii).ok()?).ok()?).err()
}

/// The body as a table of a scenario file, `[system.body]`; without a support where its surface has another form.
pub fn toml(solid: &Solid) -> String {
    let vector = |v: &[f64; 3]| format!("[{}]", v.map(shortest).join(", "));
    let rows = solid.inertia.each_ref().map(vector).join(", ");
    let support = solid.form().map_or(String::new(), |form| {
        let (point, radius, axes) = (vector(&form.point), shortest(form.radius), vector(&form.axes));
        format!("support = {{ point = {point}, radius = {radius}, axes = {axes} }}\n")
    });
    format!("[system.body]\nmass = {}\ninertia = [{rows}]\n{support}", shortest(solid.mass))
}

/// Everything about a body, with its inertia about a further point.
pub fn json(solid: &Solid, point: [f64; 3]) -> serde_json::Value {
    let (moments, axes) = solid.principal();
    json!({
        "mass": solid.mass,
        "centre": solid.centre,
        "inertia": solid.inertia,
        "point": point,
        "inertia_about_point": solid.inertia_about(point),
        "principal_moments": moments,
        "principal_axes": axes,
        "revolution": solid.revolution().map(|(i1, i3)| json!({ "i1": i1, "i3": i3 })),
        "support": solid.form().map(|form| {
            json!({ "point": form.point, "radius": form.radius, "axes": form.axes })
        }),
    })
}

/// One line on a size: what it means, its unit, its default.
pub fn meaning(size: &Size) -> String {
    let default = size.default.map_or(String::new(), |x| format!(" ({} where not given)", shortest(x)));
    format!("{}, {}{default}", size.text.0, size.unit)
}
