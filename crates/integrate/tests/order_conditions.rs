//! Every rooted tree at once: the system `y_tree' = product of the y of its branches`, from zero, has the
//! solution `t^nodes / gamma(tree)`, and one step of length 1 gives a Runge-Kutta method's elementary weight of
//! that tree. The order conditions (Butcher; Hairer, Norsett, Wanner, *Solving ODEs I*, II.2) are then equalities
//! between numbers that the stepper itself computed, for the step, the estimate and the dense output alike.

mod toys;

use precess_integrate::{Options, Stepper};
use precess_scalar::{DoubleDouble, Scalar};
use toys::{Bound, Toy, bind, method, stepper, take};

/// A rooted tree: the trees that hang on its root, by number, and what follows from them.
#[derive(Clone)]
struct Tree {
    branches: Vec<usize>,
    nodes: u32,
    gamma: f64,
}

/// All rooted trees with up to `most` nodes, smaller ones first.
fn trees(most: u32) -> Vec<Tree> {
    let mut all = vec![Tree { branches: vec![], nodes: 1, gamma: 1.0 }];
    for nodes in 2..=most {
        let mut found = vec![];
        forests(&all, nodes - 1, all.len(), &mut vec![], &mut found);
        let new: Vec<Tree> = found
            .into_iter()
            .map(|branches| {
                let gamma = branches.iter().fold(f64::from(nodes), |g, b| g * all[*b].gamma);
                Tree { branches, nodes, gamma }
            })
            .collect();
        all.extend(new);
    }
    all
}

/// Multisets of trees with `nodes` nodes in all, as numbers that do not increase.
fn forests(all: &[Tree], nodes: u32, below: usize, taken: &mut Vec<usize>, found: &mut Vec<Vec<usize>>) {
    if nodes == 0 {
        found.push(taken.clone());
        return;
    }
    for tree in 0..below {
        if all[tree].nodes <= nodes {
            taken.push(tree);
            forests(all, nodes - all[tree].nodes, tree + 1, taken, found);
            taken.pop();
        }
    }
}

struct Forest(Vec<Tree>);
impl Toy for Forest {
    fn rate<S: Scalar>(&self, _t: S, y: &[S], dy: &mut [S]) {
        for (tree, dy) in self.0.iter().zip(dy) {
            *dy = tree.branches.iter().fold(S::from(1.0), |product, b| product * y[*b]);
        }
    }
}

fn forest(most: u32) -> (Vec<Tree>, Bound<Forest>) {
    let trees = trees(most);
    let count = trees.len();
    (trees.clone(), bind(Forest(trees), 0, count, 0))
}

/// The largest violation among trees of each size, 1-based.
fn violations(trees: &[Tree], y: &[f64], expected: impl Fn(&Tree) -> f64) -> Vec<f64> {
    let mut worst = vec![0.0_f64; trees.last().map_or(0, |t| t.nodes) as usize + 1];
    for (tree, y) in trees.iter().zip(y) {
        let off = (y - expected(tree)).abs();
        let place = &mut worst[tree.nodes as usize];
        *place = off.larger(*place);
    }
    worst
}

fn one_step(id: &str, field: &Bound<Forest>, count: usize) -> (Box<dyn Stepper<f64>>, Vec<f64>) {
    let mut steps = stepper::<f64>(method(id), field, &Options::default());
    let mut end = vec![0.0; count];
    take(&mut *steps, field, 0.0, &vec![0.0; count], 1.0, &mut end).expect("an explicit step");
    (steps, end)
}

#[test]
fn there_are_as_many_trees_as_cayley_counted() {
    let count = |n| trees(8).iter().filter(|t| t.nodes == n).count();
    assert_eq!((1..=8).map(count).collect::<Vec<_>>(), [1, 1, 2, 4, 9, 20, 48, 115]);
}

#[test]
fn the_step_has_its_order_and_no_more() {
    let (trees, field) = forest(9);
    for (id, order) in [("euler", 1), ("rk4", 4), ("dopri5", 5), ("dop853", 8)] {
        let (_, end) = one_step(id, &field, trees.len());
        let worst = violations(&trees, &end, |t| 1.0 / t.gamma);
        for (nodes, off) in worst.iter().enumerate().skip(1) {
            println!("{id}: {nodes} nodes, off by {off:.1e}");
        }
        assert!(worst[1..=order].iter().all(|off| *off < 1e-14), "{id}");
        assert!(worst[order + 1] > 1e-7, "{id} has a higher order than it says");
    }
}

#[test]
fn the_estimate_is_blind_to_the_lower_order_alone() {
    let (trees, field) = forest(7);
    for (id, blind) in [("dopri5", 4), ("dop853", 5)] {
        let (mut steps, _) = one_step(id, &field, trees.len());
        let mut worst = [0.0_f64; 8];
        for (k, tree) in trees.iter().enumerate() {
            let mut weights = vec![0.0; trees.len()];
            weights[k] = 1.0;
            let place = &mut worst[tree.nodes as usize];
            *place = steps.error(1.0, &weights).larger(*place);
        }
        assert!(worst[1..=blind].iter().all(|e| *e < 1e-14), "{id}: {worst:?}");
        assert!(worst[blind + 1] > 1e-6, "{id}: {worst:?}");
    }
}

#[test]
fn dense_output_has_its_order_all_along_the_step() {
    let (trees, field) = forest(8);
    for (id, order) in [("dopri5", 4), ("dop853", 7)] {
        let (mut steps, end) = one_step(id, &field, trees.len());
        let start = vec![0.0; trees.len()];
        let dense = steps.dense(&field, 0.0, &start, 1.0, &end);
        let mut worst = vec![0.0_f64; 9];
        for k in 0..=16 {
            let theta = f64::from(k) / 16.0;
            let mut y = start.clone();
            dense.at(theta, &mut y);
            let power = |t: &Tree| (0..t.nodes).fold(1.0, |power, _| power * theta) / t.gamma;
            for (place, off) in worst.iter_mut().zip(violations(&trees, &y, power)) {
                *place = off.larger(*place);
            }
        }
        println!("{id}: {worst:?}");
        assert!(worst[1..=order].iter().all(|off| *off < 2e-13), "{id}: {worst:?}");
        assert!(worst[order + 1] > 1e-7, "{id}: {worst:?}");
    }
}

#[test]
fn twice_the_digits_reach_the_coefficients() {
    let (trees, field) = forest(8);
    for (id, order) in [("dopri5", 5), ("dop853", 8)] {
        let mut steps = stepper::<DoubleDouble>(method(id), &field, &Options::default());
        let zeros = vec![DoubleDouble::from(0.0); trees.len()];
        let mut end = zeros.clone();
        take(&mut *steps, &field, zeros[0], &zeros, DoubleDouble::from(1.0), &mut end)
            .expect("an explicit step");
        let mut worst = 0.0;
        for (tree, y) in trees.iter().zip(&end).filter(|(t, _)| t.nodes <= order) {
            worst = (*y * tree.gamma - 1.0).abs().to_f64().larger(worst);
        }
        println!("{id}: {worst:.1e}");
        assert!(worst < 1e-26, "{id}: {worst:e}");
    }
}
