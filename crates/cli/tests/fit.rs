//! `precess fit` and `precess sensitivity` as a person types them.

mod program;

use program::{Folder, err, out, precess, refused};

#[test]
fn a_fit_finds_what_a_run_was_made_with() {
    let folder = Folder::new("fit");
    let (data, fitted, gap) = (folder.file("swing.csv"), folder.file("fitted.toml"), folder.file("gap.csv"));
    let (data, fitted, gap) = (data.as_str(), fitted.as_str(), gap.as_str());
    let made = precess(&[
        "run",
        "pendulum",
        "-i",
        "theta=0.6",
        "-p",
        "l=0.8",
        "--until",
        "4",
        "--every",
        "0.1",
        "-o",
        data,
    ]);
    assert!(made.status.success(), "{}", err(&made));
    let found = precess(&[
        "fit",
        "pendulum",
        "--data",
        data,
        "--columns",
        "theta",
        "--free",
        "theta,l",
        "--save",
        fitted,
    ]);
    assert!(found.status.success(), "{}", err(&found));
    let table = out(&found);
    let values: Vec<f64> =
        table.lines().skip(1).filter_map(|line| line.split(',').nth(1)?.parse().ok()).collect();
    assert!((values[0] - 0.6).abs() < 1e-7 && (values[1] - 0.8).abs() < 1e-7, "{table}");
    assert!(err(&found).contains("l = 0.8"), "{}", err(&found));
    let again = precess(&["run", fitted, "--until", "1", "--every", "1", "-q", "-o", "-"]);
    assert!(again.status.success(), "{}", err(&again));

    std::fs::write(gap, "t,theta\n0,1\n1,\n").expect("a file");
    for (arguments, sentence) in [
        (vec!["--data", gap, "--free", "l"], "line 3: theta is no number"),
        (vec!["--data", data, "--columns", "thet", "--free", "l"], "did you mean 'theta'"),
        (vec!["--data", data, "--columns", "theta", "--free", "m"], "the data do not determine m"),
        (vec!["--data", "nowhere.csv", "--free", "l"], "cannot read 'nowhere.csv'"),
        (vec!["--data", data, "--free", "l", "--columns", "theta", "--uncertainty", "phi=1"], "'phi'"),
    ] {
        refused(&[&["fit", "pendulum"], arguments.as_slice()].concat(), sentence);
    }
}

#[test]
fn a_sensitivity_is_a_table_of_derivatives() {
    let found = precess(&[
        "sensitivity",
        "harmonic_oscillator",
        "--along",
        "x,omega",
        "--until",
        "1",
        "--every",
        "0.5",
        "-q",
    ]);
    assert!(found.status.success(), "{}", err(&found));
    let table = out(&found);
    assert!(table.starts_with("t,x,x_dot,"), "{table}");
    assert!(table.contains("dx_dx,dx_dot_dx,") && table.contains("dx_domega,"), "{table}");
    assert_eq!(table.lines().count(), 4);
    refused(&["sensitivity", "noria", "--along", "J"], "needs a motion without jumps");
}
