//! The members of a scenario's families, each a plan of its own.

use crate::error::{Error, input};
use crate::figure::Stroke;
use crate::plan::Plan;
use crate::scenario::{FamilySpec, Scenario};

/// A trajectory that is drawn beside the run.
#[derive(Clone)]
pub struct FamilyMember {
    /// What panels call its family by.
    pub family: String,
    /// Its name in legends; may be empty.
    pub label: String,
    /// What it runs.
    pub plan: Plan,
    /// Also backwards in time.
    pub both_ways: bool,
    /// How it is drawn.
    pub style: Option<Stroke>,
    /// The quantity of its own that is drawn where a panel asks for one of the run's.
    pub names: Vec<(String, String)>,
}

/// More trajectories than this make no picture.
const MOST: usize = 1000;

/// All members of all families.
pub(crate) fn members(scenario: &Scenario) -> Result<Vec<FamilyMember>, Error> {
    let mut members = vec![];
    for family in &scenario.families {
        let at = |e: Error| e.at("[[family]]");
        for (label, own) in family.members(scenario).map_err(at)? {
            if members.len() == MOST {
                return input(format!("more than {MOST} trajectories in all families make no picture"));
            }
            members.push(member(family, label, &own).map_err(at)?);
        }
    }
    Ok(members)
}

fn member(family: &FamilySpec, label: String, own: &Scenario) -> Result<FamilyMember, Error> {
    if label.contains(['{', '}']) {
        return input(format!("label: there is no value for the braces in {label:?}"));
    }
    let plan = Plan::new(own)?;
    for (_, name) in &family.names {
        crate::resolve::column(&plan, name).map_err(|e| e.at("names"))?;
    }
    Ok(FamilyMember {
        family: family.name.clone(),
        label,
        plan,
        both_ways: family.both_ways,
        style: family.style,
        names: family.names.clone(),
    })
}
