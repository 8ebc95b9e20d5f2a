//! A lane gives the bits of the plain number, whatever its neighbours are.

mod support;

use precess_scalar::{Batch, Scalar};
use support::{Random, SPECIAL};

fn same(a: f64, b: f64) -> bool {
    a.to_bits() == b.to_bits() || a.is_nan() && b.is_nan()
}

/// Ordinary, huge and special numbers mixed.
fn argument(random: &mut Random) -> f64 {
    match random.bits() % 6 {
        0 => random.finite(),
        1 => SPECIAL[random.bits() as usize % SPECIAL.len()],
        2 => random.between(-1.0, 1.0),
        3 => random.between(-1e7, 1e7),
        _ => random.between(-20.0, 20.0),
    }
}

/// Every function of the trait on one pair of numbers, in a fixed order.
fn everything<S: Scalar>(x: S, y: S) -> Vec<S> {
    let (sin, cos) = x.sin_cos();
    let less = x.lt(y);
    let at_most = x.le(y);
    vec![
        -x,
        x + y,
        x - y,
        x * y,
        x / y,
        x + 0.3,
        x - 0.3,
        x * 0.3,
        x / 0.3,
        S::from(0.3),
        sin,
        cos,
        x.sin(),
        x.cos(),
        x.tan(),
        x.atan2(y),
        x.asin(),
        x.acos(),
        x.exp(),
        x.ln(),
        x.sinh(),
        x.cosh(),
        x.tanh(),
        x.powi(0),
        x.powi(7),
        x.powi(-3),
        x.powf(y),
        x.abs().powf(y),
        x.cbrt(),
        x.hypot(y),
        x.abs(),
        x.sqrt(),
        x.sign(),
        x.larger(y),
        x.smaller(y),
        x.squared(),
        S::select(less, x, y),
        S::select(at_most, x, y),
        S::select(!less & at_most, x, y),
        S::select(less | x.gt(y), x, y),
    ]
}

fn lanes_agree<const W: usize>() {
    let mut random = Random(W as u64);
    for _ in 0..20_000 / W {
        let x: [f64; W] = std::array::from_fn(|_| argument(&mut random));
        let y: [f64; W] = std::array::from_fn(|_| argument(&mut random));
        let blocks = everything(Batch(x), Batch(y));
        for lane in 0..W {
            for (i, plain) in everything(x[lane], y[lane]).into_iter().enumerate() {
                let value = blocks[i].0[lane];
                assert!(
                    same(value, plain),
                    "entry {i} at {:e}, {:e}: {value:e}, {plain:e}",
                    x[lane],
                    y[lane]
                );
            }
        }
    }
}

#[test]
fn one_lane() {
    lanes_agree::<1>();
}

#[test]
fn four_lanes() {
    lanes_agree::<4>();
}

#[test]
fn eight_lanes() {
    lanes_agree::<8>();
}

#[test]
fn thirty_two_lanes() {
    lanes_agree::<32>();
}

#[test]
fn masks() {
    let x = Batch([1.0, 2.0, 3.0, f64::NAN]);
    let mask = x.lt(Batch::splat(2.5));
    assert!(mask.any() && !mask.all());
    assert_eq!([0, 1, 2, 3].map(|i| mask.lane(i)), [true, true, false, false]);
    assert_eq!(Batch::select(!mask, x * 10.0, Batch::from(0.0)).0[..3], [0.0, 0.0, 30.0]);
}
