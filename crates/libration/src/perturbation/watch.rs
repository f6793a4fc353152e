//! How far an expansion is, told as it goes on, and the end of it when it is broken off.

use std::ops::ControlFlow;

/// How far an expansion is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Progress {
    /// What is being done.
    pub stage: Stage,
    /// The order it has come to, of those that the stage goes through.
    pub order: usize,
}

/// What is being done for an expansion.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Stage {
    /// Order after order modulo another prime, this many being done.
    Prime {
        /// The primes that are done.
        done: usize,
    },
    /// Fractions are put together from their residues modulo this many primes.
    Fractions {
        /// The primes that are done.
        primes: usize,
    },
    /// Order after order in floats of this many bits.
    Floats {
        /// Their precision.
        bits: usize,
    },
    /// The answer is checked by another road.
    Check,
}

/// Whom to tell.
pub(crate) struct Watch<'a> {
    tell: &'a mut dyn FnMut(Progress) -> ControlFlow<()>,
    pub(crate) stage: Stage,
    broken_off: bool,
}

impl<'a> Watch<'a> {
    pub(crate) fn new(tell: &'a mut dyn FnMut(Progress) -> ControlFlow<()>) -> Self {
        Self { tell, stage: Stage::Prime { done: 0 }, broken_off: false }
    }

    /// Tells that an order is reached, and learns whether to go on.
    pub(crate) fn goes_on(&mut self, order: usize) -> bool {
        let progress = Progress { stage: self.stage, order };
        self.broken_off = self.broken_off || (self.tell)(progress).is_break();
        !self.broken_off
    }

    /// Whether it has been broken off.
    pub(crate) const fn is_broken_off(&self) -> bool {
        self.broken_off
    }
}
