//! Command as a program: the standard streams, Ctrl-C, the progress of long work, the exit status.

use crate::call::{self, Call};
use crate::host::Host;
use crate::query_error::{self, QueryError};
use crate::{answer, command};
use std::ffi::OsString;
use std::io::{self, IsTerminal, Read, Write, stderr, stdin, stdout};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{Receiver, RecvTimeoutError, channel};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread::{JoinHandle, spawn};
use std::time::{Duration, Instant};

/// Answers the arguments of a command line, which begin behind the name of the program, on the standard output; the exit status.
///
/// Ctrl-C asks for an early end of what takes long; pressed again it ends the process at once.
pub fn program(arguments: impl IntoIterator<Item = OsString>) -> u8 {
    let terminal = Arc::new(Terminal::new());
    let arguments: Vec<OsString> = arguments.into_iter().collect();
    let call = Call::new(arguments.clone(), terminal.clone());
    call::within(&call, || match command::question(arguments) {
        Ok(question) => {
            let heartbeat = Heartbeat::begin(&terminal);
            let answered = answer(&question);
            heartbeat.end();
            answered.map_or_else(|failure| report(&failure), |()| 0)
        }
        Err(error) => refuse(&error),
    })
}

/// Ends a command whose arguments are not understood, or whose help is asked for, as clap has it.
fn refuse(error: &clap::Error) -> u8 {
    let shown = query_error::refusal(error);
    // Nothing is left to be done when a stream is closed.
    let _ = match !error.use_stderr() || shown == error.render().to_string() {
        true => error.print(),
        false => write!(stderr(), "{shown}"),
    };
    u8::try_from(error.exit_code()).unwrap_or(1)
}

/// Writes the message to the error stream and gives the exit status.
fn report(failure: &QueryError) -> u8 {
    if !failure.is_closed_pipe() {
        // Nothing is left to be done when even the error stream is closed.
        let _ = writeln!(stderr(), "error: {failure}");
    }
    failure.status()
}

static INTERRUPTED: AtomicBool = AtomicBool::new(false);

/// The standard streams.
struct Terminal {
    answers_are_seen: bool,
    progress_is_seen: bool,
    line: Mutex<Line>,
}

/// The line of progress, which is written over and over.
struct Line {
    /// `true` if the result has begun on the terminal, where progress would stand among its lines.
    is_over: bool,
    shown: Option<Instant>,
}

impl Terminal {
    fn new() -> Self {
        let progress_is_seen = stderr().is_terminal();
        Self {
            answers_are_seen: progress_is_seen && stdout().is_terminal(),
            progress_is_seen,
            line: Mutex::new(Line { is_over: false, shown: None }),
        }
    }

    fn show(&self, text: Option<&str>) {
        let mut line = self.line.lock().unwrap_or_else(PoisonError::into_inner);
        if self.progress_is_seen && !line.is_over && (text.is_some() || line.shown.is_some()) {
            line.write(text);
        }
    }

    /// Returns `true` if no progress was shown for this time.
    fn is_silent(&self, since: Duration) -> bool {
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
        // A note that cannot be written does not end the run.
        let _ = writeln!(stderr(), "note: {sentence}");
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

    /// `COLUMNS` where it is set, else those of the terminal, else 80: files and pipes do not change with the window.
    fn columns(&self) -> usize {
        const USUAL: usize = 80;
        let said = std::env::var("COLUMNS").ok().and_then(|text| text.trim().parse().ok());
        let of_terminal = || terminal_size::terminal_size_of(stdout()).map(|(width, _)| usize::from(width.0));
        said.or_else(of_terminal).unwrap_or(USUAL)
    }
}

/// The progress of commands that are long at work and show no progress of their own.
struct Heartbeat {
    /// Hangs up when the work has ended.
    at_work: std::sync::mpsc::Sender<()>,
    beating: Option<JoinHandle<()>>,
}

impl Heartbeat {
    /// Time between two looks.
    const BEAT: Duration = Duration::from_secs(1);

    fn begin(terminal: &Arc<Terminal>) -> Self {
        let (at_work, work) = channel();
        let terminal = Arc::clone(terminal);
        let beating = terminal.progress_is_seen.then(|| spawn(move || beat(&work, &terminal)));
        Self { at_work, beating }
    }

    fn end(self) {
        let Self { at_work, beating } = self;
        drop(at_work);
        if let Some(beating) = beating {
            // A failed display of progress does not fail the run.
            let _ = beating.join();
        }
    }
}

fn beat(work: &Receiver<()>, terminal: &Terminal) {
    let begin = Instant::now();
    while work.recv_timeout(Heartbeat::BEAT) == Err(RecvTimeoutError::Timeout) {
        let seconds = begin.elapsed().as_secs();
        if seconds > 1 && terminal.is_silent(Heartbeat::BEAT / 2) {
            terminal.show(Some(&format!("at work for {seconds} s; Ctrl-C ends it")));
        }
    }
    terminal.show(None);
}
