//! The way to the minimum.

use crate::statistics::count;
use std::f64::consts::PI;
use std::ops::ControlFlow;

use super::layout::Layout;
use super::problem::{Minimum, NoMinimum, Problem};
use super::swing::Swing;
use super::{DampingTerms, TraceFitError, TraceOptions, huber, weak_form};
use crate::fit::cycles;
use crate::measurement::Trace;
use crate::statistics::median;

/// Traces and a model, and the weights of the rows.
pub(super) struct Search<'a> {
    pub(super) traces: &'a [Trace],
    pub(super) layout: Layout,
    pub(super) options: TraceOptions,
    swing: Swing,
    /// Of each row; with outliers turned down once a robust minimum is found.
    pub(super) weights: Vec<Vec<f64>>,
    watch: &'a mut dyn FnMut() -> ControlFlow<()>,
}

/// Evaluations for each parameter, as MINPACK counts them.
const PATIENCE: usize = 30;
/// On the way there.
const PATIENCE_GROWING: usize = 10;
/// Near a minimum that is known.
const PATIENCE_NEAR: usize = 8;
const ROBUST_ROUNDS: usize = 30;

/// How more and more of the traces is taken, in small periods.
struct Growth {
    first: f64,
    factor: f64,
    /// Below it damping is not looked for.
    damped_from: f64,
}

/// Quick, and careful: near the top a little damping decides whether the pendulum goes over it.
const QUICK: Growth = Growth { first: 1.5, factor: 2.0, damped_from: 2.9 };
const CAREFUL: Growth = Growth { first: 0.75, factor: 1.3, damped_from: 0.0 };
/// Cycles from which on all kinds of damping are looked for at once.
const CYCLES_OF_ALL_DAMPING: f64 = 11.9;
/// A search that has followed the data for so long is not lost.
const CYCLES_OF_SEARCH: f64 = 5.0;
/// Of the scatter of the data, the part that a fit leaves if it has not failed.
const GOOD: f64 = 0.0025;
/// The part beyond which it has.
pub(super) const HOPELESS: f64 = 0.5;

impl<'a> Search<'a> {
    pub(super) fn new(
        traces: &'a [Trace],
        terms: DampingTerms,
        options: TraceOptions,
        watch: &'a mut dyn FnMut() -> ControlFlow<()>,
    ) -> Result<Self, TraceFitError> {
        if traces.is_empty() {
            return Err(TraceFitError::NoTrace);
        }
        if let Some(beyond) = traces.iter().find_map(cycles::beyond_a_turn) {
            return Err(beyond.into());
        }
        let layout = Layout::new(terms, traces.len());
        let parameters = layout.len();
        if let Some(trace) = traces.iter().find(|trace| trace.len() < 2 * parameters / traces.len() + 4) {
            let (name, rows, needed) =
                (trace.name().to_owned(), trace.len(), 2 * parameters / traces.len() + 4);
            return Err(TraceFitError::TooFewRows { name, rows, parameters, needed });
        }
        let weights = stated_weights(traces);
        Ok(Self { traces, layout, options, swing: Swing::new(terms), weights, watch })
    }

    /// The same traces and weights with another model.
    pub(super) fn set_terms(&mut self, terms: DampingTerms) {
        self.layout = Layout::new(terms, self.traces.len());
        self.swing = Swing::new(terms);
        self.weights = stated_weights(self.traces);
    }

    /// The minimum, from the first swings on.
    pub(super) fn minimum_from_scratch(&mut self) -> Result<Minimum, TraceFitError> {
        let parameters = self.beginning()?;
        let quick = self.minimum_grown(parameters.clone(), &QUICK);
        match &quick {
            Ok((minimum, _)) if self.unexplained(minimum) <= GOOD => {}
            // The model fails later on, and not the search.
            Ok((_, followed)) if *followed > CYCLES_OF_SEARCH => {}
            Err(TraceFitError::Interrupted) => {}
            _ => {
                let careful = self.minimum_grown(parameters, &CAREFUL).map(|(minimum, _)| minimum);
                return better(quick.map(|(minimum, _)| minimum), careful);
            }
        }
        quick.map(|(minimum, _)| minimum)
    }

