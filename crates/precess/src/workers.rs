//! The registers and threads that compute an ensemble.

use crate::error::{Error, input};
use precess_scalar::Isa;

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
