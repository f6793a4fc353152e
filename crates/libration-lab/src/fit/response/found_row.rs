//! A row of a response with what the best parameters make of it.

/// A row under the best parameters.
#[derive(Clone, Debug)]
pub(super) struct FoundRow {
    /// Without its error.
    pub(super) amplitude: f64,
    /// What a whole step would make of that.
    pub(super) aim: f64,
    /// How the amplitude of the required drive changes over one standard deviation of that of the answer.
    pub(super) slope: f64,
    /// What the curvature adds to it on the average.
    pub(super) bend: f64,
    /// In standard deviations: that of the amplitude, and with a phase another.
    pub(super) residuals: Vec<f64>,
    /// What part of each the parameters take up.
    pub(super) leverages: Vec<f64>,
}