    /// The minimum, and for how many cycles the model could follow the data on the way to it.
    fn minimum_grown(
        &mut self,
        mut parameters: Vec<f64>,
        growth: &Growth,
    ) -> Result<(Minimum, f64), TraceFitError> {
        let period = 2.0 * PI / parameters[Layout::OMEGA0];
        let span = |trace: &Trace| trace.times()[trace.len() - 1] - trace.times()[0];
        let longest = self.traces.iter().map(span).fold(0.0, f64::max);
        let mut cycles = growth.first;
        self.weights = stated_weights(self.traces);
        while cycles * period < longest {
            let rows = self.rows_within(cycles * period);
            let free = self.free_within(cycles, growth);
            let minimum = self.minimum_of(rows.clone(), free, parameters, PATIENCE_GROWING)?;
            let hopeless = minimum.sum_of_squares() > HOPELESS * self.scatter(&rows, &minimum.weights);
            parameters = minimum.parameters;
            if hopeless {
                return Ok((self.minimum_with_patience(parameters, PATIENCE_GROWING)?, cycles));
            }
            cycles *= growth.factor;
        }
        Ok((self.minimum_near(parameters)?, f64::INFINITY))
    }

    /// The part of the scatter of the data that a minimum leaves.
    pub(super) fn unexplained(&self, minimum: &Minimum) -> f64 {
        minimum.sum_of_squares() / self.scatter(&self.all_rows(), &minimum.weights)
    }

    /// The weighted sum of squares about the mean of each trace, of so many rows.
    fn scatter(&self, rows: &[usize], weights: &[Vec<f64>]) -> f64 {
        let of_trace = |((trace, weights), &rows): ((&Trace, &Vec<f64>), &usize)| {
            let values = &trace.values()[..rows];
            let mean = values.iter().sum::<f64>() / count(rows);
            let deviations = values.iter().zip(weights).map(|(value, weight)| (value - mean) * weight);
            deviations.map(|deviation| deviation * deviation).sum::<f64>()
        };
        self.traces.iter().zip(weights).zip(rows).map(of_trace).sum()
    }

    /// The minimum near some parameters, robust if asked for.
    pub(super) fn minimum_near(&mut self, parameters: Vec<f64>) -> Result<Minimum, TraceFitError> {
        self.minimum_with_patience(parameters, PATIENCE)
    }

    fn minimum_with_patience(
        &mut self,
        parameters: Vec<f64>,
        patience: usize,
    ) -> Result<Minimum, TraceFitError> {
        self.weights = stated_weights(self.traces);
        if self.options.robust {
            // Least squares would be drawn away from where the search has come.
            let here = self.minimum_of(self.all_rows(), vec![], parameters.clone(), PATIENCE)?;
            self.turn_outliers_down(&here);
        }
        let mut minimum = self.minimum_of(self.all_rows(), self.free(), parameters, patience)?;
        if !self.options.robust {
            return Ok(minimum);
        }
        for _ in 0..ROBUST_ROUNDS {
            self.turn_outliers_down(&minimum);
            let next = self.minimum_next_to(minimum.parameters.clone(), self.free())?;
            let change =
                (next.sum_of_squares() / minimum.sum_of_squares().max(f64::MIN_POSITIVE) - 1.0).abs();
            minimum = next;
            if change < 1e-8 {
                break;
            }
        }
        Ok(minimum)
    }

    /// The minimum next to some parameters with these free, at the weights as they are.
    pub(super) fn minimum_next_to(
        &mut self,
        parameters: Vec<f64>,
        free: Vec<usize>,
    ) -> Result<Minimum, TraceFitError> {
        self.minimum_of(self.all_rows(), free, parameters, PATIENCE_NEAR)
    }

    fn all_rows(&self) -> Vec<usize> {
        self.traces.iter().map(Trace::len).collect()
    }

    /// The parameters that are varied.
    pub(super) fn free(&self) -> Vec<usize> {
        (0..self.layout.len())
            .filter(|&place| self.options.free_scale || place != self.layout.scale())
            .collect()
    }

    /// Residuals in units of the stated uncertainties, outliers at their full size.
    pub(super) fn unweighted(&self, minimum: &Minimum) -> Vec<f64> {
        let stated = stated_weights(self.traces).into_iter().flatten();
        let weights = minimum.weights.iter().flatten().zip(stated);
        minimum
            .residuals
            .iter()
            .zip(weights)
            .map(|(residual, (weight, stated))| residual / weight * stated)
            .collect()
    }

