//! The functions that the host calls, and the one that it gives.
//!
//! A function that may refuse returns 0 then, and the answer is the sentence; otherwise the answer is what it was
//! asked for. Nothing is held while the host is called back, so that it may call in turn.

// An exported name is `unsafe` to Rust because two of the same name would clash; every one here begins with
// `precess_`. The imported function takes a number and gives one. No pointer is ever read on this side.
#![allow(unsafe_code)]

use crate::{catalogue, desk, memory, run};

/// Makes room for a text of so many bytes; null where there is none. The next call takes the text.
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

/// Answers with everything there is: systems, methods, scenarios.
#[unsafe(no_mangle)]
pub extern "C" fn precess_catalogue() {
    desk::say(catalogue::catalogue().to_string());
}

/// Runs the scenario (TOML) in the input: a handle to its numbers, and a report as the answer.
#[unsafe(no_mangle)]
pub extern "C" fn precess_run() -> u32 {
    desk::keep(desk::text().and_then(|text| run::run(&text, &mut host::progress)))
}

/// Where the numbers of a result lie: row by row, one number a column.
#[unsafe(no_mangle)]
pub extern "C" fn precess_numbers(handle: u32) -> *const f64 {
    desk::look(handle, |kept| kept.trajectory.numbers.as_ptr()).unwrap_or(std::ptr::null())
}

/// How many numbers there are.
#[unsafe(no_mangle)]
pub extern "C" fn precess_numbers_length(handle: u32) -> usize {
    desk::look(handle, |kept| kept.trajectory.numbers.len()).unwrap_or(0)
}

/// Where the events of a result lie: row by row, which of the report's events, the time, the state.
#[unsafe(no_mangle)]
pub extern "C" fn precess_events(handle: u32) -> *const f64 {
    desk::look(handle, |kept| kept.events.as_ptr()).unwrap_or(std::ptr::null())
}

/// How many numbers there are.
#[unsafe(no_mangle)]
pub extern "C" fn precess_events_length(handle: u32) -> usize {
    desk::look(handle, |kept| kept.events.len()).unwrap_or(0)
}

/// Answers with the SHA-256 of a result, the one that the command line prints.
#[unsafe(no_mangle)]
pub extern "C" fn precess_hash(handle: u32) -> u32 {
    match desk::look(handle, |kept| precess::hash(&kept.trajectory)) {
        Some(hash) => {
            desk::say(hash);
            1
        }
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
        safe fn host_progress(t: f64) -> u32;
    }

    /// Tells the time that a run has reached; whether it shall go on.
    pub fn progress(t: f64) -> bool {
        host_progress(t) == 0
    }
}

/// Outside a browser (lints, tests) nobody watches.
#[cfg(not(target_arch = "wasm32"))]
mod host {
    pub fn progress(_: f64) -> bool {
        true
    }
}
