//! Basins: attractors that are known, labels held against long runs, what the map says, refusals.

use precess::basins::{
    Basins, BasinsSpec, ESCAPED, Kind, UNDECIDED, basins, entropy, fraction, part, uncertainty, whole,
};
use precess::scalar::Isa;
use precess::value::{Value, parse};
use precess::{Axis, Keep, Plan, Scenario, Workers, ensemble, grid, run};
use std::f64::consts::TAU;
use std::ops::ControlFlow;
use std::path::Path;

fn scenario(system: &str, parameters: &[(&str, &str)], settings: &[(&str, f64)]) -> Scenario {
    let mut scenario = Scenario::of(system);
    scenario.parameters =
        parameters.iter().map(|(name, text)| ((*name).into(), parse(text).expect("a value"))).collect();
    scenario.run = settings.iter().map(|(name, x)| ((*name).into(), Value::number(*x))).collect();
    scenario
}

fn axis(name: &str, low: f64, high: f64, points: usize) -> Axis {
    Axis { name: name.into(), low, high, points }
}

fn spec(axes: &[Axis]) -> BasinsSpec {
    BasinsSpec { axes: axes.to_vec(), ..BasinsSpec::default() }
}

fn found(scenario: &Scenario, spec: &BasinsSpec) -> Basins {
    let workers = Workers { isa: Isa::best(), threads: 2 };
    basins(scenario, spec, workers, &mut |_| ControlFlow::Continue(())).expect("basins")
}

/// Where a start is after a long time, within a tight tolerance.
fn end(scenario: &Scenario, start: &[(&str, f64)], until: f64) -> Vec<f64> {
    let mut scenario = scenario.clone();
    scenario.start = start.iter().map(|(name, x)| ((*name).into(), Value::number(*x))).collect();
    scenario.run = [("until", until), ("every", until), ("rtol", 1e-13), ("atol", 1e-13)]
        .map(|(name, x)| (name.into(), Value::number(x)))
        .into();
    let outcome = run(&Plan::new(&scenario).expect("a plan"), &mut |_| ControlFlow::Continue(()));
    outcome.trajectory.rows().last().expect("an end")[1..].to_vec()
}

const DOUBLE_WELL: [(&str, &str); 2] = [("u", "[0; 0; -0.5; 0; 0.25]"), ("b", "0.2")];

#[test]
fn a_double_well_has_two_basins_and_they_mirror_each_other() {
    let scenario = scenario("potential_well", &DOUBLE_WELL, &[]);
    let map = found(&scenario, &spec(&[axis("x", -1.9, 2.1, 40), axis("x_dot", -1.7, 1.7, 24)]));
    assert_eq!(map.attractors.len(), 2);
    for (attractor, place) in map.attractors.iter().zip([-1.0, 1.0]) {
        assert!((attractor.state[0] - place).abs() < 1e-12 && attractor.state[1] == 0.0, "{attractor:?}");
        // The hill between them is at height 0, the floors at -1/4; a thousandth of that is left as a margin.
        assert!((attractor.pass.expect("a well") + 0.25e-3).abs() < 1e-9, "{attractor:?}");
    }
    assert!(!map.labels.contains(&UNDECIDED), "200 s are enough");
    let mirrored = found(&scenario, &spec(&[axis("x", 1.9, -2.1, 40), axis("x_dot", 1.7, -1.7, 24)]));
    assert!(map.labels.iter().zip(&mirrored.labels).all(|(a, b)| *a == 1 - *b));
    for k in (0..map.labels.len()).step_by(37) {
        let start = [("x", map.axes[0].value(k % 40)), ("x_dot", map.axes[1].value(k / 40))];
        let x = end(&scenario, &start, 400.0)[0];
        assert_eq!(map.labels[k], i32::from(x > 0.0), "{start:?}");
    }
}

const MAGNETS: [(&str, &str); 3] = [("c", "4"), ("r", "0.2"), ("d", "0.1")];

