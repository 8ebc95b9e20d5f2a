//! Imports point one way: scalar <- system <- {models, integrate} <- analysis <- precess <- bench <- faces; the lab's
//! server stands apart.

use std::collections::BTreeSet;
use std::process::Command;

/// Each crate of ours and those of ours that it may depend on.
const EDGES: [(&str, &[&str]); 11] = [
    ("precess-scalar", &[]),
    ("precess-system", &["precess-scalar"]),
    ("precess-models", &["precess-scalar", "precess-system"]),
    ("precess-integrate", &["precess-scalar", "precess-system"]),
    ("precess-analysis", &["precess-scalar", "precess-system", "precess-integrate"]),
    (
        "precess",
        &["precess-scalar", "precess-system", "precess-models", "precess-integrate", "precess-analysis"],
    ),
    ("precess-bench", &["precess"]),
    ("precess-lab", &[]),
    ("precess-cli", &["precess", "precess-bench", "precess-lab"]),
    ("precess-wasm", &["precess"]),
    ("precess-python", &["precess"]),
];

/// The lines of `cargo tree` at depth one: what a crate depends on.
fn dependencies(package: &str) -> Vec<String> {
    let cargo = std::env::var("CARGO").unwrap_or_else(|_| "cargo".into());
    let output = Command::new(cargo)
        .args([
            "tree",
            "--offline",
            "--package",
            package,
            "--depth",
            "1",
            "--prefix",
            "none",
            "--edges",
            "normal,build,dev",
            "--all-features",
        ])
        .current_dir(env!("CARGO_MANIFEST_DIR"))
        .output()
        .expect("cargo runs");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    // A crate may be there twice: once more for the tests, with other features.
    let found: BTreeSet<_> = text.lines().skip(1).filter_map(|line| line.split(' ').next()).collect();
    found.into_iter().map(str::to_string).collect()
}

/// The first edge that is not allowed.
fn forbidden(package: &str, found: &[String], allowed: &[&str]) -> Option<String> {
    let ours = found.iter().filter(|name| name.starts_with("precess"));
    let wrong = ours.into_iter().find(|name| *name != package && !allowed.contains(&name.as_str()));
    wrong.map(|name| format!("{package} depends on {name}"))
}

#[test]
fn imports_point_one_way() {
    for (package, allowed) in EDGES {
        let found = dependencies(package);
        assert_eq!(forbidden(package, &found, allowed), None);
        assert_eq!(
            found.iter().filter(|n| allowed.contains(&n.as_str())).count(),
            allowed.len(),
            "{package}"
        );
    }
}

#[test]
fn a_forbidden_edge_is_noticed() {
    let found = ["precess-scalar".to_string(), "precess-integrate".to_string()];
    assert!(forbidden("precess-models", &found, EDGES[2].1).is_some());
}
