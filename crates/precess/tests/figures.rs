//! The figures of P: each can be drawn, and shows what its note says.

use precess::figure::{Figure, Panel};
use precess::{FigureKind, Plan, Scenario, picture, run, scenarios};
use std::ops::ControlFlow;

/// The picture of a scenario that comes with the program.
fn drawn(name: &str) -> Figure {
    let text = scenarios::find(name).unwrap_or_else(|| panic!("{name}"));
    let plan = Scenario::parse(text).and_then(|s| Plan::new(&s)).unwrap_or_else(|e| panic!("{name}: {e}"));
    let mut on = |_: f64| ControlFlow::Continue(());
    let outcome = run(&plan, &mut on);
    picture(&plan, &outcome.trajectory, &mut on).unwrap_or_else(|e| panic!("{name}: {e}"))
}

fn largest(values: &[f64]) -> f64 {
    values.iter().copied().fold(f64::NEG_INFINITY, |a, b| if b > a { b } else { a })
}
fn smallest(values: &[f64]) -> f64 {
    -largest(&values.iter().map(|x| -x).collect::<Vec<_>>())
}

#[test]
fn every_figure_of_p_has_something_in_every_panel() {
    for (name, text) in scenarios::all().into_iter().filter(|(name, _)| name.starts_with("p-")) {
        let plan =
            Scenario::parse(text).and_then(|s| Plan::new(&s)).unwrap_or_else(|e| panic!("{name}: {e}"));
        assert!(!plan.panels.is_empty(), "{name} has no panel of its own");
        // These two compute for longer than a test should.
        if plan.panels.iter().any(|p| p.spec.kind.name() == "basins") || plan.card.id == "cluster" {
            continue;
        }
        let figure = drawn(name);
        let filled = |panel: &Panel| {
            let point = |(x, y): (&f64, &f64)| x.is_finite() && y.is_finite();
            panel.map.is_some() || panel.curves.iter().any(|c| c.x.iter().zip(&c.y).any(point))
        };
        for (k, panel) in figure.panels.iter().enumerate() {
            assert!(filled(panel), "{name}: panel {k} is empty");
        }
    }
}

#[test]
fn limit_cycles_have_twice_the_root_of_e_as_amplitude() {
    for (panel, e) in drawn("p-fig-15.toml").panels.iter().zip([0.05_f64, 0.1, 0.2, 0.4, 0.8, 1.6]) {
        for curve in &panel.curves {
            let settled = &curve.x[curve.x.len() * 3 / 4..];
            // From outside it has come as near as exp(-e t) lets it; the cycle itself is within 1 % of 2 sqrt(e).
            let amplitude = largest(settled) / (2.0 * e.sqrt());
            assert!((amplitude - 1.0).abs() < 0.02, "e = {e}: {amplitude}");
        }
    }
}

#[test]
fn one_moon_stays_and_the_other_is_thrown_out() {
    let figure = drawn("p-fig-28.toml");
    let apart = |panel: &Panel| {
        let (planet, moon) = (&panel.curves[1], &panel.curves[2]);
        let distance = |k: usize| {
            let (dx, dy) = (planet.x[k] - moon.x[k], planet.y[k] - moon.y[k]);
            (dx * dx + dy * dy).sqrt()
        };
        largest(&(0..planet.x.len()).map(distance).collect::<Vec<_>>())
    };
    assert!(apart(&figure.panels[2]) < 0.4, "{}", apart(&figure.panels[2]));
    assert!(apart(&figure.panels[3]) > 4.0, "{}", apart(&figure.panels[3]));
}

#[test]
fn the_rod_pulls_most_at_the_bottom() {
    let panel = &drawn("p-fig-31.toml").panels[0];
    let cosines = [std::f64::consts::FRAC_1_SQRT_2, 0.0, -std::f64::consts::FRAC_1_SQRT_2, -1.0];
    for (curve, cosine) in panel.curves.iter().zip(cosines) {
        // m = g = 1; samples miss the bottom by a little, 179.9 degrees is not quite upright.
        let pull = largest(&curve.y);
        assert!((pull - (3.0 - 2.0 * cosine)).abs() < 1e-3, "{pull} at {cosine}");
    }
}

#[test]
fn a_pendulum_goes_over_from_two_omega_on_and_a_string_from_root_five() {
    let figure = drawn("p-ex-11.toml");
    let turns: Vec<bool> =
        figure.panels[0].curves.iter().map(|c| largest(&c.y) > std::f64::consts::PI).collect();
    let holds: Vec<bool> = figure.panels[1].curves.iter().map(|c| smallest(&c.y) > 0.0).collect();
    assert_eq!(turns, [false, true, true, true]);
    assert_eq!(holds, [false, false, false, true]);
}

#[test]
fn the_separatrix_crosses_the_bottom_with_twice_omega() {
    let figure = drawn("p-fig-7.toml");
    let portrait = &figure.panels[1];
    let red = portrait.curves.iter().filter(|c| c.ink == Some(1));
    let fastest = largest(&red.flat_map(|c| c.y.clone()).collect::<Vec<_>>());
    assert!((fastest - 2.0).abs() < 1e-4, "{fastest}");
    assert_eq!(portrait.marks.len(), 6 + 1, "six saddles and centres, and one more at the border");
}

#[test]
fn resonance_is_where_the_formula_has_it() {
    let figure = drawn("p-fig-20.toml");
    let curves = &figure.panels.last().expect("panels").curves;
    let peak =
        (0..curves[0].x.len()).max_by(|a, b| curves[0].y[*a].total_cmp(&curves[0].y[*b])).expect("points");
    // sqrt(q - p^2 / 2) = 0.9975, on a grid of 0.02.
    assert!((curves[0].x[peak] - 0.9975).abs() < 0.02, "{}", curves[0].x[peak]);
    let apart = curves[0].y.iter().zip(&curves[1].y).map(|(a, b)| (a / b - 1.0).abs()).collect::<Vec<_>>();
    assert!(largest(&apart) < 1e-7, "{}", largest(&apart));
}

#[test]
fn ps_shaken_pivot_is_stable() {
    let figure = drawn("p-fig-16.toml");
    let map = figure.panels[2].map.as_ref().expect("tongues");
    let rows = map.classes.len() / map.columns;
    let place = |(low, high): (f64, f64), n: usize, x: f64| {
        ((x - low) / (high - low) * (n - 1) as f64).round() as usize
    };
    let class =
        |x: f64, y: f64| map.classes[place(map.y, rows, y) * map.columns + place(map.x, map.columns, x)];
    assert_eq!(class(4.7, 0.0851), -1);
    assert_eq!(class(2.0, 0.3), 0);
    assert_eq!(FigureKind::Tongues.name(), "tongues");
}
