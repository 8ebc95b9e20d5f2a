pub mod free_body;
pub mod gyroscope;
pub mod tippe_top_rolling;
