//! One number of the state at many times of a step.

use super::Step;
use super::step::elapsed;
use libration_kernels::dispatch::{Kernel, dispatch_slices};

impl Step<'_> {
    /// One number of the state, counted from zero, at many times between start and end.
    ///
    /// # Accuracy
    /// That of [`state_at`](Step::state_at) but for the rounding of one word.
    ///
    /// # Panics
    /// No such number, or not as many values as times.
    pub fn values_at(&self, number: usize, times: &[f64], values: &mut [f64]) {
        assert!(number < self.numbers() && times.len() == values.len(), "{number}: a number of the state");
        let series: Vec<f64> = (0..self.terms).map(|n| self.coefficient(number, n)).collect();
        let slope_low = self.layout.velocity(number).map_or(0.0, |velocity| self.low(velocity) * self.unit);
        let lows = [self.low(number), slope_low];
        dispatch_slices(Values { step: self, series: &series, lows, times, values });
    }
}

/// The values of a series, compiled for each instruction set.
struct Values<'s> {
    step: &'s Step<'s>,
    series: &'s [f64],
    /// What the first two coefficients lack.
    lows: [f64; 2],
    times: &'s [f64],
    values: &'s mut [f64],
}

impl Kernel for Values<'_> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        /// Times that are done together: all of one power before the next, in four or eight registers.
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

#[cfg(test)]
mod tests {
    use crate::taylor::{Effort, Moment, System, integrate_watched};
    use std::ops::ControlFlow;

    /// Fewer and more times than are done together, with those of start and end.
    #[test]
    fn many_values_are_those_of_the_states() {
        let system = System::new(&"theta'' + theta'/10 + sin(theta) = 0".parse().unwrap()).unwrap();
        let start = Moment { time: 3.0, state: vec![2.0, 0.3] };
        for end in [20.0, -20.0] {
            integrate_watched(&system, &start, &[end], &Effort::to_tolerance(1e-15), |step| {
                for parts in [1_u32, 5, 63, 100] {
                    let length = (step.end() - step.start()) / f64::from(parts);
                    let inner = (0..parts).map(|part| step.start() + length * f64::from(part));
                    let times: Vec<f64> = inner.chain([step.end()]).collect();
                    for number in 0..2 {
                        let mut values = vec![f64::NAN; times.len()];
                        step.values_at(number, &times, &mut values);
                        for (time, value) in times.iter().zip(values) {
                            let error = (value - step.state_at(*time)[number]).abs();
                            assert!(error <= 4.0 * f64::EPSILON * (1.0 + value.abs()), "{time}: {error}");
                        }
                    }
                }
                ControlFlow::Continue(())
            })
            .unwrap();
        }
    }
}
