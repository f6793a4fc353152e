//! Errors of normal forms.

use crate::normal_modes::ModesError;
use libration_numbers::expression::WithoutValue;
use libration_numbers::progress::Interrupted;

/// Reason why a system has no normal form about an equilibrium.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum NormalFormError {
    /// Small oscillations that do not exist.
    #[error(transparent)]
    NoModes(#[from] ModesError),
    /// A symbolic parameter without a value.
    #[error(transparent)]
    WithoutValue(#[from] WithoutValue),
    /// A mode that does not oscillate.
    #[error(
        "mode {0} does not oscillate: amplitudes change slowly only where all modes oscillate without damping; set the damping to zero, or choose another equilibrium"
    )]
    NotOscillating(usize),
    /// An order outside the range that is implemented.
    #[error("the order is {0}: give 2 to {most}", most = super::LARGEST_ORDER)]
    Order(usize),
    /// Accelerations without power series.
    #[error(
        "at the equilibrium the accelerations have no power series: they have a kink or a jump there, or are not finite"
    )]
    NoSeries,
    /// Cancellation by the caller.
    #[error(transparent)]
    Interrupted(#[from] Interrupted),
}