#[test]
fn the_magnets_labels_are_right_in_all_lanes_and_threads() {
    let mut scenario = scenario("magnetic_pendulum", &MAGNETS, &[]);
    scenario.start = vec![("y_dot".into(), Value::number(0.0))];
    let grid = spec(&[axis("x", -2.0, 2.0, 23), axis("y", -2.0, 2.0, 21)]);
    let map = found(&scenario, &grid);
    assert_eq!(map.attractors.len(), 3);
    for isa in Isa::available() {
        for threads in [1, 2] {
            let workers = Workers { isa, threads };
            let same = basins(&scenario, &grid, workers, &mut |_| ControlFlow::Continue(())).expect("basins");
            assert_eq!(same.labels, map.labels, "{workers:?}");
            let bits = |map: &Basins| map.times.iter().map(|t| t.to_bits()).collect::<Vec<_>>();
            assert_eq!(bits(&same), bits(&map), "{workers:?}");
        }
    }
    for k in (0..map.labels.len()).step_by(9) {
        let (x, y) = (map.axes[0].value(k % 23), map.axes[1].value(k / 23));
        let ended = end(&scenario, &[("x", x), ("y", y), ("y_dot", 0.0)], 200.0);
        let near = |state: &[f64]| (ended[0] - state[0]).abs() + (ended[1] - state[1]).abs() < 1e-2;
        let right = map.attractors.iter().position(|a| near(&a.state));
        assert_eq!(usize::try_from(map.labels[k]).ok(), right, "from ({x}, {y}), which ends at {ended:?}");
    }
}

/// `golden/basins.txt` holds the map of the three magnets, a line a row, the lowest first: the number of an attractor, or `-`.
/// The other faces must print the same. `PRECESS_BLESS=1` writes it anew, after a change that is meant.
#[test]
fn the_map_of_the_magnets_is_the_golden_one() {
    const SIDE: usize = 28;
    let mut scenario = scenario("magnetic_pendulum", &MAGNETS, &[]);
    scenario.start = vec![("y_dot".into(), Value::number(0.0))];
    let map = found(&scenario, &spec(&[axis("x", -2.0, 2.0, SIDE), axis("y", -2.0, 2.0, SIDE)]));
    let sign = |label: &i32| char::from_digit(label.cast_unsigned(), 10).unwrap_or('-');
    let now: String =
        map.labels.chunks(SIDE).map(|row| row.iter().map(sign).collect::<String>() + "\n").collect();
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../golden/basins.txt");
    if std::env::var_os("PRECESS_BLESS").is_some() {
        std::fs::write(&path, now).expect("the file can be written");
        return;
    }
    assert_eq!(now, std::fs::read_to_string(&path).expect("the golden map"));
}

/// The attractor at which each start of a map is found after a hundred seconds, when its swing has died down to e^-10 of what it
/// was: by a method within a tolerance that follows all of them to the end, and proves nothing on the way.
fn followed(map: &Basins, scenario: &Scenario, method: &str, tolerance: f64) -> Vec<Option<i32>> {
    let mut scenario = scenario.clone();
    scenario.method = Some(method.into());
    scenario.run = [("until", 100.0), ("every", 100.0), ("rtol", tolerance), ("atol", tolerance)]
        .map(|(name, x)| (name.into(), Value::number(x)))
        .into();
    let plan = Plan::new(&scenario).expect("a plan");
    let starts = grid(&plan, &map.axes).expect("starts");
    let workers = Workers { isa: Isa::best(), threads: 2 };
    let ends =
        ensemble(&plan, &starts, Keep::Last, workers, &mut |_| ControlFlow::Continue(())).expect("an end");
    let near = |k: usize| {
        let end = ends.member(k);
        map.attractors.iter().position(|a| a.state.iter().zip(end).all(|(a, b)| (a - b).abs() < 1e-2))
    };
    (0..map.labels.len()).map(|k| near(k).map(|label| i32::try_from(label).expect("three"))).collect()
}

