//! A lane gives the bits of the plain number, whatever its neighbours are.

mod support;

use precess_scalar::{Isa, Kernel, Lanes, Scalar, with_lanes};
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

/// The same inside [`Scalar::enter`].
struct Everything<S>(S, S);
impl<S: Lanes> Kernel for Everything<S> {
    type Output = Vec<S>;
    fn run(self) -> Vec<S> {
        everything(self.0, self.1)
    }
}

fn lanes_agree<S: Lanes>() {
    let mut random = Random(S::LANES as u64);
    for _ in 0..20_000 / S::LANES {
        let x: Vec<f64> = (0..S::LANES).map(|_| argument(&mut random)).collect();
        let y: Vec<f64> = (0..S::LANES).map(|_| argument(&mut random)).collect();
        let blocks = S::enter(Everything(S::from_lanes(|i| x[i]), S::from_lanes(|i| y[i])));
        for lane in 0..S::LANES {
            for (i, plain) in everything(x[lane], y[lane]).into_iter().enumerate() {
                let value = blocks[i].lanes()[lane];
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
fn every_width_of_this_machine() {
    for isa in Isa::available() {
        println!("{}", isa.name());
        with_lanes!(isa, S => lanes_agree::<S>());
    }
}

fn masks<S: Lanes>() {
    let x = S::from_lanes(|i| if i == 1 { f64::NAN } else { i as f64 });
    let mask = x.below(2.5);
    let truth: u32 = (0..S::LANES).filter(|&i| i != 1 && i < 3).map(|i| 1 << i).sum();
    assert_eq!(S::truth(mask), truth);
    assert_eq!(S::truth(!mask), !truth & ((1 << S::LANES) - 1));
    assert_eq!(S::truth(x.is_nan()), if S::LANES == 1 { 0 } else { 2 });
    assert!(S::any(mask) && S::all(mask | !mask) && !S::any(mask & !mask));
    assert_eq!(S::all(mask), S::LANES == 1);
    let chosen = S::select(mask, x * 10.0, S::from(-1.0));
    for (i, &chosen) in chosen.lanes().iter().enumerate() {
        assert_eq!(chosen, if truth >> i & 1 == 1 { 10.0 * i as f64 } else { -1.0 });
    }
}

#[test]
fn masks_choose_lane_by_lane() {
    for isa in Isa::available() {
        with_lanes!(isa, S => masks::<S>());
    }
}

#[test]
fn an_instruction_set_goes_by_its_name() {
    for isa in Isa::available() {
        assert_eq!(Isa::named(isa.name()), Ok(isa));
        assert_eq!(Isa::named(&isa.name().to_uppercase()), Ok(isa));
    }
    assert!(Isa::available().windows(2).all(|pair| pair[0].lanes() < pair[1].lanes()));
    let refusal = Isa::named("avx9000").expect_err("there is none").to_string();
    assert!(refusal.contains("avx9000") && refusal.contains("scalar"), "{refusal}");
}
