//! The functions that the host calls, and the one that it gives.
//!
//! A function that may refuse returns 0 then, and the answer is the sentence; otherwise the answer is what it was
//! asked for. Nothing is held while the host is called back, so that it may call in turn.

// An exported name is `unsafe` to Rust because two of the same name would clash; every one here begins with
// `precess_`. The imported function takes a number and gives one. No pointer is ever read on this side.
#![allow(unsafe_code)]

use crate::kept::{Kept, Table};
use crate::{basins, catalogue, desk, ensemble, memory, run, trust};

/// Makes room for an input of so many bytes; null where there is none, and earlier inputs are then forgotten, too. The
/// next call takes all inputs, in order.
#[unsafe(no_mangle)]
pub extern "C" fn precess_input(bytes: usize) -> *mut u8 {
    desk::input(bytes)
}

/// Where the last answer lies (UTF-8).
#[unsafe(no_mangle)]
pub extern "C" fn precess_answer() -> *const u8 {
    desk::answer().0
}

/// Its length in bytes.
#[unsafe(no_mangle)]
pub extern "C" fn precess_answer_bytes() -> usize {
    desk::answer().1
}

/// Whether this core is the small one of the lab's first page.
const FIRST: bool = cfg!(feature = "first");

/// Answers with everything there is: systems, methods, scenarios.
#[unsafe(no_mangle)]
pub extern "C" fn precess_catalogue() {
    desk::say(if FIRST { "null".into() } else { catalogue::catalogue().to_string() });
}

/// Runs the scenario (TOML) in the input: a handle to its numbers, and a report as the answer.
#[unsafe(no_mangle)]
pub extern "C" fn precess_run() -> u32 {
    let done = || {
        let [scenario] = desk::inputs()?;
        run::run(&desk::text(scenario)?, &mut host::progress)
    };
    desk::keep(done())
}

/// Runs a scenario from many starts: a handle, and a report as the answer. The inputs are the scenario, names of
/// initial values (one a line), and numbers: the values of each start in the order of the names; or, where `grid` is
/// not zero, six for each name: first value, last value, points; of these points the first, every which, how many.
/// Every sample is kept where `samples` is not zero, otherwise the end. `plain` not zero computes one number at a time.
#[unsafe(no_mangle)]
pub extern "C" fn precess_ensemble(grid: u32, samples: u32, plain: u32) -> u32 {
    let done = || {
        if FIRST {
            return Err("this core has no ensembles".into());
        }
        let [scenario, names, numbers] = desk::inputs()?;
        let request = ensemble::Request {
            scenario: &desk::text(scenario)?,
            names: &desk::text(names)?,
            numbers: &desk::numbers(&numbers)?,
            grid: grid != 0,
            samples: samples != 0,
            plain: plain != 0,
        };
        ensemble::ensemble(&request, &mut host::progress)
    };
    desk::keep(done())
}

/// Where the starts of a tile end, only what is proved: a handle to their labels (the number of an attractor in the answer;
/// -1 undecided, -2 escaped, -3 diverged). The inputs are those of an ensemble's grid. `draft` not zero follows each start
/// once, within a loose tolerance; `plain` as above.
#[unsafe(no_mangle)]
pub extern "C" fn precess_basins(draft: u32, plain: u32) -> u32 {
    let done = || {
        if FIRST {
            return Err("this core has no basins".into());
        }
        let [scenario, names, numbers] = desk::inputs()?;
        let request = basins::Request {
            scenario: &desk::text(scenario)?,
            names: &desk::text(names)?,
            numbers: &desk::numbers(&numbers)?,
            draft: draft != 0,
            plain: plain != 0,
        };
        basins::basins(&request, &mut host::progress)
    };
    desk::keep(done())
}

/// How far the run of the scenario in the input can be trusted, where a relative error `within` is borne: a handle to a
/// table (`t`, `error`, and `trusted`: one up to the horizon, zero beyond), and its columns as the answer.
#[unsafe(no_mangle)]
pub extern "C" fn precess_trust(within: f64) -> u32 {
    let done = || {
        if FIRST {
            return Err("this core has no shadows".into());
        }
        let [scenario] = desk::inputs()?;
        trust::trust(&desk::text(scenario)?, within, &mut host::progress)
    };
    desk::keep(done())
}

/// Where a table of a result lies; null where it has none.
#[unsafe(no_mangle)]
pub extern "C" fn precess_table(handle: u32, table: u32) -> *const f64 {
    look(handle, table, <[f64]>::as_ptr).unwrap_or(std::ptr::null())
}

/// How many numbers are in it.
#[unsafe(no_mangle)]
pub extern "C" fn precess_table_length(handle: u32, table: u32) -> usize {
    look(handle, table, <[f64]>::len).unwrap_or(0)
}

fn look<T>(handle: u32, table: u32, f: impl FnOnce(&[f64]) -> T) -> Option<T> {
    let table = Table::numbered(table)?;
    desk::look(handle, |kept| f(kept.table(table)))
}

/// Answers with the SHA-256 of a member of a result, the one that the command line prints for the same run; a run is
/// its member 0.
#[unsafe(no_mangle)]
pub extern "C" fn precess_hash(handle: u32, member: usize) -> u32 {
    tell(handle, |kept| kept.hash(member), "there is no such member")
}

/// Answers why a member of an ensemble ended before its time; refuses where it did not.
#[unsafe(no_mangle)]
pub extern "C" fn precess_failure(handle: u32, member: usize) -> u32 {
    tell(handle, |kept| kept.failure(member), "this member has not failed")
}

fn tell(handle: u32, what: impl FnOnce(&Kept) -> Option<String>, nothing: &str) -> u32 {
    match desk::look(handle, what) {
        Some(Some(answer)) => {
            desk::say(answer);
            1
        }
        Some(None) => desk::refuse(nothing.into()),
        None => desk::refuse("there is no such result: it has been freed".into()),
    }
}

/// Forgets a result. A handle that is none, or no longer, does nothing.
#[unsafe(no_mangle)]
pub extern "C" fn precess_free(handle: u32) {
    desk::free(handle);
}

/// Bytes in use, to find out what keeps them.
#[unsafe(no_mangle)]
pub extern "C" fn precess_used() -> usize {
    memory::used()
}

/// What the host gives.
#[cfg(target_arch = "wasm32")]
mod host {
    #[link(wasm_import_module = "precess")]
    unsafe extern "C" {
        #[link_name = "progress"]
        safe fn host_progress(done: f64) -> u32;
    }

    /// Tells how far the work has come (the time of a run, the members of an ensemble); whether it shall go on.
    pub fn progress(done: f64) -> bool {
        host_progress(done) == 0
    }
}

/// Outside a browser (lints, tests) nobody watches.
#[cfg(not(target_arch = "wasm32"))]
mod host {
    pub fn progress(_: f64) -> bool {
        true
    }
}
