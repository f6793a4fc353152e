//! One step: the state as polynomials of the time.

use crate::double_double::{DoubleDouble, two_prod, two_sum};

/// A step of an integration, which gives the state at every time inside it.
#[derive(Clone, Debug)]
pub struct Step {
    pub(super) start: f64,
    pub(super) end: f64,
    /// Coefficients in powers of the time since the start, of the coordinates and then of the velocities.
    pub(super) series: Vec<Vec<f64>>,
    /// What the first coefficients lack of the state.
    pub(super) low: Vec<f64>,
}

impl Step {
    /// A step still without length, with so many numbers in its state.
    pub(super) fn new(numbers: usize) -> Self {
        Self { start: 0.0, end: 0.0, series: vec![vec![0.0]; numbers], low: vec![0.0; numbers] }
    }

    /// Begins at a time in a state; the series have their first coefficients.
    pub(super) fn begin(&mut self, time: f64, state: &[DoubleDouble]) {
        (self.start, self.end) = (time, time);
        for ((value, series), low) in state.iter().zip(&mut self.series).zip(&mut self.low) {
            series.truncate(1);
            (series[0], *low) = (value.hi, value.lo);
        }
    }

    /// When it begins, in the direction of the integration.
    #[must_use]
    pub fn start(&self) -> f64 {
        self.start
    }

    /// When it ends: before the start when the integration goes backward.
    #[must_use]
    pub fn end(&self) -> f64 {
        self.end
    }

    /// Coordinates, then velocities, at a time between start and end.
    ///
    /// # Accuracy
    /// As good as the state at the end of the step. Outside the step the error grows with every power up to its order.
    #[must_use]
    pub fn state_at(&self, time: f64) -> Vec<f64> {
        self.two_word_state_at(time).map(DoubleDouble::to_f64).collect()
    }

    pub(super) fn two_word_state_at(&self, time: f64) -> impl Iterator<Item = DoubleDouble> {
        (0..self.series.len()).map(move |component| self.component_at(component, time))
    }

    /// Whether a time that is not before its start is not behind its end.
    pub(super) fn reaches(&self, time: f64) -> bool {
        if self.end < self.start { time >= self.end } else { time <= self.end }
    }

    /// One number of the state in two words. The time since the start is exact, in two words if need be.
    fn component_at(&self, component: usize, time: f64) -> DoubleDouble {
        let DoubleDouble { hi: elapsed, lo: remainder } = two_sum(time, -self.start);
        let (value, slope, higher) = self.parts(component, elapsed);
        let first = two_prod(slope, elapsed);
        let small = higher * elapsed + self.low_velocity(component) * elapsed;
        let base = DoubleDouble::new(value, self.low[component]) + first + small;
        if remainder == 0.0 { base } else { base + self.slope_at(component, elapsed) * remainder }
    }

    /// c₀, c₁ and c₂h + c₃h² + ….
    fn parts(&self, component: usize, h: f64) -> (f64, f64, f64) {
        let series = &self.series[component];
        let higher = series[2..].iter().rev().fold(0.0, |sum, c| (sum + c) * h);
        (series[0], series[1], higher)
    }

    /// What a coordinate's second coefficient lacks of the velocity.
    fn low_velocity(&self, component: usize) -> f64 {
        self.low.get(component + self.low.len() / 2).copied().unwrap_or(0.0)
    }

    /// The time derivative of one number of the state, so long after the start.
    pub(super) fn slope_at(&self, component: usize, h: f64) -> f64 {
        let horner = |(value, slope): (f64, f64), c: &f64| (value * h + c, slope * h + value);
        self.series[component].iter().rev().fold((0.0, 0.0), horner).1
    }
}
