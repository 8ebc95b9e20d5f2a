//! The mechanical systems of Precess, one file each, and the list of them.

mod attitude;
mod gravity;
mod oscillators;
mod pendulums;
mod rotation;
mod table;
mod tops;

use precess_system::AnySystem;

/// Every system, in the order in which a catalogue shows them.
///
/// A static, not a constant: every crate that uses a constant would compile all systems once more.
pub static ALL: &[&dyn AnySystem] = &[
    &oscillators::harmonic_oscillator::HarmonicOscillator,
    &oscillators::planar_oscillator::PlanarOscillator,
    &pendulums::pendulum::Pendulum,
    &pendulums::double_pendulum::DoublePendulum,
    &pendulums::magnetic_pendulum::MagneticPendulum,
    &pendulums::noria::Noria,
    &gravity::n_body::NBody,
    &tops::gyroscope::Gyroscope,
    &tops::tippe_top_rolling::TippeTopRolling,
    &tops::free_body::FreeBody,
    &table::rolling_body::ROLLING_BODY,
    &table::rattleback::RATTLEBACK,
    &table::euler_disk::EULER_DISK,
    &table::sliding_body::SLIDING_BODY,
    &table::tippe_top::TIPPE_TOP,
    &table::spinning_egg::SPINNING_EGG,
    &table::billiard_ball::BILLIARD_BALL,
];
