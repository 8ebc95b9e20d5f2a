//! The words of the command line.

use clap::{Args, Parser, Subcommand, ValueEnum};
use std::path::PathBuf;

/// A laboratory of classical mechanics.
#[derive(Parser)]
#[command(name = "precess", version, about = "A laboratory of classical mechanics", max_term_width = 100)]
pub struct Command {
    /// What to do.
    #[command(subcommand)]
    pub verb: Verb,
}

/// What the program can do.
#[derive(Subcommand)]
pub enum Verb {
    /// Lists what there is
    List {
        /// Only these
        what: Option<What>,
        /// As JSON, with everything the cards say
        #[arg(long)]
        json: bool,
    },
    /// Shows a system: equations, coordinates, parameters, invariants, source
    Show {
        /// System id
        system: String,
        /// As JSON
        #[arg(long, conflicts_with = "latex")]
        json: bool,
        /// The equations in LaTeX
        #[arg(long)]
        latex: bool,
    },
    /// Works out mass, centre and inertia of a body: cone density=100 height=0.15 radius=0.05 (alone: the shapes)
    Body(Body),
    /// Runs a system, or a scenario file
    Run(Run),
    /// Runs several methods on the same start, side by side
    Compare(Compare),
    /// Finds how far a run can be trusted: until it leaves its shadow, the same motion in double-double
    Trust(Trust),
    /// Finds how fast neighbours of a motion move away from it, in every direction (Lyapunov exponents)
    Lyapunov(Analysis),
    /// Finds where a motion passes through a surface (Poincaré section)
    Poincare(Poincare),
    /// Runs the [ensemble] of a scenario: many members, reduced as they come, with a checkpoint
    Ensemble(Ensemble),
    /// Basins of attraction: where each start of a grid ends, decided only by proof
    Basins(Basins),
    /// Draws the phase portrait: energy levels, separatrices, and the fixed points with their kinds
    Portrait(Portrait),
    /// Finds amplitude and lag of the settled motion while a parameter of the drive goes through a range
    Response(Response),
    /// Records where the settled motion comes by while a parameter goes through a range
    Bifurcation(Response),
    /// Finds the multipliers of a driven motion over a period, and the parameters where it is unstable
    Floquet(Floquet),
    /// Follows a plane path with its moving frames: tangent and normal acceleration, curvature, polar accelerations
    Frenet(Frenet),
    /// Draws every scenario that comes with the program into a page of pictures with notes
    Gallery(Gallery),
    /// Derivatives of a run with respect to its start and its parameters
    Sensitivity(Sensitivity),
    /// Fits starts and parameters to measured points
    Fit(Fit),
    /// Measures how fast this program is on this machine, ratios first
    Bench(Bench),
    /// Serves the lab to a browser on this machine and prints its address; Ctrl-C ends it
    Lab {
        /// Port on loopback; 0 takes any free one (7654, or the next free one, where absent)
        #[arg(long, value_name = "N")]
        port: Option<u16>,
    },
}

/// What `list` lists.
#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum What {
    /// Mechanical systems
    Systems,
    /// Integration methods
    Methods,
    /// Scenarios that come with the program
    Scenarios,
}

/// A body.
#[derive(Args)]
pub struct Body {
    /// A shape and its sizes; '+' begins the next part of a sum, which x, y and z place
    #[arg(value_name = "SHAPE NAME=VALUE...")]
    pub words: Vec<String>,
    /// A further point for the inertia: '[0; 0; 0.1]' (the origin of the shape's axes where absent)
    #[arg(long, value_name = "POINT", allow_hyphen_values = true)]
    pub about: Option<String>,
    /// As JSON
    #[arg(long)]
    pub json: bool,
}

