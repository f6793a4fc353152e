//! What a step may err by in one number of a state.

/// Below so many roundings of an acceleration its errors say nothing.
pub(super) const ROUNDING: f64 = 16.0 * f64::EPSILON;

/// What one number of a state may err by in a step.
#[derive(Clone, Copy, Debug)]
pub(super) struct Allowance {
    /// As a part of its size.
    pub(super) relative: f64,
    /// How much longer than for the least of all tolerances a step may be, as a power of two.
    pub(super) log2_longer: f64,
    /// By what its error is multiplied to be compared with the least of all tolerances.
    pub(super) weight: f64,
}
