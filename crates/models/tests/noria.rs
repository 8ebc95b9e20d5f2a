//! The noria against P's own program, and its events one by one.

mod common;
use common::{Ready, ready};
use precess_scalar::Scalar;
use precess_system::Direction;
use std::f64::consts::{PI, TAU};

const MASS: usize = 1;
const MODE: usize = 10;
const TURNING: usize = 18;

/// P's program (exercise 8) with all increments for a time step `dt` instead of 0.001.
fn as_printed(dt: f64, until: f64) -> ([f64; 8], f64, f64) {
    let (mut turn, mut w, mut m, mut touched) = (0.15, 0.0, [0.0_f64; 8], 8);
    let part = dt / 0.001;
    for _ in 0..(until / dt).round() as usize {
        let angle = |i: usize, turn: f64| i as f64 * PI / 4.0 + turn;
        let water: f64 = m.iter().sum();
        let force: f64 = (0..8).map(|i| m[i] * Scalar::sin(angle(i, turn))).sum();
        w = if water > 0.0005 { w + dt * (-50.0 * force / water - 75.0 * w / water) } else { 0.0 };
        turn += w * dt;
        for (i, mass) in m.iter_mut().enumerate() {
            let at = angle(i, turn);
            let at = at - TAU * (at / TAU).floor();
            if at < PI + 0.35 && at > PI - 0.35 {
                touched = i;
                *mass += part / 9.0;
                if *mass > 20.0 * 40.0 / 9.0 {
                    *mass = 0.0;
                }
            }
        }
        for (j, mass) in m.iter_mut().enumerate() {
            if j != touched && *mass > 0.5 * 40.0 / 9.0 {
                *mass -= part / 180.0;
            }
        }
    }
    (m, turn, w)
}

/// One small step after another, with whatever events it crosses.
fn ours(noria: &Ready, dt: f64, until: f64) -> (Vec<f64>, usize) {
    let (field, mut y) = (noria.field(), noria.start(&[]).expect("a sound start"));
    let directions: Vec<Direction> = noria.layout.events.iter().map(|e| e.direction).collect();
    let (mut before, mut after, mut rate) = (vec![0.0; 34], vec![0.0; 34], vec![0.0; y.len()]);
    let mut events = 0;
    for _ in 0..(until / dt).round() as usize {
        field.crossings(0.0, &y, &mut before);
        field.rate(0.0, &y, &mut rate);
        for (x, v) in y.iter_mut().zip(&rate) {
            *x += dt * v;
        }
        field.crossings(0.0, &y, &mut after);
        for k in 0..directions.len() {
            let met = match directions[k] {
                Direction::Rising => before[k] < 0.0 && after[k] >= 0.0,
                _ => before[k] > 0.0 && after[k] <= 0.0,
            };
            if met {
                field.jump(k, 0.0, &mut y);
                events += 1;
            }
        }
    }
    (y, events)
}

#[test]
fn the_smooth_model_is_the_limit_of_the_printed_program() {
    let noria = ready("noria");
    for until in [0.5, 2.0, 4.0] {
        let distance = |dt: f64| {
            let ((m, turn, w), (y, _)) = (as_printed(dt, until), ours(&noria, dt, until));
            let water: f64 = (0..8).map(|i| (m[i] - y[MASS + i]).abs()).sum();
            ((turn - y[0]).abs(), (w - y[9]).abs(), water)
        };
        let (coarse, fine) = (distance(1e-4), distance(1e-5));
        assert!(fine.0 < 1e-3 && fine.1 < 1e-3 && fine.2 < 0.05, "at {until}: {fine:?}");
        assert!(fine.0 < coarse.0 / 5.0 && fine.2 < coarse.2 / 5.0, "at {until}: {coarse:?}, then {fine:?}");
    }
}

#[test]
fn a_wheel_fills_and_turns() {
    let noria = ready("noria");
    let y = noria.start(&[]).expect("a sound start");
    assert_eq!(y[MODE..], [0.0, 0.0, 0.0, 0.0, 2.0, 0.0, 0.0, 0.0, 0.0], "bucket 4 fills, the wheel rests");
    assert_eq!(noria.rate(&y)[MASS + 4], 1000.0 / 9.0);
    let (y, events) = ours(&noria, 1e-3, 30.0);
    assert!((50..5000).contains(&events), "{events} events");
    assert!(y[MASS..][..8].iter().all(|&m| (0.0..800.0 / 9.0 + 1.0).contains(&m)), "{y:?}");
    assert_eq!(y[TURNING], 1.0);
}

