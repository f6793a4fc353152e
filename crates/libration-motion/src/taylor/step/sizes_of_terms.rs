//! Error estimates of a step from the sizes of its terms.

use crate::taylor::Step;

/// The sizes of the terms of one state component, in a part of a step.
#[derive(Clone, Copy, Debug)]
pub(in crate::taylor) struct SizesOfTerms {
    /// The sum of the terms that are rounded.
    pub(in crate::taylor) rounded: f64,
    /// Estimate of the truncation error of the series; `None` if its last terms vanish.
    pub(in crate::taylor) left_out: Option<f64>,
}

impl SizesOfTerms {
    pub(in crate::taylor) fn new(step: &Step<'_>, number: usize, length: f64) -> Self {
        let h = (length / step.unit).abs();
        let (mut power, mut rounded) = (1.0, 0.0);
        let mut term = |n: usize| {
            let coefficient = step.coefficient(number, n).abs();
            // A coefficient of zero stays zero even if the power overflows.
            let term = if coefficient == 0.0 { 0.0 } else { coefficient * power };
            power *= h;
            // Terms up to the first power are added in two words.
            if n >= 2 {
                rounded += term;
            }
            term
        };
        let before_last = step.terms.saturating_sub(LAST);
        (0..before_last).for_each(|n| _ = term(n));
        let mut last = [0.0; LAST];
        last.iter_mut().zip(before_last..step.terms).for_each(|(last, n)| *last = term(n));
        Self { rounded, left_out: left_out(last) }
    }
}

/// Number of last terms from which the remainder is estimated.
const LAST: usize = 12;

/// The sum of a geometric series that continues the largest of the last terms: by parity
/// every other term may vanish, and next to pairs of singularities the terms oscillate.
fn left_out(last: [f64; LAST]) -> Option<f64> {
    /// Largest ratio of the sizes of successive terms; the sum of those left out is then nine times the last one.
    const LARGEST_RATIO: f64 = 0.9;
    const MARGIN: f64 = 4.0;
    let largest = |terms: &[f64]| terms.iter().copied().fold(0.0, f64::max);
    let (before, end) = (largest(&last[..4]), largest(&last[8..]));
    if end == 0.0 {
        return (largest(&last) > 0.0).then_some(0.0);
    }
    let ratio = (end / before).sqrt().sqrt().sqrt().min(LARGEST_RATIO);
    let next = last[4..].iter().fold(0.0, |next: f64, term| (next * ratio).max(*term));
    Some(MARGIN * next * ratio / (1.0 - ratio))
}
