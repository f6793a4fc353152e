//! The response of a driven oscillator → ω0, damping, drive, and the bend of the resonance, through its jumps.
//!
//! The data are the amplitude, and perhaps the phase, of the periodic response at several frequencies of the drive. Where the resonance is
//! bent over, one frequency has several responses, and which of them was measured depends on the history: the amplitude is not a function
//! of the frequency. A response of a given amplitude needs exactly one drive, on stable and unstable branches alike, so that the fit minimises its
//! difference from the acting drive. It comes from the equation of motion with all harmonics.
//!
//! The curve has the period of the drive and is its own mirror image after half of it, as the strong responses of these oscillators are.
//!
//! ```
//! use libration_lab::fit::response::{ResponseColumns, ResponseModel, ResponseTable, MeasuredAmplitude, fit_response};
//! use libration::progress::Quiet;
//!
//! // A linear oscillator with ω0 = 2, c = 0.1 and A = 0.5, without errors.
//! let frequencies: Vec<f64> = (0..21).map(|row| 1.5 + 0.05 * f64::from(row)).collect();
//! let amplitude = |w: &f64| 0.5 / ((4.0 - w * w).powi(2) + 0.01 * w * w).sqrt();
//! let amplitudes: Vec<f64> = frequencies.iter().map(amplitude).collect();
//! let columns = ResponseColumns { frequencies: &frequencies, amplitudes: &amplitudes, ..Default::default() };
//! let table = ResponseTable::new(&columns)?;
//! let fit = fit_response(&table, &[ResponseModel::Linear], MeasuredAmplitude::Peak, &Quiet)?;
//! assert!((fit.best().natural_frequency.value - 2.0).abs() < 1e-9);
//! assert!((fit.best().damping.value - 0.1).abs() < 1e-9);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Method
//! Half a period is integrated with its sensitivities, and Newton's method finds the turning point and the drive of the solution that is its own
//! mirror image afterwards (`required_drive.rs`). Starts are the solutions with one harmonic from the best points of a grid (`start.rs`); of the
//! different solutions with all harmonics that they lead to, the one with the least misfit counts. Parameters and the amplitudes about which rows are
//! linearised are renewed together, by a part of a step where a whole one goes too far, as on either side of a fold in turns (`search.rs`).

mod error;
mod model;
mod required_drive;
pub(crate) mod stability;
mod table;
mod found_row;
mod scatters;
mod search;
mod start;
mod fitted;
mod curve;
mod warning;

pub use curve::{FittedCurve, FittedCurvePoint, FittedJump};
pub use error::ResponseFitError;
pub use fitted::{FittedAnswer, ResponseFit};
pub use model::ResponseModel;
pub use table::{AmplitudeErrors, ResponseColumns, ResponseTable};
pub use warning::ResponseWarning;

use crate::parallel;
use libration::internals::progress::Watch;
use libration::progress::Progress;
use required_drive::{AllHarmonics, OneHarmonic};
use search::{ResponseMinimum, Search, State};

/// Definition of the amplitude of a response.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum MeasuredAmplitude {
    /// The largest displacement.
    #[default]
    Peak,
    /// The amplitude of the harmonic that has the frequency of the drive, as a lock-in amplifier or a fitted sine gives it.
    Fundamental,
}

/// The fits of several models to a measured response.
#[derive(Clone, Debug, PartialEq)]
pub struct ResponsesFit {
    /// Fits of the models that could be fitted, in the order of [`ResponseModel::ALL`].
    pub fits: Vec<ResponseFit>,
    /// Reasons why the other models could not be fitted.
    pub left_out: Vec<ResponseFitError>,
    /// Index of the preferred model: of those whose criterion is within two of the least one, the simplest.
    pub preferred: usize,
    /// Warnings about the preferred fit.
    pub warnings: Vec<ResponseWarning>,
}

impl ResponsesFit {
    /// The fit of the preferred model.
    #[must_use]
    pub fn best(&self) -> &ResponseFit {
        &self.fits[self.preferred]
    }
}

