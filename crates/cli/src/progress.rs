//! A progress bar where the work takes over a second, and a run that Ctrl-C ends without loss.

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use std::ops::ControlFlow;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

/// Watches a run: draws the bar and listens for Ctrl-C.
pub struct Progress {
    bar: ProgressBar,
    began: Instant,
    shown: bool,
    until: f64,
    stop: Arc<AtomicBool>,
}

/// The bar counts in thousandths of the run.
const PARTS: u64 = 1000;

impl Progress {
    /// A watch over a run until this time.
    pub fn new(until: f64, quiet: bool, stop: &Arc<AtomicBool>) -> Self {
        let target = if quiet { ProgressDrawTarget::hidden() } else { ProgressDrawTarget::stderr() };
        let bar = ProgressBar::with_draw_target(None, target);
        let style = ProgressStyle::with_template("{bar:40} {percent:>3} %  {msg}  {eta} left");
        bar.set_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()));
        Self { bar, began: Instant::now(), shown: false, until, stop: Arc::clone(stop) }
    }

    /// The run has come this far.
    pub fn at(&mut self, t: f64) -> ControlFlow<()> {
        if self.stop.load(Ordering::Relaxed) {
            return ControlFlow::Break(());
        }
        if !self.shown && self.began.elapsed() > Duration::from_secs(1) {
            self.shown = true;
            self.bar.set_length(PARTS);
        }
        if self.shown {
            let done = (t / self.until).abs() * PARTS as f64;
            self.bar.set_position(done as u64);
            self.bar.set_message(format!("t = {t:.4} s"));
        }
        ControlFlow::Continue(())
    }

    /// Takes the bar away.
    pub fn finish(&self) {
        self.bar.finish_and_clear();
    }
}

/// From now on Ctrl-C asks the run to end, and a second one ends the program.
pub fn listen() -> Arc<AtomicBool> {
    let stop = Arc::new(AtomicBool::new(false));
    let heard = Arc::clone(&stop);
    // Without a handler Ctrl-C ends the program at once, which is no worse than before.
    let _ = ctrlc::set_handler(move || {
        if heard.swap(true, Ordering::Relaxed) {
            std::process::exit(130);
        }
    });
    stop
}
