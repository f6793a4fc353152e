//! A row of a response under the best parameters.

/// A row under the best parameters.
#[derive(Clone, Debug)]
pub(super) struct FoundRow {
    /// Amplitude without its error.
    pub(super) amplitude: f64,
    /// The amplitude after a whole step of the search.
    pub(super) aim: f64,
    /// Change of the required drive's amplitude over one standard deviation of the response's amplitude.
    pub(super) slope: f64,
    /// Mean contribution of the curvature to that change.
    pub(super) bend: f64,
    /// Residuals in standard deviations: that of the amplitude, and with a phase another.
    pub(super) residuals: Vec<f64>,
    /// Leverage of each residual: the fraction of it that the fit of the parameters removes.
    pub(super) leverages: Vec<f64>,
}
