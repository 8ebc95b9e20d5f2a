//! Names as a reader writes them.

use crate::plan::{Plan, Step};
use precess_system::Quantity;

/// Method and steps.
pub(crate) fn subtitle(plan: &Plan) -> String {
    let method = plan.method.card().id;
    match plan.step {
        Step::Fixed(dt) => format!("{method}, dt = {dt} s"),
        Step::Adaptive { rtol, atol } => format!("{method}, rtol = {rtol:e}, atol = {atol:e}"),
    }
}

/// Name and unit of an axis: `theta [rad]`.
pub(crate) fn axis(quantity: &Quantity) -> String {
    let (name, unit) = (readable(&quantity.name), raised(&quantity.unit));
    if unit.is_empty() { name } else { format!("{name} [{unit}]") }
}

/// `kg m^2/s` to `kg m²/s`.
fn raised(unit: &str) -> String {
    unit.replace("^2", "²").replace("^3", "³").replace("^4", "⁴")
}

/// `theta1_dot` to `θ1′`.
pub(crate) fn readable(name: &str) -> String {
    let (stem, prime) = name.strip_suffix("_dot").map_or((name, ""), |stem| (stem, "′"));
    let letters = stem.trim_end_matches(|c: char| c.is_ascii_digit());
    let greek = match letters {
        "theta" => "θ",
        "psi" => "ψ",
        "phi" => "φ",
        "omega" => "ω",
        "alpha" => "α",
        "beta" => "β",
        "gamma" => "γ",
        "delta" => "δ",
        "mu" => "μ",
        "rho" => "ρ",
        "sigma" => "σ",
        other => other,
    };
    format!("{greek}{}{prime}", &stem[letters.len()..])
}

/// The label of an axis that several quantities share: one name, the names without their numbers, or the unit alone.
pub(crate) fn shared(quantities: &[&Quantity]) -> String {
    let [first, rest @ ..] = quantities else { return String::new() };
    let bare = |q: &Quantity| q.name.chars().filter(|c| !c.is_ascii_digit()).collect::<String>();
    if rest.iter().all(|q| q.name == first.name) {
        return axis(first);
    }
    if rest.iter().any(|q| q.unit != first.unit) {
        return String::new();
    }
    if rest.iter().all(|q| bare(q) == bare(first)) {
        return axis(&Quantity { name: bare(first), ..(*first).clone() });
    }
    if first.unit.is_empty() { String::new() } else { format!("[{}]", raised(&first.unit)) }
}
