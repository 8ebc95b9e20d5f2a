//! What the methods that solve a step by a loop have in common.

use crate::OptionCard;

/// A fixed point that converges at all is there long before.
pub(super) const MOST_ITERATIONS: u32 = 200;

/// The option that ends the loop.
pub(super) const EPSILON: OptionCard = OptionCard {
    name: "epsilon",
    default: 1e-12,
    low: 1e-15,
    high: 1.0,
    text: ("where the loop ends, relative to the state", "fin de la boucle, relative à l'état"),
};
