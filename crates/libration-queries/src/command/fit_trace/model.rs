//! Choice of the damping that is fitted.

use libration_lab::fit::{DampingModel, DampingModelError};
use std::str::FromStr;

/// The damping that is fitted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::command) enum DampingChoice {
    /// All combinations, among which the data choose.
    Auto,
    /// The given model.
    Given(DampingModel),
}

impl FromStr for DampingChoice {
    type Err = DampingModelError;
    fn from_str(text: &str) -> Result<Self, Self::Err> {
        match text.trim() {
            "auto" => Ok(Self::Auto),
            other => other.parse().map(Self::Given),
        }
    }
}
