//! An estimate of the remainder of a truncated series.

use super::convergence::Convergence;
use super::stride::stride;
use libration_kernels::elementary::count;
use libration_numbers::algebra::BigFloat;

/// The fewest terms after the first that determine the trend of a series. With one or two, one estimate in eight was too small.
const FEWEST: usize = 3;
/// Number of terms above which [`Convergence`] is used: with eight to twelve it made one estimate in thirty too small.
const MANY: usize = 13;
/// Factor of estimated radii, whose uncertainty may be too small: without it one estimate in a hundred was too small, with it none.
const CAUTION: f64 = 1.05;

/// An estimate of the sum of the terms that are not given, infinite when too few are given or they do not shrink. `terms` are the terms
/// that are not zero with their powers.
///
/// The terms |t| of the later half are continued with the largest of their mean ratios over at least a third of it, raised by the (1 + 1/n)
/// that a series like Σ xⁿ/n needs. From 13 terms on the ratio is at most what the estimated radius of convergence makes it.
///
/// All constants here are from 18 600 partial sums (28 oscillators, periods, frequencies, harmonics and offsets, up to 40 powers, between 0.1
/// and 0.9 of the radius) compared with exact values: one estimate in 1000 was too small, one sum in nine had none; half of the others are within a
/// factor of 5. `tests/suite/remainders.rs` has the same for other oscillators.
pub(super) fn beyond_the_last(
    terms: &[(usize, &BigFloat)],
    convergence: Option<&Convergence>,
    x: f64,
) -> f64 {
    if x == 0.0 {
        return 0.0;
    }
    let [(first, _), .., (last, _)] = terms else { return f64::INFINITY };
    if terms.len() <= FEWEST {
        return f64::INFINITY;
    }
    let stride = stride(terms.iter().map(|(power, _)| *power));
    let index = |power: usize| (power - first) / stride;
    let end = index(*last);
    let from = (end / 2).min(end - 2).max(1);
    let later: Vec<(usize, f64)> = terms
        .iter()
        .map(|(power, term)| (index(*power), term.ln_magnitude()))
        .filter(|(step, _)| *step >= from)
        .collect();
    let ratio = largest_ratio(&later, ((end - from) / 3).max(1));
    let estimate = convergence.filter(|_| terms.len() > MANY);
    let of_radius = estimate.map(|radius| CAUTION * libm::pow(x.abs() / radius.at_least, count(stride)));
    let ratio = of_radius.map_or(ratio, |other| f64::min(ratio, other));
    if ratio.is_nan() || ratio >= 1.0 {
        return f64::INFINITY;
    }
    let continued = |(step, logarithm): &(usize, f64)| logarithm + count(end - step) * libm::log(ratio);
    let largest = later.iter().map(continued).fold(f64::NEG_INFINITY, f64::max);
    libm::exp(largest) * ratio / (1.0 - ratio)
}

/// The largest mean ratio of two terms, given by their logarithms, that are at least so far apart; NaN when there are none.
fn largest_ratio(terms: &[(usize, f64)], apart: usize) -> f64 {
    let pairs = terms.iter().flat_map(|a| terms.iter().map(move |b| (a, b)));
    pairs
        .filter(|((i, _), (j, _))| j - i.min(j) >= apart)
        .map(|((i, a), (j, b))| libm::exp((b - a) / count(j - i)) * (1.0 + 1.0 / count(*j)))
        .fold(f64::NAN, f64::max)
}
