//! "The same bits" as one number: the SHA-256 of a result.

use precess_system::Trajectory;
use sha2::{Digest, Sha256};
use std::fmt::Write;

fn hex(bytes: impl AsRef<[u8]>) -> String {
    bytes.as_ref().iter().fold(String::new(), |mut text, byte| {
        let _ = write!(text, "{byte:02x}");
        text
    })
}

/// SHA-256 over the columns `t` and state as little-endian f64, row by row, every NaN the canonical one.
pub fn hash(trajectory: &Trajectory) -> String {
    let width = trajectory.state_columns();
    hash_numbers(trajectory.rows().flat_map(|row| row[..width].iter().copied()))
}

/// SHA-256 of numbers as they come: little-endian f64, every NaN the canonical one.
#[derive(Default)]
pub(crate) struct Hasher(Sha256);

impl Hasher {
    pub fn add(&mut self, x: f64) {
        let x = if x.is_nan() { f64::from_bits(0x7ff8_0000_0000_0000) } else { x };
        self.0.update(x.to_le_bytes());
    }
    pub fn hex(self) -> String {
        hex(self.0.finalize())
    }
}

/// SHA-256 of numbers as little-endian f64, every NaN the canonical one.
pub fn hash_numbers(numbers: impl Iterator<Item = f64>) -> String {
    let mut hasher = Hasher::default();
    numbers.for_each(|x| hasher.add(x));
    hasher.hex()
}

/// SHA-256 of a text.
pub fn hash_text(text: &str) -> String {
    hex(Sha256::digest(text.as_bytes()))
}
