//! Progress of long work on a terminal, and nothing elsewhere.

use std::io::{IsTerminal, Write, stderr};
use std::time::{Duration, Instant};

/// Work that ends sooner shows nothing.
const SILENCE: Duration = Duration::from_secs(1);
/// Time between two lines.
const PAUSE: Duration = Duration::from_millis(200);

/// A line of the error stream that is written over and over, and cleared in the end.
#[derive(Debug)]
pub(crate) struct Progress {
    due: Option<Instant>,
    shown: bool,
}

impl Progress {
    pub(crate) fn new() -> Self {
        Self { due: stderr().is_terminal().then(|| Instant::now() + SILENCE), shown: false }
    }

    /// Shows how far the work is, if it is time.
    pub(crate) fn show(&mut self, how_far: impl FnOnce() -> String) {
        if self.due.is_some_and(|due| Instant::now() >= due) {
            // A line of progress that cannot be written is no reason to stop.
            let _ = write!(stderr(), "\r{}\x1b[K", how_far());
            self.due = Some(Instant::now() + PAUSE);
            self.shown = true;
        }
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        if self.shown {
            let _ = write!(stderr(), "\r\x1b[K");
        }
    }
}