/// What is run, and for how long.
#[derive(Args)]
pub struct Subject {
    /// System id, or a scenario file (*.toml; - for standard input)
    #[arg(value_name = "SYSTEM|FILE.toml")]
    pub name: String,
    /// Sets a parameter: l=0.5, masses='[10; 1]', theta='30 deg'
    #[arg(short, long = "parameter", value_name = "NAME=VALUE", allow_hyphen_values = true)]
    pub parameters: Vec<String>,
    /// Sets an initial value: theta=49*pi/50
    #[arg(short, long = "initial", value_name = "NAME=VALUE", allow_hyphen_values = true)]
    pub initial: Vec<String>,
    /// Step of the fixed-step methods
    #[arg(long, value_name = "DT", allow_hyphen_values = true)]
    pub dt: Option<String>,
    /// Relative tolerance of the adaptive methods
    #[arg(long, value_name = "R", allow_hyphen_values = true)]
    pub rtol: Option<String>,
    /// Absolute tolerance of the adaptive methods
    #[arg(long, value_name = "A", allow_hyphen_values = true)]
    pub atol: Option<String>,
    /// End time; a negative one runs backwards
    #[arg(long, value_name = "T", allow_hyphen_values = true)]
    pub until: Option<String>,
    /// Time between samples (a thousandth of the run where absent)
    #[arg(long, value_name = "DT", allow_hyphen_values = true)]
    pub every: Option<String>,
    /// Writes a CSV file (- for standard output) or an NPZ file
    #[arg(short, long, value_name = "FILE")]
    pub output: Option<PathBuf>,
    /// Draws an SVG or PNG file
    #[arg(long, value_name = "FILE")]
    pub plot: Option<PathBuf>,
    /// No summary, no progress
    #[arg(short, long)]
    pub quiet: bool,
}

/// A run.
#[derive(Args)]
pub struct Run {
    /// What is run.
    #[command(flatten)]
    pub subject: Subject,
    /// Integration method
    #[arg(long, value_name = "ID")]
    pub method: Option<String>,
    /// Sets an option of the method: alpha=1
    #[arg(long = "option", value_name = "NAME=VALUE", allow_hyphen_values = true)]
    pub options: Vec<String>,
    /// Prints the SHA-256 of the result (time and state)
    #[arg(long)]
    pub hash: bool,
    /// Writes the scenario with everything spelt out, so that it runs the same for ever
    #[arg(long, value_name = "FILE.toml")]
    pub save: Option<PathBuf>,
}

/// A comparison.
#[derive(Args)]
pub struct Compare {
    /// What is run.
    #[command(flatten)]
    pub subject: Subject,
    /// Method ids, separated by commas
    #[arg(long, value_name = "A,B,C", value_delimiter = ',', required = true)]
    pub methods: Vec<String>,
}

/// What an analysis is asked of, and where the answer goes.
#[derive(Args)]
pub struct Analysis {
    /// What is run.
    #[command(flatten)]
    pub subject: Subject,
    /// Integration method
    #[arg(long, value_name = "ID")]
    pub method: Option<String>,
    /// Sets an option of the method: alpha=1
    #[arg(long = "option", value_name = "NAME=VALUE", allow_hyphen_values = true)]
    pub options: Vec<String>,
}

/// A section.
#[derive(Args)]
pub struct Poincare {
    /// What it is asked of.
    #[command(flatten)]
    pub analysis: Analysis,
    /// The surface: "theta = 0", "theta = 0 mod 2*pi", "t = 0 mod 3" (in the time of a drive: "mod period")
    #[arg(long, value_name = "QUANTITY = VALUE", allow_hyphen_values = true)]
    pub section: String,
    /// rising, falling or either
    #[arg(long, value_name = "DIRECTION")]
    pub direction: Option<String>,
    /// Quantity across the picture
    #[arg(long, value_name = "NAME")]
    pub x: Option<String>,
    /// Quantity up the picture
    #[arg(long, value_name = "NAME")]
    pub y: Option<String>,
}

/// A horizon.
#[derive(Args)]
pub struct Trust {
    /// What it is asked of.
    #[command(flatten)]
    pub analysis: Analysis,
    /// The error that is borne, as a share of the size of each number of the state
    #[arg(long, value_name = "SHARE", default_value = "1e-3", allow_hyphen_values = true)]
    pub within: String,
}

/// An ensemble.
#[derive(Args)]
pub struct Ensemble {
    /// What it is asked of.
    #[command(flatten)]
    pub analysis: Analysis,
    /// Prints the SHA-256 of all rows
    #[arg(long)]
    pub hash: bool,
    /// Goes on where the work is very large
    #[arg(long)]
    pub yes: bool,
}

/// Basins of attraction.
#[derive(Args)]
pub struct Basins {
    /// What it is asked of.
    #[command(flatten)]
    pub analysis: Analysis,
    /// Starts along one quantity, both ends included: x=-2:2:200. Once or twice; the first runs across the picture
    #[arg(long = "grid", value_name = "NAME=LOW:HIGH:N", allow_hyphen_values = true, required = true)]
    pub grid: Vec<String>,
    /// Attractors that differ by whole turns are one
    #[arg(long)]
    pub wrap: bool,
    /// Follows each start once: faster, but nothing tells labels that are right from those that another tolerance would change
    #[arg(long)]
    pub once: bool,
    /// Goes on where the work is very large
    #[arg(long)]
    pub yes: bool,
}

