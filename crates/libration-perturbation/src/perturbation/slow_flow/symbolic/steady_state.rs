//! The formulas of steady states.

/// Steady states of a slow flow as formulas in the symbols, A and σ.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct SteadyState {
    /// A′ and A·φ′, both zero at steady states; without drive A′ only.
    pub equations: Vec<String>,
    /// Zero on the response curve, or for limit cycles.
    pub relation: Option<String>,
    /// cos mφ and sin mφ at steady states, with m.
    pub phase: Option<(usize, [String; 2])>,
    /// A on the only limit cycle, without drive.
    pub cycle_amplitude: Option<String>,
    /// The frequency of this limit cycle.
    pub cycle_frequency: Option<String>,
    /// σ of the largest amplitude.
    pub backbone: Option<String>,
    /// The largest amplitude of the response curve.
    pub peak_amplitude: Option<String>,
    /// The detuning of the largest amplitude.
    pub peak_detuning: Option<String>,
    /// Zero where the response curve turns back.
    pub folds: Option<String>,
    /// The amplitude of the drive above which there are folds, to lowest order.
    pub critical_drive: Option<String>,
    /// The formula of this amplitude in the symbols of the drive, such as F or F1 + F2.
    pub drive_amplitude: Option<String>,
    /// The trace of the Jacobian of A′ and φ′; without drive ∂A′/∂A.
    pub trace: Option<String>,
    /// The determinant of the Jacobian.
    pub determinant: Option<String>,
    /// The reasons why fields are `None`.
    pub notes: Vec<String>,
}

/// Maximum number of terms of a relation that is given.
pub(super) const MOST_TERMS: usize = 200;
