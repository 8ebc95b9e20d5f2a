//! The analyses on systems whose answers are known: linear ones, the Lorenz equations, a Hamiltonian.

use precess_analysis::{
    Exponent, Flow, Kind, Section, Window, fixed_points, lyapunov, multipliers, response, section,
    separatrices, strobe,
};
use precess_integrate::{METHODS, Options, Pace, Tolerance};
use precess_scalar::{Dual, Scalar};
use precess_system::{Bind, Card, Direction, Layout, State, System, Values, card, coordinate, number};
use std::cell::RefCell;
use std::ops::ControlFlow;

/// x'' = -x - x' / 5 + cos t: exponents -1/10, -1/10, whatever the motion.
#[derive(Clone)]
struct Damped;
impl System for Damped {
    fn card(&self) -> Card {
        card("damped", "d", "d").coordinate(coordinate("x", "", "x", "x").start(1.0))
    }
    fn equations<S: Scalar>(&self, s: &State<S>, highest: &mut [S]) {
        let ([x], [v]) = (s.q(), s.v());
        highest[0] = -x - v * 0.2 + s.t.cos();
    }
}

/// x' = -30 x, y' = y / 2: far apart, so that the frame must be mended often.
#[derive(Clone)]
struct Apart;
impl System for Apart {
    fn card(&self) -> Card {
        let first = |name: &str| coordinate(name, "", "x", "x").start(1.0).first_order();
        card("apart", "a", "a").coordinate(first("x")).coordinate(first("y"))
    }
    fn equations<S: Scalar>(&self, s: &State<S>, highest: &mut [S]) {
        let [x, y] = s.q();
        highest.copy_from_slice(&[x * -30.0, y * 0.5]);
    }
}

/// x' = 10 (y - x), y' = x (28 - z) - y, z' = x y - 8 z / 3 (Lorenz 1963).
#[derive(Clone)]
struct Lorenz;
impl System for Lorenz {
    fn card(&self) -> Card {
        let first = |name: &str| coordinate(name, "", "x", "x").start(1.0).first_order();
        card("lorenz", "l", "l").coordinate(first("x")).coordinate(first("y")).coordinate(first("z"))
    }
    fn equations<S: Scalar>(&self, s: &State<S>, highest: &mut [S]) {
        let [x, y, z] = s.q();
        highest.copy_from_slice(&[(y - x) * 10.0, x * (S::from(28.0) - z) - y, x * y - z * 8.0 / 3.0]);
    }
}

/// Hénon and Heiles 1964: a Hamiltonian, so the exponents come in pairs of opposite sign.
#[derive(Clone)]
struct HenonHeiles;
impl System for HenonHeiles {
    fn card(&self) -> Card {
        card("henon", "h", "h")
            .coordinate(coordinate("x", "", "x", "x").start_dot(0.45))
            .coordinate(coordinate("y", "", "y", "y").start(-0.15).start_dot(0.25))
    }
    fn equations<S: Scalar>(&self, s: &State<S>, highest: &mut [S]) {
        let [x, y] = s.q();
        highest.copy_from_slice(&[-x - x * y * 2.0, -y - x * x + y * y]);
    }
}

/// Asks something of a system's flow under a method, within 1e-10.
fn ask<M: System, T>(system: &M, method: &str, question: impl Fn(&Flow, &[f64]) -> T) -> T {
    ask_with(system, &Values::defaults(&system.card()), method, question)
}

/// The same with other parameters.
fn ask_with<M: System, T>(
    system: &M,
    values: &Values<f64>,
    method: &str,
    question: impl Fn(&Flow, &[f64]) -> T,
) -> T {
    let layout = Layout::of(&system.card());
    let field = Bind::<f64>::bind(system, values.clone(), &layout);
    let tangents = Bind::<Dual<f64>>::bind(system, values.map(|&x| Dual::from(x)), &layout);
    let method = METHODS.iter().find(|m| m.card().id == method).expect("a method");
    let pace = match method.card().kind {
        precess_integrate::Kind::Fixed => Pace::Fixed(0.002),
        precess_integrate::Kind::Adaptive => {
            Pace::Adaptive(Tolerance { rtol: 1e-10, atol: 1e-10, skip: vec![] })
        }
    };
    let mut on = |_| ControlFlow::Continue(());
    let flow = Flow {
        field: field.as_ref(),
        tangents: tangents.as_ref(),
        directions: &[],
        method: *method,
        options: Options::default(),
        pace,
        progress: RefCell::new(&mut on),
    };
    question(&flow, &layout.start())
}

