pub mod double_pendulum;
pub mod magnetic_pendulum;
pub mod noria;
pub mod pendulum;
