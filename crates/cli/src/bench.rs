//! `precess bench`: how fast this program is on this machine.

use crate::args::Bench;
use crate::failure::Failure;
use crate::list;
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressFinish};
use precess_bench::{Effort, NAMES, Peer, Settings, measure};
use serde_json::json;
use std::time::Duration;

/// Measures, and prints each table when it is there.
pub fn bench(arguments: &Bench) -> Result<(), Failure> {
    let names = arguments.name.as_deref().map_or(NAMES.to_vec(), |name| vec![name]);
    if !arguments.peers.is_empty() && !names.contains(&"magnets") {
        return Err(Failure::Wrong("peers do the magnets: --peer goes with 'precess bench magnets'".into()));
    }
    let peers = arguments.peers.iter().map(|peer| Peer::parse(peer)).collect::<Result<_, _>>()?;
    let effort = if arguments.long { Effort::LONG } else { Effort::QUICK };
    let settings = Settings::new(effort, peers)?;

    let target = if arguments.quiet { ProgressDrawTarget::hidden() } else { ProgressDrawTarget::stderr() };
    let spinner = ProgressBar::with_draw_target(None, target).with_finish(ProgressFinish::AndClear);
    // Less often than the default: drawing takes time from what is measured.
    spinner.enable_steady_tick(Duration::from_secs(1));
    let mut tables = vec![];
    for name in names {
        let measured = measure(name, &settings, &mut |what| spinner.set_message(what.to_string()))?;
        for table in &measured {
            if !arguments.json {
                spinner.suspend(|| list::print(&format!("{table}\n")))?;
            }
            tables.push(table.json());
        }
    }
    spinner.finish_and_clear();
    if arguments.json {
        let isas: Vec<&str> = settings.isas.iter().map(|isa| isa.name()).collect();
        let report = json!({
            "version": env!("CARGO_PKG_VERSION"),
            "machine": { "architecture": std::env::consts::ARCH, "lanes": isas },
            "benchmarks": tables,
        });
        list::print(&format!("{report:#}\n"))?;
    }
    Ok(())
}