/// Held against two methods of their own tolerances. Where these disagree a rounding decides, and nobody can be right; that,
/// and what is undecided, lies within a pixel of a boundary.
#[test]
fn the_magnets_labels_are_those_of_motions_followed_to_their_ends() {
    const SIDE: usize = 40;
    let mut scenario = scenario("magnetic_pendulum", &MAGNETS, &[]);
    scenario.start = vec![("y_dot".into(), Value::number(0.0))];
    let map = found(&scenario, &spec(&[axis("x", -2.0, 2.0, SIDE), axis("y", -2.0, 2.0, SIDE)]));
    let [fine, coarse] = [("dop853", 1e-13), ("tsit5", 1e-10)]
        .map(|(name, tolerance)| followed(&map, &scenario, name, tolerance));
    let at_boundary = |k: usize| {
        let within = |i: usize| i.saturating_sub(1)..if i + 2 < SIDE { i + 2 } else { SIDE };
        let mut neighbours = within(k / SIDE).flat_map(|row| within(k % SIDE).map(move |i| row * SIDE + i));
        neighbours.any(|other| map.labels[other] != map.labels[k])
    };
    let mut settled = 0;
    for (k, label) in map.labels.iter().enumerate() {
        let place = (map.axes[0].value(k % SIDE), map.axes[1].value(k / SIDE));
        if fine[k].is_some() && fine[k] == coarse[k] && *label != UNDECIDED {
            assert_eq!(Some(*label), fine[k], "from {place:?}");
            settled += 1;
        } else {
            assert!(at_boundary(k), "from {place:?}: {label}, {:?}, {:?}", fine[k], coarse[k]);
        }
    }
    println!("{settled} of {} starts are told alike by all three", SIDE * SIDE);
    assert!(settled > SIDE * SIDE * 98 / 100, "{settled}");
}

/// From (1.28, 1.69) and its mirror image a run within 1e-12 is to be trusted up to t = 11, its end is decided later, and within
/// 1e-13 `dop853` and `taylor` end at another magnet: a label that follows them once gives is wrong.
#[test]
fn what_another_tolerance_would_change_is_undecided() {
    let mut scenario = scenario("magnetic_pendulum", &MAGNETS, &[]);
    scenario.start = vec![("y_dot".into(), Value::number(0.0))];
    let cell = 4.0 / 39.0;
    let [x, y] = [32.0, 36.0].map(|k| -2.0 + k * cell);
    let spec = spec(&[axis("x", x, x + cell, 2), axis("y", -y, y, 2)]);
    let once = found(&scenario, &BasinsSpec { once: true, ..spec.clone() });
    let twice = found(&scenario, &spec);
    let fine = followed(&once, &scenario, "dop853", 1e-13);
    for k in [0, 2] {
        assert_ne!(once.labels[k], UNDECIDED);
        assert_ne!(Some(once.labels[k]), fine[k]);
        assert_eq!(twice.labels[k], UNDECIDED);
    }
    // Their neighbours are right either way, with the same bits.
    for k in [1, 3] {
        assert_eq!(Some(twice.labels[k]), fine[k]);
        assert_eq!((twice.labels[k], twice.times[k].to_bits()), (once.labels[k], once.times[k].to_bits()));
    }
}

/// Wells, traps about driven cycles, and starts that nobody decides: cut anywhere, in any lanes, the bits are the same.
#[test]
fn parts_make_the_same_whole_wherever_they_are_cut() {
    let mut magnets = scenario("magnetic_pendulum", &MAGNETS, &[("until", 12.0)]);
    magnets.start = vec![("y_dot".into(), Value::number(0.0))];
    let driven = scenario("duffing", &[("gamma", "0.1")], &[("until", 60.0)]);
    let cases = [
        (magnets, spec(&[axis("x", -2.0, 2.0, 11), axis("y", -2.0, 2.0, 9)])),
        (driven, spec(&[axis("x", -2.0, 2.0, 10), axis("x_dot", -1.0, 1.0, 7)])),
    ];
    for (scenario, grid) in cases {
        let map = found(&scenario, &grid);
        let members = map.labels.len();
        let mut rows = vec![];
        for (k, isa) in Isa::available().into_iter().cycle().take(4).enumerate() {
            let workers = Workers { isa, threads: 1 + k % 2 };
            // Not into equal pieces.
            let cut = |k: usize| members * k * k / 16;
            let mine =
                part(&scenario, &grid, cut(k)..cut(k + 1), workers, &mut |_| ControlFlow::Continue(()));
            rows.extend(mine.expect("a part").0);
        }
        let workers = Workers { isa: Isa::Scalar, threads: 1 };
        let same =
            whole(&scenario, &grid, &rows, workers, &mut |_| ControlFlow::Continue(())).expect("basins");
        let bits = |map: &Basins| map.times.iter().map(|t| t.to_bits()).collect::<Vec<_>>();
        assert_eq!(same.labels, map.labels);
        assert_eq!(bits(&same), bits(&map));
        assert_eq!(same.attractors, map.attractors);
        assert!(map.labels.contains(&UNDECIDED) || map.attractors.len() == 2, "{}", map.attractors.len());
        assert!(whole(&scenario, &grid, &rows[1..], workers, &mut |_| ControlFlow::Continue(())).is_err());
        let beyond = part(&scenario, &grid, 0..members + 1, workers, &mut |_| ControlFlow::Continue(()));
        assert!(beyond.is_err());
    }
}

