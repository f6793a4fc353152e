//! Places where a function of one variable vanishes, to double precision.

use crate::roots::{Tolerance, bisect};

/// The interval searched for zeros of what is no polynomial.
pub(super) const SEARCHED: f64 = 10.0;
/// The pieces it is cut into; of two zeros within one piece both are missed.
const PIECES: i32 = 2000;
/// Polynomials up to this degree are searched everywhere.
pub(super) const LARGEST_DEGREE: usize = 40;

/// What a search has seen of a function.
pub(super) struct Seen {
    /// Where it changes its sign through zero, ascending.
    pub(super) zeros: Vec<f64>,
    /// Whether it has a value anywhere.
    pub(super) has_values: bool,
}

/// The zeros where the function changes sign, and those it has at an end of a piece, within ±[`SEARCHED`].
pub(super) fn zeros(f: impl Fn(f64) -> f64) -> Seen {
    let at = |i: i32| SEARCHED * f64::from(i) / f64::from(PIECES / 2);
    let values: Vec<(f64, f64)> = (-PIECES / 2..=PIECES / 2).map(|i| (at(i), f(at(i)))).collect();
    let mut found: Vec<f64> = values.iter().filter(|(_, y)| *y == 0.0).map(|(x, _)| *x).collect();
    for pair in values.windows(2) {
        let ((a, fa), (b, fb)) = (pair[0], pair[1]);
        if fa * fb < 0.0 {
            let zero = sign_change(&f, [a, b]);
            // At a pole the function grows where it changes sign.
            found.extend(Some(zero).filter(|&zero| f(zero).abs() <= fa.abs().max(fb.abs())));
        }
    }
    found.sort_by(f64::total_cmp);
    Seen { zeros: found, has_values: values.iter().any(|(_, y)| !y.is_nan()) }
}

/// The zeros at which a polynomial changes sign, ascending: between those of its derivative it is monotonic. The
/// coefficients are given from the constant term on; `None` where `f64`s do not hold them side by side.
pub(super) fn polynomial_zeros(coefficients: &[f64]) -> Option<Vec<f64>> {
    let mut derivatives = vec![coefficients.to_vec()];
    while let Some(last) = derivatives.last().filter(|it| it.len() > 2) {
        derivatives.push(derivative(last));
    }
    derivatives.iter().rev().try_fold(vec![], |turns, polynomial| monotonic_zeros(polynomial, &turns))
}

fn derivative(coefficients: &[f64]) -> Vec<f64> {
    let powers = (1_u32..).map(f64::from);
    coefficients.iter().skip(1).zip(powers).map(|(c, n)| c * n).collect()
}

/// The zeros of a polynomial that is monotonic between the turns.
fn monotonic_zeros(polynomial: &[f64], turns: &[f64]) -> Option<Vec<f64>> {
    let value = |x: f64| polynomial.iter().rev().fold(0.0, |sum, c| sum * x + c);
    // Cauchy: no zero is further out.
    let last = polynomial.last().copied().unwrap_or(0.0).abs();
    let bound = 1.0 + polynomial.iter().fold(0.0, |most: f64, c| most.max(c.abs())) / last;
    if polynomial.len() < 2 {
        return Some(vec![]);
    }
    if !bound.is_finite() {
        return None;
    }
    let ends: Vec<f64> = std::iter::once(-bound).chain(turns.iter().copied()).chain([bound]).collect();
    let mut found: Vec<f64> = turns.iter().copied().filter(|&turn| value(turn) == 0.0).collect();
    found.extend(
        ends.windows(2)
            .filter(|pair| value(pair[0]) * value(pair[1]) < 0.0)
            .map(|pair| sign_change(value, [pair[0], pair[1]])),
    );
    found.sort_by(f64::total_cmp);
    Some(found)
}

/// Where the sign changes between two places, to the last bit.
fn sign_change(f: impl Fn(f64) -> f64, ends: [f64; 2]) -> f64 {
    let negative = f(ends[0]) < 0.0;
    let [a, b] = bisect(ends, Tolerance::LAST_BIT, |x| (f(x) < 0.0) == negative);
    if f(a).abs() < f(b).abs() { a } else { b }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn zeros_of_polynomials_are_found_everywhere() {
        // (x − 1)(x − 2)(x + 300).
        let zeros = polynomial_zeros(&[600.0, -898.0, 297.0, 1.0]).unwrap();
        assert_eq!(zeros.len(), 3);
        for (zero, expected) in zeros.iter().zip([-300.0, 1.0, 2.0]) {
            assert!((zero - expected).abs() < 1e-12 * expected.abs(), "{zero}");
        }
        for none in [&[1.0, 0.0, 1.0][..], &[1.0], &[]] {
            assert_eq!(polynomial_zeros(none), Some(vec![]));
        }
        assert_eq!(polynomial_zeros(&[f64::INFINITY, 0.0, 1.0]), None);
    }

    #[test]
    fn poles_are_no_zeros() {
        assert!(zeros(|x| 1.0 / (x - 0.123)).zeros.is_empty());
        assert!(!zeros(|_| f64::NAN).has_values);
        let found = zeros(|x| libm::exp(x) - 2.0).zeros;
        assert!((found[0] - core::f64::consts::LN_2).abs() < 1e-15 && found.len() == 1);
    }
}
