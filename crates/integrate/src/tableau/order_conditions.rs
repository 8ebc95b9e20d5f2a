//! The order conditions of a tableau, one for every rooted tree (Butcher 1963; Hairer, Norsett, Wanner, II.2).

use super::{Row, Tableau};
use crate::methods::{DOP853, DOPRI5};

/// A rooted tree: the subtrees above its root.
#[derive(Clone, Debug, PartialEq, PartialOrd)]
struct Tree(Vec<Tree>);

impl Tree {
    fn size(&self) -> u32 {
        1 + self.0.iter().map(Tree::size).sum::<u32>()
    }
    /// The density: the exact weight is one over it.
    fn density(&self) -> f64 {
        f64::from(self.size()) * self.0.iter().map(Tree::density).product::<f64>()
    }
    /// The elementary weight of every stage.
    fn weights(&self, rows: &[Row]) -> Vec<f64> {
        let children: Vec<Vec<f64>> = self.0.iter().map(|child| child.weights(rows)).collect();
        let stage = |row: &Row| children.iter().map(|w| sum(row, w)).product();
        rows.iter().map(stage).collect()
    }
}

fn sum(row: Row, weights: &[f64]) -> f64 {
    row.iter().map(|&(j, a)| a * weights[j]).sum()
}

/// All trees up to a size: a leaf grafted onto every node of the smaller ones, each kept once.
fn trees(largest: u32) -> Vec<Tree> {
    fn grafted(tree: &Tree) -> Vec<Tree> {
        let mut all = vec![];
        let mut children = tree.0.clone();
        children.push(Tree(vec![]));
        all.push(Tree(children));
        for k in 0..tree.0.len() {
            for child in grafted(&tree.0[k]) {
                let mut children = tree.0.clone();
                children[k] = child;
                all.push(Tree(children));
            }
        }
        for tree in &mut all {
            tree.0.sort_by(|a, b| a.partial_cmp(b).expect("trees compare"));
        }
        all
    }
    let (mut all, mut last) = (vec![Tree(vec![])], vec![Tree(vec![])]);
    for _ in 1..largest {
        let mut next: Vec<Tree> = vec![];
        for tree in last.iter().flat_map(grafted) {
            if !next.contains(&tree) {
                next.push(tree);
            }
        }
        all.extend(next.iter().cloned());
        last = next;
    }
    all
}

/// Rows of all stages, the one at the end and the extra ones included.
fn rows(tableau: &Tableau) -> Vec<Row> {
    let first: &[Row] = &[&[]];
    [first, tableau.stages, &[tableau.weights], tableau.extra_stages].concat()
}

#[test]
fn there_are_as_many_trees_as_cayley_counted() {
    let sizes: Vec<usize> = (1..=8).map(|n| trees(8).iter().filter(|t| t.size() == n).count()).collect();
    assert_eq!(sizes, [1, 1, 2, 4, 9, 20, 48, 115]);
}

#[test]
fn the_step_has_its_order() {
    for (tableau, order) in [(&DOPRI5, 5), (&DOP853, 8)] {
        let rows = rows(tableau);
        for tree in trees(order + 1) {
            let defect = sum(tableau.weights, &tree.weights(&rows)) * tree.density() - 1.0;
            if tree.size() <= order {
                assert!(defect.abs() < 2e-13, "order {order}: {tree:?} {defect:e}");
            }
        }
        // It can fail: one order higher, some tree is missed by far.
        let beyond = trees(order + 1).into_iter().filter(|t| t.size() == order + 1);
        let worst = beyond.map(|t| (sum(tableau.weights, &t.weights(&rows)) * t.density() - 1.0).abs());
        assert!(worst.fold(0.0, f64_larger) > 1e-3);
    }
}

fn f64_larger(a: f64, b: f64) -> f64 {
    if a > b { a } else { b }
}

/// The error rows are differences of formulas: they see nothing below the lower order, and something at it.
#[test]
fn the_error_estimates_have_their_orders() {
    for (tableau, row, order) in
        [(&DOPRI5, DOPRI5.error, 4), (&DOP853, DOP853.error, 5), (&DOP853, DOP853.second_error, 3)]
    {
        let rows = rows(tableau);
        let size = |n: u32| {
            let of_size = trees(n).into_iter().filter(move |t| t.size() == n);
            of_size.map(|t| sum(row, &t.weights(&rows)).abs()).fold(0.0, f64_larger)
        };
        for n in 1..=order {
            assert!(size(n) < 1e-14, "trees of size {n}: {:e}", size(n));
        }
        assert!(size(order + 1) > 1e-6, "trees of size {}: {:e}", order + 1, size(order + 1));
    }
}

#[test]
fn times_are_row_sums() {
    for tableau in [&DOPRI5, &DOP853] {
        let nodes = tableau.nodes.iter().chain(&[1.0]).chain(tableau.extra_nodes);
        for (row, node) in rows(tableau).iter().zip(nodes) {
            let total: f64 = row.iter().map(|(_, a)| a).sum();
            assert!((total - node).abs() < 2e-14, "{total} {node}");
        }
    }
}
