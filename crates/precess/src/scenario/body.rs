//! A body written out in a scenario, `[system.body]`, as parameters of the systems that take one.

use super::reading::{as_table, entries, line_of, read, word};
use crate::error::{Error, input, quoted, unknown};
use crate::value::{Value, shortest};
use toml::de::{DeTable, DeValue};

/// The system that takes a shape and turns about the origin of its axes: the tip of a cone, the lower end of a profile.
const ON_A_POINT: &str = "heavy_top";
/// The systems that take one.
const FOR: [&str; 3] = [ON_A_POINT, "rolling_body", "sliding_body"];
const KEYS: [&str; 4] = ["mass", "inertia", "support", "shape"];

/// The body as it has been read so far.
#[derive(Default)]
struct Body {
    mass: Option<f64>,
    inertia: Option<[[f64; 3]; 3]>,
    support: Option<Support>,
}

/// `h(n) = point.n + radius |n| + |axes n|`, from G.
#[derive(Default)]
struct Support {
    point: [f64; 3],
    radius: f64,
    axes: [f64; 3],
}

/// The parameters that make this body: written out (`mass`, `inertia`, `support`), or a `shape` with its sizes as
/// `precess body` takes them, whose support may be given besides.
///
/// # Errors
/// One sentence: what is missing, unknown, or no body.
pub(super) fn parameters(system: &str, text: &str, table: &DeTable) -> Result<Vec<(String, Value)>, Error> {
    if !FOR.contains(&system) {
        return input(format!(
            "only {} take a body that is written out; {} has parameters of its own",
            either(FOR),
            quoted(system)
        ));
    }
    let mut body = Body::default();
    let mut words = vec![];
    let on_a_point = system == ON_A_POINT;
    let shaped = entries(table).iter().any(|(key, _)| key.get_ref() == "shape");
    for (key, value) in entries(table) {
        let key_text = key.get_ref().as_ref();
        let at = |e: Error| e.at(&format!("line {}: {key_text}", line_of(text, key.span().start)));
        match key_text {
            "support" if !on_a_point => {
                body.support = Some(support(as_table(value).map_err(at)?).map_err(at)?);
            }
            "shape" => words.insert(0, word(value).map_err(at)?),
            other if on_a_point && !shaped => {
                return input(format!(
                    "[system.body]: {ON_A_POINT} takes a shape, not {}; mass, inertia and centre are its own parameters",
                    quoted(other)
                ));
            }
            size if shaped => words.push(format!("{size}={}", spelt(value).map_err(at)?)),
            "mass" => body.mass = Some(read(value).and_then(|v| v.in_unit("kg")).map_err(at)?),
            "inertia" => body.inertia = Some(inertia(&read(value).map_err(at)?).map_err(at)?),
            other => {
                return Err(unknown("key", other, KEYS)
                    .at(&format!("line {}: [system.body]", line_of(text, key.span().start))));
            }
        }
    }
    if on_a_point {
        return top(&words).map_err(|e| e.at("[system.body]"));
    }
    if shaped {
        body.shape(&words)?;
    }
    body.parameters().map_err(|e| e.at("[system.body]"))
}

/// `a, b and c`.
fn either<const N: usize>(names: [&str; N]) -> String {
    let (last, others) = names.split_last().unwrap_or((&"none", &[]));
    format!("{} and {last}", others.join(", "))
}

/// Whether a system takes a body.
pub(crate) fn taken_by(system: &str) -> bool {
    FOR.contains(&system)
}

/// A shape as a heavy top that turns about the origin of the shape's axes.
fn top(words: &[String]) -> Result<Vec<(String, Value)>, Error> {
    let solid = crate::body::read(words)?;
    let [[i1, i12, i13], [_, i2, i23], [_, _, i3]] = solid.inertia_about([0.0; 3]);
    if [i12, i13, i23] != [0.0; 3] {
        return input(format!(
            "the axes of this body are not its principal axes at the fixed point, which {ON_A_POINT} needs"
        ));
    }
    let numbers = [("m", solid.mass), ("i1", i1), ("i2", i2), ("i3", i3)];
    let centre = Value::List(solid.centre.map(Value::number).into());
    Ok(numbers
        .map(|(name, x)| (name.to_string(), Value::number(x)))
        .into_iter()
        .chain([("centre".to_string(), centre)])
        .collect())
}

