//! How much memory is in use: a result that does not fit is refused with a sentence before an allocation fails,
//! because a failed allocation ends the program.

use std::alloc::{GlobalAlloc, Layout, System};
use std::sync::atomic::{AtomicUsize, Ordering::Relaxed};

/// Results beyond this are refused: a quarter of what 32 bits can address, since a table that grows needs its old
/// and its new place at once, and events are copied once.
pub const MOST: usize = 1 << 30;

static USED: AtomicUsize = AtomicUsize::new(0);

/// Bytes in use.
pub fn used() -> usize {
    USED.load(Relaxed)
}

/// Whether there is room for so many numbers; `sentence` where there is not.
pub fn fits(numbers: f64, sentence: impl FnOnce() -> String) -> Result<(), String> {
    if numbers * 8.0 < MOST.saturating_sub(used()) as f64 { Ok(()) } else { Err(sentence()) }
}

struct Counting;

// An allocator is unsafe to write: this one hands everything to the system's and counts.
#[allow(unsafe_code)]
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        USED.fetch_add(layout.size(), Relaxed);
        // The caller keeps the contract of `GlobalAlloc`, which is the system allocator's own.
        unsafe { System.alloc(layout) }
    }

    unsafe fn dealloc(&self, place: *mut u8, layout: Layout) {
        USED.fetch_sub(layout.size(), Relaxed);
        // As above.
        unsafe { System.dealloc(place, layout) }
    }

    unsafe fn realloc(&self, place: *mut u8, layout: Layout, size: usize) -> *mut u8 {
        USED.fetch_add(size, Relaxed);
        USED.fetch_sub(layout.size(), Relaxed);
        // As above.
        unsafe { System.realloc(place, layout, size) }
    }
}

#[global_allocator]
static COUNTING: Counting = Counting;
