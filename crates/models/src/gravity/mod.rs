mod kepler;
pub mod n_body;
mod n_body_card;
