pub mod lorenz;
pub mod malkus_waterwheel;
pub mod noria;
mod noria_card;
