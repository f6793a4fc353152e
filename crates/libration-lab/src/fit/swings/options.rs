//! What is known of swings besides the recordings.

use crate::fit::DampingModel;
use crate::fit::budget::{Apparatus, Correlation};
use crate::fit::trace::TraceOptions;

/// What is known of swings besides the recordings.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SwingsOptions<'a> {
    /// The kinds of damping of the model; none to compare all.
    pub damping: Option<DampingModel>,
    /// How the motion is fitted.
    pub trace: TraceOptions,
    /// The pendulum, of which gravity is found; none to find the length.
    pub apparatus: Option<Apparatus>,
    /// The relative standard uncertainty of all angles.
    pub angle_scale: Option<f64>,
    /// The relative standard uncertainty of the clock.
    pub clock: Option<f64>,
    /// Of the inputs of gravity.
    pub correlations: &'a [Correlation],
}