#[test]
fn a_pendulum_falls_into_wells_a_turn_apart() {
    let scenario = scenario("pendulum", &[("b", "0.5")], &[]);
    let mut grid = spec(&[axis("theta", -3.0, 3.0, 16), axis("theta_dot", -14.0, 14.0, 15)]);
    let map = found(&scenario, &grid);
    assert!(map.attractors.len() > 4, "{:?}", map.attractors);
    for attractor in &map.attractors {
        let turns = attractor.state[0] / TAU;
        assert!((turns - turns.round()).abs() < 1e-12, "{attractor:?}");
    }
    for k in (0..map.labels.len()).step_by(11) {
        let start = [("theta", map.axes[0].value(k % 16)), ("theta_dot", map.axes[1].value(k / 16))];
        let theta = end(&scenario, &start, 80.0)[0];
        let label = usize::try_from(map.labels[k]).expect("decided");
        assert!((map.attractors[label].state[0] - theta).abs() < 1e-6, "{start:?}");
    }
    grid.wrap = true;
    let wrapped = found(&scenario, &grid);
    assert_eq!(wrapped.attractors.len(), 1);
    assert!(wrapped.labels.iter().all(|label| *label == 0));
}

#[test]
fn a_weakly_driven_duffing_oscillator_has_a_cycle_in_each_well() {
    let scenario = scenario("duffing", &[("gamma", "0.1")], &[("until", 120.0)]);
    let map = found(&scenario, &spec(&[axis("x", -1.5, 1.5, 12), axis("x_dot", -1.0, 1.0, 10)]));
    assert_eq!(map.attractors.len(), 2, "{:?}", map.attractors);
    assert!(map.attractors.iter().all(|a| a.kind == Kind::Driven { periods: 1 }));
    let undecided = fraction(&map.labels, UNDECIDED).value;
    assert!(undecided < 0.02, "{undecided}");
    // Half a period later, everything is mirrored: the other well's cycle.
    let half = 0.5 * TAU / 1.2;
    let state = &map.attractors[0].state;
    let later = end(&scenario, &[("x", state[0]), ("x_dot", state[1])], half);
    for (a, b) in later.iter().zip(&map.attractors[1].state) {
        assert!((a + b).abs() < 1e-8, "{later:?}");
    }
    for k in (0..map.labels.len()).step_by(13) {
        let start = [("x", map.axes[0].value(k % 12)), ("x_dot", map.axes[1].value(k / 12))];
        let x = end(&scenario, &start, 400.0 * half)[0];
        assert!(map.labels[k] < 0 || map.labels[k] == i32::from(x > 0.0), "{start:?}");
    }
}

#[test]
fn van_der_pols_cycle_takes_all_but_the_origin() {
    let scenario = scenario("van_der_pol", &[], &[("until", 60.0)]);
    let map = found(&scenario, &spec(&[axis("x", -3.0, 3.0, 9), axis("x_dot", -3.0, 3.0, 9)]));
    assert_eq!((map.attractors.len(), map.attractors[0].kind), (1, Kind::Cycle));
    let origin = map.labels.len() / 2;
    assert!(
        map.labels.iter().enumerate().all(|(k, label)| *label == if k == origin { UNDECIDED } else { 0 })
    );
}

