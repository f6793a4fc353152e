//! Traces, the model that is fitted to them, and the options of the fit.

use libration::internals::progress::Watch;

use super::data::Data;
use super::minimum::{Care, Descent, Start, TraceMinimum, descent, linearised, promised};
use super::model::Model;
use super::series;
use super::weak_form::{self, Beginning};
use super::weights::Weights;
use super::{DampingModel, TraceFitError, TraceOptions};
use crate::measurement::Trace;
use crate::statistics::median;
use std::f64::consts::TAU;

/// Traces and a model of them.
#[derive(Clone, Debug)]
pub struct Problem<'a> {
    /// The traces.
    pub data: Data<'a>,
    /// The model that is fitted to them.
    pub model: Model,
    pub(super) options: TraceOptions,
    /// Starts of the search, one for each trace.
    pub(super) beginnings: Vec<Beginning>,
    /// Length of the longest trace in periods of small swings.
    pub cycles: f64,
}

/// Evaluations for each parameter of a long search, counted as in MINPACK: of 24 recordings (`search.rs`) all but one that no model describes gave
/// the same results with 10 and with 60.
pub const PATIENCE: usize = 30;
/// Evaluations of a search that begins near a known minimum: with 1, 3 and 30 the parameters of 21 fits moved by less than 2e-6 of their
/// uncertainties.
const PATIENCE_NEAR: usize = 8;
/// Rounds in which the weights of outliers are renewed: with 5, 10 and 100 twelve robust fits ended alike.
const ROBUST_ROUNDS: usize = 30;
/// Largest negligible relative change of the sum of squares: with 1e-6 they ended alike.
const SETTLED: f64 = 1e-8;

/// Relative decrease of the sum below which the model is taken as linear: its error is of the order of the square of the step, so that a predicted
/// decrease of a hundredth is wrong by far less, and the ends of intervals by less than a thousandth of a deviation.
const SMALL_PART: f64 = 0.01;

impl<'a> Problem<'a> {
    /// Checks that traces have enough rows for these kinds of damping, and prepares their fit.
    pub fn new(
        traces: &'a [Trace],
        terms: DampingModel,
        options: TraceOptions,
    ) -> Result<Self, TraceFitError> {
        let model = Model::new(terms, traces.len(), options.free_scale);
        let data = Data::new(traces, model.layout.len())?;
        let beginning = |trace: &Trace| {
            let no_pendulum = || TraceFitError::NoPendulum { name: trace.name().to_owned() };
            weak_form::beginning(trace).ok_or_else(no_pendulum)
        };
        let beginnings = traces.iter().map(beginning).collect::<Result<Vec<Beginning>, TraceFitError>>()?;
        let omega0 = median(beginnings.iter().map(|beginning| beginning.omega0).collect());
        let cycles = data.span() * omega0.ok_or(TraceFitError::NoTrace)? / TAU;
        Ok(Self { data, model, options, beginnings, cycles })
    }

    /// Returns the problem of the same traces with other kinds of damping.
    pub(super) fn with_terms(&self, terms: DampingModel) -> Self {
        let model = Model::new(terms, self.data.traces.len(), self.options.free_scale);
        Self { model, ..self.clone() }
    }

    /// Finds the minimum near some parameters, robust if requested.
    pub fn minimum_near(
        &self,
        parameters: Vec<f64>,
        patience: usize,
        care: Care,
        watch: &Watch<'_>,
    ) -> Result<TraceMinimum, TraceFitError> {
        let free = self.model.free();
        let stated = Weights::stated(self.data.traces);
        if !self.options.robust {
            return self.minimum_with(stated, Start { parameters, free, patience, care }, watch);
        }
        // Least squares would be drawn away from the start.
        let here = Start { parameters: parameters.clone(), free: vec![], patience, care };
        let weights = self.robust_weights(&self.minimum_with(stated, here, watch)?);
        let start = Start { parameters, free: free.clone(), patience, care };
        let mut best = self.minimum_with(weights, start, watch)?;
        for _ in 0..ROBUST_ROUNDS {
            let (parameters, free) = (best.parameters.clone(), free.clone());
            let start = Start { parameters, free, patience: PATIENCE_NEAR, care };
            let next = self.minimum_with(self.robust_weights(&best), start, watch)?;
            let before = best.sum_of_squares().max(f64::MIN_POSITIVE);
            let change = (next.sum_of_squares() / before - 1.0).abs();
            best = next;
            if change < SETTLED {
                break;
            }
        }
        Ok(best)
    }

