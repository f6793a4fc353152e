//! The larger of two numbers, one of which may be none.

/// The first where they cannot be compared.
#[inline(always)]
pub(in crate::taylor) fn larger(a: f64, b: f64) -> f64 {
    if b > a { b } else { a }
}

/// NaN where one of them is.
#[inline(always)]
pub(crate) fn larger_or_nan(largest: f64, part: f64) -> f64 {
    if part <= largest || largest.is_nan() { largest } else { part }
}
