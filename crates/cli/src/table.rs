//! Trajectories as CSV and NPZ.

use npyz::WriterBuilder;
use npyz::zip::write::FileOptions;
use precess::value::shortest;
use precess::{Plan, scenario_toml, system::Trajectory};
use std::io::{self, Seek, Write};

/// CSV: the names, then a row a sample, each number the shortest text that reads back to the same bits.
pub fn csv(out: &mut impl Write, trajectory: &Trajectory) -> io::Result<()> {
    for (k, column) in trajectory.columns.iter().enumerate() {
        let comma = if k == 0 { "" } else { "," };
        write!(out, "{comma}{}", column.name)?;
    }
    writeln!(out)?;
    for row in trajectory.rows() {
        for (k, x) in row.iter().enumerate() {
            let comma = if k == 0 { "" } else { "," };
            write!(out, "{comma}{}", shortest(*x))?;
        }
        writeln!(out)?;
    }
    Ok(())
}

/// NPZ: one array a column, and the texts `units` (in the order of the columns), `scenario` and `version`.
pub fn npz(out: &mut (impl Write + Seek), plan: &Plan, trajectory: &Trajectory) -> io::Result<()> {
    arrays(out, trajectory, &scenario_toml(plan))
}

/// The same of any table with the scenario that it comes from.
pub fn arrays(out: &mut (impl Write + Seek), trajectory: &Trajectory, scenario: &str) -> io::Result<()> {
    let mut archive = npyz::npz::NpzWriter::new(out);
    for (k, column) in trajectory.columns.iter().enumerate() {
        let mut array = archive
            .array(&column.name, FileOptions::default())?
            .default_dtype()
            .shape(&[trajectory.len() as u64])
            .begin_nd()?;
        array.extend(trajectory.rows().map(|row| row[k]))?;
        array.finish()?;
    }
    let units: Vec<String> = trajectory.columns.iter().map(|c| c.unit).collect();
    for (name, text) in [
        ("units", units.join("\n")),
        ("scenario", scenario.to_string()),
        ("version", env!("CARGO_PKG_VERSION").to_string()),
    ] {
        let bytes = text.as_bytes();
        let mut array = archive
            .array(name, FileOptions::default())?
            .default_dtype()
            .shape(&[bytes.len() as u64])
            .begin_nd()?;
        array.extend(bytes.iter().copied())?;
        array.finish()?;
    }
    Ok(())
}