/// A portrait.
#[derive(Args)]
pub struct Portrait {
    /// What it is asked of.
    #[command(flatten)]
    pub analysis: Analysis,
    /// What is looked at, once for each number of the state: theta=-2*pi:2*pi
    #[arg(long = "window", value_name = "NAME=LOW:HIGH", allow_hyphen_values = true)]
    pub windows: Vec<String>,
    /// About how many energy levels (12 where absent)
    #[arg(long, value_name = "N")]
    pub levels: Option<usize>,
}

/// A question asked at many values of a parameter.
#[derive(Args)]
pub struct Response {
    /// What it is asked of.
    #[command(flatten)]
    pub analysis: Analysis,
    /// The parameter and its values, both ends included: frequency=0.2:3:200
    #[arg(long, value_name = "NAME=LOW:HIGH:N", allow_hyphen_values = true)]
    pub sweep: String,
    /// The number of the state that is looked at; the first coordinate where absent
    #[arg(long, value_name = "NAME")]
    pub coordinate: Option<String>,
    /// From the last value to the first: each value starts where the one before has settled
    #[arg(long)]
    pub down: bool,
}

/// A plane path.
#[derive(Args)]
pub struct Frenet {
    /// What it is asked of.
    #[command(flatten)]
    pub analysis: Analysis,
    /// Horizontal quantity of the path; that of the card's own path where absent
    #[arg(long, value_name = "NAME")]
    pub x: Option<String>,
    /// Vertical quantity of the path
    #[arg(long, value_name = "NAME")]
    pub y: Option<String>,
}

/// Multipliers.
#[derive(Args)]
pub struct Floquet {
    /// What it is asked of.
    #[command(flatten)]
    pub analysis: Analysis,
    /// A parameter and its values: alpha=1:4:100; twice for a map of stable and unstable parameters
    #[arg(long = "sweep", value_name = "NAME=LOW:HIGH:N", allow_hyphen_values = true)]
    pub sweeps: Vec<String>,
}

/// A gallery.
#[derive(Args)]
pub struct Gallery {
    /// Only scenarios whose file name contains one of these: p-fig-25
    pub names: Vec<String>,
    /// The folder for pages and pictures
    #[arg(short, long, value_name = "FOLDER")]
    pub output: PathBuf,
    /// No progress
    #[arg(short, long)]
    pub quiet: bool,
}

/// Derivatives.
#[derive(Args)]
pub struct Sensitivity {
    /// What they are asked of.
    #[command(flatten)]
    pub analysis: Analysis,
    /// What moves: numbers of the start and numeric parameters, separated by commas
    #[arg(long, value_name = "A,B,C", value_delimiter = ',', required = true)]
    pub along: Vec<String>,
}

/// A fit.
#[derive(Args)]
pub struct Fit {
    /// What is fitted; its values are the first guesses.
    #[command(flatten)]
    pub analysis: Analysis,
    /// CSV file: a line of names (t among them), then a line for each time
    #[arg(long, value_name = "FILE.csv")]
    pub data: PathBuf,
    /// What is fitted: numbers of the start and numeric parameters, separated by commas
    #[arg(long, value_name = "A,B,C", value_delimiter = ',', required = true)]
    pub free: Vec<String>,
    /// Columns of the file that are used (all of them where absent)
    #[arg(long, value_name = "A,B,C", value_delimiter = ',')]
    pub columns: Vec<String>,
    /// Uncertainty of a column, one standard deviation (judged from the scatter where absent)
    #[arg(long = "uncertainty", value_name = "NAME=VALUE")]
    pub uncertainties: Vec<String>,
    /// Writes the fitted scenario
    #[arg(long, value_name = "FILE.toml")]
    pub save: Option<PathBuf>,
}

/// A measurement.
#[derive(Args)]
pub struct Bench {
    /// limits, magnets, elementary, methods or systems; all of them where absent
    pub name: Option<String>,
    /// Takes minutes, for numbers to write down
    #[arg(long)]
    pub long: bool,
    /// As JSON
    #[arg(long)]
    pub json: bool,
    /// Runs COMMAND N STEPS FILE in turns with the magnets (benches/peers/README.md)
    #[arg(long = "peer", value_name = "NAME=COMMAND", allow_hyphen_values = true)]
    pub peers: Vec<String>,
    /// No progress
    #[arg(short, long)]
    pub quiet: bool,
}
