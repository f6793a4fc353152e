//! Sign changes of a polynomial on the real line.

use super::{Tolerance, bisect};

/// The places at which Σ cₙxⁿ, given by c₀, c₁, …, changes its sign, ascending; and places at which it touches zero, where it is zero
/// in double precision. Between the zeros of its derivative a polynomial is monotonic, so that none is missed.
///
/// # Domain
/// Finite coefficients; highest ones that are zero do not count. `None` where the quotient of two of them is beyond `f64`.
///
/// # Accuracy
/// To the last bit of where the value by Horner's scheme changes its sign: a simple zero to some rounding errors times its condition,
/// as [`polynomial_roots`](super::polynomial_roots) bounds it.
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
    while let Some(last) = derivatives.last().filter(|it| it.len() > 2) {
        derivatives.push(derivative(last));
    }
    derivatives.iter().rev().try_fold(vec![], |turns, polynomial| between(polynomial, &turns))
}

fn derivative(coefficients: &[f64]) -> Vec<f64> {
    let powers = (1_u32..).map(f64::from);
    coefficients.iter().skip(1).zip(powers).map(|(c, n)| c * n).collect()
}

/// The zeros of a polynomial that is monotonic between the turns.
fn between(polynomial: &[f64], turns: &[f64]) -> Option<Vec<f64>> {
    let [.., last] = polynomial else { return Some(vec![]) };
    let value = |x: f64| polynomial.iter().rev().fold(0.0, |sum, c| sum * x + c);
    // Cauchy: no zero is further out.
    let bound = 1.0 + polynomial.iter().fold(0.0, |most: f64, c| most.max((c / last).abs()));
    if polynomial.len() < 2 {
        return Some(vec![]);
    }
    if !(bound.is_finite() && polynomial.iter().all(|c| c.is_finite())) {
        return None;
    }
    let ends: Vec<f64> = std::iter::once(-bound).chain(turns.iter().copied()).chain([bound]).collect();
    let mut found: Vec<f64> = turns.iter().copied().filter(|&turn| value(turn) == 0.0).collect();
    let changes = |a: f64, b: f64| a < 0.0 && b > 0.0 || a > 0.0 && b < 0.0;
    let changes = ends.windows(2).filter(|pair| changes(value(pair[0]), value(pair[1])));
    found.extend(changes.map(|pair| sign_change(value, [pair[0], pair[1]])));
    found.sort_by(f64::total_cmp);
    Some(found)
}

/// The place of the sign change between two places, to the last bit.
pub fn sign_change(f: impl Fn(f64) -> f64, ends: [f64; 2]) -> f64 {
    let negative = f(ends[0]) < 0.0;
    let [a, b] = bisect(ends, Tolerance::LAST_BIT, |x| (f(x) < 0.0) == negative);
    if f(a).abs() < f(b).abs() { a } else { b }
}
