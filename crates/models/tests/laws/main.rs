//! The laws: what every system of the list must hold to, unasked.
//!
//! Each law is a function from a system to a result, walks [`precess_models::ALL`], and is shown able to fail:
//! beside it stand small systems with a planted fault that it must name.

mod card;
mod cases;
mod closed_form;
mod draw;
mod invariants;
mod lagrangian;
mod parity;
mod period;
mod units;

use precess_system::AnySystem;

/// A system whose type is forgotten.
type Any = &'static dyn AnySystem;

/// Holds every system to a law and shows all that break it at once.
fn holds_for_all(law: impl Fn(Any) -> Result<(), String>) {
    let broken: Vec<String> = precess_models::ALL
        .iter()
        .filter_map(|&system| law(system).err().map(|fault| format!("{}: {fault}", system.card().id)))
        .collect();
    assert!(broken.is_empty(), "\n{}\n", broken.join("\n"));
}

/// Asserts that a law finds a planted fault, and says so in these words.
#[track_caller]
fn finds(verdict: &Result<(), String>, words: &[&str]) {
    let Err(fault) = verdict else { panic!("the law passed a faulty system") };
    for word in words {
        assert!(fault.contains(word), "the law complains of something else: {fault}");
    }
}

/// Whether a number is small enough; one that is none is not.
fn within(x: f64, bound: f64) -> bool {
    x.abs() <= bound
}