fn spectrum<M: System>(system: &M, method: &str, until: f64) -> Vec<Exponent> {
    ask(system, method, |flow, start| lyapunov(flow, start, until).expect("it runs").exponents)
}

#[test]
fn linear_systems_have_the_real_parts_of_their_eigenvalues() {
    for method in ["dop853", "rk4"] {
        let damped = spectrum(&Damped, method, 400.0);
        assert!((damped[0].value + damped[1].value + 0.2).abs() < 1e-9, "{damped:?}");
        assert!(damped.iter().all(|e| (e.value + 0.1).abs() < 2e-3 && e.error < 1e-2), "{damped:?}");
        let apart = spectrum(&Apart, method, 20.0);
        assert!((apart[0].value - 0.5).abs() < 1e-8 && (apart[1].value + 30.0).abs() < 1e-4, "{apart:?}");
    }
}

#[test]
fn the_lorenz_equations_have_their_known_spectrum_and_exactly_their_divergence() {
    // 0.9056 and -14.572: Sprott, *Chaos and Time-Series Analysis*, 2003.
    let [first, second, third] = spectrum(&Lorenz, "dop853", 600.0)[..] else { panic!("three numbers") };
    assert!((first.value + second.value + third.value + 10.0 + 1.0 + 8.0 / 3.0).abs() < 1e-7);
    assert!(first.error < 0.05 && (first.value - 0.9056).abs() < 2.0 * first.error, "{first:?}");
    assert!(third.error < 0.05 && (third.value + 14.572).abs() < 2.0 * third.error, "{third:?}");
    assert!(second.value.abs() < 0.01, "{second:?}");
}

#[test]
fn the_exponents_of_a_hamiltonian_are_pairs() {
    let found = spectrum(&HenonHeiles, "dop853", 1000.0);
    let value: Vec<f64> = found.iter().map(|e| e.value).collect();
    assert!((value[0] + value[1] + value[2] + value[3]).abs() < 1e-8, "{value:?}");
    assert!((value[0] + value[3]).abs() < 0.1 * value[0], "{value:?}");
    assert!(value[0] > 0.02 && (value[1] + value[2]).abs() < 0.1 * value[0], "{value:?}");
}

#[test]
fn the_settled_motion_is_met_once_a_period() {
    // Settled, x = 5 sin t: it rises through zero at whole turns, where the drive begins anew.
    let (crossings, failure) = ask(&Damped, "dop853", |flow, start| {
        let x = |_: f64, y: &[f64]| y[0];
        section(
            flow,
            start,
            400.0,
            &Section { quantity: &x, value: 0.0, period: None, direction: Direction::Rising },
        )
    });
    assert_eq!(failure, None);
    let late: Vec<_> = crossings.iter().filter(|c| c.t > 300.0).collect();
    assert_eq!(late.len(), 16);
    for crossing in late {
        let turns = crossing.t / std::f64::consts::TAU;
        assert!(
            (turns - turns.round()).abs() < 1e-8 && (crossing.state[1] - 5.0).abs() < 1e-7,
            "{crossing:?}"
        );
    }
    let turn = std::f64::consts::TAU;
    let (strobed, failure) =
        ask(&Damped, "dop853", |flow, start| strobe(flow, start, 400.0, (0.5 * turn, turn)));
    assert_eq!(failure, None);
    assert_eq!(strobed.len(), 64);
    assert!(strobed[60].state[0].abs() < 1e-8 && (strobed[60].state[1] + 5.0).abs() < 1e-7, "{strobed:?}");
}

#[test]
fn a_growing_angle_is_met_at_every_turn_of_its_own() {
    // y grows as e^(t/2) from 1: it passes 2, 4, 6, ... at 2 ln of them, and 1, 3, 5, ... do not count.
    let (crossings, _) = ask(&Apart, "dop853", |flow, start| {
        let y = |_: f64, y: &[f64]| y[1];
        let section = |flow, section| precess_analysis::section(flow, start, 5.0, &section);
        section(flow, Section { quantity: &y, value: 0.0, period: Some(2.0), direction: Direction::Either })
    });
    let times: Vec<f64> = crossings.iter().map(|c| c.t).collect();
    let wanted: Vec<f64> = (1..=6).map(|k| 2.0 * Scalar::ln(2.0 * f64::from(k))).collect();
    assert_eq!(times.len(), wanted.len(), "{times:?}");
    assert!(times.iter().zip(&wanted).all(|(a, b)| (a - b).abs() < 1e-8), "{times:?} {wanted:?}");
}

