//! Zeros of a function of one variable, to double precision.

use libration_numbers::internals::roots::sign_change;

/// The interval searched for zeros of functions that are not polynomials.
pub(super) const SEARCHED: f64 = 10.0;
/// Number of pieces of this interval; two zeros within one piece are both missed.
const PIECES: i32 = 2000;
/// Largest degree of polynomials for which all zeros are searched.
pub(super) const LARGEST_DEGREE: usize = 40;

/// The result of a search for the zeros of a function.
#[derive(Debug)]
pub struct Scan {
    /// The zeros at which the function changes its sign, ascending.
    pub zeros: Vec<f64>,
    /// `true` if the function has a value at any of the points.
    pub has_values: bool,
}

/// The zeros at which the function changes sign, and those at an end of a piece, within ±`SEARCHED`.
pub fn zeros(f: impl Fn(f64) -> f64) -> Scan {
    let at = |i: i32| SEARCHED * f64::from(i) / f64::from(PIECES / 2);
    let values: Vec<(f64, f64)> = (-PIECES / 2..=PIECES / 2).map(|i| (at(i), f(at(i)))).collect();
    let mut zeros: Vec<f64> = values.iter().filter(|(_, y)| *y == 0.0).map(|(x, _)| *x).collect();
    for pair in values.windows(2) {
        let ((a, fa), (b, fb)) = (pair[0], pair[1]);
        if fa * fb < 0.0 {
            let zero = sign_change(&f, [a, b]);
            // At a pole the function grows towards the change of sign.
            zeros.extend(Some(zero).filter(|&zero| f(zero).abs() <= fa.abs().max(fb.abs())));
        }
    }
    zeros.sort_by(f64::total_cmp);
    Scan { zeros, has_values: values.iter().any(|(_, y)| !y.is_nan()) }
}
