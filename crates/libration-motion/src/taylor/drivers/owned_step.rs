//! A step that owns its data.

use crate::taylor::{StateLayout, Step};
use std::sync::Arc;

/// A step of an integration that owns its numbers.
#[derive(Clone, Debug)]
pub struct OwnedStep {
    start: f64,
    end: f64,
    unit: f64,
    terms: usize,
    coefficients: Vec<f64>,
    low: Vec<f64>,
    layout: Arc<StateLayout>,
}

impl Step<'_> {
    /// The step with its own copy of the numbers, which outlives the integration.
    #[must_use]
    pub fn to_owned_step(&self) -> OwnedStep {
        let numbers = 0..self.numbers();
        let series = numbers.clone().flat_map(|number| (0..self.terms).map(move |n| (number, n)));
        OwnedStep {
            start: self.start,
            end: self.end,
            unit: self.unit,
            terms: self.terms,
            coefficients: series.map(|(number, n)| self.coefficient(number, n)).collect(),
            low: numbers.map(|number| self.low(number)).collect(),
            layout: Arc::clone(self.layout),
        }
    }
}

impl OwnedStep {
    /// A step that was computed elsewhere: coordinate and velocity as series
    /// in powers of the time in a unit, both with the same number of terms.
    pub(crate) fn new(start: f64, end: f64, unit: f64, series: [Vec<f64>; 2]) -> Self {
        let terms = series[0].len();
        let layout = Arc::new(StateLayout::one_coordinate());
        Self { start, end, unit, terms, coefficients: series.concat(), low: vec![0.0; 2], layout }
    }

    /// The step as a borrowed view.
    #[must_use]
    pub fn step(&self) -> Step<'_> {
        Step {
            start: self.start,
            end: self.end,
            unit: self.unit,
            coefficients: &self.coefficients,
            low: &self.low,
            layout: &self.layout,
            terms: self.terms,
            lanes: 1,
            lane: 0,
        }
    }
}
