//! The registers of this machine, by the names of their instruction sets.

use crate::{Lanes, Narrow, Wide, Widest};
use std::fmt;

/// Which registers blocks of trajectories are computed in. All give the same bits.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Isa {
    /// Plain numbers, one at a time.
    Scalar,
    /// [`Narrow`].
    Narrow,
    /// [`Wide`].
    Wide,
    /// [`Widest`].
    Widest,
}

/// A name that no instruction set of this machine has.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct UnknownIsa(String);

impl fmt::Display for UnknownIsa {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let known: Vec<_> = Isa::available().into_iter().map(Isa::name).collect();
        write!(f, "this machine has no '{}': it has {}", self.0, known.join(", "))
    }
}
impl std::error::Error for UnknownIsa {}

impl Isa {
    /// Those that this machine has, the widest last.
    pub fn available() -> Vec<Self> {
        let all = [Self::Scalar, Self::Narrow, Self::Wide, Self::Widest];
        let mut lanes = 0;
        // A width that an architecture lacks stands for the one before.
        let wider = |isa: &Self| isa.lanes() > std::mem::replace(&mut lanes, isa.lanes());
        all.into_iter().filter(|isa| isa.is_available()).filter(wider).collect()
    }

    /// The widest that this machine has.
    pub fn best() -> Self {
        Self::available().pop().unwrap_or(Self::Scalar)
    }

    /// The one of this name.
    ///
    /// # Errors
    /// Where this machine has none of this name; the sentence lists what it has.
    pub fn named(name: &str) -> Result<Self, UnknownIsa> {
        let known = Self::available().into_iter().find(|isa| isa.name() == name.to_ascii_lowercase());
        known.ok_or_else(|| UnknownIsa(name.chars().take(40).flat_map(char::escape_debug).collect()))
    }

    /// Its usual name.
    pub fn name(self) -> &'static str {
        match (self, std::env::consts::ARCH) {
            (Self::Scalar, _) => "scalar",
            (Self::Narrow, "x86_64") => "sse2",
            (Self::Wide, "x86_64") => "avx2",
            (Self::Widest, "x86_64") => "avx512",
            (_, "aarch64") => "neon",
            _ => "simd128",
        }
    }

    /// How many numbers a register holds.
    pub fn lanes(self) -> usize {
        match self {
            Self::Scalar => 1,
            Self::Narrow => <Narrow as Lanes>::LANES,
            Self::Wide => <Wide as Lanes>::LANES,
            Self::Widest => <Widest as Lanes>::LANES,
        }
    }

    /// Whether plain numbers fit side by side into [`Wide`], and the machine has it.
    pub(crate) fn has_wide() -> bool {
        Self::Wide.lanes() > 1 && (Self::Wide.lanes() == Self::Narrow.lanes() || Self::Wide.is_available())
    }

    #[cfg(target_arch = "x86_64")]
    fn is_available(self) -> bool {
        match self {
            Self::Scalar | Self::Narrow => true,
            Self::Wide => std::arch::is_x86_feature_detected!("avx2"),
            Self::Widest => {
                std::arch::is_x86_feature_detected!("avx512f")
                    && std::arch::is_x86_feature_detected!("avx512vl")
                    && std::arch::is_x86_feature_detected!("avx512dq")
                    && std::arch::is_x86_feature_detected!("avx512bw")
            }
        }
    }
    #[cfg(not(target_arch = "x86_64"))]
    fn is_available(self) -> bool {
        self <= Self::Narrow
    }
}

/// Evaluates an expression with a type name standing for the numbers of an instruction set:
/// `with_lanes!(isa, S => block::<S>(...))`. The expression is compiled for each.
#[macro_export]
macro_rules! with_lanes {
    ($isa:expr, $number:ident => $body:expr) => {
        match $isa {
            $crate::Isa::Scalar => {
                type $number = f64;
                $body
            }
            $crate::Isa::Narrow => {
                type $number = $crate::Narrow;
                $body
            }
            $crate::Isa::Wide => {
                type $number = $crate::Wide;
                $body
            }
            $crate::Isa::Widest => {
                type $number = $crate::Widest;
                $body
            }
        }
    };
}
