//! The hashes see a single operation that rounds differently: what a fused multiply-add, a sum in another order or a
//! relaxed division would do.

use precess::scalar::{Isa, Scalar};
use precess::system::{Card, State, System};
use precess::{Keep, Plan, Scenario, Workers, ensemble, hash, run, value::Value};
use std::ops::ControlFlow;

/// The pendulum over magnets, copied, with one operation changed.
#[derive(Clone, Copy, Debug)]
enum Copied {
    Faithful,
    Fused,
    Reordered,
    Relaxed,
}

/// `a b + c` with the product's rounding error taken along (Dekker), as a fused multiply-add would.
fn fused<S: Scalar>(a: S, b: S, c: S) -> S {
    let split = |x: S| {
        let scaled = x * 134217729.0;
        let high = scaled - (scaled - x);
        (high, x - high)
    };
    let product = a * b;
    let ((a1, a0), (b1, b0)) = (split(a), split(b));
    let lost = ((a1 * b1 - product) + a1 * b0 + a0 * b1) + a0 * b0;
    let sum = product + c;
    let part = sum - product;
    let rest = (product - (sum - part)) + (c - part);
    sum + (rest + lost)
}

impl System for Copied {
    fn card(&self) -> Card {
        plan().card
    }

    fn equations<S: Scalar>(&self, s: &State<S>, highest: &mut [S]) {
        let ([x, y], [x_dot, y_dot], [c, r, d]) = (s.q(), s.v(), s.p());
        let mut ax = -(c * x) - r * x_dot;
        let mut ay = -(c * y) - r * y_dot;
        for &[xk, yk, strength] in s.rows(0) {
            let (dx, dy) = (xk - x, yk - y);
            let square = match self {
                Self::Fused => fused(dx, dx, dy * dy) + d * d,
                Self::Reordered => dx * dx + (dy * dy + d * d),
                _ => dx * dx + dy * dy + d * d,
            };
            let cube = square * square.sqrt();
            let pull =
                if let Self::Relaxed = self { strength * (S::from(1.0) / cube) } else { strength / cube };
            ax = ax + pull * dx;
            ay = ay + pull * dy;
        }
        highest.copy_from_slice(&[ax, ay]);
    }
}

fn plan() -> Plan {
    let mut scenario = Scenario::of("magnetic_pendulum");
    scenario.method = Some("verlet".into());
    // Strengths of one would hide the relaxed division.
    scenario.parameters = vec![
        ("r".into(), Value::number(0.0)),
        ("magnets".into(), precess::value::parse("[[0.5; 0; 0.9]; [-0.25; 0.433; 1.1]]").expect("a list")),
    ];
    // With short steps a last bit of the acceleration is lost in the velocity; these are long, and chaos does the rest.
    let numbers = [("dt", 0.01), ("until", 100.0), ("every", 10.0)];
    scenario.run = numbers.map(|(name, x)| (name.into(), Value::number(x))).to_vec();
    Plan::new(&scenario).expect("a plan")
}

/// The hash of the run alone and of the run in the lanes of every instruction set.
fn hashes(plan: &Plan) -> Vec<String> {
    let alone = hash(&run(plan, &mut |_| ControlFlow::Continue(())).trajectory);
    let in_lanes = Isa::available().into_iter().map(|isa| {
        let (workers, go_on) = (Workers { isa, threads: 1 }, &mut |_| ControlFlow::Continue(()));
        ensemble(plan, &plan.start, Keep::Samples, workers, go_on).expect("no watches").hash(0)
    });
    std::iter::once(alone).chain(in_lanes).collect()
}

#[test]
fn a_hash_sees_one_rounding() {
    let sound = hashes(&plan());
    assert!(sound.iter().all(|hash| *hash == sound[0]), "{sound:?}");
    let with = |copied: &'static Copied| hashes(&Plan { system: copied, ..plan() });
    assert_eq!(with(&Copied::Faithful), sound, "the copy is no copy");
    for copied in [&Copied::Fused, &Copied::Reordered, &Copied::Relaxed] {
        let hashes = with(copied);
        assert!(hashes.iter().all(|hash| *hash != sound[0]), "{copied:?} goes unseen: {hashes:?}");
    }
}
