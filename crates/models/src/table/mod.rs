//! Bodies on a table: rolling without slipping, or sliding with friction.

mod body;
mod check;
mod form;
mod friction;
mod ground;
mod impact;
mod measure;
mod parameters;
mod regimes;
mod roller;
mod rolling;
mod slider;
mod sliding;
mod top;

pub mod billiard_ball;
pub mod euler_disk;
pub mod rattleback;
pub mod raw_egg;
pub mod rolling_body;
pub mod rounded_top;
pub mod sliding_body;
pub mod sliding_cone;
pub mod spinning_egg;
pub mod tippe_top;
