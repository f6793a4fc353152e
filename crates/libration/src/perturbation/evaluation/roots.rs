//! All roots of a polynomial at once.

use std::f64::consts::TAU;

use crate::algebra::Complex;
use crate::elementary::count;

/// The roots of Σ cₙzⁿ by Ehrlich's and Aberth's method, by ascending magnitude; none for a constant. Simple roots are right to
/// rounding errors times their condition, multiple ones to fewer digits. The coefficients must be finite, and the
/// first and the last not zero.
///
/// Reference: O. Aberth, Math. Comp. **27**, 339 (1973).
pub(super) fn roots(coefficients: &[f64]) -> Vec<Complex> {
    const ENOUGH: usize = 200;
    let degree = coefficients.len().saturating_sub(1);
    if degree == 0 {
        return vec![];
    }
    // On a circle with the mean magnitude of the roots, in no symmetric position.
    let radius = libm::pow((coefficients[0] / coefficients[degree]).abs(), 1.0 / count(degree));
    let start = |k| Complex::unit(TAU * (count(k) + 0.3) / count(degree)).scaled(radius);
    let mut roots: Vec<Complex> = (0..degree).map(start).collect();
    for _ in 0..ENOUGH {
        let moved = improve(coefficients, &mut roots);
        if moved < 4.0 * f64::EPSILON {
            break;
        }
    }
    roots.sort_by(|a, b| a.abs().total_cmp(&b.abs()).then(a.im.total_cmp(&b.im)));
    roots
}

/// One step for each root: Newton's method for the polynomial over the other roots. The largest relative step.
fn improve(coefficients: &[f64], roots: &mut [Complex]) -> f64 {
    let mut largest = 0.0;
    for k in 0..roots.len() {
        let z = roots[k];
        let newton = newton_step(coefficients, z);
        let repulsion: Complex =
            roots.iter().enumerate().filter(|(j, _)| *j != k).map(|(_, other)| ONE / (z - *other)).sum();
        let step = newton / (ONE - newton * repulsion);
        if step.is_finite() {
            roots[k] = z - step;
            largest = f64::max(largest, step.abs() / roots[k].abs());
        }
    }
    largest
}

const ONE: Complex = Complex::new(1.0, 0.0);

/// p/p′; outside the unit circle by way of the reversed polynomial, which does not overflow.
fn newton_step(coefficients: &[f64], z: Complex) -> Complex {
    if z.abs() <= 1.0 {
        let (value, slope) = value_and_slope(coefficients.iter().rev(), z);
        return value / slope;
    }
    let inverse = ONE / z;
    let (value, slope) = value_and_slope(coefficients.iter(), inverse);
    // p(z) = zⁿ r(1/z).
    z / (Complex::from(count(coefficients.len() - 1)) - inverse * slope / value)
}

/// Horner's scheme; the coefficient of the highest power comes first.
pub(super) fn value_and_slope<'a>(
    coefficients: impl Iterator<Item = &'a f64>,
    z: Complex,
) -> (Complex, Complex) {
    let start = (Complex::default(), Complex::default());
    coefficients.fold(start, |(value, slope), coefficient| {
        (value * z + Complex::from(*coefficient), slope * z + value)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn roots_of_unity_are_found() {
        let mut coefficients = vec![0.0; 13];
        (coefficients[0], coefficients[12]) = (-1.0, 1.0);
        let found = roots(&coefficients);
        for k in 0..12 {
            let root = Complex::unit(TAU * count(k) / 12.0);
            assert!(found.iter().any(|z| (*z - root).abs() < 1e-15 * 12.0));
        }
    }

    #[test]
    fn roots_of_very_different_size_are_found() {
        // (z − 1/1024)(z + 2)(z − 4096), in numbers that are exact.
        let (a, b, c) = (1.0 / 1024.0, -2.0, 4096.0);
        let found = roots(&[-a * b * c, a * b + a * c + b * c, -(a + b + c), 1.0]);
        for (root, z) in [a, b, c].into_iter().zip(found) {
            assert!((z - Complex::from(root)).abs() < 1e-14 * root.abs());
        }
    }
}
