//! One state component at many times of a step.

use crate::taylor::Step;
use crate::taylor::step::elapsed;
use libration_kernels::dispatch::{Kernel, dispatch_slices};

impl Step<'_> {
    /// One state component, with its index from zero, at many times between start and end.
    ///
    /// # Accuracy
    /// That of [`state_at`](Step::state_at) except for the rounding to one word.
    ///
    /// # Panics
    /// An index that is too large, or different numbers of values and times.
    pub fn values_at(&self, number: usize, times: &[f64], values: &mut [f64]) {
        assert!(number < self.numbers() && times.len() == values.len(), "{number}: a number of the state");
        let series: Vec<f64> = (0..self.terms).map(|n| self.coefficient(number, n)).collect();
        let slope_low = self.layout.velocity(number).map_or(0.0, |velocity| self.low(velocity) * self.unit);
        let lows = [self.low(number), slope_low];
        dispatch_slices(ValuesKernel { step: self, series: &series, lows, times, values });
    }
}

/// The values of a series, compiled for each instruction set.
struct ValuesKernel<'s> {
    step: &'s Step<'s>,
    series: &'s [f64],
    /// Low words of the first two coefficients.
    lows: [f64; 2],
    times: &'s [f64],
    values: &'s mut [f64],
}

impl Kernel for ValuesKernel<'_> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        /// Number of times that are evaluated together: all of one power before the next, in four or eight registers.
        const TOGETHER: usize = 32;
        let [low, slope_low] = self.lows;
        for (times, values) in self.times.chunks(TOGETHER).zip(self.values.chunks_mut(TOGETHER)) {
            let (mut parts, mut sums) = ([0.0; TOGETHER], [0.0; TOGETHER]);
            for (part, &time) in parts.iter_mut().zip(times) {
                let (whole, rest) = elapsed(self.step.start, time);
                *part = (whole + rest) / self.step.unit;
            }
            for &coefficient in self.series[1..].iter().rev() {
                for (sum, part) in sums.iter_mut().zip(&parts) {
                    *sum = (*sum + coefficient) * part;
                }
            }
            for ((value, sum), part) in values.iter_mut().zip(&sums).zip(&parts) {
                *value = self.series[0] + (sum + (low + slope_low * part));
            }
        }
    }
}
