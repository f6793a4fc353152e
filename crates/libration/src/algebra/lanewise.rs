//! Several double-precision numbers at once, lane by lane, and sums of products in an order that many of them can be formed in.

use libration_jit::MultiplyAdd;

/// One number for each lane. Other than `std::array::from_fn` it is always compiled into its caller, and so for the same
/// instruction set.
#[inline(always)]
pub(crate) fn lanes<const N: usize>(mut number: impl FnMut(usize) -> f64) -> [f64; N] {
    let mut all = [0.0; N];
    for (lane, one) in all.iter_mut().enumerate() {
        *one = number(lane);
    }
    all
}

/// Σ aᵢ·b_{n−1−i}, where the sum of what lies between the ends is formed as an inner product.
///
/// The ends come last: there are the newest coefficients.
#[inline(always)]
pub(crate) fn convolution<S: MultiplyAdd>(
    on: &S,
    a: &[S::Element],
    b: &[S::Element],
    inner_product: impl FnOnce(&[S::Element], &[S::Element]) -> S::Element,
) -> S::Element {
    let n = a.len().min(b.len());
    let (a, b) = (&a[..n], &b[..n]);
    match n {
        0 => on.nothing(),
        1 => on.multiply_add(a[0], b[0], on.nothing()),
        _ => {
            let inner = inner_product(&a[1..n - 1], &b[1..n - 1]);
            on.multiply_add(a[n - 1], b[0], on.multiply_add(a[0], b[n - 1], inner))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::{Lanes, Ring};

    #[test]
    fn convolutions_of_every_length_are_those_of_whole_numbers() {
        let numbers = |factor: u32, length: u32| (0..length).map(move |n| f64::from(n * n * factor % 17));
        for length in 0..20 {
            let (a, b): (Vec<f64>, Vec<f64>) = (numbers(3, length).collect(), numbers(5, length).collect());
            let plain = a.iter().zip(b.iter().rev()).fold(0.0, |sum, (a, b)| sum + a * b);
            let [sum] = Lanes::<1>.convolution(a.as_chunks().0, b.as_chunks().0);
            assert_eq!(sum.to_bits(), plain.to_bits(), "{length}");
        }
    }
}
