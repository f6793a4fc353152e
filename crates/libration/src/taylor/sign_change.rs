//! Where a polynomial changes its sign between zero and one, none missed.
//!
//! A polynomial has no more zeros inside an interval than its coefficients in Bernstein's basis change sign: G. Farin,
//! *Curves and Surfaces for CAGD*, 5th ed., Morgan Kaufmann 2002, section 6.

use crate::elementary::count;
use std::ops::ControlFlow;

/// The first place in 0 < x ≤ 1 behind which Σ cₙxⁿ has the other sign; `None` if there is none.
pub(super) fn first_sign_change(coefficients: &[f64]) -> Option<f64> {
    match search(bernstein(coefficients), 0.0, 1.0, &mut ControlFlow::Break) {
        ControlFlow::Break(place) => Some(place),
        ControlFlow::Continue(()) => None,
    }
}

/// All such places, in their order.
pub(super) fn sign_changes(coefficients: &[f64]) -> Vec<f64> {
    let mut places = Vec::new();
    let mut note = |place| {
        places.push(place);
        ControlFlow::Continue(())
    };
    // Nothing breaks the search.
    let _ = search(bernstein(coefficients), 0.0, 1.0, &mut note);
    places
}

/// The coefficients of a series in the part of a length as variable. A power that overflows makes nothing of no term.
pub(super) fn scaled(series: impl Iterator<Item = f64>, length: f64) -> Vec<f64> {
    let mut power = 1.0;
    let terms = series.map(|c| {
        let term = if c == 0.0 { c } else { c * power };
        power *= length;
        term
    });
    terms.collect()
}

/// Below this two zeros are one.
const NARROWEST: f64 = f64::EPSILON;

fn search(
    form: Vec<f64>,
    from: f64,
    to: f64,
    found: &mut impl FnMut(f64) -> ControlFlow<f64>,
) -> ControlFlow<f64> {
    let signs = || form.iter().filter(|c| **c != 0.0).map(|c| c.is_sign_positive());
    if signs().zip(signs().skip(1)).all(|(before, after)| before == after) {
        return ControlFlow::Continue(());
    }
    if to - from <= NARROWEST * to {
        let changes = signs().next() != signs().next_back();
        return if changes { found(to) } else { ControlFlow::Continue(()) };
    }
    let middle = 0.5 * (from + to);
    let (left, mut right) = halves(form);
    // A zero in the very middle belongs to the right half.
    let before = left.iter().rfind(|c| **c != 0.0).copied();
    if right[0] == 0.0 {
        right[0] = before.map_or(0.0, |before| f64::MIN_POSITIVE.copysign(before));
    }
    search(left, from, middle, found)?;
    search(right, middle, to, found)
}

/// The coefficients βᵢ = Σⱼ (i over j)/(m over j)·cⱼ in Bernstein's basis, between the least and the greatest of which
/// the polynomial stays.
pub(super) fn bernstein(coefficients: &[f64]) -> Vec<f64> {
    let degree = coefficients.len().saturating_sub(1);
    let coefficient = |i: usize| {
        let mut ratio = 1.0;
        let mut sum = 0.0;
        for (j, c) in coefficients.iter().enumerate().take(i + 1) {
            sum += ratio * c;
            ratio *= count(i - j) / count((degree - j).max(1));
        }
        sum
    };
    (0..coefficients.len()).map(coefficient).collect()
}

/// De Casteljau's division in the middle.
fn halves(mut form: Vec<f64>) -> (Vec<f64>, Vec<f64>) {
    let mut left = Vec::with_capacity(form.len());
    for last in (0..form.len()).rev() {
        left.push(form[0]);
        for i in 0..last {
            form[i] = 0.5 * (form[i] + form[i + 1]);
        }
    }
    (left, form)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// (x − 0.2)(x − 0.2001)(x − 0.9).
    const CUBIC: [f64; 4] = [-0.2 * 0.2001 * 0.9, 0.2 * 0.2001 + 0.9 * 0.4001, -1.3001, 1.0];

    #[test]
    fn all_of_several_zeros_are_found() {
        let first = first_sign_change(&CUBIC).unwrap();
        assert!((first - 0.2).abs() < 1e-11, "{first}");
        let all = sign_changes(&CUBIC);
        assert!((all[0] - first).abs() == 0.0);
        assert!((all[1] - 0.2001).abs() < 1e-11 && (all[2] - 0.9).abs() < 1e-15, "{all:?}");
        assert_eq!(all.len(), 3);
    }

    #[test]
    fn zeros_between_two_halves_are_found_once() {
        assert_eq!(sign_changes(&[-0.5, 1.0]).len(), 1);
        // (x − 1/4)(x − 1/2)(x − 3/4).
        let three = sign_changes(&[-0.09375, 0.6875, -1.5, 1.0]);
        assert_eq!(three.len(), 3, "{three:?}");
    }

    #[test]
    fn lengths_whose_powers_overflow_leave_a_polynomial_what_it_is() {
        let fall = scaled([0.5, 0.0, -0.5, 0.0, 0.0].into_iter(), 1e100);
        assert!(fall.iter().all(|term| term.is_finite()), "{fall:?}");
        assert!((first_sign_change(&fall).unwrap() * 1e100 - 1.0).abs() < 1e-15);
    }

    #[test]
    fn touching_is_no_change_of_sign() {
        assert_eq!(first_sign_change(&[0.25, -1.0, 1.0]), None);
        assert_eq!(first_sign_change(&[1.0, -3.0, 3.0]), None);
        assert_eq!(first_sign_change(&[0.0, 0.0]), None);
        assert_eq!(first_sign_change(&[]), None);
    }
}
