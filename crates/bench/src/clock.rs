//! The measuring loop: contenders take turns, and the shortest time of each counts.
//!
//! Frameworks (criterion, divan) measure one thing after another and report how times scatter. Here only ratios
//! matter, and on a shared machine the clock and the neighbours change within seconds: what is to be compared must
//! run in turns. The same loop serves the program and `cargo bench`, and costs no minute of compilation.

use crate::Error;
use precess::scalar::Lanes;
use std::hint::black_box;
use std::time::Instant;

/// How long it took, in seconds.
pub fn seconds(work: impl FnOnce()) -> f64 {
    let began = Instant::now();
    work();
    began.elapsed().as_secs_f64()
}

/// The shortest time of each contender over some rounds of turns.
///
/// # Errors
/// Where a contender fails.
pub fn shortest(
    rounds: usize,
    contenders: usize,
    mut time: impl FnMut(usize) -> Result<f64, Error>,
) -> Result<Vec<f64>, Error> {
    let mut best = vec![f64::INFINITY; contenders];
    for _ in 0..rounds {
        for (contender, best) in best.iter_mut().enumerate() {
            let taken = time(contender)?;
            if taken < *best {
                *best = taken;
            }
        }
    }
    Ok(best)
}

/// How often the work must be repeated to last for about so many seconds.
///
/// # Errors
/// Where the work fails.
pub fn repeats(spell: f64, mut time: impl FnMut(u32) -> Result<f64, Error>) -> Result<u32, Error> {
    let mut times = 1;
    loop {
        let taken = time(times)?;
        // A quarter is enough to tell: the start of the clock and of the work no longer count.
        if taken > spell / 4.0 || times > u32::MAX / 4 {
            let whole = (f64::from(times) * spell / taken).ceil();
            return Ok(if whole < 1.0 { 1 } else { whole as u32 });
        }
        times *= 2;
    }
}

/// Hides from the compiler that a plain number has neighbours: it would put them into registers side by side, and the
/// measurement would be one of lanes.
#[inline(always)]
pub fn alone<S: Lanes>(x: S) -> S {
    if S::LANES == 1 { black_box(x) } else { x }
}
