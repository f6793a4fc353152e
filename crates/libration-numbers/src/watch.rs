//! Cancellation and progress of long calls.
//!
//! Every call that may take long has a variant that ends in `_watched` and takes a [`Watch`], which it consults at least once in each step of an
//! integration, order of an expansion or piece of a catalogue. Once the watch has returned `Break` it is not consulted again, and the call returns
//! its partial result or the error [`Interrupted`].

use std::cell::Cell;
use std::fmt;
use std::ops::ControlFlow;

/// Progress of a long call.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Progress {
    /// The current stage.
    pub stage: Stage,
    /// Number of points, values, orders … of this stage that are done.
    pub done: usize,
    /// Total number, where it is known.
    pub of: Option<usize>,
}

/// Stage of a call that does several things.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Stage {
    /// The whole of the work.
    Whole,
    /// An expansion, order after order, modulo another prime.
    Prime {
        /// The primes that are done.
        done: usize,
    },
    /// The fractions of an expansion are put together from their residues.
    Fractions {
        /// The primes that are done.
        primes: usize,
    },
    /// An expansion, order after order, in floats.
    Floats {
        /// Their precision in bits.
        bits: usize,
    },
    /// An expansion is checked by another method.
    Check,
    /// The motion requested, 0, or another one next to it.
    Motion {
        /// The number of the motion.
        number: usize,
    },
}

/// A long call was cancelled.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("the computation was interrupted")]
pub struct Interrupted;

/// Cancellation and progress of a long call.
pub struct Watch<'w> {
    asked: Asked<'w>,
    progress: Cell<Progress>,
    stopped: Cell<bool>,
}

enum Asked<'w> {
    Nobody,
    Caller(&'w dyn Fn(Progress) -> ControlFlow<()>),
    Whole(&'w Watch<'w>),
}

impl Watch<'static> {
    /// A watch that never cancels, and reports no progress.
    #[must_use]
    pub const fn none() -> Self {
        Self::asking(Asked::Nobody)
    }
}

impl<'w> Watch<'w> {
    /// Asks a function, which is told how far the call is.
    #[must_use]
    pub const fn new(ask: &'w dyn Fn(Progress) -> ControlFlow<()>) -> Self {
        Self::asking(Asked::Caller(ask))
    }

    const fn asking(asked: Asked<'w>) -> Self {
        let progress = Progress { stage: Stage::Whole, done: 0, of: None };
        Self { asked, progress: Cell::new(progress), stopped: Cell::new(false) }
    }

    /// A watch for a part of the work, which cancels but does not report the progress of the part.
    #[must_use]
    pub fn part(&self) -> Watch<'_> {
        Watch::asking(Asked::Whole(self))
    }

    /// Begins a stage with a number of pieces.
    pub fn begin(&self, stage: Stage, of: Option<usize>) {
        self.progress.set(Progress { stage, done: 0, of });
    }

    /// Records the number of finished pieces of the stage, and consults the caller.
    ///
    /// # Errors
    /// [`Interrupted`] if the call was cancelled.
    pub fn reached(&self, done: usize) -> Result<(), Interrupted> {
        self.progress.set(Progress { done, ..self.progress.get() });
        self.go_on()
    }

    /// Consults the caller whether the call may continue; after a cancellation the caller is not consulted again.
    ///
    /// # Errors
    /// [`Interrupted`] if the call was cancelled.
    pub fn go_on(&self) -> Result<(), Interrupted> {
        if !self.stopped.get() {
            self.stopped.set(match self.asked {
                Asked::Nobody => false,
                Asked::Caller(ask) => ask(self.progress.get()).is_break(),
                Asked::Whole(whole) => whole.go_on().is_err(),
            });
        }
        if self.stopped.get() { Err(Interrupted) } else { Ok(()) }
    }

    /// [`go_on`](Self::go_on) for closures that answer with a [`ControlFlow`].
    pub fn flow(&self) -> ControlFlow<()> {
        if self.go_on().is_ok() { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
    }

    /// [`reached`](Self::reached) for closures that answer with a [`ControlFlow`].
    pub fn flow_at(&self, done: usize) -> ControlFlow<()> {
        if self.reached(done).is_ok() { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
    }

    /// Returns whether the call was cancelled, without consulting the caller.
    #[must_use]
    pub fn is_stopped(&self) -> bool {
        self.stopped.get()
    }
}

impl fmt::Debug for Watch<'_> {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (progress, stopped) = (self.progress.get(), self.stopped.get());
        formatter.debug_struct("Watch").field("progress", &progress).field("stopped", &stopped).finish()
    }
}
