//! Traces, the model that is to explain them, and what is asked for.

use libration::watch::Watch;

use super::data::Data;
use super::minimum::{Minimum, Start, minimum};
use super::model::Model;
use super::weights::Weights;
use super::{DampingModel, TraceFitError, TraceOptions};
use crate::measurement::Trace;

/// Traces and a model of them.
#[derive(Clone, Debug)]
pub(super) struct Problem<'a> {
    pub(super) data: Data<'a>,
    pub(super) model: Model,
    pub(super) options: TraceOptions,
}

/// Evaluations for each parameter of a search that may have to go far, as MINPACK counts them: of 24 recordings (`search.rs`) all but
/// one that no model describes ended alike with 10 and with 60.
pub(super) const PATIENCE: usize = 30;
/// Of one that begins near a minimum that is known: with 1, 3 and 30 the parameters of 21 fits moved by less than 2e-6 of their uncertainties.
const PATIENCE_NEAR: usize = 8;
/// Rounds in which the weights of outliers are renewed: with 5, 10 and 100 twelve robust fits ended alike.
const ROBUST_ROUNDS: usize = 30;
/// A relative change of the sum of squares that is none: with 1e-6 they ended alike.
const SETTLED: f64 = 1e-8;

impl<'a> Problem<'a> {
    /// Traces with rows enough for these kinds of damping.
    pub(super) fn new(
        traces: &'a [Trace],
        terms: DampingModel,
        options: TraceOptions,
    ) -> Result<Self, TraceFitError> {
        let model = Model::new(terms, traces.len(), options.free_scale);
        let data = Data::new(traces, model.layout.len())?;
        Ok(Self { data, model, options })
    }

    /// The same traces with other kinds of damping.
    pub(super) fn with_terms(&self, terms: DampingModel) -> Self {
        let model = Model::new(terms, self.data.traces.len(), self.options.free_scale);
        Self { model, ..*self }
    }

    /// The minimum near some parameters, robust if asked for.
    pub(super) fn minimum_near(
        &self,
        parameters: Vec<f64>,
        patience: usize,
        watch: &Watch<'_>,
    ) -> Result<Minimum, TraceFitError> {
        let start = |parameters: Vec<f64>, patience: usize| Start {
            parameters,
            free: self.model.free(),
            rows: self.data.rows(),
            patience,
        };
        let stated = Weights::stated(self.data.traces);
        if !self.options.robust {
            return minimum(self.data, &self.model, stated, start(parameters, patience), watch);
        }
        // Least squares would be drawn away from where the search has come.
        let here = Start { free: vec![], ..start(parameters.clone(), patience) };
        let here = minimum(self.data, &self.model, stated, here, watch)?;
        let weights = self.robust_weights(&here);
        let mut best = minimum(self.data, &self.model, weights, start(parameters, patience), watch)?;
        for _ in 0..ROBUST_ROUNDS {
            let start = start(best.parameters.clone(), PATIENCE_NEAR);
            let next = minimum(self.data, &self.model, self.robust_weights(&best), start, watch)?;
            let before = best.sum_of_squares().max(f64::MIN_POSITIVE);
            let change = (next.sum_of_squares() / before - 1.0).abs();
            best = next;
            if change < SETTLED {
                break;
            }
        }
        Ok(best)
    }

    /// The minimum next to some parameters with these free, at the weights of another minimum.
    pub(super) fn minimum_beside(
        &self,
        weights: &Weights,
        parameters: Vec<f64>,
        free: Vec<usize>,
        watch: &Watch<'_>,
    ) -> Result<Minimum, TraceFitError> {
        let start = Start { parameters, free, rows: self.data.rows(), patience: PATIENCE_NEAR };
        minimum(self.data, &self.model, weights.clone(), start, watch)
    }

    /// The part of the scatter of the data that a minimum leaves.
    pub(super) fn unexplained(&self, minimum: &Minimum) -> f64 {
        minimum.sum_of_squares() / self.data.scatter(&self.data.rows(), &minimum.weights)
    }

    fn robust_weights(&self, minimum: &Minimum) -> Weights {
        Weights::robust(self.data.traces, &minimum.standard_residuals(self.data.traces))
    }
}
