//! Progress and cancellation of long calls.
//!
//! Every call that may take long has a [`Progress`] as its last argument. It is updated at least once in each step of an integration, order of
//! an expansion or piece of a catalogue. After the first `Break` there are no further updates, and the call returns its partial result or the
//! error [`Interrupted`]. [`Quiet`] is for calls that need neither progress nor cancellation.

pub(crate) mod watch;

use std::ops::ControlFlow;

/// Progress and cancellation of a long call. Every function from a [`Status`] to a [`ControlFlow`] implements this trait.
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
    /// Number of completed points, values, orders … in this stage.
    pub done: usize,
    /// Total number, if it is known.
    pub of: Option<usize>,
}

/// Stage of a call that consists of several.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum Stage {
    /// The only stage.
    #[default]
    Whole,
    /// An expansion modulo another prime, order by order.
    Prime {
        /// The number of completed primes.
        done: usize,
    },
    /// Reconstruction of the fractions of an expansion from their residues.
    Fractions {
        /// The number of completed primes.
        primes: usize,
    },
    /// An expansion in floats, order by order.
    Floats {
        /// The precision of the floats in bits.
        bits: usize,
    },
    /// A check of an expansion by another method.
    Check,
    /// The requested motion (0), or another one near it.
    Motion {
        /// The index of the motion.
        number: usize,
    },
}

/// The error for a cancelled call.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("the computation was interrupted")]
pub struct Interrupted;
