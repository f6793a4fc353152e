//! The terminal as the host of a run: standard streams, progress line, Ctrl-C, width of tables.

use libration_queries::{Host, QueryError};
use std::io::{self, IsTerminal, Read, Write, stderr, stdin, stdout};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Mutex, PoisonError};
use std::time::{Duration, Instant};

static INTERRUPTED: AtomicBool = AtomicBool::new(false);

/// The standard streams.
pub(crate) struct Terminal {
    is_quiet: bool,
    answers_are_seen: bool,
    pub(crate) progress_is_seen: bool,
    line: Mutex<Line>,
}

/// The progress line, which is overwritten repeatedly.
struct Line {
    /// `true` if output has begun on the terminal, where a progress line would appear between its lines.
    is_over: bool,
    shown: Option<Instant>,
}

impl Terminal {
    /// The terminal, without notes and progress if `is_quiet`.
    pub(crate) fn new(is_quiet: bool) -> Self {
        let progress_is_seen = !is_quiet && stderr().is_terminal();
        Self {
            is_quiet,
            answers_are_seen: progress_is_seen && stdout().is_terminal(),
            progress_is_seen,
            line: Mutex::new(Line { is_over: false, shown: None }),
        }
    }

    pub(crate) fn show(&self, text: Option<&str>) {
        let mut line = self.line.lock().unwrap_or_else(PoisonError::into_inner);
        if self.progress_is_seen && !line.is_over && (text.is_some() || line.shown.is_some()) {
            line.write(text);
        }
    }

    /// Returns `true` if no progress was shown for this duration.
    pub(crate) fn is_silent(&self, since: Duration) -> bool {
        let line = self.line.lock().unwrap_or_else(PoisonError::into_inner);
        !line.is_over && line.shown.is_none_or(|shown| shown.elapsed() >= since)
    }
}

impl Line {
    /// Writes the line; a failure is ignored.
    fn write(&mut self, text: Option<&str>) {
        let _ = write!(stderr(), "\r{}\x1b[K", text.unwrap_or_default());
        self.shown = text.map(|_| Instant::now());
    }
}

impl Host for Terminal {
    fn write(&self, bytes: &[u8]) -> io::Result<()> {
        if self.answers_are_seen {
            let mut line = self.line.lock().unwrap_or_else(PoisonError::into_inner);
            if line.shown.is_some() {
                line.write(None);
            }
            line.is_over = true;
        }
        let mut out = stdout().lock();
        out.write_all(bytes)?;
        out.flush()
    }

    fn read(&self) -> Box<dyn Read + '_> {
        Box::new(stdin().lock())
    }

    fn note(&self, sentence: &str) {
        if !self.is_quiet {
            // A note that cannot be written does not end the run.
            let _ = writeln!(stderr(), "note: {sentence}");
        }
    }

    fn progress(&self, how_far: Option<&str>) {
        self.show(how_far);
    }

    fn listen(&self) -> io::Result<()> {
        let heard = || {
            if INTERRUPTED.swap(true, Ordering::Relaxed) {
                std::process::exit(i32::from(QueryError::INTERRUPTED));
            }
        };
        ctrlc::set_handler(heard).map_err(io::Error::other)
    }

    fn goes_on(&self) -> bool {
        !INTERRUPTED.load(Ordering::Relaxed)
    }

    /// `COLUMNS` if it is set, otherwise the width of the terminal, otherwise 80; the output to files and pipes does not depend on the window.
    fn columns(&self) -> usize {
        const USUAL: usize = 80;
        let said = std::env::var("COLUMNS").ok().and_then(|text| text.trim().parse().ok());
        let of_terminal = || terminal_size::terminal_size_of(stdout()).map(|(width, _)| usize::from(width.0));
        said.or_else(of_terminal).unwrap_or(USUAL)
    }
}
