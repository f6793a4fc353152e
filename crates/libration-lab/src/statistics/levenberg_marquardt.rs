//! Nonlinear least squares by the Levenberg–Marquardt method (J. J. Moré, Lect. Notes Math. 630, 105 (1978), doi:10.1007/BFb0067700).

use levenberg_marquardt::{LeastSquaresProblem, LevenbergMarquardt, TerminationReason};
use nalgebra::storage::Owned;
use nalgebra::{DMatrix, DVector, Dyn};
use std::cell::{Cell, RefCell};

/// A model at some parameters.
#[derive(Clone, Debug)]
pub struct Linearised {
    /// Values of the model less the data, each times its weight: one over its standard deviation.
    pub residuals: DVector<f64>,
    /// The derivatives of the residuals: a row for each residual, a column for each parameter.
    pub jacobian: DMatrix<f64>,
}

/// Reason why a model has no residuals at some parameters.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ResidualsError {
    /// The parameters are outside the domain of the model.
    OutOfDomain,
    /// The model was cancelled.
    Stopped,
}

/// Minimum of the sum of squares.
#[derive(Clone, Debug)]
pub struct Minimum {
    pub parameters: DVector<f64>,
    pub linearised: Linearised,
    /// `true` if the search converged and did not end at its limit of evaluations.
    pub converged: bool,
}

/// Tolerance and limit of a search.
#[derive(Clone, Copy, Debug)]
pub struct Effort {
    /// Relative change of the sum of squares that counts as zero, and of the parameters if it is less than 1e-10; at least the accuracy of the
    /// residuals.
    pub tolerance: f64,
    /// Evaluations for each parameter and one more, as MINPACK counts them.
    pub patience: usize,
}

/// Maximum length of the first step in multiples of that of the parameters, each in units of its change by a residual of one. Moré takes 100 and
/// advises 0.1 to 100: a motion over many periods is linear in short steps only. Fits of swings give the same results with 0.1, 1, 10 and 100 (the
/// recordings of `fit/trace/search.rs`).
const STEP_BOUND: f64 = 10.0;
/// Relative size of a step of the parameters that counts as zero, however rough the search: those of a swing next to the top are exact to it when a
/// thousandth of the sum of squares is still far away.
const SMALL_STEP: f64 = 1e-10;
/// Predicted decrease of the sum of squares, relative to the tolerance, below which another step is not worth an evaluation: a tolerance of 1e-11
/// of a million rows then leaves the parameters within 1e-4 of their uncertainties.
const SETTLED: f64 = 1e-3;
/// Residuals outside the domain of the model, so large that the search turns back.
const OUT_OF_DOMAIN: f64 = 1e9;

/// The minimum next to some parameters. Outside the domain of the model the search turns back.
///
/// # Errors
/// A start outside the domain of the model, or a cancelled model.
pub fn minimum(
    start: DVector<f64>,
    effort: Effort,
    mut evaluate: impl FnMut(&DVector<f64>) -> Result<Linearised, ResidualsError>,
) -> Result<Minimum, ResidualsError> {
    let linearised = evaluate(&start)?;
    if start.is_empty() {
        return Ok(Minimum { parameters: start, linearised, converged: true });
    }
    let accepted = RefCell::new(None);
    let search = MinimumSearch {
        evaluate,
        parameters: start,
        linearised,
        accepted,
        settled: SETTLED * effort.tolerance,
        end: None.into(),
    };
    let method = LevenbergMarquardt::new()
        .with_stepbound(STEP_BOUND)
        .with_ftol(effort.tolerance)
        .with_xtol(effort.tolerance.min(SMALL_STEP))
        .with_gtol(0.0);
    let (search, report) = method.with_patience(effort.patience).minimize(search);
    if search.end.get() == Some(SearchEnd::Stopped) {
        return Err(ResidualsError::Stopped);
    }
    // No improvement possible means that rounding errors are all that is left.
    let converged = report.termination.was_successful()
        || search.end.get() == Some(SearchEnd::Settled)
        || matches!(report.termination, TerminationReason::NoImprovementPossible(_));
    Ok(Minimum { parameters: search.parameters, linearised: search.linearised, converged })
}

/// A model on its way to the minimum.
struct MinimumSearch<F> {
    evaluate: F,
    parameters: DVector<f64>,
    linearised: Linearised,
    /// Result of the last accepted step, to which a rejected one returns.
    accepted: RefCell<Option<(DVector<f64>, Linearised)>>,
    /// The relative change of the sum of squares that a linear model promises at the end.
    settled: f64,
    end: Cell<Option<SearchEnd>>,
}

/// Reason why a search ends before the method does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum SearchEnd {
    Stopped,
    Settled,
}

impl<F> LeastSquaresProblem<f64, Dyn, Dyn> for MinimumSearch<F>
where
    F: FnMut(&DVector<f64>) -> Result<Linearised, ResidualsError>,
{
    type ResidualStorage = Owned<f64, Dyn>;
    type JacobianStorage = Owned<f64, Dyn, Dyn>;
    type ParameterStorage = Owned<f64, Dyn>;

    fn set_params(&mut self, parameters: &DVector<f64>) {
        self.parameters.copy_from(parameters);
        if let Some((parameters_then, linearised)) = &*self.accepted.borrow()
            && parameters_then == parameters
        {
            self.linearised = linearised.clone();
            return;
        }
        match (self.evaluate)(parameters) {
            Ok(linearised) => self.linearised = linearised,
            Err(ResidualsError::OutOfDomain) => self.linearised.residuals.fill(OUT_OF_DOMAIN),
            Err(ResidualsError::Stopped) => self.end.set(Some(SearchEnd::Stopped)),
        }
    }

    fn params(&self) -> DVector<f64> {
        self.parameters.clone()
    }

    fn residuals(&self) -> Option<DVector<f64>> {
        self.end.get().is_none().then(|| self.linearised.residuals.clone())
    }

    /// The Jacobian at the accepted parameters, evaluated at the start and after each accepted step.
    fn jacobian(&self) -> Option<DMatrix<f64>> {
        if self.linearised.promises() <= self.settled {
            self.end.set(Some(SearchEnd::Settled));
        }
        *self.accepted.borrow_mut() = Some((self.parameters.clone(), self.linearised.clone()));
        self.end.get().is_none().then(|| self.linearised.jacobian.clone())
    }
}

impl Linearised {
    /// Relative decrease of the sum of squares to its least value in the linear model.
    pub(crate) fn promises(&self) -> f64 {
        let sum = self.residuals.norm_squared();
        if sum > 0.0 && self.jacobian.nrows() >= self.jacobian.ncols() {
            self.jacobian.clone().qr().q().tr_mul(&self.residuals).norm_squared() / sum
        } else {
            f64::INFINITY
        }
    }
}
