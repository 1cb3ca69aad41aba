//! How far long work has come: a line on standard error, where a person looks on.

use crate::files::Out;
use std::io::{self, IsTerminal, Write};
use std::time::{Duration, Instant};

/// Work that takes less shows nothing.
const PATIENCE: Duration = Duration::from_millis(500);
/// Between two lines.
const REST: Duration = Duration::from_millis(100);
/// Back to the beginning of the terminal's line, and clear it.
const CLEAR: &str = "\r\x1b[K";

/// Steps of work of which only the share that is done is known.
pub const PARTS: u64 = 100;

/// The steps that this share, from 0 to 1, is of [`PARTS`].
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "a share from 0 to 1"
)]
pub fn part(share: f64) -> u64 {
    (PARTS as f64 * share) as u64
}

/// Work in so many steps.
pub struct Progress {
    what: &'static str,
    steps: u64,
    began: Instant,
    next: Instant,
    /// Is a terminal there to show it?
    seen: bool,
    shown: bool,
}

impl Progress {
    /// `what` is one step, such as a frame.
    pub fn new(what: &'static str, steps: u64) -> Self {
        let began = Instant::now();
        Self {
            what,
            steps,
            began,
            next: began + PATIENCE,
            seen: io::stderr().is_terminal(),
            shown: false,
        }
    }

    /// The same for work that writes as it goes: on a terminal its output is progress enough.
    pub fn beside(mut self, out: &Out) -> Self {
        self.seen &= !out.is_terminal();
        self
    }

    /// So many steps are done.
    pub fn at(&mut self, done: u64) {
        if !self.seen {
            return;
        }
        let now = Instant::now();
        if now >= self.next {
            self.next = now + REST;
            self.shown = true;
            let line = line(self.what, done, self.steps, now - self.began);
            let _ = write!(io::stderr(), "{CLEAR}{line}");
        }
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        if self.shown {
            let _ = write!(io::stderr(), "{CLEAR}");
        }
    }
}

/// `frame 120 of 500, 24 %, 1 min 12 s left`
fn line(what: &str, done: u64, steps: u64, spent: Duration) -> String {
    let share = done as f64 / steps.max(1) as f64;
    let percent = (100.0 * share).floor();
    let left = if done == 0 {
        String::new()
    } else {
        let seconds = (spent.as_secs_f64() * (1.0 - share) / share).ceil();
        let (minutes, seconds) = ((seconds / 60.0).floor(), seconds % 60.0);
        if minutes > 0.0 {
            format!(", {minutes} min {seconds} s left")
        } else {
            format!(", {seconds} s left")
        }
    };
    format!("{what} {done} of {steps}, {percent} %{left}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn says_how_far_and_how_long() {
        let spent = Duration::from_secs(30);
        assert_eq!(line("frame", 0, 500, spent), "frame 0 of 500, 0 %");
        assert_eq!(
            line("frame", 120, 500, spent),
            "frame 120 of 500, 24 %, 1 min 35 s left"
        );
        assert_eq!(
            line("frame", 499, 500, spent),
            "frame 499 of 500, 99 %, 1 s left"
        );
    }
}
