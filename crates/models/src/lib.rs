//! The mechanical systems of Precess, one file each, and the list of them.

mod attitude;
pub mod bodies;
mod complex;
mod gravity;
mod inertia;
mod linear;
mod oscillators;
mod pendulums;
mod rotation;
mod table;
mod tops;
mod waterwheels;

use precess_system::AnySystem;

/// What the lab shows first: a core with nothing else loads fast.
pub static FIRST: &[&dyn AnySystem] = &[&tops::gyroscope::Gyroscope];

/// Every system, in the order in which a catalogue shows them.
///
/// A static, not a constant: every crate that uses a constant would compile all systems once more.
pub static ALL: &[&dyn AnySystem] = &[
    &oscillators::harmonic_oscillator::HarmonicOscillator,
    &oscillators::spring::Spring,
    &oscillators::planar_oscillator::PlanarOscillator,
    &oscillators::potential_well::PotentialWell,
    &oscillators::cubic_well::CubicWell,
    &oscillators::bead_on_curve::BeadOnCurve,
    &oscillators::van_der_pol::VanDerPol,
    &oscillators::parametric_oscillator::ParametricOscillator,
    &oscillators::driven_oscillator::DrivenOscillator,
    &oscillators::car_suspension::CarSuspension,
    &oscillators::duffing::Duffing,
    &oscillators::henon_heiles::HenonHeiles,
    &pendulums::pendulum::Pendulum,
    &pendulums::kapitza_pendulum::KapitzaPendulum,
    &pendulums::wheel_pendulum::WheelPendulum,
    &pendulums::driven_pendulum::DrivenPendulum,
    &pendulums::elastic_pendulum::ElasticPendulum,
    &pendulums::spherical_pendulum::SphericalPendulum,
    &pendulums::foucault_pendulum::FoucaultPendulum,
    &pendulums::coupled_pendulums::CoupledPendulums,
    &pendulums::double_pendulum::DoublePendulum,
    &pendulums::n_pendulum::NPendulum,
    &pendulums::swinging_atwood::SwingingAtwood,
    &pendulums::magnetic_pendulum::MagneticPendulum,
    &waterwheels::noria::Noria,
    &waterwheels::malkus_waterwheel::MalkusWaterwheel,
    &waterwheels::lorenz::Lorenz,
    &gravity::n_body::NBody,
    &gravity::cluster::Cluster,
    &tops::gyroscope::Gyroscope,
    &tops::gyroscope_rolling::GyroscopeRolling,
    &tops::gyroscope_integrals::GyroscopeIntegrals,
    &tops::symmetric_body::SymmetricBody,
    &tops::heavy_top::HeavyTop,
    &tops::tippe_top_rolling::TippeTopRolling,
    &tops::rolling_top::RollingTop,
    &tops::free_body::FreeBody,
    &table::rolling_body::ROLLING_BODY,
    &table::rattleback::RATTLEBACK,
    &table::euler_disk::EULER_DISK,
    &table::sliding_body::SLIDING_BODY,
    &table::tippe_top::TIPPE_TOP,
    &table::spinning_egg::SPINNING_EGG,
    &table::raw_egg::RawEgg,
    &table::sliding_cone::SLIDING_CONE,
    &table::rounded_top::ROUNDED_TOP,
    &table::billiard_ball::BILLIARD_BALL,
];
