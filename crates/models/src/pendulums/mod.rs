pub mod double_pendulum;
pub mod magnetic_pendulum;
pub mod noria;
mod noria_card;
pub mod pendulum;
