//! A step of rk4 for each system that runs in lanes.

use crate::{Error, Settings, Table, lanes};
use precess::{Plan, Scenario, catalogue};

/// Every system without events.
pub fn measure(settings: &Settings, progress: &mut dyn FnMut(&str)) -> Result<Vec<Table>, Error> {
    let title = "a trajectory's step of rk4, ratio to plain numbers";
    let mut table = Table::of_lanes("systems", title, &settings.isas);
    let mut left_out = vec![];
    for system in catalogue::systems() {
        let id = system.card().id;
        let plan = Plan::new(&Scenario { method: Some("rk4".into()), ..Scenario::of(id) })?;
        if !plan.layout.events.is_empty() {
            left_out.push(id);
            continue;
        }
        progress(&format!("systems: {id}"));
        table.row_of_lanes(id, &lanes::nanoseconds(&plan, &settings.isas, settings)?);
    }
    table.note_least_gain(&settings.isas);
    if !left_out.is_empty() {
        table.notes.push(format!("Without lanes, since their events differ: {}.", left_out.join(", ")));
    }
    table.notes.push("Every set of registers gives the same bits.".into());
    Ok(vec![table])
}
