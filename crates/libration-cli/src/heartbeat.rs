//! Progress display of commands that take long and report no progress themselves.

use crate::terminal::Terminal;
use std::sync::Arc;
use std::sync::mpsc::{Receiver, RecvTimeoutError, channel};
use std::thread::{JoinHandle, spawn};
use std::time::{Duration, Instant};

/// Progress display of commands that take long and report no progress themselves.
pub(crate) struct Heartbeat {
    /// The channel that is closed at the end of the work.
    at_work: std::sync::mpsc::Sender<()>,
    beating: Option<JoinHandle<()>>,
}

impl Heartbeat {
    /// Time between two updates.
    const BEAT: Duration = Duration::from_secs(1);

    pub(crate) fn begin(terminal: &Arc<Terminal>) -> Self {
        let (at_work, work) = channel();
        let terminal = Arc::clone(terminal);
        let beating = terminal.progress_is_seen.then(|| spawn(move || beat(&work, &terminal)));
        Self { at_work, beating }
    }

    pub(crate) fn end(self) {
        let Self { at_work, beating } = self;
        drop(at_work);
        if let Some(beating) = beating {
            // A failed progress display does not fail the run.
            let _ = beating.join();
        }
    }
}

fn beat(work: &Receiver<()>, terminal: &Terminal) {
    let begin = Instant::now();
    while work.recv_timeout(Heartbeat::BEAT) == Err(RecvTimeoutError::Timeout) {
        let seconds = begin.elapsed().as_secs();
        if seconds > 1 && terminal.is_silent(Heartbeat::BEAT / 2) {
            terminal.show(Some(&format!("running for {seconds} s; Ctrl-C stops it")));
        }
    }
    terminal.show(None);
}
