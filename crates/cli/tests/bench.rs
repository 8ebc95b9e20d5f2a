//! `precess bench`: one thing by name, its peers, its lanes.

mod program;

use program::{err, out, precess, refused};
use std::process::Command;

#[test]
fn bench_measures_one_thing_by_name() {
    let run = precess(&["bench", "limits", "--json"]);
    assert!(run.status.success(), "{}", err(&run));
    assert_eq!(err(&run), "");
    let report: serde_json::Value = serde_json::from_str(&out(&run)).expect("JSON");
    let table = &report["benchmarks"][0];
    assert_eq!(table["name"], "limits");
    assert_eq!(table["rows"][0]["name"], "scalar");
    assert!(table["rows"][0]["divide_rate"].as_f64().is_some_and(|rate| rate > 0.0));
    let text = out(&precess(&["bench", "limits"]));
    assert!(text.starts_with("limits: ") && text.contains("multiply, add"), "{text}");
}

#[test]
fn bench_says_what_is_wrong() {
    let cases: [(&[&str], &str); 4] = [
        (&["bench", "limit"], "did you mean 'limits'?"),
        (&["bench", "limits", "--peer", "c=true"], "peers do the magnets"),
        (&["bench", "magnets", "--peer", "c"], "NAME=COMMAND"),
        (&["bench", "magnets", "--peer", "c=/no/such/program"], "cannot be run: no such file or directory"),
    ];
    for (arguments, words) in cases {
        refused(arguments, words);
    }
}

#[test]
fn bench_measures_the_lanes_that_the_environment_names() {
    let with = |lanes: &str| {
        let mut command = Command::new(env!("CARGO_BIN_EXE_precess"));
        command.args(["bench", "limits", "--json"]).env("PRECESS_LANES", lanes);
        command.output().expect("the program starts")
    };
    let report: serde_json::Value = serde_json::from_str(&out(&with("scalar"))).expect("JSON");
    assert_eq!(report["machine"]["lanes"], serde_json::json!(["scalar"]));
    let refused = with("mmx");
    assert_eq!(refused.status.code(), Some(2), "{}", err(&refused));
    assert!(err(&refused).contains("it has scalar"), "{}", err(&refused));
}