    /// Finds the approximate end of the descent from some parameters, by enough rows of all traces; with outliers down-weighted, if requested,
    /// the minimum by all rows.
    pub(super) fn approach(
        &self,
        parameters: Vec<f64>,
        patience: usize,
        watch: &Watch<'_>,
    ) -> Result<Descent, TraceFitError> {
        if self.options.robust {
            let minimum = self.minimum_near(parameters, patience, Care::COMPARISON, watch)?;
            return Ok(minimum.to_descent(self.unexplained(&minimum)));
        }
        let start = Start { parameters, free: self.model.free(), patience, care: Care::SEARCH };
        self.descent_over(self.cycles, start, watch)
    }

    /// Describes given parameters as the end of a descent, by enough rows of all traces.
    pub(super) fn without_descent(
        &self,
        parameters: Vec<f64>,
        watch: &Watch<'_>,
    ) -> Result<Descent, TraceFitError> {
        let start = Start { parameters, free: vec![], patience: 1, care: Care::SEARCH };
        self.descent_over(self.cycles, start, watch)
    }

    /// Finds the approximate end of the descent, by enough rows of this number of periods of small swings.
    pub(super) fn descent_over(
        &self,
        cycles: f64,
        start: Start,
        watch: &Watch<'_>,
    ) -> Result<Descent, TraceFitError> {
        let (span, stated) = (self.data.span(), Weights::stated(self.data.traces));
        let rows = self.data.rows_within(span * cycles / self.cycles, self.model.layout.len() + 2);
        descent(&self.model, &series::of_search(self.data, &rows, &stated, cycles), start, watch)
    }

    /// The least sum of squares next to given parameters with these free, with the weights of a minimum with this sum. If the decrease is a small
    /// fraction of the difference of the sum from that minimum, the model is taken as linear.
    pub fn sum_beside(
        &self,
        weights: &Weights,
        parameters: Vec<f64>,
        free: Vec<usize>,
        least: f64,
        watch: &Watch<'_>,
    ) -> Result<f64, TraceFitError> {
        let series = series::whole(self.data, weights);
        let start = Start { parameters, free, patience: PATIENCE_NEAR, care: Care::FULL };
        let (sum, promised) = promised(&self.model, &series, &start, watch)?;
        if promised <= SMALL_PART * (sum - least) {
            return Ok(sum - promised);
        }
        Ok(descent(&self.model, &series, start, watch)?.sum_of_squares)
    }

    fn minimum_with(
        &self,
        weights: Weights,
        start: Start,
        watch: &Watch<'_>,
    ) -> Result<TraceMinimum, TraceFitError> {
        let (series, free) = (series::whole(self.data, &weights), start.free.clone());
        let descent = descent(&self.model, &series, start, watch)?;
        let linearised = linearised(&self.model, &series, &free, &descent)?;
        let Descent { parameters, converged, .. } = descent;
        drop(series);
        Ok(TraceMinimum { parameters, linearised, weights, converged })
    }

    /// The fraction of the scatter of the data that a minimum leaves unexplained.
    pub(super) fn unexplained(&self, minimum: &TraceMinimum) -> f64 {
        minimum.sum_of_squares() / series::scatter(&series::whole(self.data, &minimum.weights))
    }

    fn robust_weights(&self, minimum: &TraceMinimum) -> Weights {
        Weights::robust(self.data.traces, &minimum.standard_residuals(self.data.traces))
    }
}
