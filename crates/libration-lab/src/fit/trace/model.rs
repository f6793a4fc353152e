//! What a pendulum with some kinds of damping should have shown.

use super::DampingModel;
use super::data::Data;
use super::layout::Layout;
use super::swing::{Sample, Swing};
use super::weights::Weights;
use crate::measurement::{Observable, Trace};
use crate::statistics::levenberg_marquardt::Linearised;
use nalgebra::{DMatrix, DVector};

/// The motion of some traces, and the parameters it has.
#[derive(Clone, Debug)]
pub(super) struct Model {
    pub(super) layout: Layout,
    swing: Swing,
    free_scale: bool,
}

/// What should be seen in a row, with its derivatives by the parameters at these places.
type Predicted = (f64, Vec<(usize, f64)>);

impl Model {
    /// Of so many traces; the scale of the angles is one if it is not free.
    pub(super) fn new(terms: DampingModel, traces: usize, free_scale: bool) -> Self {
        Self { layout: Layout::new(terms, traces), swing: Swing::new(terms), free_scale }
    }

    /// The places of the parameters that are varied.
    pub(super) fn free(&self) -> Vec<usize> {
        (0..self.layout.len()).filter(|&place| self.free_scale || place != self.layout.scale()).collect()
    }

    /// Residuals of so many rows, with their derivatives by the parameters at these places; none where the motion cannot be
    /// followed.
    pub(super) fn linearised(
        &self,
        data: Data<'_>,
        rows: &[usize],
        weights: &Weights,
        parameters: &[f64],
        free: &[usize],
    ) -> Option<Linearised> {
        let total = rows.iter().sum();
        let mut residuals = DVector::zeros(total);
        let mut jacobian = DMatrix::zeros(total, free.len());
        let column = |place: usize| free.iter().position(|&own| own == place);
        let columns: Vec<Option<usize>> = (0..self.layout.len()).map(column).collect();
        let mut next = 0;
        for (number, ((trace, weights), &rows)) in
            data.traces.iter().zip(weights.traces()).zip(rows).enumerate()
        {
            let predicted = self.predicted(number, trace, rows, parameters)?;
            for ((value, derivatives), (observed, weight)) in
                predicted.iter().zip(trace.values().iter().zip(weights))
            {
                residuals[next] = (value - observed) * weight;
                for &(place, derivative) in derivatives {
                    if let Some(column) = columns[place] {
                        jacobian[(next, column)] = derivative * weight;
                    }
                }
                next += 1;
            }
        }
        let finite = residuals.iter().chain(jacobian.iter()).all(|x| x.is_finite());
        finite.then_some(Linearised { residuals, jacobian })
    }

    fn predicted(
        &self,
        number: usize,
        trace: &Trace,
        rows: usize,
        parameters: &[f64],
    ) -> Option<Vec<Predicted>> {
        let layout = self.layout;
        let omega0 = parameters[Layout::OMEGA0];
        if omega0 <= 0.0 {
            return None;
        }
        let start = layout.first_state(number).map(|place| parameters[place]);
        let coefficients = &parameters[layout.coefficients()];
        let samples = self.swing.samples(omega0, coefficients, start, &trace.times()[..rows])?;
        let (offset, scale) = (layout.offset(number), layout.scale());
        let component = if trace.observable() == Observable::Angle { 0 } else { 1 };
        let places: Vec<usize> = layout.of_motion(number).collect();
        let row = |sample: &Sample| {
            let value = sample.state[component];
            let of_motion = places.iter().zip(&sample.derivatives);
            let of_motion =
                of_motion.map(|(&place, derivative)| (place, parameters[scale] * derivative[component]));
            let derivatives = of_motion.chain([(offset, 1.0), (scale, value)]).collect();
            (parameters[offset] + parameters[scale] * value, derivatives)
        };
        Some(samples.iter().map(row).collect())
    }
}
