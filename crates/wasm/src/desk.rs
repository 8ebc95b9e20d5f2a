//! What lies between two calls of the host: its text, the last answer, the results it has not freed.

use crate::kept::Kept;
use std::cell::RefCell;
use std::collections::BTreeMap;

#[derive(Default)]
struct Desk {
    input: Vec<u8>,
    answer: String,
    results: BTreeMap<u32, Kept>,
    /// Handles are never used twice, so that an old one is noticed.
    last: u32,
}

thread_local! {
    static DESK: RefCell<Desk> = RefCell::default();
}

fn with<T>(f: impl FnOnce(&mut Desk) -> T) -> T {
    DESK.with_borrow_mut(f)
}

/// Room for a text; null where there is none.
pub fn input(bytes: usize) -> *mut u8 {
    with(|desk| {
        desk.input = Vec::new();
        if desk.input.try_reserve_exact(bytes).is_err() {
            return std::ptr::null_mut();
        }
        desk.input.resize(bytes, 0);
        desk.input.as_mut_ptr()
    })
}

/// Takes the text that the host has written.
pub fn text() -> Result<String, String> {
    let bytes = with(|desk| std::mem::take(&mut desk.input));
    String::from_utf8(bytes).map_err(|_| "that is no text (UTF-8)".into())
}

/// Puts down an answer.
pub fn say(answer: String) {
    with(|desk| desk.answer = answer);
}

/// Puts down a sentence; the status of a call that is refused.
pub fn refuse(sentence: String) -> u32 {
    say(sentence);
    0
}

/// The last answer: where it lies, how long it is.
pub fn answer() -> (*const u8, usize) {
    with(|desk| (desk.answer.as_ptr(), desk.answer.len()))
}

/// Keeps a result and answers with its report.
pub fn keep(result: Result<(Kept, String), String>) -> u32 {
    let (kept, report) = match result {
        Ok(result) => result,
        Err(sentence) => return refuse(sentence),
    };
    with(|desk| {
        desk.answer = report;
        desk.last += 1;
        desk.results.insert(desk.last, kept);
        desk.last
    })
}

/// Looks at a result.
pub fn look<T>(handle: u32, f: impl FnOnce(&Kept) -> T) -> Option<T> {
    with(|desk| desk.results.get(&handle).map(f))
}

/// Forgets a result.
pub fn free(handle: u32) {
    with(|desk| desk.results.remove(&handle));
}

#[cfg(test)]
mod tests {
    use super::*;

    fn a_result() -> (Kept, String) {
        (Kept { events: vec![1.0, 2.0], ..Kept::default() }, "report".into())
    }

    #[test]
    fn a_freed_handle_is_noticed_and_never_given_again() {
        let first = keep(Ok(a_result()));
        let events = |handle| look(handle, |kept| kept.events.len());
        assert_eq!(events(first), Some(2));
        free(first);
        free(first);
        assert_eq!(events(first), None);
        let second = keep(Ok(a_result()));
        assert_ne!(first, second);
        assert_ne!(second, 0);
        assert_eq!(keep(Err("no".into())), 0);
        assert_eq!(answer().1, 2);
    }

    #[test]
    fn a_text_is_taken_once() {
        assert!(!input(3).is_null());
        assert_eq!(text().as_deref(), Ok("\0\0\0"));
        assert_eq!(text().as_deref(), Ok(""));
        assert!(input(usize::MAX).is_null());
    }
}
