//! The run to which a thread belongs, with its data, so that simultaneous runs do not mix.
//!
//! # Method
//! The data of one run are in its `Call`, which each thread that works for it knows (`call::within`), so that simultaneous runs do not mix and end
//! independently.

use crate::host::Host;
use crate::query_error::text::Text;
use std::cell::RefCell;
use std::ffi::OsString;
use std::io::{self, Write};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, PoisonError};

thread_local! {
    static CURRENT: RefCell<Option<Arc<Call>>> = const { RefCell::new(None) };
}

/// A query while it runs.
pub struct Call {
    host: Arc<dyn Host>,
    /// Arguments as they were given.
    arguments: Vec<OsString>,
    is_output_taken: AtomicBool,
    is_cancelled: AtomicBool,
    notes: Mutex<Vec<String>>,
}

impl std::fmt::Debug for Call {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Call").field("arguments", &self.arguments).finish_non_exhaustive()
    }
}

impl Call {
    /// A question with its arguments, for a host.
    pub fn new(arguments: Vec<OsString>, host: Arc<dyn Host>) -> Arc<Self> {
        Arc::new(Self {
            host,
            arguments,
            is_output_taken: AtomicBool::new(false),
            is_cancelled: AtomicBool::new(false),
            notes: Mutex::default(),
        })
    }

    pub(crate) fn host(&self) -> &dyn Host {
        &*self.host
    }

    pub(crate) fn arguments(&self) -> &[OsString] {
        &self.arguments
    }

    /// Passes a sentence with marks to the host, unless it was passed already.
    pub(crate) fn note(&self, sentence: &str) {
        let sentence = Text::marked(sentence).in_words(self.host.words());
        let mut notes = self.notes.lock().unwrap_or_else(PoisonError::into_inner);
        if !notes.contains(&sentence) {
            self.host.note(&sentence);
            notes.push(sentence);
        }
    }

    /// Keeps the standard output for a file, so that nothing else is written to it.
    pub(crate) fn take_output(&self) {
        self.is_output_taken.store(true, Ordering::Relaxed);
    }

    /// Returns `true` once the run is cancelled, and then forever.
    pub(crate) fn is_cancelled(&self) -> bool {
        let is_cancelled = self.is_cancelled.load(Ordering::Relaxed) || !self.host.goes_on();
        if is_cancelled {
            self.is_cancelled.store(true, Ordering::Relaxed);
        }
        is_cancelled
    }
}

/// Works for a question on this thread.
pub fn within<R>(call: &Arc<Call>, work: impl FnOnce() -> R) -> R {
    let _before = Before(CURRENT.replace(Some(Arc::clone(call))));
    work()
}

/// The call that the thread has worked for before, restored when this one ends, also after a panic.
struct Before(Option<Arc<Call>>);

impl Drop for Before {
    fn drop(&mut self) {
        CURRENT.set(self.0.take());
    }
}

/// The call that this thread works for; threads without a call work for `Nobody`.
pub fn current() -> Arc<Call> {
    CURRENT.with_borrow(Option::clone).unwrap_or_else(|| Call::new(vec![], Arc::new(Nobody)))
}

/// The sentence with the names of this thread's front end in place of the marks.
pub(crate) fn in_words(marked: &str) -> String {
    Text::marked(marked).in_words(current().host().words())
}

/// Returns `true` if this thread's run is cancelled.
pub(crate) fn is_cancelled() -> bool {
    CURRENT.with_borrow(|call| call.as_ref().is_some_and(|call| call.is_cancelled()))
}

/// The host of threads outside a run.
#[derive(Debug)]
pub struct Nobody;

impl Host for Nobody {
    fn write(&self, _: &[u8]) -> io::Result<()> {
        Ok(())
    }
}

/// The output of this thread's run.
pub(crate) struct Output(Arc<Call>);

impl Output {
    pub(crate) fn new() -> Self {
        Self(current())
    }

    /// Returns `true` if a file is written to the standard output in place of the result.
    pub(crate) fn is_taken(&self) -> bool {
        self.0.is_output_taken.load(Ordering::Relaxed)
    }
}

impl Write for Output {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.0.host.write(bytes)?;
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}
