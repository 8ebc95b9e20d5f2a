pub mod n_body;
