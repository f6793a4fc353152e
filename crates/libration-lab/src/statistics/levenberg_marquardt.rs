//! Levenberg's and Marquardt's way to least squares of what is not linear (J. J. Moré, Lect. Notes Math. 630, 105 (1978),
//! doi:10.1007/BFb0067700).

use levenberg_marquardt::{LeastSquaresProblem, LevenbergMarquardt, TerminationReason};
use nalgebra::storage::Owned;
use nalgebra::{DMatrix, DVector, Dyn};
use std::cell::{Cell, RefCell};

/// A model at some parameters.
#[derive(Clone, Debug)]
pub(crate) struct Linearised {
    /// What it says less the data, each times its weight: one over its standard deviation.
    pub(crate) residuals: DVector<f64>,
    /// Their derivatives: a row for each residual, a column for each parameter.
    pub(crate) jacobian: DMatrix<f64>,
}

/// Why a model has no residuals at some parameters.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum NoResiduals {
    /// It says nothing there.
    OutOfDomain,
    /// It was stopped.
    Stopped,
}

/// Where the sum of squares is least.
#[derive(Clone, Debug)]
pub(crate) struct Minimum {
    pub(crate) parameters: DVector<f64>,
    pub(crate) linearised: Linearised,
    /// Whether the way ended there, and not for want of patience.
    pub(crate) converged: bool,
}

/// How far to go.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Effort {
    /// The relative change of the sum of squares that is none, and of the parameters where that is less than 1e-10; not less than the residuals
    /// are exact to.
    pub(crate) tolerance: f64,
    /// Evaluations for each parameter and one more, as MINPACK counts them.
    pub(crate) patience: usize,
}

/// The first step is at most so many times as long as the parameters, each in units of what a residual of one makes of it. Moré
/// takes 100 and advises 0.1 to 100: a motion that is followed over many periods is linear in short steps only. Fits of swings end
/// alike with 0.1, 1, 10 and 100 (the recordings of `fit/trace/search.rs`).
const STEP_BOUND: f64 = 10.0;
/// A step by a smaller part of the parameters is none, however rough the search: those of a swing next to the top are exact to it when a
/// thousandth of the sum of squares is still far away.
const SMALL_STEP: f64 = 1e-10;
/// A linear model promises so small a part of the tolerance of the sum of squares where another step is not worth an evaluation: a
/// tolerance of 1e-11 of a million rows leaves the parameters within 1e-4 of their uncertainties then.
const SETTLED: f64 = 1e-3;
/// So large that the search turns back.
const OUT_OF_DOMAIN: f64 = 1e9;

/// The minimum next to some parameters. Where the model says nothing the search turns back.
///
/// # Errors
/// The model says nothing at the start, or was stopped.
pub(crate) fn minimum(
    start: DVector<f64>,
    effort: Effort,
    mut evaluate: impl FnMut(&DVector<f64>) -> Result<Linearised, NoResiduals>,
) -> Result<Minimum, NoResiduals> {
    let linearised = evaluate(&start)?;
    if start.is_empty() {
        return Ok(Minimum { parameters: start, linearised, converged: true });
    }
    let accepted = RefCell::new(None);
    let search = Search {
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
    if search.end.get() == Some(End::Stopped) {
        return Err(NoResiduals::Stopped);
    }
    // No improvement possible means that rounding errors are all that is left.
    let converged = report.termination.was_successful()
        || search.end.get() == Some(End::Settled)
        || matches!(report.termination, TerminationReason::NoImprovementPossible(_));
    Ok(Minimum { parameters: search.parameters, linearised: search.linearised, converged })
}

/// A model on its way to the minimum.
struct Search<F> {
    evaluate: F,
    parameters: DVector<f64>,
    linearised: Linearised,
    /// Where the last good step led, to which a bad one returns.
    accepted: RefCell<Option<(DVector<f64>, Linearised)>>,
    /// The relative change of the sum of squares that a linear model promises at the end.
    settled: f64,
    end: Cell<Option<End>>,
}

/// Why a search ends before its method says so.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum End {
    Stopped,
    Settled,
}

impl<F> LeastSquaresProblem<f64, Dyn, Dyn> for Search<F>
where
    F: FnMut(&DVector<f64>) -> Result<Linearised, NoResiduals>,
{
    type ResidualStorage = Owned<f64, Dyn>;
    type JacobianStorage = Owned<f64, Dyn, Dyn>;
    type ParameterStorage = Owned<f64, Dyn>;

    fn set_params(&mut self, parameters: &DVector<f64>) {
        self.parameters.copy_from(parameters);
        if let Some((known, linearised)) = &*self.accepted.borrow()
            && known == parameters
        {
            self.linearised = linearised.clone();
            return;
        }
        match (self.evaluate)(parameters) {
            Ok(linearised) => self.linearised = linearised,
            Err(NoResiduals::OutOfDomain) => self.linearised.residuals.fill(OUT_OF_DOMAIN),
            Err(NoResiduals::Stopped) => self.end.set(Some(End::Stopped)),
        }
    }

    fn params(&self) -> DVector<f64> {
        self.parameters.clone()
    }

    fn residuals(&self) -> Option<DVector<f64>> {
        self.end.get().is_none().then(|| self.linearised.residuals.clone())
    }

    /// Asked for at the start and after each good step.
    fn jacobian(&self) -> Option<DMatrix<f64>> {
        if self.linearised.promises() <= self.settled {
            self.end.set(Some(End::Settled));
        }
        *self.accepted.borrow_mut() = Some((self.parameters.clone(), self.linearised.clone()));
        self.end.get().is_none().then(|| self.linearised.jacobian.clone())
    }
}

