//! Traces of swings → ω0, damping and their uncertainties, at any amplitude.
//!
//! The model of the data is y = offset + scale·θ, or + scale·θ′ for angular velocities, with a motion
//! θ″ = −ω0² sin θ − d·sign θ′ − b·θ′ − c·θ′|θ′| that begins with an angle and a velocity of its own in each trace. The
//! equation is integrated together with its derivatives with respect to all of these, and Levenberg's and Marquardt's method
//! (J. J. Moré, Lect. Notes Math. 630, 105 (1978), doi:10.1007/BFb0067700) minimises the sum of squares. It starts from
//! the weak form of the equation, which needs no guess, in the first swings, and takes more and more of the trace.
//!
//! Uncertainties are those of the scatter, or of the stated ones if these are larger, times their inflation by the correlation of
//! residuals: the noise is fitted with the parameters, and where residuals are not noise at all a bootstrap
//! of blocks shows whether that is enough. Errors common to all rows, as by a clock or a pivot that was fitted, are added.
//!
//! # Method
//! The motions of all traces go side by side through the lanes of the integrator, and each step gives the model values of all rows in it
//! (`Step::values_at`). Only the derivatives by the coefficients of the damping and by one shift of the first state are integrated (`swing.rs`).
//! Residuals and derivatives are reduced by orthogonal transformations to as many rows as there are parameters, with the same sum of squares and
//! slopes (`statistics/triangle.rs`), so that the cost of Levenberg's and Marquardt's method does not depend on the number of rows.
//!
//! The search thins rows to 64 in a period (`series.rs`), follows the motion to 1e-9 and ends roughly. Further starts are not tried once two ends
//! are alike, in phase with the data throughout, or leave only noise. The last descent has all rows, each model its numbers, and the preferred
//! model its last digits. A search ends without a further motion when a linear model predicts a decrease below the tolerance.

mod error;
mod options;
pub(crate) mod swing;
mod weak_form;
mod sine;
mod data;
pub(crate) mod huber;
mod layout;
pub(crate) mod minimum;
pub(crate) mod model;
pub(crate) mod problem;
pub(crate) mod search;
pub(crate) mod series;
pub(crate) mod weights;
mod autocorrelation;
mod bootstrap;
pub(crate) mod noise;
pub(crate) mod random;
mod response;
pub(crate) mod uncertainty;
pub(crate) mod clock;
mod pivot;
pub(crate) mod systematic;
pub(crate) mod profile;
pub(crate) mod comparison;
mod fitted;
pub(crate) mod information;
mod continuation;

pub use super::{DampingKind, DampingModel, DampingModelError};
pub use autocorrelation::Autocorrelation;
pub use comparison::{Comparison, ModelAverage, Standing, compare};
pub use continuation::{ContinuationError, FittedDecay, FittedTurningPoint};
pub use error::TraceFitError;
pub use fitted::{FittedTrace, Parameter, ParameterKind, TraceFit};
pub use options::TraceOptions;

use crate::measurement::Trace;
use libration::internals::progress::Watch;
use libration::progress::Progress;
use problem::Problem;

/// Fits a model with these kinds of damping to traces of the same pendulum, which share ω0, damping and scale.
///
/// # Errors
/// Fails for too few rows, a trace that is not that of a pendulum, parameters that the data do not determine, and a cancellation.
///
/// # Examples
/// ```
/// use libration_lab::fit::trace::{DampingKind, DampingModel, TraceOptions, fit_traces};
/// use libration_lab::measurement::{Observable, Trace};
/// use libration::pendulum::Pendulum;
/// use libration::progress::Quiet;
///
/// let motion = Pendulum::from_angular_frequency(3.0)?.released_from("100deg".parse()?)?;
/// let times: Vec<f64> = (0..300).map(|row| 0.02 * f64::from(row)).collect();
/// let angles = times.iter().map(|&time| motion.state_at(time).angle).collect();
/// let trace = Trace::new("exact", Observable::Angle, times, angles, None)?;
/// let linear = DampingModel::only(DampingKind::Linear);
/// let fit = fit_traces(&[trace], linear, &TraceOptions::default(), &Quiet)?;
/// assert!((fit.parameters[0].estimate.value - 3.0).abs() < 1e-8);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn fit_traces(
    traces: &[Trace],
    damping: DampingModel,
    options: &TraceOptions,
    progress: &dyn Progress,
) -> Result<TraceFit, TraceFitError> {
    let watch = &Watch::new(progress);
    let problem = Problem::new(traces, damping, *options)?;
    let end = search::from_scratch(&problem, None, watch)?;
    if end.is_lost() {
        return Err(end.unexplained_data());
    }
    let minimum = problem.minimum_near(end.parameters, problem::PATIENCE, minimum::Care::FULL, watch)?;
    let fit = uncertainty::fit(&problem, &minimum, watch)?;
    check_explained(&fit).map(|()| fit)
}

/// Refuses a fit that leaves more than half of the data unexplained.
fn check_explained(fit: &TraceFit) -> Result<(), TraceFitError> {
    let percent = 100.0 * fit.unexplained;
    if fit.unexplained > minimum::HOPELESS { Err(TraceFitError::Unexplained { percent }) } else { Ok(()) }
}
