//! Remainder of a power series whose coefficients are all non-negative.

use libration_kernels::elementary::count;

/// Σ cₙxⁿ with cₙ ≥ 0, where n increases by a constant stride, up to some power.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct PositiveSeries {
    /// Coefficients, indexed by powers from zero.
    coefficients: Vec<f64>,
    first: usize,
    stride: usize,
}

/// The remainder of such a series at one point.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct PositiveSeriesAt<'a> {
    series: &'a PositiveSeries,
    x: f64,
    /// Larger arguments, with bounds of the whole series there.
    larger: Vec<(f64, f64)>,
}

/// Bound of the relative rounding error of sums and values, far above the actual one: each has less than 1e5 terms, all positive.
const ROUNDING: f64 = 1e-10;

impl PositiveSeries {
    /// The powers `first`, `first` + `stride`, … of these coefficients, which are indexed by the power from zero.
    pub(crate) const fn new(coefficients: Vec<f64>, first: usize, stride: usize) -> Self {
        Self { coefficients, first, stride }
    }

    /// The remainder at x, where `value` gives the whole series, right to 1e-11 or too large, at any x below the limit.
    pub(crate) fn at(&self, x: f64, limit: f64, value: impl Fn(f64) -> f64) -> PositiveSeriesAt<'_> {
        // All coefficients being positive, the remainder at x is at most (x/y)^next of that at a larger y. At x itself rounding would
        // hide a remainder that is small, near the limit the value is large: the best of some is taken.
        // With 24 it is within 2 % of the remainder, where that is the bound itself, up to 0.9999 of the limit
        // (tests/suite/period_majorants.rs).
        const PLACES: u32 = 24;
        let x = x.abs();
        let larger_point = |n: u32| x + (limit - x) * (1.0 - libm::exp2(-f64::from(n) / 2.0));
        let larger = match x < limit {
            true => (0..PLACES).map(larger_point).map(|y| (y, value(y) * (1.0 + ROUNDING))).collect(),
            false => vec![],
        };
        PositiveSeriesAt { series: self, x, larger }
    }

    /// The first power beyond this one.
    fn next(&self, power: usize) -> usize {
        match power.checked_sub(self.first) {
            None => self.first,
            Some(beyond) => self.first + (beyond / self.stride + 1) * self.stride,
        }
    }
}

impl PositiveSeriesAt<'_> {
    /// A bound of the remainder if the series ends with this power; infinite from the limit on.
    pub(crate) fn after(&self, power: usize) -> f64 {
        if self.x.is_nan() {
            return f64::NAN;
        }
        if self.x == 0.0 {
            return 0.0;
        }
        let next = count(self.series.next(power));
        let coefficients = &self.series.coefficients[..self.series.coefficients.len().min(power + 1)];
        let bound = |(y, value): &(f64, f64)| {
            let sum = coefficients.iter().rev().fold(0.0, |sum, coefficient| sum * y + coefficient);
            let share = libm::pow(self.x / y, next) * (1.0 + ROUNDING);
            share * (value - sum * (1.0 - ROUNDING))
        };
        // At a limit the value may be infinite: so are these bounds, or NaN.
        self.larger.iter().map(bound).fold(f64::INFINITY, f64::min)
    }
}
