//! Precision of numbers.

/// Bits of every number: 77 decimal digits.
pub(crate) const PRECISION: usize = 256;
