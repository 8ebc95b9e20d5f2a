pub mod harmonic_oscillator;
pub mod planar_oscillator;
