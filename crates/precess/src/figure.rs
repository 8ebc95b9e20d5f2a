//! A figure: data and labels, no pixels. The faces draw it.

/// A picture of one or several panels.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Figure {
    /// Heading of the whole picture.
    pub title: String,
    /// Smaller line under the title (method, tolerance, the system's parameters); may be empty.
    pub subtitle: String,
    /// The panels, in reading order.
    pub panels: Vec<Panel>,
    /// The scenario (TOML) that reproduces the picture; the drawing carries it as metadata.
    pub scenario: String,
}

/// One pair of axes.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Panel {
    /// Heading of the panel; may be empty.
    pub title: String,
    /// Horizontal axis with its unit, such as `t [s]`.
    pub x_label: String,
    /// Vertical axis with its unit.
    pub y_label: String,
    /// One unit of x is as long as one unit of y (orbits, traces in a plane).
    pub equal_scales: bool,
    /// Vertical axis in decades; values that are not positive are left out.
    pub logarithmic: bool,
    /// Curves, drawn in order, coloured in order.
    pub curves: Vec<Curve>,
    /// Single points that deserve a mark: magnets, events, starts.
    pub marks: Vec<Mark>,
    /// Horizontal range; what lies beyond is cut off. As the data need where absent.
    pub x_range: Option<(f64, f64)>,
    /// Vertical range, likewise.
    pub y_range: Option<(f64, f64)>,
    /// Classes on a grid, below everything else.
    pub map: Option<Map>,
}

/// A polyline; a point that is not finite interrupts it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Curve {
    /// Name in the legend; empty for none.
    pub label: String,
    /// Abscissae.
    pub x: Vec<f64>,
    /// Ordinates, as many.
    pub y: Vec<f64>,
    /// Number of its colour; its place among the curves where absent.
    pub ink: Option<usize>,
    /// How it is drawn.
    pub stroke: Stroke,
}

/// How a curve is drawn.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Stroke {
    /// A line.
    #[default]
    Line,
    /// A line so thin that many of them make a texture.
    Thin,
    /// A broken line: what another curve is held against.
    Dashed,
    /// Its points alone.
    Dots,
}

/// Classes on a grid of points, a cell about each: basins of attraction, stable and unstable parameters.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Map {
    /// Abscissae of the first and the last column of points.
    pub x: (f64, f64),
    /// Ordinates of the first and the last row.
    pub y: (f64, f64),
    /// Points of a row.
    pub columns: usize,
    /// The class of each point, the first row first; a negative one has no colour of its own.
    pub classes: Vec<i32>,
    /// Names of the classes from zero on, for the legend; may be empty.
    pub names: Vec<String>,
}

/// A marked point.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mark {
    /// Text beside it; may be empty.
    pub label: String,
    /// Abscissa.
    pub x: f64,
    /// Ordinate.
    pub y: f64,
    /// Its shape.
    pub sign: Sign,
    /// Number of its colour; black where absent.
    pub ink: Option<usize>,
}

/// The shape of a mark.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Sign {
    /// A full dot.
    #[default]
    Dot,
    /// An open ring: a point that repels.
    Ring,
    /// A cross: a saddle.
    Cross,
    /// A large ball: a body that rolls on a curve.
    Ball,
}
