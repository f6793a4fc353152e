//! A step that is kept when the integration has gone on.

use super::Step;

/// A step with numbers of its own.
#[derive(Clone, Debug)]
pub struct KeptStep(Step);

impl Step {
    /// The step to be kept.
    #[must_use]
    pub fn kept(&self) -> KeptStep {
        KeptStep(self.clone())
    }
}

impl KeptStep {
    /// The step as it was.
    #[must_use]
    pub fn step(&self) -> &Step {
        &self.0
    }
}
