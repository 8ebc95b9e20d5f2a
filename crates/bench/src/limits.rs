//! What one core of this machine can do at most: divisions, roots, multiply-adds in independent chains.
//!
//! Nothing that divides can be faster than the divider, however wide its registers: a factor between two sets of
//! registers here bounds what lanes can gain in a system.

use crate::clock::{alone, repeats, seconds, shortest};
use crate::{Column, Error, Kind, Settings, Table};
use precess::scalar::{Isa, Kernel, Lanes, with_lanes};
use std::hint::black_box;

/// A step of a chain. The constants keep the numbers away from those that a divider finishes early.
trait Operation {
    fn apply<S: Lanes>(x: S, a: S, b: S) -> S;
}

struct Divide;
impl Operation for Divide {
    #[inline(always)]
    fn apply<S: Lanes>(x: S, a: S, _: S) -> S {
        a / alone(x)
    }
}

struct Root;
impl Operation for Root {
    #[inline(always)]
    fn apply<S: Lanes>(x: S, a: S, _: S) -> S {
        (a * alone(x)).sqrt()
    }
}

struct RootThenDivide;
impl Operation for RootThenDivide {
    #[inline(always)]
    fn apply<S: Lanes>(x: S, a: S, _: S) -> S {
        a / alone(x).sqrt()
    }
}

/// A product and a sum, each rounded: a fused one would give other bits. Compilers leave plain ones alone here, and a
/// detour through memory would be slower than they are.
struct MultiplyAdd;
impl Operation for MultiplyAdd {
    #[inline(always)]
    fn apply<S: Lanes>(x: S, a: S, b: S) -> S {
        a * x + b
    }
}

/// Chains that wait for nobody but themselves.
struct Chains<S, O, const N: usize> {
    times: u32,
    number: std::marker::PhantomData<(S, O)>,
}

impl<S: Lanes, O: Operation, const N: usize> Kernel for Chains<S, O, N> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        let (a, b) = black_box((S::from(0.737), S::from(0.419)));
        let mut chains: [S; N] = black_box(std::array::from_fn(|k| S::from(1.3 + 0.1 * k as f64)));
        for _ in 0..self.times {
            for x in &mut chains {
                *x = O::apply(*x, a, b);
            }
        }
        black_box(chains);
    }
}

/// Twelve registers are busy, which hides every latency and leaves room for the constants: numbers with lanes are pairs
/// of registers.
const REGISTERS: usize = 12;

fn run<S: Lanes, O: Operation>(times: u32) {
    let number = std::marker::PhantomData;
    if S::LANES == 1 {
        S::enter(Chains::<S, O, REGISTERS> { times, number });
    } else {
        S::enter(Chains::<S, O, { REGISTERS / 2 }> { times, number });
    }
}

fn time<O: Operation>(isa: Isa, times: u32) -> f64 {
    seconds(|| with_lanes!(isa, S => run::<S, O>(times)))
}

fn chains(isa: Isa) -> f64 {
    if isa == Isa::Scalar { REGISTERS as f64 } else { (REGISTERS / 2 * isa.lanes()) as f64 }
}

/// Numbers a second in every set of registers, in 1e9.
fn rates<O: Operation>(settings: &Settings) -> Result<Vec<f64>, Error> {
    let isas = &settings.isas;
    let times = repeats(settings.effort.spell / 4.0, |times| Ok(time::<O>(Isa::Scalar, times)))?;
    let best = shortest(settings.effort.rounds, isas.len(), |k| Ok(time::<O>(isas[k], times)))?;
    Ok(isas.iter().zip(best).map(|(isa, s)| chains(*isa) * f64::from(times) / s * 1e-9).collect())
}

/// Roots, each followed by a division, in 1e9 a second.
pub fn roots_then_divisions(settings: &Settings) -> Result<Vec<f64>, Error> {
    rates::<RootThenDivide>(settings)
}

/// What the machine can do.
pub fn measure(settings: &Settings, progress: &mut dyn FnMut(&str)) -> Result<Vec<Table>, Error> {
    progress("limits");
    let operations = [
        ("divide", "divide", rates::<Divide>(settings)?),
        ("root", "root", rates::<Root>(settings)?),
        ("root_then_divide", "root, divide", rates::<RootThenDivide>(settings)?),
        ("multiply_add", "multiply, add", rates::<MultiplyAdd>(settings)?),
    ];
    let ratio =
        |(name, heading, _): &(&str, &str, _)| Column::new(format!("{name}_ratio"), *heading, Kind::Ratio);
    let rate = |(name, heading, _): &(&str, &str, _)| {
        Column::new(format!("{name}_rate"), format!("{heading} 1e9/s"), Kind::Number)
    };
    let columns = operations.iter().map(ratio).chain(operations.iter().map(rate)).collect();
    let title = "one core of this machine at most, ratio to plain numbers";
    let mut table = Table::new("limits", title, columns);
    for (k, isa) in settings.isas.iter().enumerate() {
        let ratios = operations.iter().map(|(_, _, rates)| Some(rates[k] / rates[0]));
        table.row(isa.name(), ratios.chain(operations.iter().map(|(_, _, rates)| Some(rates[k]))));
    }
    Ok(vec![table])
}
