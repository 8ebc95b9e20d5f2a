//! `precess ensemble` in the terminal: its table, its checkpoint, and what it refuses.

mod program;

use program::{Folder, err, out, peak_of, precess, refused, rows};
use std::process::{Child, Command, Stdio};

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

const MANY_SWINGS: &str = "precess = 1\n[system]\nid = \"pendulum\"\n\
    [run]\nmethod = \"tsit5\"\nrtol = 1e-9\natol = 1e-9\nuntil = 10\nevery = 10\n\
    [ensemble]\nrandom = { theta = \"-3:3\", theta_dot = \"-1:1\" }\nmembers = 20000\nseed = 7\n";

/// Starts an ensemble that prints its hash.
fn begun(file: &str, more: &[&str]) -> Child {
    let mut command = Command::new(env!("CARGO_BIN_EXE_precess"));
    command.args(["ensemble", file, "--hash", "--quiet"]).args(more);
    command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().expect("the program starts")
}

/// Bytes in a folder.
fn bytes(folder: &Folder) -> u64 {
    let entries = std::fs::read_dir(&folder.0).expect("the folder is there");
    entries.filter_map(|e| Some(e.ok()?.metadata().ok()?.len())).sum()
}

/// Killed when so many bytes have been written, whatever they are (the head of the checkpoint, a record, the table), and begun
/// again: what comes out in the end has the bytes of what was never killed.
#[test]
fn what_is_killed_ten_times_ends_with_the_same_bytes() {
    let (quiet, killed) = (Folder::new("unkilled"), Folder::new("killed"));
    for folder in [&quiet, &killed] {
        std::fs::write(folder.file("many.toml"), MANY_SWINGS).expect("written");
    }
    let csv = quiet.file("many.csv");
    let undisturbed = begun(&quiet.file("many.toml"), &["-o", &csv]).wait_with_output().expect("an end");
    assert!(undisturbed.status.success(), "{}", err(&undisturbed));
    let table = std::fs::read(&csv).expect("a table");

    let (file, csv) = (killed.file("many.toml"), killed.file("many.csv"));
    // Knuth's generator of 64 bits; the upper half is taken.
    let mut state = 5_u64;
    let mut random = |below: u64| {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        ((state >> 32) * below) >> 32
    };
    let (mut kills, mut resumed) = (0, 0);
    while kills < 10 {
        let before = bytes(&killed);
        resumed += u32::from(killed.names().contains(&"many.csv.checkpoint".to_string()));
        let enough = before + random(table.len() as u64 / 4);
        let mut child = begun(&file, &["-o", &csv]);
        let mut ended = None;
        while ended.is_none() && bytes(&killed) < enough {
            ended = child.try_wait().expect("a child");
            std::thread::yield_now();
        }
        match ended {
            None => {
                child.kill().expect("killed");
                let status = child.wait().expect("an end");
                kills += u32::from(!status.success());
            }
            // It was through before it had written so much: from the beginning.
            Some(_) => std::fs::remove_file(&csv).expect("a table"),
        }
    }
    assert!(resumed > 3, "{resumed}");
    let last = begun(&file, &["-o", &csv]).wait_with_output().expect("an end");
    assert!(last.status.success(), "{}", err(&last));
    assert_eq!(out(&last), out(&undisturbed));
    assert!(std::fs::read(&csv).expect("a table") == table, "the tables differ");
    assert!(!killed.names().contains(&"many.csv.checkpoint".to_string()), "{:?}", killed.names());
}

/// The most memory that an ensemble of so many closed forms has had, in bytes.
#[cfg(target_os = "linux")]
fn peak(folder: &Folder, members: u32, more: &[&str]) -> u64 {
    let text = format!(
        "precess = 1\n[system]\nid = \"harmonic_oscillator\"\n[run]\nmethod = \"exact\"\nuntil = 1\nevery = 1\n\
         [ensemble]\nrandom = {{ x = \"-1:1\" }}\nmembers = {members}\nseed = 1\n"
    );
    let file = folder.file("flat.toml");
    std::fs::write(&file, text).expect("written");
    peak_of(begun(&file, more))
}

/// A table of a million rows is 32 MB; of these not a quarter may lie in memory, wherever the rows go.
#[cfg(target_os = "linux")]
#[test]
fn memory_does_not_grow_with_the_members() {
    let folder = Folder::new("flat");
    let npz = folder.file("flat.npz");
    for more in [&["-o", &npz][..], &[]] {
        let few = peak(&folder, 10_000, more);
        let many = peak(&folder, 1_000_000, more);
        println!("{more:?}: {few} and {many}");
        assert!(many < few + 8_000_000, "{more:?}: {few} and {many}");
    }
}
