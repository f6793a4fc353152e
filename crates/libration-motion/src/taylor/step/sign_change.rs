//! All sign changes of a polynomial between zero and one.
//!
//! The number of zeros of a polynomial inside an interval is at most the number of sign changes of its coefficients in Bernstein's basis: G.
//! Farin, *Curves and Surfaces for CAGD*, 5th ed., Morgan Kaufmann 2002, section 6.

use libration_kernels::elementary::count;
use libration_numbers::roots::{Tolerance, zero_between};
use std::ops::ControlFlow;

/// The first position in 0 < x ≤ 1 after which Σ cₙxⁿ has the other sign; `None` if there is none.
pub fn first_sign_change(coefficients: &[f64]) -> Option<f64> {
    match Search::new(coefficients, ControlFlow::Break).within(bernstein(coefficients), 0.0, 1.0) {
        ControlFlow::Break(position) => Some(position),
        ControlFlow::Continue(()) => None,
    }
}

/// All such positions in ascending order.
pub fn sign_changes(coefficients: &[f64]) -> Vec<f64> {
    let mut positions = Vec::new();
    let note = |position| {
        positions.push(position);
        ControlFlow::Continue(())
    };
    // The search is never stopped by `note`.
    let _ = Search::new(coefficients, note).within(bernstein(coefficients), 0.0, 1.0);
    positions
}

/// The coefficients of a series in powers of the fraction of a length. A coefficient of zero stays zero even if the power overflows.
pub fn scaled(series: impl Iterator<Item = f64>, length: f64) -> Vec<f64> {
    let mut power = 1.0;
    let terms = series.map(|c| {
        let term = if c == 0.0 { c } else { c * power };
        power *= length;
        term
    });
    terms.collect()
}

/// Length of an interval below which two zeros count as one.
const NARROWEST: f64 = f64::EPSILON;

/// A search for zeros by subdivision.
struct Search<F> {
    note: F,
    /// Number of intervals that may still be divided: of rounding errors, in which each interval seems to contain zeros, there are 2⁵².
    divisions: usize,
}

impl<F: FnMut(f64) -> ControlFlow<f64>> Search<F> {
    fn new(coefficients: &[f64], note: F) -> Self {
        /// Divisions for each zero: 52 lead to neighbouring numbers.
        const DIVISIONS: usize = 64;
        Self { note, divisions: DIVISIONS * coefficients.len() }
    }

    fn within(&mut self, form: Vec<f64>, from: f64, to: f64) -> ControlFlow<f64> {
        let changes = changes_of_sign(&form);
        if changes == 0 {
            return ControlFlow::Continue(());
        }
        if to - from <= NARROWEST * to || self.divisions == 0 {
            return if changes.is_multiple_of(2) { ControlFlow::Continue(()) } else { (self.note)(to) };
        }
        if changes == 1
            && let Some(part) = only_zero(&form)
        {
            return (self.note)(from + part * (to - from));
        }
        self.divisions -= 1;
        let middle = 0.5 * (from + to);
        let (left, mut right) = halves(form);
        // A zero exactly in the middle belongs to the right half.
        let before = left.iter().rfind(|c| **c != 0.0).copied();
        if right[0] == 0.0 {
            right[0] = before.map_or(0.0, |before| f64::MIN_POSITIVE.copysign(before));
        }
        self.within(left, from, middle)?;
        self.within(right, middle, to)
    }
}

fn changes_of_sign(form: &[f64]) -> usize {
    let signs = || form.iter().filter(|c| **c != 0.0).map(|c| c.is_sign_positive());
    signs().zip(signs().skip(1)).filter(|(before, after)| before != after).count()
}

/// The zero in 0 < x < 1 of a form with one change of sign. Divided by (1 − x)ᵐ it is a polynomial in u =
/// x/(1 − x) with the coefficients (m over i)βᵢ, which has by Descartes' rule one positive zero: this, or
/// its inverse, the zero of the reversed polynomial, is below one. `None` if the coefficients overflow.
fn only_zero(form: &[f64]) -> Option<f64> {
    let mut terms = times_binomials(form);
    if !terms.iter().map(|c| c.abs()).sum::<f64>().is_finite() {
        return None;
    }
    let at_one: f64 = terms.iter().sum();
    let is_below = terms.iter().find(|c| **c != 0.0).is_some_and(|first| first * at_one.signum() < 0.0);
    if !is_below {
        terms.reverse();
    }
    // A zero at the end itself does not count.
    let first = terms.iter().position(|c| *c != 0.0)?;
    let terms = &terms[first..];
    let value = |u: f64| terms.iter().rev().fold(0.0, |sum, c| sum * u + c);
    let u = zero_between([(0.0, terms[0]), (1.0, at_one)], Tolerance::relative(NARROWEST), value)?;
    Some(if is_below { u / (1.0 + u) } else { 1.0 / (1.0 + u) })
}

fn times_binomials(form: &[f64]) -> Vec<f64> {
    let mut binomial = 1.0;
    let terms = form.iter().enumerate().map(|(i, c)| {
        let term = binomial * c;
        binomial *= count(form.len() - 1 - i) / count(i + 1);
        term
    });
    terms.collect()
}

/// The coefficients βᵢ = Σⱼ (i over j)/(m over j)·cⱼ in Bernstein's basis, whose minimum and maximum are bounds of the polynomial.
pub(in crate::taylor) fn bernstein(coefficients: &[f64]) -> Vec<f64> {
    let degree = coefficients.len().saturating_sub(1);
    let mut over_binomial = 1.0;
    let quotients = coefficients.iter().enumerate().map(|(j, c)| {
        let quotient = over_binomial * c;
        over_binomial *= count(j + 1) / count((degree - j).max(1));
        quotient
    });
    let mut form: Vec<f64> = quotients.collect();
    // Additions as in Pascal's triangle.
    for first in 1..form.len() {
        for i in (first..form.len()).rev() {
            form[i] += form[i - 1];
        }
    }
    form
}

/// De Casteljau's subdivision at the middle.
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