/// Largest difference from the least criterion for substantial support of a model (Burnham and Anderson 2002, section 2.6).
const SUBSTANTIAL: f64 = 2.0;

/// Fits models to a measured response; those that it excludes altogether are left out, with the reason, as long as another one remains.
///
/// # Accuracy
/// Uncertainties are those of least squares with effective variances; where amplitudes have errors of a few per cent they cover the truth as
/// often as stated, folds and points next to them included.
///
/// Fails for too few rows, amplitudes of π or more for a pendulum alone, rows that do not determine the parameters or that no model comes close to,
/// and a cancellation by the caller.
pub fn fit_response(
    table: &ResponseTable,
    models: &[ResponseModel],
    measured: MeasuredAmplitude,
    progress: &dyn Progress,
) -> Result<ResponsesFit, ResponseFitError> {
    let watch = &Watch::new(progress);
    let outcomes = parallel::map(models, watch, |model, watch| fitted(table, *model, measured, watch));
    watch.go_on().map_err(|_| ResponseFitError::Interrupted)?;
    let (mut fits, mut left_out) = (vec![], vec![]);
    for outcome in outcomes {
        match outcome {
            Ok(fit) => fits.push(fit),
            Err(error) => left_out.push(error),
        }
    }
    if fits.is_empty() {
        let first = left_out.into_iter().next();
        return Err(first.unwrap_or(ResponseFitError::NoConvergence(ResponseModel::Linear)));
    }
    let preferred = preferred(&fits);
    let mut fit = ResponsesFit { fits, left_out, preferred, warnings: vec![] };
    fit.warnings = warning::warnings(table, &fit);
    Ok(fit)
}

fn fitted(
    table: &ResponseTable,
    model: ResponseModel,
    measured: MeasuredAmplitude,
    watch: &Watch<'_>,
) -> Result<ResponseFit, ResponseFitError> {
    table.check_for(model)?;
    let mut refusal = ResponseFitError::NoConvergence(model);
    let of_grid: Vec<State> =
        start::starts(table, model).iter().map(|start| State::new(table, start)).collect();
    let (balance, mut near): (_, Vec<ResponseMinimum>) = (OneHarmonic(model), vec![]);
    for start in &of_grid {
        match (Search { table, model, law: &balance, watch }).near(start.clone()) {
            Ok(minimum) if near.iter().any(|other| minimum.is_at(other)) => {}
            Ok(minimum) => near.push(minimum),
            Err(ResponseFitError::Interrupted) => return Err(ResponseFitError::Interrupted),
            Err(error) => refusal = error,
        }
    }
    let starts = if near.is_empty() { of_grid } else { near.iter().map(State::after).collect() };
    let mut best: Option<(f64, ResponseFit)> = None;
    for start in starts {
        let law = AllHarmonics::new(model, measured);
        match (Search { table, model, law: &law, watch }).near(start) {
            Ok(minimum)
                if minimum.settled && best.as_ref().is_none_or(|(misfit, _)| minimum.misfit < *misfit) =>
            {
                best = fitted::described(table, &law, &minimum).map(|fit| (minimum.misfit, fit)).or(best);
            }
            Ok(_) => {}
            Err(ResponseFitError::Interrupted) => return Err(ResponseFitError::Interrupted),
            Err(error) => refusal = error,
        }
    }
    best.map(|(_, fit)| fit).ok_or(refusal)
}

/// Index of the preferred fit: of those within [`SUBSTANTIAL`] of the best one those with the fewest parameters, and of these the best.
fn preferred(fits: &[ResponseFit]) -> usize {
    let criterion = |index: usize| fits[index].aicc.unwrap_or(f64::INFINITY);
    let least = (0..fits.len()).map(criterion).fold(f64::INFINITY, f64::min);
    let order = |a: &usize, b: &usize| {
        let parameters = |index: usize| fits[index].covariance.len();
        parameters(*a).cmp(&parameters(*b)).then_with(|| criterion(*a).total_cmp(&criterion(*b)))
    };
    (0..fits.len()).filter(|&index| criterion(index) <= least + SUBSTANTIAL).min_by(order).unwrap_or(0)
}
