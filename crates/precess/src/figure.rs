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
}
