//! A body written out in a scenario, `[system.body]`, as parameters of `rolling_body` and `sliding_body`.

use crate::error::{Error, input, quoted, unknown};
use crate::scenario::{as_table, entries, line_of, read, word};
use crate::value::{Value, shortest};
use toml::de::{DeTable, DeValue};

/// The systems that take one.
const FOR: [&str; 2] = ["rolling_body", "sliding_body"];
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
pub(crate) fn parameters(system: &str, text: &str, table: &DeTable) -> Result<Vec<(String, Value)>, Error> {
    if !FOR.contains(&system) {
        return input(format!(
            "only {} take a body that is written out; {} has parameters of its own",
            FOR.join(" and "),
            quoted(system)
        ));
    }
    let mut body = Body::default();
    let mut words = vec![];
    let shaped = entries(table).iter().any(|(key, _)| key.get_ref() == "shape");
    for (key, value) in entries(table) {
        let key_text = key.get_ref().as_ref();
        let at = |e: Error| e.at(&format!("line {}: {key_text}", line_of(text, key.span().start)));
        match key_text {
            "support" => body.support = Some(support(as_table(value).map_err(at)?).map_err(at)?),
            "shape" => words.insert(0, word(value).map_err(at)?),
            size if shaped => words.push(format!("{size}={}", spelt(value).map_err(at)?)),
            "mass" => body.mass = Some(read(value).and_then(|v| v.in_unit("kg")).map_err(at)?),
            "inertia" => body.inertia = Some(inertia(&read(value).map_err(at)?).map_err(at)?),
            other => {
                return Err(unknown("key", other, KEYS)
                    .at(&format!("line {}: [system.body]", line_of(text, key.span().start))));
            }
        }
    }
    if shaped {
        body.shape(&words)?;
    }
    body.parameters().map_err(|e| e.at("[system.body]"))
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
