//! The measurements measure what they say. No test asks how long anything took.

use precess::integrate::Needs;
use precess_bench::{Effort, Error, Kind, NAMES, Peer, Settings, Table, measure};

/// As little work as there can be.
const TINY: Effort = Effort { rounds: 1, spell: 1e-6, side: 5, steps: 7 };

fn measured(name: &str, peers: &[&str]) -> Result<Vec<Table>, Error> {
    let peers = peers.iter().map(|peer| Peer::parse(peer)).collect::<Result<_, _>>()?;
    measure(name, &Settings::new(TINY, peers)?, &mut |_| {})
}

fn is_choosy(method: &str) -> bool {
    precess::catalogue::method(method).is_ok_and(|method| method.card().needs != Needs::Any)
}

/// That the bits are the same in all registers is checked on the way: a difference would be an error.
#[test]
fn every_measurement_gives_a_table_of_finite_positive_numbers() {
    for name in NAMES {
        for table in measured(name, &[]).expect("measured") {
            assert_eq!(table.name, name);
            assert!(!table.rows.is_empty(), "{name}");
            for row in &table.rows {
                assert_eq!(row.cells.len(), table.columns.len(), "{name}, {}", row.name);
                let empty = row.cells.iter().filter(|cell| cell.is_none()).count();
                // Only methods that need something do not fit every system.
                assert!(empty == 0 || is_choosy(&row.name), "{name}, {}", row.name);
                for x in row.cells.iter().flatten() {
                    assert!(x.is_finite() && *x > 0.0, "{name}, {}: {x}", row.name);
                }
            }
            // Ratios come first.
            let ratios = table.columns.iter().skip_while(|column| column.kind == Kind::Ratio);
            assert!(ratios.clone().count() > 0 && ratios.clone().all(|column| column.kind != Kind::Ratio));
        }
    }
}

#[test]
fn json_names_every_number() {
    for table in measured("systems", &[]).expect("measured") {
        let json = table.json();
        let rows = json["rows"].as_array().expect("rows");
        assert_eq!(rows.len(), table.rows.len());
        assert_eq!(rows[0]["name"], "harmonic_oscillator");
        assert!(rows.iter().all(|row| row["scalar_ns"].as_f64().is_some_and(|ns| ns > 0.0)));
        assert!(json["title"].is_string() && json["notes"].is_array());
    }
}

#[test]
fn an_unknown_name_names_the_nearest() {
    let error = measured("magnet", &[]).expect_err("no such benchmark");
    assert_eq!(error, Error::Wrong("no benchmark 'magnet': did you mean 'magnets'?".into()));
}

#[test]
fn a_peer_without_a_command_is_refused() {
    for text in ["c", "c=", "=c", "c= "] {
        let error = Peer::parse(text).expect_err("no peer");
        assert!(error.to_string().contains("NAME=COMMAND"), "{error}");
    }
}

#[cfg(unix)]
mod peers {
    use super::*;
    use std::os::unix::fs::PermissionsExt;

    /// A shell script that is gone afterwards.
    struct Script(std::path::PathBuf);
    impl Script {
        fn new(name: &str, lines: &str) -> Self {
            let path = std::env::temp_dir().join(format!("precess-peer-{name}-{}", std::process::id()));
            std::fs::write(&path, format!("#!/bin/sh\n{lines}\n")).expect("a script");
            std::fs::set_permissions(&path, std::fs::Permissions::from_mode(0o700)).expect("permissions");
            Self(path)
        }
        fn peer(&self, name: &str) -> String {
            format!("{name}=sh {}", self.0.display())
        }
    }
    impl Drop for Script {
        fn drop(&mut self) {
            let _ = std::fs::remove_file(&self.0);
        }
    }

    const LINE: &str =
        r#"printf '{"peer": "zero", "seconds": 2e-6, "points": %d, "steps": %d}\n' $(($1*$1)) $2"#;

    /// It says that every mass has stayed in the middle.
    #[test]
    fn a_peer_is_raced_and_its_positions_are_held_against_ours() {
        let zero = Script::new("zero", &format!("head -c $(($1*$1*16)) /dev/zero > $3\n{LINE}"));
        let tables = measured("magnets", &[&zero.peer("zero"), &zero.peer("zero-again")]).expect("measured");
        let [_, peers] = &tables[..] else { panic!("{tables:?}") };
        let row = &peers.json()["rows"][0];
        assert_eq!(row["name"], "zero");
        let ns = row["ns"].as_f64().expect("a time");
        assert!((ns - 2e3 / (25.0 * 7.0)).abs() < 1e-9, "{ns}");
        assert!(row["scalar_ratio"].as_f64().is_some_and(|ratio| ratio > 0.0 && ratio.is_finite()));
        // Ours are still near the corners they started from.
        let distance = row["distance"].as_f64().expect("a distance");
        assert!((distance - 8_f64.sqrt()).abs() < 1e-3, "{distance}");
        assert!(
            peers.notes[0].contains("25 of 25 points where zero and zero-again agree"),
            "{:?}",
            peers.notes
        );
    }

    #[test]
    fn a_broken_peer_gives_a_sentence() {
        let nothing = Script::new("nothing", "true");
        let fails = Script::new("fails", "echo out of magnets >&2; exit 3");
        let other = Script::new("other", r#"echo '{"seconds": 1, "points": 4, "steps": 7}'"#);
        let silent = Script::new("silent", LINE);
        for (script, words) in [
            (nothing.peer("p"), "25 points and 7 steps"),
            (fails.peer("p"), "exit status: 3): out of magnets"),
            (other.peer("p"), "25 points and 7 steps"),
            (silent.peer("p"), "left 0 positions"),
            ("p=/no/such/program".into(), "cannot be run: no such file"),
        ] {
            let error = measured("magnets", &[&script]).expect_err("a broken peer");
            assert!(matches!(error, Error::Wrong(_)), "{error}");
            let sentence = error.to_string();
            assert!(
                sentence.starts_with("peer 'p': ") && sentence.to_lowercase().contains(words),
                "{sentence}"
            );
        }
    }
}
