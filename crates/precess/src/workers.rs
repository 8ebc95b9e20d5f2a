//! The registers and threads that compute an ensemble.

use crate::error::{Error, input};
use precess_scalar::Isa;
use std::ops::ControlFlow;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::mpsc;

/// How an ensemble is computed: nothing here changes a bit of it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Workers {
    /// The registers.
    pub isa: Isa,
    /// The number of threads, at least one.
    pub threads: usize,
}

impl Workers {
    /// The widest registers of this machine, and a thread for each of its cores.
    pub fn all() -> Self {
        Self { isa: Isa::best(), threads: std::thread::available_parallelism().map_or(1, Into::into) }
    }

    /// The registers that the environment variable `PRECESS_LANES` names, otherwise the widest; a thread a core.
    ///
    /// # Errors
    /// Where this machine has no registers of that name; the sentence lists what it has.
    pub fn chosen() -> Result<Self, Error> {
        match std::env::var("PRECESS_LANES") {
            Ok(name) => match Isa::named(&name) {
                Ok(isa) => Ok(Self { isa, ..Self::all() }),
                Err(error) => input(format!("PRECESS_LANES: {error}")),
            },
            Err(_) => Ok(Self::all()),
        }
    }
}

/// Members of a chunk for each lane.
const ROUNDS: usize = 16;

/// Members of a chunk: enough for lanes to be refilled, few enough for all threads to have some.
pub(crate) fn chunk(members: usize, lanes: usize, threads: usize) -> usize {
    let fair = members.div_ceil(4 * threads).next_multiple_of(lanes);
    if fair < ROUNDS * lanes { fair } else { ROUNDS * lanes }
}

/// Does pieces of work: threads take the next one that nobody has taken, and `take` is given what comes out, in the order
/// in which it comes; where it breaks, no further piece is begun.
pub(crate) fn spread<T: Send>(
    threads: usize,
    pieces: usize,
    work: &(dyn Fn(usize) -> T + Sync),
    take: &mut dyn FnMut(usize, T) -> ControlFlow<()>,
) {
    if threads < 2 || pieces < 2 {
        for index in 0..pieces {
            if take(index, work(index)).is_break() {
                return;
            }
        }
        return;
    }
    let (next, stop) = (AtomicUsize::new(0), AtomicBool::new(false));
    // Whoever takes slowly is not flooded: pieces wait with their threads.
    let (send, receive) = mpsc::sync_channel(threads);
    std::thread::scope(|scope| {
        for _ in 0..if threads < pieces { threads } else { pieces } {
            let (send, next, stop) = (send.clone(), &next, &stop);
            scope.spawn(move || {
                while !stop.load(Ordering::Relaxed) {
                    let index = next.fetch_add(1, Ordering::Relaxed);
                    if index >= pieces || send.send((index, work(index))).is_err() {
                        return;
                    }
                }
            });
        }
        drop(send);
        for (index, part) in receive {
            if take(index, part).is_break() {
                stop.store(true, Ordering::Relaxed);
            }
        }
    });
}
