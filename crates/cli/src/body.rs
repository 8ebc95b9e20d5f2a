//! `precess body SHAPE name=value ...`: mass, centre and inertia of a body.

use crate::args::Body;
use crate::failure::Failure;
use crate::list;
use precess::body;
use precess::body::bodies::Solid;
use precess::value::{self, Value, shortest};
use std::fmt::Write;

/// Describes a body; without words, lists the shapes.
pub fn body(arguments: &Body) -> Result<(), Failure> {
    if arguments.words.is_empty() {
        return list::print(&shapes());
    }
    let solid = body::read(&arguments.words)?;
    let point = arguments.about.as_deref().map_or(Ok([0.0; 3]), place)?;
    if arguments.json {
        return list::print(&format!("{:#}\n", body::json(&solid, point)));
    }
    let mut text = describe(&solid, point);
    if let Some(why) = body::hollow(&arguments.words) {
        let _ = writeln!(text, "\nOn a table it touches with its hull: {why}.");
    }
    list::print(&text)
}

/// A point written `[0; 0; 0.1]`.
fn place(text: &str) -> Result<[f64; 3], Failure> {
    let wrong =
        || Failure::Wrong(format!("--about: a point has three coordinates, such as [0; 0; 0.1], not {text}"));
    let Value::List(items) = value::parse(text).map_err(|e| e.at("--about"))? else { return Err(wrong()) };
    let numbers: Result<Vec<f64>, _> = items.iter().map(|item| item.in_unit("m")).collect();
    numbers.map_err(|e| e.at("--about"))?.try_into().map_err(|_| wrong())
}

fn shapes() -> String {
    let mut text =
        String::from("Shapes, with their sizes (and density or mass; x, y, z place a part of a sum)\n");
    for card in body::shapes() {
        let _ = writeln!(text, "\n{}  {}  ({})", card.id, card.title.0, card.source);
        for size in card.sizes {
            let _ = writeln!(text, "  {:8}  {}", size.name, body::meaning(size));
        }
        if card.radii {
            let _ = writeln!(text, "  radii     radii at the middles of equal slices, from below, m");
        }
    }
    text
}

fn describe(solid: &Solid, point: [f64; 3]) -> String {
    let vector = |v: [f64; 3]| v.map(shortest).join("  ");
    // Writing to a String cannot fail.
    let mut text = String::new();
    let _ = writeln!(text, "mass     {} kg", shortest(solid.mass));
    let _ = writeln!(text, "centre   {} m", vector(solid.centre));
    matrix(&mut text, "Inertia about the centre of mass, kg m^2", solid.inertia);
    matrix(&mut text, &format!("Inertia about ({}), kg m^2", vector(point)), solid.inertia_about(point));
    if solid.revolution().is_none() {
        let (moments, axes) = solid.principal();
        let _ = writeln!(text, "\nPrincipal moments, kg m^2, and their axes");
        for (moment, axis) in moments.into_iter().zip(axes) {
            let _ = writeln!(text, "  {}   ({})", shortest(moment), vector(axis));
        }
    }
    let _ = writeln!(text, "\nIn a scenario\n\n{}", body::toml(solid).trim_end());
    if let Some((i1, i3)) = solid.revolution() {
        let [m, i1, i3, d] = [solid.mass, i1, i3, solid.centre[2] - point[2]].map(shortest);
        let _ = writeln!(text, "\nAs a gyroscope that turns about that point");
        let _ = writeln!(text, "\nprecess run gyroscope -p m={m} -p i1={i1} -p i3={i3} -p d={d}");
    }
    text
}

/// Three aligned rows.
fn matrix(text: &mut String, heading: &str, rows: [[f64; 3]; 3]) {
    let cells = rows.map(|row| row.map(shortest));
    let width = cells.iter().flatten().map(String::len).max().unwrap_or(0);
    let _ = writeln!(text, "\n{heading}");
    for [a, b, c] in cells {
        let _ = writeln!(text, "  {a:>width$}  {b:>width$}  {c:>width$}");
    }
}
