//! Precess as WebAssembly: a thin face over the `precess` crate.
//!
//! The interface is plain functions ([`exports`]), so no tool stands between `cargo build` and the page. The host
//! writes a text where [`exports::precess_input`] says, calls, and reads the answer: JSON, or one sentence that
//! says what was wrong. Results are tables of numbers; they stay here under a handle, to be looked at in place,
//! until they are freed. `docs/wasm.md` describes it from outside, `web/src/core/` is the facade.
//!
//! Another kind of result is another function that makes a `kept::Kept`: reading it, hashing it and freeing it are
//! there already.

mod basins;
mod catalogue;
mod desk;
mod ensemble;
pub mod exports;
mod kept;
mod memory;
mod report;
mod run;
mod trust;
