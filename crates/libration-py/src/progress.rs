//! Progress of long calls, and their cancellation by Ctrl-C.
//!
//! # Method
//! Objects of the package are frozen dataclasses of `python/libration` that hold their input data, so that they
//! can be pickled, copied, compared and printed; computed values come from a native object. Long calls release the
//! interpreter's lock and check every 20 ms whether Ctrl-C was pressed; the exception carries the completed part.

use std::ops::ControlFlow;
use std::sync::{Mutex, PoisonError};
use std::thread::{ThreadId, current};
use std::time::{Duration, Instant};

use libration::progress::{Progress, Status};
use pyo3::prelude::*;

/// Interval between checks with the interpreter, which may be busy with another thread.
const INTERVAL: Duration = Duration::from_millis(20);

/// Cancellation and progress of a long call.
pub(crate) struct CallProgress {
    /// A function that receives the progress, or `None`.
    function: Option<Py<PyAny>>,
    /// The calling thread: only there does the interpreter process signals.
    caller: ThreadId,
    state: Mutex<State>,
}

struct State {
    asked: Instant,
    stopped_by: Option<PyErr>,
}

impl CallProgress {
    pub(crate) fn new(function: Option<Py<PyAny>>) -> Self {
        let state = State { asked: Instant::now(), stopped_by: None };
        Self { function, caller: current().id(), state: Mutex::new(state) }
    }

    /// Returns `true` if the call is cancelled, without reporting progress.
    pub(crate) fn is_cancelled(&self) -> bool {
        self.consult(INTERVAL, |_, _| Ok(())).is_break()
    }

    /// Reports the progress of the call in words.
    pub(crate) fn report(&self, how_far: &str) {
        // A cancellation is detected at the next check.
        let _ = self.consult(Duration::ZERO, |py, tell| tell.call1(py, (how_far,)).map(drop));
    }

    fn consult(
        &self,
        interval: Duration,
        tell: impl FnOnce(Python<'_>, &Py<PyAny>) -> PyResult<()>,
    ) -> ControlFlow<()> {
        let mut state = self.state.lock().unwrap_or_else(PoisonError::into_inner);
        if state.stopped_by.is_some() {
            return ControlFlow::Break(());
        }
        if current().id() != self.caller || state.asked.elapsed() < interval {
            return ControlFlow::Continue(());
        }
        let answer = Python::attach(|py| {
            py.check_signals()?;
            self.function.as_ref().map_or(Ok(()), |function| tell(py, function))
        });
        state.asked = Instant::now();
        match answer {
            Ok(()) => ControlFlow::Continue(()),
            Err(error) => {
                state.stopped_by = Some(error);
                ControlFlow::Break(())
            }
        }
    }

    /// The exception that stopped the call: `KeyboardInterrupt`, or one raised by the progress function.
    pub(crate) fn stopped_by(&self) -> Option<PyErr> {
        self.state.lock().unwrap_or_else(PoisonError::into_inner).stopped_by.take()
    }
}

impl Progress for CallProgress {
    /// Reports the progress at intervals.
    fn update(&self, status: Status) -> ControlFlow<()> {
        self.consult(INTERVAL, |py, tell| tell.call1(py, (status.done, status.of)).map(drop))
    }
}
