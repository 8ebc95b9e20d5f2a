//! A panel as a scenario asks for it.

use super::reading::entries;
use super::reading::{flag, number_of, pair, read, several, two, word, words};
use crate::error::{Error, input, unknown};
use crate::figure::Stroke;
use crate::value::Value;
use toml::de::DeTable;

/// What a panel shows.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum FigureKind {
    /// Quantities against one another.
    #[default]
    Curves,
    /// Where everything is at a few times.
    Snapshot,
    /// The potential, with a ball at each start and the level of its energy.
    Potential,
    /// Phase portrait: levels of the energy, separatrices, fixed points, and the trajectories on it.
    Portrait,
    /// Amplitude or lag of the settled motion against a parameter.
    Response,
    /// Where the settled motion comes by, against a parameter.
    Bifurcation,
    /// Which starts end where.
    Basins,
    /// Where the motion over two parameters is unstable.
    Tongues,
    /// Where the motion passes through a surface.
    Poincare,
    /// The classes of the scenario's ensemble over its grid.
    Ensemble,
}

impl FigureKind {
    /// All of them by name.
    pub const ALL: [(&'static str, Self); 10] = [
        ("curves", Self::Curves),
        ("snapshot", Self::Snapshot),
        ("potential", Self::Potential),
        ("portrait", Self::Portrait),
        ("response", Self::Response),
        ("bifurcation", Self::Bifurcation),
        ("basins", Self::Basins),
        ("tongues", Self::Tongues),
        ("poincare", Self::Poincare),
        ("ensemble", Self::Ensemble),
    ];
    /// Its name.
    pub fn name(self) -> &'static str {
        Self::ALL.iter().find(|(_, kind)| *kind == self).map_or("", |(name, _)| name)
    }
}

/// A panel. What is absent is chosen by its kind.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct FigureSpec {
    /// Heading.
    pub title: String,
    /// What it shows.
    pub kind: FigureKind,
    /// Horizontal quantities: one for all, or one for each vertical one.
    pub x: Vec<String>,
    /// Vertical quantities.
    pub y: Vec<String>,
    /// Both axes to the same scale.
    pub equal_scales: bool,
    /// The vertical axis in decades.
    pub logarithmic: bool,
    /// Names of the pairs in the legend, in their order; the quantities' own where empty.
    pub names: Vec<String>,
    /// Whose trajectories: `run`, or names of families; all of them where empty.
    pub of: Vec<String>,
    /// Range of the horizontal axis.
    pub x_range: Option<[Value; 2]>,
    /// Range of the vertical axis.
    pub y_range: Option<[Value; 2]>,
    /// Only this part of the time.
    pub between: Option<[Value; 2]>,
    /// Times: of a snapshot, of dots on the curves.
    pub at: Vec<Value>,
    /// Circles of curvature at the times `at`.
    pub circles: bool,
    /// Points of the plane to mark: magnets, for instance.
    pub marks: Vec<[Value; 2]>,
    /// A dot at every start.
    pub starts: bool,
    /// How curves are drawn.
    pub style: Option<Stroke>,
    /// Number of levels of a portrait.
    pub levels: Option<usize>,
    /// `frequency=0.2:3:200`.
    pub sweep: Option<String>,
    /// `theta = 0`.
    pub section: Option<String>,
    /// `x=-2:2:200`, once for each axis.
    pub grid: Vec<String>,
}

const KEYS: [&str; 20] = [
    "kind",
    "title",
    "x",
    "y",
    "names",
    "of",
    "x_range",
    "y_range",
    "between",
    "at",
    "circles",
    "starts",
    "marks",
    "style",
    "equal_scales",
    "logarithmic",
    "levels",
    "sweep",
    "section",
    "grid",
];

/// How curves are drawn, by name.
pub(crate) const STROKES: [(&str, Stroke); 4] =
    [("line", Stroke::Line), ("thin", Stroke::Thin), ("dashed", Stroke::Dashed), ("dots", Stroke::Dots)];

/// A stroke by its name.
pub(super) fn stroke(name: &str) -> Result<Stroke, Error> {
    let found = STROKES.iter().find(|(known, _)| *known == name);
    found.map_or_else(|| Err(unknown("style", name, STROKES.map(|(n, _)| n))), |(_, stroke)| Ok(*stroke))
}

impl FigureSpec {
    pub(super) fn read(table: &DeTable) -> Result<Self, Error> {
        let mut figure = Self::default();
        for (key, value) in entries(table) {
            let key = key.get_ref().as_ref();
            let at = |e: Error| e.at(&format!("[[figure]]: {key}"));
            match key {
                "kind" => {
                    let name = word(value).map_err(at)?;
                    let found = FigureKind::ALL.iter().find(|(known, _)| *known == name);
                    let names = FigureKind::ALL.map(|(name, _)| name);
                    figure.kind = found.ok_or_else(|| at(unknown("kind of figure", &name, names)))?.1;
                }
                "title" => figure.title = word(value).map_err(at)?,
                "x" => figure.x = words(value).map_err(at)?,
                "y" => figure.y = words(value).map_err(at)?,
                "names" => figure.names = words(value).map_err(at)?,
                "of" => figure.of = words(value).map_err(at)?,
                "grid" => figure.grid = words(value).map_err(at)?,
                "x_range" => figure.x_range = Some(pair(value).map_err(at)?),
                "y_range" => figure.y_range = Some(pair(value).map_err(at)?),
                "between" => figure.between = Some(pair(value).map_err(at)?),
                "at" => figure.at = several(read(value).map_err(at)?),
                "circles" => figure.circles = flag(value).map_err(at)?,
                "marks" => {
                    let pairs = several(read(value).map_err(at)?).into_iter();
                    figure.marks = pairs.map(|p| two(p).map_err(at)).collect::<Result<_, _>>()?;
                }
                "starts" => figure.starts = flag(value).map_err(at)?,
                "style" => figure.style = Some(stroke(&word(value).map_err(at)?).map_err(at)?),
                "equal_scales" => figure.equal_scales = flag(value).map_err(at)?,
                "logarithmic" => figure.logarithmic = flag(value).map_err(at)?,
                "levels" => figure.levels = Some(number_of(value, 200).map_err(at)?),
                "sweep" => figure.sweep = Some(word(value).map_err(at)?),
                "section" => figure.section = Some(word(value).map_err(at)?),
                other => return Err(unknown("key", other, KEYS).at("[[figure]]")),
            }
        }
        if figure.y.is_empty() && figure.kind == FigureKind::Curves {
            return input("[[figure]] needs quantities to draw, such as y = [\"theta\", \"energy\"]");
        }
        Ok(figure)
    }
}
