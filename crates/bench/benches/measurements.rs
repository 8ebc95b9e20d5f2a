//! `cargo bench -p precess-bench --bench measurements [-- NAME]... [-- --long]`: what `precess bench` does, in a program
//! without drawing and command line, which is built in a few seconds.

use precess_bench::{Effort, Error, NAMES, Settings, measure};

fn main() -> Result<(), Error> {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let effort = if words.iter().any(|word| word == "--long") { Effort::LONG } else { Effort::QUICK };
    // Cargo adds --bench.
    let mut names: Vec<&str> =
        words.iter().map(String::as_str).filter(|word| !word.starts_with("--")).collect();
    if names.is_empty() {
        names = NAMES.to_vec();
    }
    let settings = Settings::new(effort, vec![])?;
    for name in names {
        for table in measure(name, &settings, &mut |_| {})? {
            println!("{table}");
        }
    }
    Ok(())
}
