//! Sign changes of a polynomial on the real line.

use super::{Tolerance, bisect};

/// The points at which Σ cₙxⁿ, given c₀, c₁, …, changes its sign, ascending; and points at which it touches zero, if its value there is zero in
/// double precision. Between the zeros of its derivative a polynomial is monotonic, so that none is missed.
///
/// # Domain
/// Finite coefficients; highest ones that are zero are ignored. `None` if the quotient of two coefficients is beyond `f64`.
///
/// # Accuracy
/// Accurate to the last bit of the point at which the value by Horner's scheme changes its sign: for a simple zero a few rounding errors times
/// its condition number, as bounded by [`polynomial_roots`](super::polynomial_roots).
///
/// # Examples
/// ```
/// # extern crate libration_numbers as libration;
/// use libration::roots::polynomial_sign_changes;
/// // x(x − 2)(x² + 1)
/// assert_eq!(polynomial_sign_changes(&[0.0, -2.0, 1.0, -2.0, 1.0]), Some(vec![0.0, 2.0]));
/// ```
#[must_use]
pub fn polynomial_sign_changes(coefficients: &[f64]) -> Option<Vec<f64>> {
    let degree = coefficients.iter().rposition(|c| *c != 0.0);
    let mut derivatives = vec![coefficients[..degree.map_or(0, |degree| degree + 1)].to_vec()];
    while let Some(last) = derivatives.last().filter(|derivative| derivative.len() > 2) {
        derivatives.push(derivative(last));
    }
    derivatives.iter().rev().try_fold(vec![], |turns, polynomial| between(polynomial, &turns))
}

fn derivative(coefficients: &[f64]) -> Vec<f64> {
    let powers = (1_u32..).map(f64::from);
    coefficients.iter().skip(1).zip(powers).map(|(c, n)| c * n).collect()
}

/// The zeros of a polynomial that is monotonic between the given turning points.
fn between(polynomial: &[f64], turns: &[f64]) -> Option<Vec<f64>> {
    let [.., last] = polynomial else { return Some(vec![]) };
    let value = |x: f64| polynomial.iter().rev().fold(0.0, |sum, c| sum * x + c);
    // Cauchy's bound: no zero is larger.
    let bound = 1.0 + polynomial.iter().fold(0.0, |most: f64, c| most.max((c / last).abs()));
    if polynomial.len() < 2 {
        return Some(vec![]);
    }
    if !(bound.is_finite() && polynomial.iter().all(|c| c.is_finite())) {
        return None;
    }
    let ends: Vec<f64> = std::iter::once(-bound).chain(turns.iter().copied()).chain([bound]).collect();
    let mut zeros: Vec<f64> = turns.iter().copied().filter(|&turn| value(turn) == 0.0).collect();
    let changes = |a: f64, b: f64| a < 0.0 && b > 0.0 || a > 0.0 && b < 0.0;
    let changes = ends.windows(2).filter(|pair| changes(value(pair[0]), value(pair[1])));
    zeros.extend(changes.map(|pair| sign_change(value, [pair[0], pair[1]])));
    zeros.sort_by(f64::total_cmp);
    Some(zeros)
}

/// The position of the sign change between two points, to the last bit.
pub fn sign_change(f: impl Fn(f64) -> f64, ends: [f64; 2]) -> f64 {
    let negative = f(ends[0]) < 0.0;
    let [a, b] = bisect(ends, Tolerance::LAST_BIT, |x| (f(x) < 0.0) == negative);
    if f(a).abs() < f(b).abs() { a } else { b }
}
