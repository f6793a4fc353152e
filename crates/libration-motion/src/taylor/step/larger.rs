//! The larger of two numbers, one of which may be NaN.

/// The larger number; the first if the two cannot be compared.
#[inline(always)]
pub(in crate::taylor) fn larger(a: f64, b: f64) -> f64 {
    if b > a { b } else { a }
}

/// The larger number; NaN if one of the two is NaN.
#[inline(always)]
pub(crate) fn larger_or_nan(largest: f64, part: f64) -> f64 {
    if part <= largest || largest.is_nan() { largest } else { part }
}
