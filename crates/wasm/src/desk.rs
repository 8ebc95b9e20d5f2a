//! What lies between two calls of the host: its inputs, the last answer, the results it has not freed.

use crate::kept::Kept;
use std::cell::RefCell;
use std::collections::BTreeMap;

#[derive(Default)]
struct Desk {
    inputs: Vec<Vec<u8>>,
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

/// Room for an input; null where there is none, and what was put here before is then forgotten, too.
pub fn input(bytes: usize) -> *mut u8 {
    with(|desk| {
        let mut room = Vec::new();
        if room.try_reserve_exact(bytes).is_err() {
            desk.inputs.clear();
            return std::ptr::null_mut();
        }
        room.resize(bytes, 0);
        let place = room.as_mut_ptr();
        desk.inputs.push(room);
        place
    })
}

/// Takes all inputs that the host has written, which must be so many.
pub fn inputs<const N: usize>() -> Result<[Vec<u8>; N], String> {
    let inputs = with(|desk| std::mem::take(&mut desk.inputs));
    let given = inputs.len();
    inputs.try_into().map_err(|_| format!("this takes {N} inputs, not {given}"))
}

/// An input as a text.
pub fn text(bytes: Vec<u8>) -> Result<String, String> {
    String::from_utf8(bytes).map_err(|_| "that is no text (UTF-8)".into())
}

/// An input as numbers.
pub fn numbers(bytes: &[u8]) -> Result<Vec<f64>, String> {
    let (numbers, []) = bytes.as_chunks() else {
        return Err("these are no numbers of eight bytes".into());
    };
    Ok(numbers.iter().map(|bytes| f64::from_le_bytes(*bytes)).collect())
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
    use crate::kept::Table;
    use precess::system::Trajectory;

    fn a_result() -> (Kept, String) {
        let trajectory = Trajectory { numbers: vec![1.0, 2.0], ..Trajectory::default() };
        (Kept::from(trajectory), "report".into())
    }

    #[test]
    fn a_freed_handle_is_noticed_and_never_given_again() {
        let first = keep(Ok(a_result()));
        let numbers = |handle| look(handle, |kept| kept.table(Table::Numbers).len());
        assert_eq!(numbers(first), Some(2));
        free(first);
        free(first);
        assert_eq!(numbers(first), None);
        let second = keep(Ok(a_result()));
        assert_ne!(first, second);
        assert_ne!(second, 0);
        assert_eq!(keep(Err("no".into())), 0);
        assert_eq!(answer().1, 2);
    }

    #[test]
    fn inputs_are_taken_once_and_all_together() {
        assert!(!input(3).is_null());
        assert!(!input(8).is_null());
        assert_eq!(inputs().map(|[a, b]| (text(a), numbers(&b))), Ok((Ok("\0\0\0".into()), Ok(vec![0.0]))));
        assert_eq!(inputs::<1>(), Err("this takes 1 inputs, not 0".into()));
        assert!(!input(3).is_null());
        assert!(input(usize::MAX).is_null());
        assert!(!input(7).is_null());
        let [rest] = inputs().expect("what did not fit took the first one along");
        assert!(numbers(&rest).is_err());
    }
}
