//! Bodies on a table: rolling without slipping, or sliding with friction.

mod body;
mod form;
mod friction;
mod ground;
mod on_table;
mod rolling;
mod sliding;

pub mod billiard_ball;
pub mod euler_disk;
pub mod rattleback;
pub mod rolling_body;
pub mod sliding_body;
pub mod spinning_egg;
pub mod tippe_top;