#[test]
fn lorenzs_points_attract_below_the_onset_of_chaos() {
    let scenario = scenario("lorenz", &[("rho", "10")], &[("until", 60.0)]);
    let map = found(&scenario, &spec(&[axis("x", -9.0, 9.0, 8), axis("z", 0.0, 20.0, 6)]));
    let place = (8.0_f64 / 3.0 * 9.0).sqrt();
    assert_eq!(map.attractors.len(), 2);
    for (attractor, sign) in map.attractors.iter().zip([-1.0, 1.0]) {
        let right = [sign * place, sign * place, 9.0];
        assert!(attractor.state.iter().zip(right).all(|(a, b)| (a - b).abs() < 1e-11), "{attractor:?}");
    }
    assert!(!map.labels.contains(&UNDECIDED));
}

#[test]
fn who_passes_the_hill_of_the_cubic_well_escapes() {
    // x'' = -x + x^2 - b x' from rest: those beyond the hilltop at x = 1 run away.
    let map = found(&scenario("cubic_well", &[], &[]), &spec(&[axis("x", -0.4, 1.6, 11)]));
    let right: Vec<i32> =
        (0..11).map(|k| if map.axes[0].value(k) > 1.0 + 1e-9 { ESCAPED } else { 0 }).collect();
    for (k, (label, right)) in map.labels.iter().zip(right).enumerate() {
        let x = map.axes[0].value(k);
        assert!(*label == right || (x - 1.0).abs() < 1e-9 && *label == UNDECIDED, "{x}: {label}");
    }
}

#[test]
fn what_has_no_basins_is_refused_in_a_sentence() {
    let refusal = |scenario: &Scenario, name: &str| {
        let grid = spec(&[axis(name, 0.1, 0.2, 2)]);
        let answer = basins(scenario, &grid, Workers { isa: Isa::Scalar, threads: 1 }, &mut |_| {
            ControlFlow::Continue(())
        });
        answer.err().expect("refused").to_string()
    };
    assert!(refusal(&Scenario::of("pendulum"), "theta").contains("friction"));
    assert!(refusal(&Scenario::of("noria"), "theta").contains("events"));
    let plan = Plan::new(&Scenario::of("pendulum")).expect("a plan");
    for (text, word) in [
        ("theta", "LOW:HIGH:N"),
        ("theta=0:1", "LOW:HIGH:N"),
        ("thet=0:1:2", "'theta'"),
        ("theta=0:1:-2", "'-2'"),
    ] {
        let refusal = Axis::parse(&plan, text).expect_err("refused").to_string();
        assert!(refusal.contains(word), "{refusal}");
    }
    assert_eq!(
        Axis::parse(&plan, "theta = -180 deg:180 deg:3").expect("an axis").value(2),
        std::f64::consts::PI
    );
}

#[test]
fn what_a_map_says_is_known_for_simple_maps() {
    const N: usize = 80;
    let map = |label: &dyn Fn(usize, usize) -> i32| -> Vec<i32> {
        (0..N * N).map(|k| label(k % N, k / N)).collect()
    };
    let halves = map(&|column, _| i32::from(column >= 38));
    assert_eq!(fraction(&halves, 1).value, 42.0 / 80.0);
    let exponent = uncertainty(&halves, N).expect("a boundary");
    assert!((exponent.value - 1.0).abs() < 1e-9, "{exponent:?}");
    // The boundary runs through every sixteenth box, three columns on the left of it.
    let p: f64 = 3.0 / 5.0;
    let in_box = -p * precess::scalar::Scalar::ln(p) - (1.0 - p) * precess::scalar::Scalar::ln(1.0 - p);
    let [all, boundary] = entropy(&halves, N);
    assert!((all.expect("boxes").value - in_box / 16.0).abs() < 1e-12);
    assert!((boundary.expect("boxes").value - in_box).abs() < 1e-12);
    // Labels without any order: a distance says nothing.
    let mut state = 1_u64;
    let noise: Vec<i32> = (0..N * N)
        .map(|_| {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 62) as i32 & 1
        })
        .collect();
    let exponent = uncertainty(&noise, N).expect("a boundary");
    assert!(exponent.value.abs() < 0.02, "{exponent:?}");
}
