//! Progress within a long call.

use super::{Interrupted, Progress, Stage, Status};
use std::cell::Cell;
use std::fmt;
use std::ops::ControlFlow;

/// The caller's progress, with the current status of the call. A cancellation is remembered: the caller is not consulted again after it.
///
/// Used as the progress of an inner call, it reports the status of that call as its own; a [`part`](Self::part) hides that status.
pub struct Watch<'w> {
    consulted: Consulted<'w>,
    status: Cell<Status>,
    stopped: Cell<bool>,
}

enum Consulted<'w> {
    Caller(&'w dyn Progress),
    Whole(&'w Watch<'w>),
}

impl<'w> Watch<'w> {
    /// The start of a call.
    #[must_use]
    pub const fn new(progress: &'w dyn Progress) -> Self {
        Self::consulting(Consulted::Caller(progress))
    }

    const fn consulting(consulted: Consulted<'w>) -> Self {
        let status = Status { stage: Stage::Whole, done: 0, of: None };
        Self { consulted, status: Cell::new(status), stopped: Cell::new(false) }
    }

    /// The progress of a part of the work, whose status is not reported.
    #[must_use]
    pub fn part(&self) -> Watch<'_> {
        Watch::consulting(Consulted::Whole(self))
    }

    /// Begins a stage with a number of pieces.
    pub fn begin(&self, stage: Stage, of: Option<usize>) {
        self.status.set(Status { stage, done: 0, of });
    }

    /// Records the number of finished pieces of the stage, and consults the caller.
    ///
    /// # Errors
    /// [`Interrupted`] if the call is cancelled.
    pub fn reached(&self, done: usize) -> Result<(), Interrupted> {
        self.status.set(Status { done, ..self.status.get() });
        self.go_on()
    }

    /// Consults the caller.
    ///
    /// # Errors
    /// [`Interrupted`] if the call is cancelled.
    pub fn go_on(&self) -> Result<(), Interrupted> {
        if !self.stopped.get() {
            self.stopped.set(match self.consulted {
                Consulted::Caller(progress) => progress.update(self.status.get()).is_break(),
                Consulted::Whole(whole) => whole.go_on().is_err(),
            });
        }
        if self.stopped.get() { Err(Interrupted) } else { Ok(()) }
    }

    /// [`go_on`](Self::go_on) for closures that return a [`ControlFlow`].
    pub fn flow(&self) -> ControlFlow<()> {
        if self.go_on().is_ok() { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
    }

    /// [`reached`](Self::reached) for closures that return a [`ControlFlow`].
    pub fn flow_at(&self, done: usize) -> ControlFlow<()> {
        if self.reached(done).is_ok() { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
    }

    /// Returns `true` if the call is cancelled, without consulting the caller.
    #[must_use]
    pub fn is_stopped(&self) -> bool {
        self.stopped.get()
    }
}

impl Progress for Watch<'_> {
    fn update(&self, status: Status) -> ControlFlow<()> {
        self.status.set(status);
        self.flow()
    }
}

impl fmt::Debug for Watch<'_> {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (status, stopped) = (self.status.get(), self.stopped.get());
        formatter.debug_struct("Watch").field("status", &status).field("stopped", &stopped).finish()
    }
}
