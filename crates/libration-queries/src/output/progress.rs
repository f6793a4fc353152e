//! Progress of long work.

use crate::{call, interrupt};
use std::time::Duration;

/// Duration of work without a progress line.
const SILENCE: Duration = Duration::from_secs(1);
/// Time between two lines.
const PAUSE: Duration = Duration::from_millis(200);

/// A line that is written over and over, and cleared in the end.
#[derive(Debug)]
pub(crate) struct ProgressLine {
    due: Duration,
    shown: bool,
}

impl ProgressLine {
    pub(crate) fn new() -> Self {
        Self { due: now() + SILENCE, shown: false }
    }

    /// Shows the progress of the work, if it is time.
    pub(crate) fn show(&mut self, how_far: impl FnOnce() -> String) {
        if now() >= self.due {
            call::current().host().progress(Some(&how_far()));
            self.due = now() + PAUSE;
            self.shown = true;
        }
    }
}

fn now() -> Duration {
    call::current().host().now()
}

impl Drop for ProgressLine {
    fn drop(&mut self) {
        if self.shown {
            call::current().host().progress(None);
        }
    }
}

/// The items one by one until the run is cancelled, with a line of progress.
pub(crate) fn counted<T>(
    items: impl Iterator<Item = T>,
    all: usize,
    what: &'static str,
) -> impl Iterator<Item = T> {
    let mut progress = ProgressLine::new();
    let counted = items.enumerate().map(move |(index, item)| {
        progress.show(|| format!("{index} of {all} {what}"));
        item
    });
    counted.take_while(|_| !interrupt::is_cancelled())
}
