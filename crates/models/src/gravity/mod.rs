pub mod cluster;
mod cluster_card;
mod kepler;
pub mod n_body;
mod n_body_card;