/// What the events make of the modes; applied twice they change nothing more.
#[test]
fn events_switch_modes_once() {
    let noria = ready("noria");
    let field = noria.field();
    let event = |name: &str| noria.layout.events.iter().position(|e| e.name == name).expect("an event");
    let mut y = noria.start(&[("m4", 50.0), ("m5", 30.0), ("m6", 1.0)]).expect("a sound start");
    assert_eq!(y[MODE..], [0.0, 0.0, 0.0, 0.0, 2.0, -1.0, 0.0, 0.0, 1.0]);
    let mut after = |name: &str| {
        field.jump(event(name), 0.0, &mut y);
        let once = y.clone();
        field.jump(event(name), 0.0, &mut y);
        assert_eq!(once, y, "{name} twice");
        y.clone()
    };
    assert_eq!(after("bucket4_leaves")[MODE + 4], 1.0, "spared from evaporation");
    assert_eq!(after("bucket3_enters")[MODE + 3..MODE + 5], [2.0, -1.0], "spared no longer");
    assert_eq!(after("bucket4_dry")[MODE + 4], 0.0);
    assert_eq!(after("bucket5_dry")[MODE + 5], 0.0);
    assert_eq!(after("bucket3_dry")[MODE + 3], 2.0, "a bucket that fills passes the floor unmoved");
    assert_eq!(after("bucket3_full")[MASS + 3], 0.0, "what is written for a full bucket");
}

/// Where each event function of a bucket changes sign.
#[test]
fn event_functions_vanish_at_their_thresholds() {
    let noria = ready("noria");
    let mut y = noria.start(&[]).expect("a sound start");
    let mut sign_after = |name: &str, place: usize, value: f64| {
        y[place] = value;
        let mut crossings = vec![0.0; noria.layout.events.len()];
        noria.field().crossings(0.0, &y, &mut crossings);
        let event = noria.layout.events.iter().position(|e| e.name == name).expect("an event");
        crossings[event].signum()
    };
    let (capacity, floor, above, below) = (800.0 / 9.0, 20.0 / 9.0, 1.0 + 1e-12, 1.0 - 1e-12);
    for (name, place, threshold) in [
        ("bucket3_full", MASS + 3, capacity),
        ("bucket3_dry", MASS + 3, floor),
        ("bucket5_enters", 0, -PI / 4.0 - 0.35),
        ("bucket6_leaves", 0, -PI / 2.0 + 0.35),
    ] {
        let (far, near) =
            (sign_after(name, place, threshold * above), sign_after(name, place, threshold * below));
        assert!(far != near, "{name} does not change sign at {threshold}");
    }
    assert_eq!(
        [sign_after("sets_off", MASS + 3, 0.0004), sign_after("halts", MASS + 3, 0.0006)],
        [-1.0, 1.0]
    );
}

#[test]
fn a_full_bucket_empties_and_a_bare_wheel_stops() {
    let mut noria = ready("noria");
    let event = |name: &str| noria.layout.events.iter().position(|e| e.name == name).expect("an event");
    let (full, sets_off) = (event("bucket4_full"), event("sets_off"));
    let mut y = noria.start(&[("m4", 88.0), ("theta_dot", 0.3)]).expect("a sound start");
    y[MASS + 4] = 800.0 / 9.0;
    noria.field().jump(full, 0.0, &mut y);
    assert_eq!((y[MASS + 4], y[9], y[TURNING]), (0.0, 0.0, 0.0));
    assert!(noria.rate(&y).iter().all(|x| x.is_finite()));
    noria.field().jump(sets_off, 0.0, &mut y);
    assert_eq!(y[TURNING], 1.0);
    noria.start(&[("theta_dot", 0.3)]).expect_err("a bare wheel rests");
    noria.start(&[("m2", 90.0)]).expect_err("more than a bucket holds");
    noria.set("capacity", 100.0);
    noria.start(&[("m2", 90.0)]).expect("a larger bucket");
}
