//! Precision of numbers.

/// Precision in bits: 77 decimal digits.
pub(crate) const PRECISION: usize = 256;
