//! Another program doing the magnets: a command with the protocol of `benches/peers/README.md`.

use crate::Error;
use serde_json::Value;
use std::path::PathBuf;
use std::process::Command;
use std::sync::atomic::{AtomicUsize, Ordering};

/// Another program.
#[derive(Clone, Debug, PartialEq)]
pub struct Peer {
    /// What it is called in the table.
    pub name: String,
    /// The program and its first arguments.
    command: Vec<String>,
}

/// What it answered.
#[derive(Clone, Debug, Default)]
pub(crate) struct Answer {
    /// How long it integrated.
    pub seconds: f64,
    /// What it calls itself: name, version, form.
    pub title: String,
    /// Final positions, in the order of the starts.
    pub positions: Vec<[f64; 2]>,
}

/// A file that is gone afterwards.
struct Scratch(PathBuf);

impl Scratch {
    fn new() -> Self {
        static COUNT: AtomicUsize = AtomicUsize::new(0);
        let count = COUNT.fetch_add(1, Ordering::Relaxed);
        Self(std::env::temp_dir().join(format!("precess-bench-{}-{count}.f64", std::process::id())))
    }
}
impl Drop for Scratch {
    fn drop(&mut self) {
        // Where the peer has written none there is none.
        let _ = std::fs::remove_file(&self.0);
    }
}

impl Peer {
    /// From `NAME=COMMAND`. The command is split at blanks: no shell reads it.
    ///
    /// # Errors
    /// Where one of them is missing.
    pub fn parse(text: &str) -> Result<Self, Error> {
        let (name, command) = text.split_once('=').unwrap_or_default();
        let command: Vec<String> = command.split_whitespace().map(str::to_string).collect();
        if name.trim().is_empty() || command.is_empty() {
            return Err(Error::Wrong(format!(
                "peer '{text}' is no NAME=COMMAND, such as c=target/peers/exercise_7_5_native"
            )));
        }
        Ok(Self { name: name.trim().into(), command })
    }

    fn wrong<T>(&self, sentence: &str) -> Result<T, Error> {
        Err(Error::Wrong(format!("peer '{}': '{}' {sentence}", self.name, self.command.join(" "))))
    }

    /// Lets it follow side x side starts for so many steps.
    pub(crate) fn run(&self, side: usize, steps: u32) -> Result<Answer, Error> {
        let file = Scratch::new();
        let mut command = Command::new(&self.command[0]);
        command.args(&self.command[1..]).arg(side.to_string()).arg(steps.to_string()).arg(&file.0);
        let output = match command.output() {
            Ok(output) => output,
            Err(error) => return self.wrong(&format!("cannot be run: {}", reason(&error))),
        };
        if !output.status.success() {
            let words = String::from_utf8_lossy(&output.stderr);
            let last = words.lines().last().map_or(String::new(), |line| format!(": {}", line.trim()));
            return self.wrong(&format!("did not succeed ({}){last}", output.status));
        }
        let Some(mut answer) = read(&output.stdout, side * side, steps) else {
            return self.wrong(&format!(
                "did not answer with a line of JSON with its seconds, {} points and {steps} steps",
                side * side
            ));
        };
        answer.positions = pairs(&std::fs::read(&file.0).unwrap_or_default());
        if answer.positions.len() != side * side {
            let found = answer.positions.len();
            return self.wrong(&format!("left {found} positions in its file, not {}", side * side));
        }
        Ok(answer)
    }
}

/// An error of the operating system without its number.
fn reason(error: &std::io::Error) -> String {
    let text = error.to_string().to_lowercase();
    text.split(" (os error").next().unwrap_or(&text).to_string()
}

/// The line of JSON.
fn read(line: &[u8], points: usize, steps: u32) -> Option<Answer> {
    let line: Value = serde_json::from_slice(line).ok()?;
    let seconds = line.get("seconds")?.as_f64().filter(|&s| s > 0.0)?;
    if line.get("points")?.as_u64()? != points as u64 || line.get("steps")?.as_u64()? != u64::from(steps) {
        return None;
    }
    let words: Vec<&str> =
        ["peer", "version", "form"].iter().filter_map(|key| line.get(key)?.as_str()).collect();
    Some(Answer { seconds, title: words.join(", "), positions: vec![] })
}

/// Pairs of little-endian doubles.
fn pairs(bytes: &[u8]) -> Vec<[f64; 2]> {
    let (numbers, _) = bytes.as_chunks::<8>();
    let (pairs, _) = numbers.as_chunks::<2>();
    pairs.iter().map(|pair| pair.map(f64::from_le_bytes)).collect()
}
