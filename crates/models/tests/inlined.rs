//! What the lanes need of a model's source: everything that computes with a generic number is `#[inline(always)]`.
//!
//! What is not inlined into the place where a register's instructions are switched on is compiled without them, and
//! each addition becomes a call (see `Kernel` in `precess-scalar`). Nothing but the speed would tell.

use std::path::{Path, PathBuf};

fn sources(folder: &Path) -> Vec<PathBuf> {
    let entries =
        std::fs::read_dir(folder).expect("the folder is there").map(|e| e.expect("an entry").path());
    let files = entries.flat_map(|path| if path.is_dir() { sources(&path) } else { vec![path] });
    files.filter(|path| path.extension().is_some_and(|e| e == "rs")).collect()
}

/// The lines that begin a generic function that may stay a call.
fn calls(source: &str) -> Vec<String> {
    let lines: Vec<&str> = source.lines().collect();
    let generic =
        |line: &str| line.contains("fn ") && line.contains(": Scalar") && !line.trim().starts_with("//");
    let inlined = |k: usize| {
        let above = lines[..k].iter().rev().take_while(|line| line.trim_start().starts_with("#["));
        above.into_iter().any(|line| line.contains("inline(always)"))
    };
    let found = (0..lines.len()).filter(|&k| generic(lines[k]) && !inlined(k));
    found.map(|k| lines[k].trim().to_string()).collect()
}

#[test]
fn generic_functions_of_models_are_inlined() {
    let files = sources(&Path::new(env!("CARGO_MANIFEST_DIR")).join("src"));
    assert!(files.len() > 10);
    for file in files {
        let source = std::fs::read_to_string(&file).expect("a source file");
        assert_eq!(calls(&source), [""; 0], "in {}: add #[inline(always)]", file.display());
    }
}

#[test]
fn a_function_that_is_not_inlined_is_seen() {
    let source = "#[inline(always)]\nfn a<S: Scalar>(x: S) -> S {}\n\nfn b<S: Scalar>(x: S) -> S {}\n";
    assert_eq!(calls(source), ["fn b<S: Scalar>(x: S) -> S {}"]);
}
