//! What the sizes of the terms of a step tell of its errors.

use super::Step;

/// Of one number of the state, in a part of a step.
#[derive(Clone, Copy, Debug)]
pub(super) struct SizesOfTerms {
    /// The sum of the terms that are rounded.
    pub(super) rounded: f64,
    /// What the series leaves out; `None` where its last terms vanish.
    pub(super) left_out: Option<f64>,
}

impl SizesOfTerms {
    /// Of the terms from a power on those that are rounded.
    pub(super) fn new(step: &Step<'_>, number: usize, first: usize, length: f64) -> Self {
        let h = (length / step.unit).abs();
        let (mut power, mut rounded) = (1.0, 0.0);
        let mut term = |n: usize| {
            let coefficient = step.coefficient(number, n).abs();
            // A power that overflows makes nothing of no term.
            let term = if coefficient == 0.0 { 0.0 } else { coefficient * power };
            power *= h;
            if n >= first {
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

/// How many terms tell what comes after them.
const LAST: usize = 6;

/// A geometric series after the largest of the last three terms: by parity every other may vanish.
fn left_out([a, b, _, c, d, e]: [f64; LAST]) -> Option<f64> {
    const LARGEST_RATIO: f64 = 0.9;
    let (before, end) = (f64::max(a, b), f64::max(d, e));
    if end == 0.0 {
        return (before + c > 0.0).then_some(0.0);
    }
    let ratio = (end / before).sqrt().sqrt().min(LARGEST_RATIO);
    let largest = e.max(d * ratio).max(c * ratio * ratio);
    Some(largest * ratio / (1.0 - ratio))
}