/// x'' = -(a - 2 q cos 2t) x: Mathieu's equation.
#[derive(Clone)]
struct Mathieu;
impl System for Mathieu {
    fn card(&self) -> Card {
        card("mathieu", "m", "m")
            .coordinate(coordinate("x", "", "x", "x").start(1.0))
            .parameter(number("a", "", 1.0, "a", "a"))
    }
    fn equations<S: Scalar>(&self, s: &State<S>, highest: &mut [S]) {
        let ([x], [a]) = (s.q(), s.p());
        highest[0] = -(a - (s.t * 2.0).cos() * 2.0) * x;
    }
}

#[test]
fn mathieus_tongues_begin_at_his_characteristic_values() {
    // Abramowitz and Stegun, table 20.1, q = 1: the trace over half a turn is -2 at a1 and 2 at b2 and a2.
    for (a, trace) in [(1.859_108_072_5, -2.0), (3.917_024_773_0, 2.0), (4.371_300_982_7, 2.0)] {
        let mut values = Values::defaults(&Mathieu.card());
        values.numbers[0] = a;
        let found = ask_with(&Mathieu, &values, "dop853", |flow, start| {
            multipliers(flow, start, std::f64::consts::PI, true).expect("no obstacle").map.trace()
        });
        assert!((found - trace).abs() < 1e-8, "{a}: {found}");
    }
}

/// x'' = x - x^3 - x' / 10: two wells and the saddle between them.
#[derive(Clone)]
struct TwoWells;
impl System for TwoWells {
    fn card(&self) -> Card {
        card("wells", "w", "w").coordinate(coordinate("x", "", "x", "x").start(0.5))
    }
    fn equations<S: Scalar>(&self, s: &State<S>, highest: &mut [S]) {
        let ([x], [v]) = (s.q(), s.v());
        highest[0] = x - x * x * x - v * 0.1;
    }
}

#[test]
fn fixed_points_are_found_classified_and_joined() {
    let window = Window { ranges: vec![(-2.0, 2.0), (-2.0, 2.0)] };
    let (points, branches) = ask(&TwoWells, "dop853", |flow, _| {
        let points = fixed_points(flow, &[], &window);
        let branches = separatrices(flow, &points, &window, 200.0);
        (points, branches)
    });
    let kinds: Vec<_> = points.iter().map(|p| (p.state[0], p.kind, p.stable)).collect();
    assert_eq!(kinds, [(-1.0, Kind::Focus, true), (0.0, Kind::Saddle, false), (1.0, Kind::Focus, true)]);
    // At the wells: lambda^2 + lambda / 10 + 2 = 0.
    let focus = points[0].eigenvalues[0];
    assert!(
        (focus.re + 0.05).abs() < 1e-12 && (focus.im * focus.im - (2.0 - 0.0025)).abs() < 1e-12,
        "{focus:?}"
    );
    // Both branches that leave the saddle end in a well; one in each.
    let mut ends: Vec<f64> =
        branches.iter().filter(|b| b.leaves).map(|b| b.line.last().expect("points").0).collect();
    ends.sort_by(f64::total_cmp);
    assert_eq!(branches.len(), 4);
    assert!((ends[0] + 1.0).abs() < 0.01 && (ends[1] - 1.0).abs() < 0.01, "{ends:?}");
}

#[test]
fn a_damped_oscillator_answers_as_the_formula_says() {
    // x'' = -x - x' / 5 + cos t: at resonance the amplitude is 5 and the lag a quarter of a turn.
    let found = ask(&Damped, "dop853", |flow, start| {
        let period = std::f64::consts::TAU;
        response(flow, &mut start.to_vec(), period, 10.0, 0).expect("no obstacle")
    });
    assert!((found.amplitude - 5.0).abs() < 1e-8, "{found:?}");
    assert!(
        (found.lag - std::f64::consts::FRAC_PI_2).abs() < 1e-8 && (found.swing - 5.0).abs() < 1e-2,
        "{found:?}"
    );
}
