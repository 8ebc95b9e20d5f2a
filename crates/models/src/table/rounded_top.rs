//! A top with a rounded tip, that slips and rises (T, section 6.5).
//!
//! The cone of `sliding_cone` with its tip made round by a ball: now the contact lies off the axis, friction slows the spin
//! and turns the axis up. Jellett's quantity -L.r is constant under any friction.

use super::form::Form;
use super::slider::Slider;
use super::sliding_cone;
use super::top::Top;
use precess_system::{Card, Parameter, card};

/// See the module.
pub const ROUNDED_TOP: Slider = Slider(&Top {
    form: Form::Tip,
    card: text,
    parameters,
    angles: [0.0, 0.3, 0.0],
    omega: [0.0, 0.692, 600.0],
    speed: 0.0,
    run: sliding_cone::run,
});

fn text() -> Card {
    card("rounded_top", "Rounded top", "Toupie à pointe ronde").about(
        "A top with a rounded tip. Its contact lies beside the axis, so friction slows the spin a little and sets the axis upright, until the top sleeps.",
        "Une toupie à pointe arrondie. Le contact est à côté de l'axe : le frottement freine un peu la rotation et redresse l'axe, jusqu'à ce que la toupie dorme.",
    ).source("T, section 6.5; Kelvin's rise of tops: H. Crabtree, Spinning tops and gyroscopic motion (1909)")
}

fn parameters() -> Vec<Parameter> {
    sliding_cone::parameters(0.005)
}
