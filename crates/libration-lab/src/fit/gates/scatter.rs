//! Scatter of times about their trend, by the differences of neighbours on one side.

use super::swings::OrderedPassages;
use crate::statistics::{count, robust_deviation, root_mean_square};

/// Weights of differences of the fourth, third and second order, binomials with alternating signs: a course that is a polynomial of the third,
/// second or first degree over these passages drops out.
const DIFFERENCES: [&[f64]; 3] = [&[1.0, -4.0, 6.0, -4.0, 1.0], &[1.0, -3.0, 3.0, -1.0], &[1.0, -2.0, 1.0]];

/// Fewest differences of an order; with fewer, those of a lower order are used.
const ENOUGH: usize = 8;

/// Fewest differences among which outliers are detected.
const FEWEST_TO_JUDGE: usize = 12;

/// A standard deviation, and its degrees of freedom.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct PeriodScatter {
    pub(super) deviation: f64,
    /// Size of a sample of independent values that would determine the deviation as well.
    pub(super) degrees_of_freedom: f64,
}

impl OrderedPassages {
    /// The scatter of a quantity of passages about its trend on one side; `None` if no side has three passages in a row.
    pub(super) fn scatter(&self, of: impl Fn(usize) -> Option<f64>) -> Option<PeriodScatter> {
        let orders = || DIFFERENCES.into_iter().map(|weights| (weights, self.differences(weights, &of)));
        let (weights, differences) =
            orders().find(|(_, differences)| differences.len() >= ENOUGH).or_else(|| orders().last())?;
        let (starts, values): (Vec<usize>, Vec<f64>) = differences.into_iter().unzip();
        let deviation = if values.len() < FEWEST_TO_JUDGE {
            root_mean_square(values.iter().copied())
        } else {
            robust_deviation(&values)?
        };
        let of_one = deviation / inner_product(weights, 0).sqrt();
        let degrees_of_freedom = independent(&starts, weights);
        (!values.is_empty()).then_some(PeriodScatter { deviation: of_one, degrees_of_freedom })
    }

    /// The standard deviation of a time. A steadily changing period cancels in the fourth differences of the times; if these are few, it is half of
    /// that of the blocked times, since the middle of two edges with equal scatter scatters half as much as their distance; otherwise it is that of
    /// lower differences of the times, which contain a part of the trend too.
    pub(super) fn timing(&self) -> Option<f64> {
        let time = |passage: usize| Some(self.time(passage));
        let by_edges = || Some(0.5 * self.scatter(|passage| self.blocked(passage))?.deviation);
        let enough = self.differences(DIFFERENCES[0], time).len() >= ENOUGH;
        let by_times = || self.scatter(time).map(|scatter| scatter.deviation);
        if enough { by_times() } else { by_edges().or_else(by_times) }
    }

    /// Differences with these weights, each with its first passage.
    fn differences(&self, weights: &[f64], of: impl Fn(usize) -> Option<f64>) -> Vec<(usize, f64)> {
        let cycles = weights.len() - 1;
        let whole = |k: usize| (0..cycles).all(|step| self.cycles.binary_search(&(k + 2 * step)).is_ok());
        let difference = |k: usize| {
            let terms = weights.iter().enumerate().map(|(step, weight)| Some(weight * of(k + 2 * step)?));
            Some((k, terms.sum::<Option<f64>>()?))
        };
        self.cycles.iter().copied().filter(|&k| whole(k)).filter_map(difference).collect()
    }
}

/// Inner product of the weights with themselves shifted by `later` steps.
fn inner_product(weights: &[f64], later: usize) -> f64 {
    weights.iter().zip(weights.iter().skip(later)).map(|(a, b)| a * b).sum()
}

/// Number of independent squares whose mean has the scatter of that of the squares of these overlapping differences:
/// n²/Σρ² over all pairs.
fn independent(starts: &[usize], weights: &[f64]) -> f64 {
    let norm = inner_product(weights, 0);
    let square = |later: usize| {
        let correlation = inner_product(weights, later) / norm;
        correlation * correlation
    };
    let with_later = |&start: &usize| -> f64 {
        let overlapping =
            (1..weights.len()).filter(|later| starts.binary_search(&(start + 2 * later)).is_ok());
        overlapping.map(|later| 2.0 * square(later)).sum()
    };
    let n = count(starts.len());
    n * n / (n + starts.iter().map(with_later).sum::<f64>())
}
