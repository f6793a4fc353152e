//! The allowed error of a step in one state component.

/// Error of an acceleration, relative to its size, that counts as rounding.
pub(in crate::taylor) const ROUNDING: f64 = 16.0 * f64::EPSILON;

/// The allowed error of one state component in a step.
#[derive(Clone, Copy, Debug)]
pub(in crate::taylor) struct Allowance {
    /// The allowed error relative to the size of the component.
    pub(in crate::taylor) relative: f64,
    /// The base-2 logarithm of the factor by which a step may be longer than for the smallest of all tolerances.
    pub(in crate::taylor) log2_longer: f64,
    /// The factor by which the error is multiplied for the comparison with the smallest of all tolerances.
    pub(in crate::taylor) weight: f64,
}
