//! The mechanical systems of Precess, one file each, and the list of them.

mod attitude;
mod gravity;
mod inertia;
mod oscillators;
mod pendulums;
mod rotation;
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
    &tops::gyroscope_rolling::GyroscopeRolling,
    &tops::symmetric_body::SymmetricBody,
    &tops::heavy_top::HeavyTop,
    &tops::tippe_top_rolling::TippeTopRolling,
    &tops::free_body::FreeBody,
];
