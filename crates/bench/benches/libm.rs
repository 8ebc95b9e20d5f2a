//! The elementary functions beside those of the crate `libm`, which are portable, too, but know no lanes.

use precess::scalar::Isa;
use precess_bench::elementary::{self, ARGUMENTS, Function, argument};
use precess_bench::{Column, Effort, Error, Kind, Table, clock};
use std::hint::black_box;

/// How long so many sweeps of a function of `libm` take.
fn theirs(function: fn(f64) -> f64, range: (f64, f64), times: u32) -> f64 {
    let x: Vec<f64> = (0..ARGUMENTS).map(|k| argument(k, range)).collect();
    let mut y = x.clone();
    clock::seconds(|| {
        for _ in 0..times {
            for (x, y) in black_box(&x).iter().zip(&mut y) {
                *y = function(*x);
            }
            black_box(&mut y);
        }
    })
}

fn row<F: Function>(table: &mut Table, function: fn(f64) -> f64) -> Result<(), Error> {
    let effort = Effort::QUICK;
    let times = clock::repeats(effort.spell / 4.0, |times| Ok(theirs(function, F::RANGE, times)))?;
    let best = clock::shortest(effort.rounds, 3, |k| {
        Ok(match k {
            0 => theirs(function, F::RANGE, times),
            1 => elementary::time::<F>(Isa::Scalar, times),
            _ => elementary::time::<F>(Isa::best(), times),
        })
    })?;
    let ns = |k: usize| best[k] * 1e9 / (ARGUMENTS as f64 * f64::from(times));
    table.row(F::NAME, [best[0] / best[1], best[0] / best[2], ns(0), ns(1), ns(2)].map(Some));
    Ok(())
}

fn main() -> Result<(), Error> {
    let widest = Isa::best().name();
    let columns = vec![
        Column::new("scalar_ratio", "scalar", Kind::Ratio),
        Column::new("widest_ratio", widest, Kind::Ratio),
        Column::new("libm_ns", "ns libm", Kind::Number),
        Column::new("scalar_ns", "ns scalar", Kind::Number),
        Column::new("widest_ns", format!("ns {widest}"), Kind::Number),
    ];
    let mut table = Table::new("libm", "a value of a function, how many times as fast as libm", columns);
    row::<elementary::SinCos>(&mut table, |x| {
        let (sin, cos) = libm::sincos(x);
        sin + cos
    })?;
    row::<elementary::Tan>(&mut table, libm::tan)?;
    row::<elementary::Asin>(&mut table, libm::asin)?;
    row::<elementary::Acos>(&mut table, libm::acos)?;
    row::<elementary::Atan2>(&mut table, |x| libm::atan2(x, 1.1))?;
    row::<elementary::Exp>(&mut table, libm::exp)?;
    row::<elementary::Ln>(&mut table, libm::log)?;
    row::<elementary::Sinh>(&mut table, libm::sinh)?;
    row::<elementary::Cosh>(&mut table, libm::cosh)?;
    row::<elementary::Tanh>(&mut table, libm::tanh)?;
    row::<elementary::Powf>(&mut table, |x| libm::pow(x, 1.7))?;
    row::<elementary::Cbrt>(&mut table, libm::cbrt)?;
    row::<elementary::Hypot>(&mut table, |x| libm::hypot(x, 1.1))?;
    println!("{table}");
    Ok(())
}
