//! A million asteroids in the terminal: what they take of the memory.
#![cfg(target_os = "linux")]

mod program;

use program::{Folder, peak_of};
use std::process::{Command, Stdio};

/// The most memory that a run of so many asteroids has had, in bytes. Two samples are recorded.
fn peak(asteroids: u32, more: &[&str]) -> u64 {
    let rings = format!("rings=[[{asteroids}; 1000; 20; 1.2]]");
    let mut command = Command::new(env!("CARGO_BIN_EXE_precess"));
    command.args(["run", "cluster", "-p", &rings, "--method", "verlet", "--dt", "0.1", "--until", "0.2"]);
    command.args(["--every", "0.2", "--quiet"]).args(more).stdout(Stdio::null());
    peak_of(command.spawn().expect("the program starts"))
}

/// Below 100 bytes an asteroid beyond the numbers that are recorded, of which a sample has four: names, units and texts are made
/// when they are written, and not kept.
#[test]
fn an_asteroid_takes_less_than_a_hundred_bytes_beyond_its_samples() {
    let folder = Folder::new("swarm");
    let (few, many) = (50_000, 250_000);
    let recorded = 2 * 4 * 8;
    let (csv, toml) = (folder.file("rings.csv"), folder.file("rings.toml"));
    for more in [&["--hash"][..], &["-o", &csv], &["--save", &toml]] {
        let grown = peak(many, more).saturating_sub(peak(few, more)) as f64;
        let each = grown / f64::from(many - few) - f64::from(recorded);
        println!("{more:?}: {each:.0} bytes an asteroid");
        assert!(each < 100.0, "{more:?}: {each} bytes an asteroid");
    }
}
