//! The program, started as a user starts it, and what it left behind.
#![allow(dead_code, reason = "each test uses its own share")]

use std::path::PathBuf;
use std::process::{Child, Command, Output};

pub fn precess(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_precess")).args(arguments).output().expect("the program starts")
}

pub fn out(output: &Output) -> String {
    String::from_utf8_lossy(&output.stdout).into_owned()
}

pub fn err(output: &Output) -> String {
    String::from_utf8_lossy(&output.stderr).into_owned()
}

/// The most memory that a program has had when it has ended well, in bytes (as Linux tells it).
pub fn peak_of(mut child: Child) -> u64 {
    let status = format!("/proc/{}/status", child.id());
    let mut most = 0;
    let end = loop {
        // It only grows, and is gone with the program.
        let text = std::fs::read_to_string(&status).unwrap_or_default();
        let line = text.lines().find_map(|line| line.strip_prefix("VmHWM:"));
        if let Some(kilobytes) = line.and_then(|l| l.trim().strip_suffix(" kB")?.parse::<u64>().ok()) {
            most = 1000 * kilobytes;
        }
        if let Some(end) = child.try_wait().expect("a child") {
            break end;
        }
        std::thread::yield_now();
    };
    assert!(end.success() && most > 0, "{end} {most}");
    most
}

/// What is wrong is told in one sentence with this word in it, and nothing else.
pub fn refused(arguments: &[&str], word: &str) {
    let output = precess(arguments);
    let message = err(&output);
    assert_eq!(output.status.code(), Some(2), "{arguments:?}: {message}");
    assert!(message.starts_with("precess: ") && message.contains(word), "{arguments:?}: {message}");
    assert_eq!(message.lines().count(), 1, "{message}");
    assert_eq!(out(&output), "", "{arguments:?}");
}

/// A folder of the test's own that is gone afterwards.
pub struct Folder(pub PathBuf);

impl Folder {
    pub fn new(name: &str) -> Self {
        let folder = std::env::temp_dir().join(format!("precess-{name}-{}", std::process::id()));
        let _ = std::fs::remove_dir_all(&folder);
        std::fs::create_dir_all(&folder).expect("a folder for the test");
        Self(folder)
    }
    pub fn file(&self, name: &str) -> String {
        self.0.join(name).to_string_lossy().into_owned()
    }
    pub fn names(&self) -> Vec<String> {
        let entries = std::fs::read_dir(&self.0).expect("the folder is there");
        let mut names: Vec<_> =
            entries.filter_map(|e| Some(e.ok()?.file_name().to_string_lossy().into_owned())).collect();
        names.sort_unstable();
        names
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = std::fs::remove_dir_all(&self.0);
    }
}

/// Rows of numbers under a header.
pub fn rows(csv: &str) -> Vec<Vec<f64>> {
    csv.lines().skip(1).map(|l| l.split(',').map(|x| x.parse().expect("a number")).collect()).collect()
}
