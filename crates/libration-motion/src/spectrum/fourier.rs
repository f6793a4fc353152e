//! The fast Fourier transform.

use libration_numbers::algebra::Complex;
use std::f64::consts::TAU;

/// Σ xₙ e^{−2πikn/N} for all k, where N is a power of two (Cooley and Tukey, Math. Comp. 19, 297, 1965).
pub fn transform(values: &[Complex]) -> Vec<Complex> {
    let length = values.len();
    debug_assert!(length.is_power_of_two(), "a transform of {length} numbers");
    let mut sums = bit_reversed(values);
    let mut half = 1;
    while half < length {
        let factors: Vec<Complex> = (0..half).map(|k| Complex::unit(-0.5 * TAU * part(k, half))).collect();
        for block in sums.chunks_exact_mut(2 * half) {
            let (even, odd) = block.split_at_mut(half);
            for ((a, b), factor) in even.iter_mut().zip(odd).zip(&factors) {
                let turned = *b * *factor;
                (*a, *b) = (*a + turned, *a - turned);
            }
        }
        half *= 2;
    }
    sums
}

/// The numbers in the order of their bit-reversed indices.
fn bit_reversed(values: &[Complex]) -> Vec<Complex> {
    let bits = values.len().trailing_zeros();
    let index = |k: usize| if bits == 0 { 0 } else { k.reverse_bits() >> (usize::BITS - bits) };
    (0..values.len()).map(|k| values[index(k)]).collect()
}

#[expect(clippy::cast_precision_loss, reason = "lengths of lists, far below 2^53")]
pub fn part(k: usize, of: usize) -> f64 {
    k as f64 / of as f64
}