    /// One over the stated uncertainty of each row, or one.
    pub(super) fn stated_weights(&self) -> Vec<Vec<f64>> {
        stated_weights(self.traces)
    }

    fn turn_outliers_down(&mut self, minimum: &Minimum) {
        let residuals = self.unweighted(minimum);
        let scale = huber::scale(&residuals);
        let factors = residuals.iter().map(|&residual| huber::factor(residual, scale));
        let stated = stated_weights(self.traces).into_iter().flatten();
        let mut weights = stated.zip(factors).map(|(weight, factor)| weight * factor);
        self.weights = self.traces.iter().map(|trace| weights.by_ref().take(trace.len()).collect()).collect();
    }

    /// The parameters at which the search begins, without damping.
    fn beginning(&self) -> Result<Vec<f64>, TraceFitError> {
        let mut parameters = vec![0.0; self.layout.len()];
        parameters[self.layout.scale()] = 1.0;
        let mut omega0 = vec![];
        for (number, trace) in self.traces.iter().enumerate() {
            let name = || trace.name().to_owned();
            let begin =
                weak_form::beginning(trace).ok_or_else(|| TraceFitError::NoPendulum { name: name() })?;
            omega0.push(begin.omega0);
            parameters[self.layout.offset(number)] = begin.offset;
            for (place, value) in self.layout.first_state(number).into_iter().zip(begin.state) {
                parameters[place] = value;
            }
        }
        parameters[Layout::OMEGA0] = median(omega0).ok_or(TraceFitError::NoTrace)?;
        Ok(parameters)
    }

    fn rows_within(&self, span: f64) -> Vec<usize> {
        let least = |trace: &Trace| trace.len().min(self.layout.len() + 2);
        let within = |trace: &Trace| trace.times().partition_point(|&time| time <= trace.times()[0] + span);
        self.traces.iter().map(|trace| within(trace).max(least(trace))).collect()
    }

    /// The parameters that so many cycles determine: in few of them one kind of damping is as good as another.
    fn free_within(&self, cycles: f64, growth: &Growth) -> Vec<usize> {
        let damping = self.layout.coefficients();
        let first = damping.start;
        let is_free = |place: &usize| match damping.contains(place) {
            true if cycles >= CYCLES_OF_ALL_DAMPING => true,
            true => *place == first && cycles >= growth.damped_from,
            false => *place != self.layout.scale(),
        };
        (0..self.layout.len()).filter(is_free).collect()
    }

    fn minimum_of(
        &mut self,
        rows: Vec<usize>,
        free: Vec<usize>,
        parameters: Vec<f64>,
        patience: usize,
    ) -> Result<Minimum, TraceFitError> {
        let omega0 = parameters[Layout::OMEGA0];
        let (weights, swing, watch) = (&self.weights, &self.swing, &mut *self.watch);
        let problem = Problem {
            traces: self.traces,
            rows,
            weights,
            swing,
            layout: self.layout,
            free,
            parameters,
            watch,
        };
        problem.minimum(patience).map_err(|reason| match reason {
            NoMinimum::Interrupted => TraceFitError::Interrupted,
            NoMinimum::NoMotion => TraceFitError::NoMotion { omega0 },
        })
    }
}

/// The deeper of two minima, or the one there is.
pub(super) fn better(
    one: Result<Minimum, TraceFitError>,
    other: Result<Minimum, TraceFitError>,
) -> Result<Minimum, TraceFitError> {
    match (one, other) {
        (Err(TraceFitError::Interrupted), _) | (_, Err(TraceFitError::Interrupted)) => {
            Err(TraceFitError::Interrupted)
        }
        (Ok(one), Ok(other)) if other.sum_of_squares() < one.sum_of_squares() => Ok(other),
        (Err(_), other) => other,
        (one, _) => one,
    }
}

/// One over the stated uncertainty of each row, or one.
fn stated_weights(traces: &[Trace]) -> Vec<Vec<f64>> {
    let weights = |trace: &Trace| match trace.uncertainties() {
        Some(uncertainties) => uncertainties.iter().map(|uncertainty| 1.0 / uncertainty).collect(),
        None => vec![1.0; trace.len()],
    };
    traces.iter().map(weights).collect()
}
