//! Long calls, which Ctrl-C ends, and which tell how far they are.

use std::ops::ControlFlow;
use std::sync::{Mutex, PoisonError};
use std::time::{Duration, Instant};

use libration::watch::Progress;
use pyo3::prelude::*;

/// So often the interpreter is asked; it may be busy with another thread.
const INTERVAL: Duration = Duration::from_millis(20);

/// Whom a long call asks whether it may go on.
pub(crate) struct Patience {
    /// A function of how much is done and of how much, or None.
    progress: Option<Py<PyAny>>,
    state: Mutex<State>,
}

struct State {
    asked: Instant,
    stopped_by: Option<PyErr>,
}

impl Patience {
    pub(crate) fn new(progress: Option<Py<PyAny>>) -> Self {
        Self { progress, state: Mutex::new(State { asked: Instant::now(), stopped_by: None }) }
    }

    /// Whether the call may go on; the interpreter is asked from time to time.
    pub(crate) fn go_on(&self, progress: Progress) -> ControlFlow<()> {
        let mut state = self.state.lock().unwrap_or_else(PoisonError::into_inner);
        if state.stopped_by.is_some() {
            return ControlFlow::Break(());
        }
        if state.asked.elapsed() < INTERVAL {
            return ControlFlow::Continue(());
        }
        let answer = Python::attach(|py| {
            py.check_signals()?;
            let Some(tell) = &self.progress else { return Ok(()) };
            tell.call1(py, (progress.done, progress.of)).map(drop)
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

    /// What has stopped the call: `KeyboardInterrupt`, or what the function of the progress has raised.
    pub(crate) fn stopped_by(self) -> Option<PyErr> {
        self.state.into_inner().unwrap_or_else(PoisonError::into_inner).stopped_by
    }
}
