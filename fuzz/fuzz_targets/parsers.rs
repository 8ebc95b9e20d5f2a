#![no_main]

#[path = "../../crates/precess/tests/parsers/fuzz_body.rs"]
mod fuzz_body;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| fuzz_body::parsers(bytes));
