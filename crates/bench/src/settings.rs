//! What is measured with, and for how long.

use crate::{Error, Peer};
use precess::Workers;
use precess::scalar::Isa;

/// How much work goes into a number.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Effort {
    /// Rounds of which the shortest time counts.
    pub rounds: usize,
    /// About how long plain numbers work in a round, in seconds.
    pub spell: f64,
    /// The magnets: starts along a side of the square.
    pub side: usize,
    /// The magnets: steps.
    pub steps: u32,
}

impl Effort {
    /// A minute at most for everything.
    pub const QUICK: Self = Self { rounds: 5, spell: 0.02, side: 32, steps: 4000 };
    /// Numbers to write down. The magnets are the whole exercise of the source.
    pub const LONG: Self = Self { rounds: 15, spell: 0.1, side: 40, steps: 40_000 };
}

/// The settings of a measurement.
#[derive(Clone, Debug)]
pub struct Settings {
    /// The registers, plain numbers first.
    pub isas: Vec<Isa>,
    /// How long.
    pub effort: Effort,
    /// Programs to be measured beside the magnets.
    pub peers: Vec<Peer>,
}

impl Settings {
    /// Every set of registers of this machine; where `PRECESS_LANES` names one, that one beside plain numbers.
    ///
    /// # Errors
    /// Where this machine lacks what `PRECESS_LANES` names.
    pub fn new(effort: Effort, peers: Vec<Peer>) -> Result<Self, Error> {
        let chosen = Workers::chosen()?.isa;
        let mut isas = Isa::available();
        if std::env::var("PRECESS_LANES").is_ok() {
            isas.retain(|&isa| isa == Isa::Scalar || isa == chosen);
        }
        Ok(Self { isas, effort, peers })
    }

    /// The widest registers that are measured.
    pub fn widest(&self) -> Isa {
        self.isas.last().copied().unwrap_or(Isa::Scalar)
    }
}
