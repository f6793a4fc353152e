//! Kaiser's window.

use std::f64::consts::PI;

/// Shape parameter β: a larger one lowers the side lobes, 0.2172 β/sinh β of the line, and widens the lines. At 20 the side lobes are 1.8e-8,
/// and a line ends 6.4 steps of 2π over the duration from its middle: an oscillation is separated from its mean value after seven periods.
const SHAPE: f64 = 20.0;

/// The values times the window, which is scaled to the sum one.
pub(super) fn weighted(values: &[f64]) -> Vec<f64> {
    let weights: Vec<f64> = (0..values.len()).map(|n| weight(n, values.len())).collect();
    let sum: f64 = weights.iter().sum();
    values.iter().zip(weights).map(|(value, weight)| value * (weight / sum)).collect()
}

/// The half-width of the main lobe, in steps of 2π over the duration: √(1 + (β/π)²).
pub(super) fn half_width() -> f64 {
    libm::hypot(1.0, SHAPE / PI)
}

fn weight(n: usize, length: usize) -> f64 {
    let argument = 2.0 * (super::float(n) + 0.5) / super::float(length) - 1.0;
    bessel_i0(SHAPE * libm::sqrt(1.0 - argument * argument))
}

/// I₀(x) = Σ ((x/2)ᵏ/k!)² (DLMF 10.25.2), for 0 ≤ x ≤ 20: the term of k = 60 is below 1e-43.
pub fn bessel_i0(x: f64) -> f64 {
    let terms = (1..=60_u32).scan(1.0, |term, k| {
        let factor = 0.5 * x / f64::from(k);
        *term *= factor * factor;
        Some(*term)
    });
    1.0 + terms.sum::<f64>()
}
