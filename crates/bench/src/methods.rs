//! A step of each method, for equations that cost little and for equations that cost more.

use crate::{Column, Error, Kind, Settings, Table, lanes};
use precess::integrate::MethodCard;
use precess::scalar::Isa;
use precess::{Plan, Scenario, Step, catalogue};

/// One function of a sine, and a dozen of them.
const SYSTEMS: [&str; 2] = ["pendulum", "gyroscope"];

/// The plan of a system by a method with steps of fixed length; none where the method does not fit.
fn plan(system: &str, method: &MethodCard) -> Option<Plan> {
    let scenario = Scenario { method: Some(method.id.into()), ..Scenario::of(system) };
    let mut plan = Plan::new(&scenario).ok()?;
    // A step of an adaptive method costs the same whoever has chosen its length.
    plan.step = Step::Fixed(plan.card.defaults.dt);
    Some(plan)
}

/// Every method, in plain numbers and in the widest registers.
pub fn measure(settings: &Settings, progress: &mut dyn FnMut(&str)) -> Result<Vec<Table>, Error> {
    let mut isas = vec![Isa::Scalar, settings.widest()];
    isas.dedup();
    let ratios = SYSTEMS.iter().flat_map(|system| {
        let name = move |isa: &Isa| format!("{system}_{}_ratio", isa.name());
        isas.iter().skip(1).map(move |isa| Column::new(name(isa), *system, Kind::Ratio))
    });
    let times = SYSTEMS.iter().flat_map(|system| {
        let name = move |isa: &Isa| format!("{system}_{}_ns", isa.name());
        let heading = move |isa: &Isa| format!("ns {system} {}", isa.name());
        isas.iter().map(move |isa| Column::new(name(isa), heading(isa), Kind::Number))
    });
    let title = format!("a trajectory's step, {} lanes to plain numbers", settings.widest().name());
    let mut table = Table::new("methods", title, ratios.chain(times).collect());
    for method in catalogue::methods().iter().map(|m| m.card()) {
        progress(&format!("methods: {}", method.id));
        let (mut ratios, mut times) = (vec![], vec![]);
        for system in SYSTEMS {
            let ns =
                plan(system, method).map(|plan| lanes::nanoseconds(&plan, &isas, settings)).transpose()?;
            let at = |k: usize| ns.as_ref().map(|ns| ns[k]);
            ratios.extend((1..isas.len()).map(|k| Some(at(0)? / at(k)?)));
            times.extend((0..isas.len()).map(at));
        }
        table.row(method.id, ratios.into_iter().chain(times));
    }
    table.notes.push("An adaptive method's step is measured without its estimate of the error.".into());
    table.notes.push("Every set of registers gives the same bits.".into());
    Ok(vec![table])
}
