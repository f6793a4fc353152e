//! Progress and cancellation of long calls.
//!
//! Every call that may take long has a [`Progress`] as its last argument, which it updates at least once in each step of an integration, order of
//! an expansion or piece of a catalogue. After the first `Break` there are no further updates, and the call returns its partial result or the
//! error [`Interrupted`]. [`Quiet`] is for calls that need neither progress nor cancellation.

pub(crate) mod watch;

use std::ops::ControlFlow;

/// The progress and the cancellation of a long call. Any function from a [`Status`] to a [`ControlFlow`] implements it.
pub trait Progress {
    /// Receives the progress of the call; `Break` cancels the call.
    fn update(&self, status: Status) -> ControlFlow<()>;
}

impl<F: Fn(Status) -> ControlFlow<()>> Progress for F {
    fn update(&self, status: Status) -> ControlFlow<()> {
        self(status)
    }
}

/// No progress and no cancellation.
#[derive(Clone, Copy, Debug, Default)]
pub struct Quiet;

impl Progress for Quiet {
    fn update(&self, _: Status) -> ControlFlow<()> {
        ControlFlow::Continue(())
    }
}

/// Progress of a long call, as data.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Status {
    /// The current stage.
    pub stage: Stage,
    /// Number of points, values, orders … of this stage that are done.
    pub done: usize,
    /// Total number, where it is known.
    pub of: Option<usize>,
}

/// Stage of a call that does several things.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum Stage {
    /// The whole of the work.
    #[default]
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
    /// The motion asked for, 0, or another one near it.
    Motion {
        /// The number of the motion.
        number: usize,
    },
}

/// A long call was cancelled.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("the computation was interrupted")]
pub struct Interrupted;
