//! Every elementary function, over a thousand arguments in the cache.

use crate::clock::{alone, repeats, seconds, shortest};
use crate::{Error, Settings, Table};
use precess::scalar::{Isa, Kernel, Lanes, Scalar, with_lanes};
use std::hint::black_box;

/// Arguments of a function: as many as fit the fastest cache together with the results.
pub const ARGUMENTS: usize = 1024;

/// A function as it is measured.
pub trait Function {
    /// Its name.
    const NAME: &'static str;
    /// Its arguments lie between these.
    const RANGE: (f64, f64);
    /// Its value.
    fn of<S: Scalar>(x: S) -> S;
}

macro_rules! functions {
    ($($type:ident $name:literal $low:literal $high:literal |$x:ident| $value:expr;)*) => {
        $(
            #[doc = concat!("`", $name, "`.")]
            pub struct $type;
            impl Function for $type {
                const NAME: &'static str = $name;
                const RANGE: (f64, f64) = ($low, $high);
                #[inline(always)]
                fn of<S: Scalar>($x: S) -> S {
                    $value
                }
            }
        )*
        /// The functions by name, each with its measurement.
        const FUNCTIONS: &[(&str, fn(Isa, u32) -> f64)] = &[$(($name, time::<$type>)),*];
    };
}

functions! {
    SinCos "sin_cos" -10.0 10.0 |x| { let (sin, cos) = x.sin_cos(); sin + cos };
    Tan "tan" -10.0 10.0 |x| x.tan();
    Asin "asin" -1.0 1.0 |x| x.asin();
    Acos "acos" -1.0 1.0 |x| x.acos();
    Atan2 "atan2" -3.0 3.0 |x| x.atan2(S::from(1.1));
    Exp "exp" -20.0 20.0 |x| x.exp();
    Ln "ln" 0.01 100.0 |x| x.ln();
    Sinh "sinh" -5.0 5.0 |x| x.sinh();
    Cosh "cosh" -5.0 5.0 |x| x.cosh();
    Tanh "tanh" -5.0 5.0 |x| x.tanh();
    Powf "powf" 0.1 10.0 |x| x.powf(S::from(1.7));
    Powi "powi" 0.1 10.0 |x| x.powi(5);
    Cbrt "cbrt" -10.0 10.0 |x| x.cbrt();
    Hypot "hypot" -10.0 10.0 |x| x.hypot(S::from(1.1));
    Sqrt "sqrt" 0.01 100.0 |x| x.sqrt();
}

/// The k-th argument: spread evenly, and in no order that a predictor of branches could learn.
pub fn argument(k: usize, (low, high): (f64, f64)) -> f64 {
    let shuffled = (k * 389) % ARGUMENTS;
    low + (high - low) * ((shuffled as f64 + 0.5) / ARGUMENTS as f64)
}

struct Sweep<'a, S, F> {
    x: &'a [S],
    y: &'a mut [S],
    times: u32,
    function: std::marker::PhantomData<F>,
}

impl<S: Lanes, F: Function> Kernel for Sweep<'_, S, F> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        for _ in 0..self.times {
            for (x, y) in black_box(self.x).iter().zip(self.y.iter_mut()) {
                *y = F::of(alone(*x));
            }
            black_box(&mut *self.y);
        }
    }
}

fn sweep<S: Lanes, F: Function>(times: u32) -> f64 {
    let at = |k: usize| S::from_lanes(|lane| argument(k * S::LANES + lane, F::RANGE));
    let x: Vec<S> = (0..ARGUMENTS / S::LANES).map(at).collect();
    let mut y = x.clone();
    seconds(|| S::enter(Sweep::<S, F> { x: &x, y: &mut y, times, function: std::marker::PhantomData }))
}

/// How long so many sweeps over all arguments take, in seconds.
pub fn time<F: Function>(isa: Isa, times: u32) -> f64 {
    with_lanes!(isa, S => sweep::<S, F>(times))
}

/// Every function in every set of registers.
pub(crate) fn measure(settings: &Settings, progress: &mut dyn FnMut(&str)) -> Result<Vec<Table>, Error> {
    let isas = &settings.isas;
    let title = "a value of a function, ratio to plain numbers";
    let mut table = Table::of_lanes("elementary", title, isas);
    for (name, time) in FUNCTIONS {
        progress(&format!("elementary: {name}"));
        let times = repeats(settings.effort.spell / 4.0, |times| Ok(time(Isa::Scalar, times)))?;
        let best = shortest(settings.effort.rounds, isas.len(), |k| Ok(time(isas[k], times)))?;
        let values = ARGUMENTS as f64 * f64::from(times);
        let ns: Vec<f64> = best.iter().map(|s| s * 1e9 / values).collect();
        table.row_of_lanes(name, &ns);
    }
    table.note_least_gain(isas);
    Ok(vec![table])
}