impl Linearised {
    /// By which part the sum of squares would fall to its least value if the model were linear.
    pub(crate) fn promises(&self) -> f64 {
        let sum = self.residuals.norm_squared();
        if sum > 0.0 && self.jacobian.nrows() >= self.jacobian.ncols() {
            self.jacobian.clone().qr().q().tr_mul(&self.residuals).norm_squared() / sum
        } else {
            f64::INFINITY
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const EFFORT: Effort = Effort { tolerance: 1e-12, patience: 100 };

    /// Residuals of a·e^(−bt) at four times from 3·e^(−t/2), which has none for b above 5.
    fn exponential(parameters: &DVector<f64>) -> Result<Linearised, NoResiduals> {
        let (a, b) = (parameters[0], parameters[1]);
        if b > 5.0 {
            return Err(NoResiduals::OutOfDomain);
        }
        let times = [0.0, 1.0, 2.0, 3.0];
        let value = |t: f64| libm::exp(-b * t);
        Ok(Linearised {
            residuals: DVector::from_fn(4, |i, _| a * value(times[i]) - 3.0 * libm::exp(-0.5 * times[i])),
            jacobian: DMatrix::from_fn(4, 2, |i, k| {
                if k == 0 { value(times[i]) } else { -a * times[i] * value(times[i]) }
            }),
        })
    }

    #[test]
    fn the_parameters_of_exact_data_come_back() {
        let found = minimum(DVector::from_row_slice(&[1.0, 4.9]), EFFORT, exponential).unwrap();
        let [a, b] = [found.parameters[0], found.parameters[1]];
        assert!((a - 3.0).abs() < 1e-9 && (b - 0.5).abs() < 1e-9 && found.converged, "{a} {b}");
        assert!(found.linearised.residuals.norm() < 1e-9);
    }

    /// Rosenbrock's valley, from its usual start.
    #[test]
    fn a_bent_valley_is_followed_to_its_end() {
        let valley = |p: &DVector<f64>| {
            Ok(Linearised {
                residuals: DVector::from_row_slice(&[10.0 * (p[1] - p[0] * p[0]), 1.0 - p[0]]),
                jacobian: DMatrix::from_row_slice(2, 2, &[-20.0 * p[0], 10.0, -1.0, 0.0]),
            })
        };
        let found = minimum(DVector::from_row_slice(&[-1.2, 1.0]), EFFORT, valley).unwrap();
        assert!(found.parameters.iter().all(|p| (p - 1.0).abs() < 1e-10), "{}", found.parameters);
    }

    #[test]
    fn a_search_without_patience_does_not_converge() {
        let effort = Effort { patience: 1, ..EFFORT };
        assert!(!minimum(DVector::from_row_slice(&[1.0, 4.9]), effort, exponential).unwrap().converged);
    }

    #[test]
    fn outside_and_stopped_are_told_apart() {
        let start = |b: f64| DVector::from_row_slice(&[1.0, b]);
        let refused = minimum(start(6.0), EFFORT, exponential).map(|_| ()).unwrap_err();
        assert_eq!(refused, NoResiduals::OutOfDomain);
        let mut evaluations = 0;
        let stopped = |parameters: &DVector<f64>| {
            evaluations += 1;
            if evaluations > 2 { Err(NoResiduals::Stopped) } else { exponential(parameters) }
        };
        assert_eq!(minimum(start(1.0), EFFORT, stopped).map(|_| ()).unwrap_err(), NoResiduals::Stopped);
    }

    /// A line through its best parameters: one evaluation tells that they are, and two from elsewhere.
    #[test]
    fn a_search_ends_where_nothing_is_promised() {
        let counted = |start: [f64; 2]| {
            let mut evaluations = 0;
            let found = minimum(DVector::from_row_slice(&start), EFFORT, |line| {
                evaluations += 1;
                let values = [1.0, 3.0, 2.0, 4.0];
                let x = |i: usize| [-1.5, -0.5, 0.5, 1.5][i];
                Ok(Linearised {
                    residuals: DVector::from_fn(4, |i, _| line[0] + line[1] * x(i) - values[i]),
                    jacobian: DMatrix::from_fn(4, 2, |i, k| if k == 0 { 1.0 } else { x(i) }),
                })
            });
            let found = found.unwrap();
            // By hand: the mean, and (1.5·3 + 0.5·(−1))/5.
            assert!((found.parameters[0] - 2.5).abs() < 1e-12 && (found.parameters[1] - 0.8).abs() < 1e-12);
            assert!(found.converged);
            evaluations
        };
        assert_eq!((counted([2.5, 0.8]), counted([2.0, 1.0])), (1, 2));
    }
}
