//! The card's views as panels.

use crate::panel::starred;
use crate::plan::PanelPlan;
use crate::scenario::FigureSpec;
use precess_system::{Quantity, View};

/// More paths than this cannot be told apart.
const MOST_PATHS: usize = 16;

/// The panel of a view. A law holds the names in every view against the card; a name that is none draws nothing.
pub(super) fn panel(columns: &[Quantity], view: &View) -> PanelPlan {
    let known = |name: &str| columns.iter().any(|q| q.name == name);
    let mut spec = FigureSpec::default();
    match view {
        View::Time(names) => {
            spec.y = names.iter().filter(|name| known(name)).map(ToString::to_string).collect();
        }
        View::Plane { pairs, equal_scales } => {
            spec.equal_scales = *equal_scales;
            spec.starts = true;
            let pairs = expand(columns, pairs).into_iter().filter(|(x, y)| known(x) && known(y));
            (spec.x, spec.y) = pairs.take(MOST_PATHS).unzip();
        }
    }
    PanelPlan { spec, x_range: None, y_range: None, between: None, at: vec![], marks: vec![] }
}

/// The pair (`x*`, `y*`) stands for (`x0`, `y0`), (`x1`, `y1`), ... as far as there are such coordinates.
fn expand(columns: &[Quantity], pairs: &[(String, String)]) -> Vec<(String, String)> {
    let mut all = vec![];
    for (x, y) in pairs {
        if x.contains('*') {
            all.extend(starred(columns, x).into_iter().zip(starred(columns, y)));
        } else {
            all.push((x.clone(), y.clone()));
        }
    }
    all
}
