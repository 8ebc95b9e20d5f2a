//! `precess ensemble` in the terminal: its table, its checkpoint, and what it refuses.

mod program;

use program::{Folder, err, out, precess, refused, rows};

#[test]
fn an_ensemble_is_a_table_of_members_and_its_checkpoint_goes_away() {
    let folder = Folder::new("ensemble");
    let (file, csv, npz) = (folder.file("many.toml"), folder.file("many.csv"), folder.file("many.npz"));
    let text = "precess = 1\n[system]\nid = \"pendulum\"\n[run]\nuntil = 1\n\
        [ensemble]\ngrid = { theta = \"-30 deg:30 deg:3\", b = \"0:0.1:2\" }\n";
    std::fs::write(&file, text).expect("written");
    let found = precess(&["ensemble", &file, "-o", &csv, "--hash"]);
    assert!(found.status.success(), "{}", err(&found));
    assert!(err(&found).contains("6 members"), "{}", err(&found));
    let table = std::fs::read_to_string(&csv).expect("a table");
    assert!(table.starts_with("start_theta,start_b,theta,theta_dot,status\n-0.523"), "{table}");
    assert_eq!(rows(&table).len(), 6);
    let again = precess(&["ensemble", &file, "-o", &npz, "--hash", "--quiet"]);
    assert_eq!(out(&found), out(&again));
    let mut archive = npyz::npz::NpzArchive::open(&npz).expect("an archive");
    let theta: Vec<f64> =
        archive.by_name("theta").expect("readable").expect("theta").into_vec().expect("numbers");
    assert_eq!(theta, rows(&table).iter().map(|row| row[2]).collect::<Vec<_>>());
    // Nothing but the three files is left.
    assert_eq!(folder.names(), ["many.csv", "many.npz", "many.toml"]);
}

#[test]
fn an_ensemble_that_makes_no_sense_is_refused_in_a_sentence() {
    let folder = Folder::new("no-ensemble");
    let (file, npz) = (folder.file("many.toml"), folder.file("many.npz"));
    let cases = [
        ("", "[ensemble]"),
        ("[ensemble]\ngrid = { theta = \"0:1:9000\", theta_dot = \"0:1:9000\" }\n", "--yes"),
        ("[ensemble]\ngrid = { theta = \"0:1:x\" }\n", "LOW:HIGH:N"),
        ("[ensemble]\nlist = { g = [1, \"x\"] }\n", "g"),
    ];
    for (text, word) in cases {
        std::fs::write(&file, format!("precess = 1\n[system]\nid = \"pendulum\"\n{text}")).expect("written");
        refused(&["ensemble", &file, "-o", &npz], word);
    }
    std::fs::write(
        &file,
        "precess = 1\n[system]\nid = \"pendulum\"\n[ensemble]\ngrid = { theta = \"0:1:2\" }\n",
    )
    .expect("written");
    std::fs::write(folder.file("many.npz.checkpoint"), "something else").expect("written");
    refused(&["ensemble", &file, "-o", &npz], "no checkpoint");
}
