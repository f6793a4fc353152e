//! The common stride of the powers of a series.

/// The greatest common divisor of the distances between these powers; zero where there is at most one.
pub(crate) fn stride(powers: impl IntoIterator<Item = usize>) -> usize {
    let mut powers = powers.into_iter();
    let first = powers.next().unwrap_or(0);
    powers.fold(0, |stride, power| greatest_common_divisor(stride, power.abs_diff(first)))
}

fn greatest_common_divisor(a: usize, b: usize) -> usize {
    if b == 0 { a } else { greatest_common_divisor(b, a % b) }
}
