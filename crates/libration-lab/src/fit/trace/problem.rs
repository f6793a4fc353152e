//! Residuals and their derivatives: what Levenberg's and Marquardt's method asks for.

use std::ops::ControlFlow;

use levenberg_marquardt::{LeastSquaresProblem, LevenbergMarquardt, TerminationReason};
use nalgebra::storage::Owned;
use nalgebra::{DMatrix, DVector, Dyn};

use super::layout::Layout;
use super::swing::Swing;
use crate::measurement::{Seen, Trace};

/// Traces, as far as they are looked at, and a model.
pub(super) struct Problem<'a> {
    pub(super) traces: &'a [Trace],
    /// The number of rows of each trace that count.
    pub(super) rows: Vec<usize>,
    /// By which the residual of each row is multiplied.
    pub(super) weights: &'a [Vec<f64>],
    pub(super) swing: &'a Swing,
    pub(super) layout: Layout,
    /// The places of the parameters that are varied.
    pub(super) free: Vec<usize>,
    /// The values of all parameters.
    pub(super) parameters: Vec<f64>,
    /// May stop the fit before each evaluation.
    pub(super) watch: &'a mut dyn FnMut() -> ControlFlow<()>,
}

/// The best parameters, and what is known there.
#[derive(Clone, Debug)]
pub(super) struct Minimum {
    pub(super) parameters: Vec<f64>,
    /// Weighted, of all rows that count.
    pub(super) residuals: DVector<f64>,
    /// Of the weighted residuals by the free parameters.
    pub(super) jacobian: DMatrix<f64>,
    /// The weights of all rows there.
    pub(super) weights: Vec<Vec<f64>>,
    pub(super) converged: bool,
}

impl Minimum {
    /// The sum of the squares of the residuals.
    pub(super) fn sum_of_squares(&self) -> f64 {
        self.residuals.norm_squared()
    }
}

/// Why there is no minimum.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum NoMinimum {
    Interrupted,
    /// The motion cannot be followed even where the search begins.
    NoMotion,
}

impl Problem<'_> {
    /// Follows the motion of all traces from the parameters it has to the nearest minimum.
    pub(super) fn minimum(mut self, patience: usize) -> Result<Minimum, NoMinimum> {
        let free = self.free_parameters();
        let evaluation = self.evaluated()?;
        if free.is_empty() {
            let (residuals, jacobian) = evaluation;
            let (parameters, weights) = (self.parameters, self.weights.to_vec());
            return Ok(Minimum { parameters, residuals, jacobian, weights, converged: true });
        }
        let search = Search { problem: self, evaluation, interrupted: false };
        let method =
            LevenbergMarquardt::new().with_stepbound(10.0).with_ftol(1e-11).with_xtol(1e-11).with_gtol(0.0);
        let (search, report) = method.with_patience(patience).minimize(search);
        if search.interrupted {
            return Err(NoMinimum::Interrupted);
        }
        // No improvement possible means that rounding errors are all that is left.
        let converged = report.termination.was_successful()
            || matches!(report.termination, TerminationReason::NoImprovementPossible(_));
        let Search { problem, evaluation: (residuals, jacobian), .. } = search;
        let weights = problem.weights.to_vec();
        Ok(Minimum { parameters: problem.parameters, residuals, jacobian, weights, converged })
    }

    fn free_parameters(&self) -> DVector<f64> {
        DVector::from_iterator(self.free.len(), self.free.iter().map(|&place| self.parameters[place]))
    }

    fn evaluated(&mut self) -> Result<(DVector<f64>, DMatrix<f64>), NoMinimum> {
        if (self.watch)().is_break() {
            return Err(NoMinimum::Interrupted);
        }
        let total = self.rows.iter().sum();
        let mut residuals = DVector::zeros(total);
        let mut jacobian = DMatrix::zeros(total, self.free.len());
        let mut column_of = vec![None; self.layout.len()];
        for (column, &place) in self.free.iter().enumerate() {
            column_of[place] = Some(column);
        }
        let mut first = 0;
        for trace in 0..self.traces.len() {
            let rows = self.predicted(trace).ok_or(NoMinimum::NoMotion)?;
            let observed = self.traces[trace].values().iter().zip(&self.weights[trace]);
            for (row, ((value, derivatives), (observed, weight))) in (first..).zip(rows.iter().zip(observed))
            {
                residuals[row] = (value - observed) * weight;
                for &(place, derivative) in derivatives {
                    if let Some(column) = column_of[place] {
                        jacobian[(row, column)] = derivative * weight;
                    }
                }
            }
            first += rows.len();
        }
        let finite = residuals.iter().chain(jacobian.iter()).all(|x| x.is_finite());
        if finite { Ok((residuals, jacobian)) } else { Err(NoMinimum::NoMotion) }
    }

    /// What should be seen in the rows of a trace, with its derivatives by the parameters at these places.
    #[expect(clippy::type_complexity, reason = "a value with its derivatives, row by row")]
    fn predicted(&self, trace: usize) -> Option<Vec<(f64, Vec<(usize, f64)>)>> {
        let at = |place: usize| self.parameters[place];
        let times = &self.traces[trace].times()[..self.rows[trace]];
        let coefficients = &self.parameters[self.layout.coefficients()];
        let start = self.layout.first_state(trace).map(at);
        let omega0 = at(Layout::OMEGA0);
        if omega0 <= 0.0 {
            return None;
        }
        let samples = self.swing.samples(omega0, coefficients, start, times)?;
        let (offset, scale) = (self.layout.offset(trace), self.layout.scale());
        let number = if self.traces[trace].seen() == Seen::Angle { 0 } else { 1 };
        let places: Vec<usize> = self.layout.of_motion(trace).collect();
        let row = |sample: &super::swing::Sample| {
            let value = sample.state[number];
            let of_motion = places.iter().zip(&sample.derivatives);
            let of_motion = of_motion.map(|(&place, derivative)| (place, at(scale) * derivative[number]));
            (at(offset) + at(scale) * value, of_motion.chain([(offset, 1.0), (scale, value)]).collect())
        };
        Some(samples.iter().map(row).collect())
    }
}

/// A problem on its way to the minimum.
struct Search<'a> {
    problem: Problem<'a>,
    evaluation: (DVector<f64>, DMatrix<f64>),
    interrupted: bool,
}

impl LeastSquaresProblem<f64, Dyn, Dyn> for Search<'_> {
    type ResidualStorage = Owned<f64, Dyn>;
    type JacobianStorage = Owned<f64, Dyn, Dyn>;
    type ParameterStorage = Owned<f64, Dyn>;

    fn set_params(&mut self, free: &DVector<f64>) {
        let problem = &mut self.problem;
        for (&place, &value) in problem.free.iter().zip(free.iter()) {
            problem.parameters[place] = value;
        }
        match problem.evaluated() {
            Ok(evaluation) => self.evaluation = evaluation,
            // So large that the search turns back.
            Err(NoMinimum::NoMotion) => self.evaluation.0.fill(1e9),
            Err(NoMinimum::Interrupted) => self.interrupted = true,
        }
    }

    fn params(&self) -> DVector<f64> {
        self.problem.free_parameters()
    }

    fn residuals(&self) -> Option<DVector<f64>> {
        (!self.interrupted).then(|| self.evaluation.0.clone())
    }

    fn jacobian(&self) -> Option<DMatrix<f64>> {
        (!self.interrupted).then(|| self.evaluation.1.clone())
    }
}