/// A size of a shape, as it is written in a word.
fn spelt(value: &DeValue) -> Result<String, Error> {
    match value {
        DeValue::String(text) => Ok(text.to_string()),
        DeValue::Array(items) => {
            let items = items.iter().map(|item| spelt(item.get_ref())).collect::<Result<Vec<_>, _>>()?;
            Ok(format!("[{}]", items.join("; ")))
        }
        number => Ok(shortest(read(number)?.in_unit("")?)),
    }
}

fn vector(value: &Value, unit: &str) -> Result<[f64; 3], Error> {
    let items = match value {
        Value::List(items) if items.len() == 3 => items,
        _ => return input("three numbers are needed here: [1, 2, 3]"),
    };
    let mut vector = [0.0; 3];
    for (x, item) in vector.iter_mut().zip(items) {
        *x = item.in_unit(unit)?;
    }
    Ok(vector)
}

fn inertia(value: &Value) -> Result<[[f64; 3]; 3], Error> {
    let rows = match value {
        Value::List(rows) if rows.len() == 3 => rows,
        _ => return input("a matrix is needed here, three rows of three numbers"),
    };
    let mut matrix = [[0.0; 3]; 3];
    for (row, value) in matrix.iter_mut().zip(rows) {
        *row = vector(value, "kg m^2")?;
    }
    for (i, j) in [(0, 1), (0, 2), (1, 2)] {
        if matrix[i][j] != matrix[j][i] {
            return input(format!(
                "the matrix is not symmetric: its entries {}{} and {}{} are {} and {}",
                i + 1,
                j + 1,
                j + 1,
                i + 1,
                matrix[i][j],
                matrix[j][i]
            ));
        }
    }
    Ok(matrix)
}

fn support(table: &DeTable) -> Result<Support, Error> {
    let mut support = Support::default();
    for (key, value) in entries(table) {
        let value = read(value)?;
        match key.get_ref().as_ref() {
            "point" => support.point = vector(&value, "m")?,
            "radius" => support.radius = value.in_unit("m")?,
            "axes" => support.axes = vector(&value, "m")?,
            other => return Err(unknown("key", other, ["point", "radius", "axes"])),
        }
    }
    if support.radius < 0.0 || support.axes.iter().any(|&a| a < 0.0) {
        return input("radius and axes must not be below zero: the body would not be convex");
    }
    Ok(support)
}

impl Body {
    /// From a shape and its sizes.
    fn shape(&mut self, words: &[String]) -> Result<(), Error> {
        let solid = crate::body::read(words).map_err(|e| e.at("[system.body]"))?;
        self.mass = Some(solid.mass);
        self.inertia = Some(solid.inertia);
        if self.support.is_none() {
            // What touches the table is the hull, and this would roll on it as if it were there.
            if let Some(why) = crate::body::hollow(words) {
                return input(format!("[system.body]: {why}"));
            }
            let Some(form) = solid.form() else {
                return input(format!(
                    "[system.body]: the surface of a {} has flat faces or edges, which do not roll here: give the \
                     part it stands on, support = {{ point = [...], radius = ..., axes = [...] }}",
                    words[0]
                ));
            };
            self.support = Some(Support { point: form.point, radius: form.radius, axes: form.axes });
        }
        Ok(())
    }

    fn parameters(self) -> Result<Vec<(String, Value)>, Error> {
        let missing = |what: &str, how: &str| Error::Input(format!("the {what} is missing: {how}"));
        let mass = self.mass.ok_or_else(|| missing("mass", "mass = 1.0, in kg"))?;
        if !(mass.is_finite() && mass > 0.0) {
            return input(format!("the mass must be above zero, not {mass}"));
        }
        let [[i11, i12, i13], [_, i22, i23], [_, _, i33]] = self.inertia.ok_or_else(|| {
            missing("inertia", "inertia = [[1, 0, 0], [0, 1, 0], [0, 0, 1]], about G, in kg m^2")
        })?;
        let Support { point, radius, axes } = self.support.ok_or_else(|| {
            missing("support", "support = { point = [0, 0, 0], radius = 0.02, axes = [0, 0, 0] }, in m")
        })?;
        let named = [
            ("m", mass),
            ("i11", i11),
            ("i22", i22),
            ("i33", i33),
            ("i12", i12),
            ("i13", i13),
            ("i23", i23),
            ("point1", point[0]),
            ("point2", point[1]),
            ("point3", point[2]),
            ("radius", radius),
            ("axis1", axes[0]),
            ("axis2", axes[1]),
            ("axis3", axes[2]),
        ];
        Ok(named.map(|(name, x)| (name.to_string(), Value::number(x))).into())
    }
}
