//! Progress of long work on a terminal, and nothing elsewhere.

use crate::interrupt;
use std::io::{self, IsTerminal, Write, stderr, stdout};
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::mpsc::{Receiver, RecvTimeoutError, Sender, channel};
use std::thread::{JoinHandle, spawn};
use std::time::{Duration, Instant};

/// Whether the answer has begun on the terminal, where progress would stand among its lines.
static QUIET: AtomicBool = AtomicBool::new(false);
/// How many pieces of work show their own progress.
static SHOWING: AtomicUsize = AtomicUsize::new(0);

/// Work that ends sooner shows nothing.
const SILENCE: Duration = Duration::from_secs(1);
/// Time between two lines.
const PAUSE: Duration = Duration::from_millis(200);

/// A line of the error stream that is written over and over, and cleared in the end.
#[derive(Debug)]
pub(crate) struct ProgressLine {
    due: Option<Instant>,
    shown: bool,
}

impl ProgressLine {
    pub(crate) fn new() -> Self {
        SHOWING.fetch_add(1, Ordering::Relaxed);
        Self { due: stderr().is_terminal().then(|| Instant::now() + SILENCE), shown: false }
    }

    /// One where the answer itself is not seen.
    pub(crate) fn beside_the_answer() -> Option<Self> {
        (!stdout().is_terminal()).then(Self::new)
    }

    /// Shows how far the work is, if it is time.
    pub(crate) fn show(&mut self, how_far: impl FnOnce() -> String) {
        if self.due.is_some_and(|due| Instant::now() >= due) && !QUIET.load(Ordering::Relaxed) {
            write_line(&how_far());
            self.due = Some(Instant::now() + PAUSE);
            self.shown = true;
        }
    }
}

/// The items one by one until somebody asks for an early end. Progress is shown where the answer itself is not seen.
pub(crate) fn watched<T>(
    items: impl Iterator<Item = T>,
    all: usize,
    what: &'static str,
) -> impl Iterator<Item = T> {
    let mut progress = ProgressLine::beside_the_answer();
    let counted = items.enumerate().map(move |(place, item)| {
        if let Some(progress) = &mut progress {
            progress.show(|| format!("{place} of {all} {what}"));
        }
        item
    });
    counted.take_while(|_| !interrupt::asked())
}

impl Drop for ProgressLine {
    fn drop(&mut self) {
        SHOWING.fetch_sub(1, Ordering::Relaxed);
        if self.shown {
            write_line("");
        }
    }
}

/// Replaces the line of progress. One that cannot be written is no reason to stop.
fn write_line(text: &str) {
    let _ = write!(stderr(), "\r{text}\x1b[K");
}

/// A sign of life of commands that are long at work and show no progress of their own.
#[derive(Debug)]
pub(crate) struct Heartbeat {
    /// Hangs up when the work has ended.
    at_work: Sender<()>,
    beating: Option<JoinHandle<()>>,
}

impl Heartbeat {
    /// Time between two looks.
    const BEAT: Duration = Duration::from_secs(1);

    pub(crate) fn begin() -> Self {
        let (at_work, work) = channel();
        let beating = stderr().is_terminal().then(|| spawn(move || beat(&work)));
        Self { at_work, beating }
    }

    pub(crate) fn end(self) {
        let Self { at_work, beating } = self;
        drop(at_work);
        if let Some(beating) = beating {
            // A sign of life that failed is no reason to fail.
            let _ = beating.join();
        }
    }
}

fn beat(work: &Receiver<()>) {
    let begin = Instant::now();
    let mut shown = false;
    while work.recv_timeout(Heartbeat::BEAT) == Err(RecvTimeoutError::Timeout) {
        let is_silent = SHOWING.load(Ordering::Relaxed) == 0 && !QUIET.load(Ordering::Relaxed);
        let seconds = begin.elapsed().as_secs();
        if is_silent && seconds > 1 {
            write_line(&format!("at work for {seconds} s; Ctrl-C ends it"));
            shown = true;
        }
    }
    if shown && !QUIET.load(Ordering::Relaxed) {
        write_line("");
    }
}

/// The standard output. Where it is a terminal its first bytes end every line of progress.
#[derive(Debug)]
pub(crate) struct Screen<W: Write> {
    out: W,
    is_terminal: bool,
}

impl<W: Write + IsTerminal> Screen<W> {
    pub(crate) fn new(out: W) -> Self {
        Self { is_terminal: out.is_terminal() && stderr().is_terminal(), out }
    }
}

impl<W: Write> Write for Screen<W> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        if self.is_terminal && !QUIET.swap(true, Ordering::Relaxed) {
            write_line("");
        }
        self.out.write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.out.flush()
    }
}
