//! Known quantities of swings besides the recordings.

use crate::fit::budget::{Apparatus, Correlation};
use crate::fit::damping_model::DampingModel;
use crate::fit::trace::TraceOptions;

/// Known quantities of swings besides the recordings.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SwingsOptions<'a> {
    /// The kinds of damping of the model; `None` to compare all.
    pub damping: Option<DampingModel>,
    /// Options for the fit of the motion.
    pub trace: TraceOptions,
    /// The pendulum, for gravity; `None` to compute the length.
    pub apparatus: Option<Apparatus>,
    /// The relative standard uncertainty of all angles.
    pub angle_scale: Option<f64>,
    /// The relative standard uncertainty of the clock.
    pub clock: Option<f64>,
    /// Correlations of the inputs of gravity.
    pub correlations: &'a [Correlation],
}
