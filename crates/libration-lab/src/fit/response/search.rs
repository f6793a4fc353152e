//! Least squares with errors in amplitude, frequency and phase.
//!
//! The amplitude that a row would have without its error is found with the parameters: the required drive is linearised there, and
//! its difference from the acting drive is weighted by its effective variance, which at a fold, where the amplitude changes nothing to
//! first order, is that of second order. Amplitudes, weights and parameters are renewed together until nothing changes
//! (M. Lybanon, Am. J. Phys. 52, 22 (1984), doi:10.1119/1.13822): a round is a step of Gauss and Newton with fixed weights, of which a part is
//! taken by Aitken's rule for vectors (B. M. Irons and R. C. Tuck, Int. J. Numer. Meth. Eng. 1, 275 (1969), doi:10.1002/nme.1620010306). Rounds that
//! minimise with fixed weights and amplitudes do not settle for all rows: with Duffing's oscillator through those of a pendulum they jump between two
//! minima, whatever part of a step is taken.

use super::ResponseFitError;
use super::found_row::FoundRow;
use super::model::ResponseModel;
use super::required_drive::{Asked, DriveMethod, OneHarmonic, RequiredDrive};
use super::scatters::Scatters;
use super::table::{ResponseRow, ResponseTable};
use crate::statistics::{LinearFit, least_squares};
use libration::algebra::Complex;
use libration::internals::progress::Watch;
use nalgebra::{DMatrix, DVector, RowDVector};

/// Largest negligible step of a parameter or an amplitude, relative to its standard deviation.
const SETTLED: f64 = 1e-2;
/// Largest negligible relative change of the scatter.
const SETTLED_SCATTER: f64 = 1e-3;
/// Distance of the two outer points of three, in standard deviations, that represent a normal distribution up to its fifth moment.
const SPREAD: f64 = 1.732_050_807_568_877_2;
/// Least deviation relative to the required drive: smaller errors are rounding.
const LEAST_DEVIATION: f64 = 1e-12;
/// Rounds of a search: five to ten are usual, and more than eighty were where a model missed rows next to a fold by several standard deviations.
const MOST_ROUNDS: usize = 160;
/// Smallest fraction of a step, which is taken even if it is too long.
const LEAST_PART: f64 = 1.0 / 64.0;

/// The best parameters under a law.
#[derive(Clone, Debug)]
pub(super) struct ResponseMinimum {
    /// ω0², c, perhaps κ, and A.
    pub(super) parameters: Vec<f64>,
    /// Covariance of the parameters, where the uncertainties of the rows are right.
    pub(super) covariance: DMatrix<f64>,
    pub(super) chi2: f64,
    /// Factors of the uncertainties of the rows: the scatter if none are stated, otherwise one.
    pub(super) scatters: Scatters,
    /// The misfit that is minimised: χ², or where no uncertainties are stated −2 times the logarithm of the likelihood.
    pub(super) misfit: f64,
    pub(super) rows: Vec<FoundRow>,
    /// `true` if the changes of the last round were small enough.
    pub(super) settled: bool,
}

impl ResponseMinimum {
    /// Returns `true` if another search ended at the same parameters, within a tenth of their standard deviations.
    pub(super) fn is_at(&self, other: &Self) -> bool {
        let off = |k: usize| (self.parameters[k] - other.parameters[k]).abs();
        (0..self.parameters.len()).all(|k| off(k) < 0.1 * other.covariance[(k, k)].sqrt())
    }
}

/// Values that a search renews.
#[derive(Clone, Debug)]
pub(super) struct State {
    parameters: DVector<f64>,
    /// Amplitudes of the rows without their errors.
    amplitudes: Vec<f64>,
    scatters: Scatters,
}

impl State {
    /// These parameters, with the rows as measured.
    pub(super) fn new(table: &ResponseTable, parameters: &[f64]) -> Self {
        Self {
            parameters: DVector::from_row_slice(parameters),
            amplitudes: table.rows.iter().map(|row| row.amplitude).collect(),
            scatters: Scatters::first(table),
        }
    }

    /// The parameters found by another search, with the damping replaced by the root of the standard deviation of its square if that is larger: at
    /// zero damping, amplitudes do not depend on it to first order.
    pub(super) fn after(minimum: &ResponseMinimum) -> Self {
        let mut parameters = DVector::from_row_slice(&minimum.parameters);
        let of_square = 2.0 * parameters[1].abs() * minimum.covariance[(1, 1)].sqrt();
        parameters[1] = parameters[1].max(of_square.sqrt());
        let amplitudes = minimum.rows.iter().map(|row| row.amplitude).collect();
        Self { parameters, amplitudes, scatters: minimum.scatters }
    }
}

/// The linearised problem at a state.
struct Round {
    /// Change of the parameters by a whole step.
    step: DVector<f64>,
    covariance: DMatrix<f64>,
    /// Residuals after it.
    residuals: DVector<f64>,
    rows: Vec<FoundRow>,
    /// Change of the amplitude of each row by a whole step, and its standard deviation.
    moves: Vec<(f64, f64)>,
    scatters: Scatters,
}

impl Round {
    /// The steps of the parameters and of the rows, in the standard deviations of a round.
    fn step_over(&self, unit: &Self) -> DVector<f64> {
        let of_parameters = self.step.component_div(&unit.covariance.diagonal().map(f64::sqrt));
        let of_rows = self.moves.iter().zip(&unit.moves).map(|((step, _), (_, deviation))| step / deviation);
        of_parameters.iter().copied().chain(of_rows).collect::<Vec<f64>>().into()
    }

    fn is_settled(&self, state: &State) -> bool {
        self.step_over(self).amax() <= SETTLED && self.scatters.is_near(&state.scatters, SETTLED_SCATTER)
    }
}

/// A table under a law.
pub(super) struct Search<'a> {
    pub(super) table: &'a ResponseTable,
    pub(super) model: ResponseModel,
    pub(super) law: &'a dyn DriveMethod,
    pub(super) watch: &'a Watch<'a>,
}

/// The fraction of a step to take, if this fraction of the last one was taken: by Aitken's rule, for steps that change in proportion to the
/// displacement. If steps grow in their direction the fraction is doubled, up to a whole step.
fn relaxed(part: f64, last: &DVector<f64>, next: &DVector<f64>) -> f64 {
    let change = last - next;
    let along = last.dot(&change);
    let factor = if along > 0.0 { along / change.norm_squared() } else { 2.0 };
    (factor * part).clamp(LEAST_PART, 1.0)
}

/// A row linearised about an amplitude and about parameters.
struct LinearRow {
    amplitude: f64,
    /// Change of the misses over one standard deviation of the amplitude.
    slope: Vec<f64>,
    bend: Vec<f64>,
    /// Standard deviation of the measured amplitude.
    deviation: f64,
    /// L⁻¹ of the covariance L·Lᵀ of the misses.
    whitening: DMatrix<f64>,
    /// Misses from the measured amplitude, in standard deviations, and their derivatives by the parameters.
    residuals: DVector<f64>,
    jacobian: DMatrix<f64>,
}

impl Search<'_> {
    /// Searches the best parameters from this start.
    pub(super) fn near(&self, mut here: State) -> Result<ResponseMinimum, ResponseFitError> {
        let mut round = self.round(&here)?;
        let mut part = 1.0;
        for _ in 0..MOST_ROUNDS {
            self.watch.go_on().map_err(|_| ResponseFitError::Interrupted)?;
            if round.is_settled(&here) {
                return Ok(self.to_minimum(&here, round, true));
            }
            let next = self.moved(&here, &round, part);
            match self.round(&next) {
                Ok(of_next) => {
                    let [before, after] = [&round, &of_next].map(|residuals| residuals.step_over(&round));
                    let goes_too_far = after.dot(&before) < 0.0 && after.norm() > before.norm();
                    if part <= LEAST_PART || !goes_too_far {
                        (here, round) = (next, of_next);
                    }
                    part = relaxed(part, &before, &after);
                }
                Err(error) if part <= LEAST_PART => return Err(error),
                Err(_) => part = (0.5 * part).max(LEAST_PART),
            }
        }
        Ok(self.to_minimum(&here, round, false))
    }

    /// The state after a fraction of the step of a round.
    fn moved(&self, here: &State, round: &Round, part: f64) -> State {
        let parameters = &here.parameters + part * &round.step;
        let amplitudes = here.amplitudes.iter().zip(&round.moves);
        let amplitudes = amplitudes.map(|(amplitude, (step, _))| amplitude + part * step).collect();
        State { parameters, amplitudes, scatters: round.scatters }
    }

    /// Solves the problem linearised about this state.
    fn round(&self, here: &State) -> Result<Round, ResponseFitError> {
        let failed = || ResponseFitError::NoConvergence(self.model);
        let undetermined = |_| ResponseFitError::Undetermined(self.model);
        let linear = self.linearised(here).ok_or_else(failed)?;
        let blocks: Vec<RowDVector<f64>> =
            linear.iter().flat_map(|row| row.jacobian.row_iter().map(|row| row.into_owned())).collect();
        let jacobian = DMatrix::from_rows(&blocks);
        let residuals = linear.iter().flat_map(|row| row.residuals.iter().copied());
        let residuals = DVector::from_iterator(jacobian.nrows(), residuals);
        let LinearFit { coefficients, covariance, .. } =
            least_squares(&jacobian, &-&residuals).map_err(undetermined)?;
        let step = self.possible(&here.parameters, coefficients);
        let residuals = residuals + &jacobian * &step;
        let leverages = jacobian.row_iter().map(|row| (row * &covariance).dot(&row));
        let rows = self.rows(linear, residuals.iter().copied().zip(leverages));
        let scatters = here.scatters.renewed(self.table, &rows, here.parameters.len());
        let moves = self.moves(&rows, &scatters);
        Ok(Round { step, covariance, residuals, rows, moves, scatters })
    }

    /// Limits a step to positive dampings: amplitudes alone depend on the damping by its square, which the step changes linearly, to a quarter at least.
    fn possible(&self, here: &DVector<f64>, mut step: DVector<f64>) -> DVector<f64> {
        if !self.table.has_phases() {
            let damping = here[1];
            step[1] = (damping * (damping + 2.0 * step[1])).max(0.25 * damping * damping).sqrt() - damping;
        }
        step
    }

    fn to_minimum(&self, here: &State, round: Round, settled: bool) -> ResponseMinimum {
        let chi2 = round.residuals.norm_squared();
        let misfit =
            if self.table.is_weighted() { chi2 } else { here.scatters.misfit(self.table, &round.rows) };
        let parameters = (&here.parameters + round.step).as_slice().to_vec();
        let (covariance, rows) = (round.covariance, round.rows);
        ResponseMinimum { parameters, covariance, chi2, scatters: here.scatters, misfit, rows, settled }
    }

    /// Steps to the amplitudes without their errors, limited to those that the model can have, and standard deviations.
    fn moves(&self, rows: &[FoundRow], scatters: &Scatters) -> Vec<(f64, f64)> {
        const FARTHEST: f64 = 0.5;
        let bound = self.model.amplitude_bound();
        let of_row = |(row, estimate): (&ResponseRow, &FoundRow)| {
            let measured = row.amplitude;
            let deviation = scatters.of_amplitude(row, estimate.amplitude);
            let spread = (6.0 * deviation).min(FARTHEST * measured.min(bound - measured));
            (estimate.aim.clamp(measured - spread, measured + spread) - estimate.amplitude, deviation)
        };
        self.table.rows.iter().zip(rows).map(of_row).collect()
    }

    fn required(
        &self,
        law: &dyn DriveMethod,
        amplitudes: &[f64],
        parameters: &DVector<f64>,
    ) -> Option<Vec<RequiredDrive>> {
        let rows = self.table.rows.iter().zip(amplitudes);
        let asked: Vec<Asked> =
            rows.map(|(row, &amplitude)| Asked { frequency: row.frequency, amplitude }).collect();
        let possible = parameters[0] > 0.0 && parameters.iter().all(|number| number.is_finite());
        possible.then(|| law.required(&asked, self.coefficients(parameters)))?
    }

    fn coefficients<'p>(&self, parameters: &'p DVector<f64>) -> &'p [f64] {
        &parameters.as_slice()[..self.model.coefficients()]
    }

    /// Linearises the rows about a state.
    fn linearised(&self, here: &State) -> Option<Vec<LinearRow>> {
        let State { parameters, amplitudes, scatters } = here;
        let bound = self.model.amplitude_bound();
        let rows = self.table.rows.iter().zip(amplitudes);
        let deviations = rows.map(|(row, &amplitude)| scatters.of_amplitude(row, amplitude));
        let deviations: Vec<f64> = deviations.collect();
        let steps: Vec<f64> = amplitudes
            .iter()
            .zip(&deviations)
            .map(|(amplitude, deviation)| (SPREAD * deviation).min(0.9 * amplitude.min(bound - amplitude)))
            .collect();
        let here = self.required(self.law, amplitudes, parameters)?;
        // The curvature matters next to folds only, and one harmonic determines it well enough.
        let balance = OneHarmonic(self.model);
        let shifted = |sign: f64| -> Option<Vec<RequiredDrive>> {
            let shifted = amplitudes.iter().zip(&steps).map(|(amplitude, step)| amplitude + sign * step);
            self.required(&balance, &shifted.collect::<Vec<f64>>(), parameters)
        };
        let balanced = [shifted(-1.0)?, shifted(0.0)?, shifted(1.0)?];
        let of_row = |index: usize| {
            let row = &self.table.rows[index];
            let part = deviations[index] / steps[index];
            let slope = row.components(here[index].drive, here[index].by_amplitude.scaled(deviations[index]));
            let [below, level, above] = balanced.each_ref().map(|all| row.misses(all[index].drive, 0.0));
            let bend = |k: usize| 0.5 * part * part * (above[k] + below[k] - 2.0 * level[k]);
            let bend: Vec<f64> = (0..slope.len()).map(bend).collect();
            let asked = Asked { frequency: row.frequency, amplitude: amplitudes[index] };
            let by_frequency = here[index].by_frequency(&asked, self.coefficients(parameters));
            let drive = here[index].drive;
            let across = Complex::new(-drive.im, drive.re).scaled(scatters.of_phase(row));
            let errors = [
                slope.clone(),
                bend.iter().map(|bend| std::f64::consts::SQRT_2 * bend).collect(),
                row.components(drive, by_frequency.scaled(row.frequency_uncertainty)),
                row.components(drive, across),
            ];
            let whitening = whitening(&errors, LEAST_DEVIATION * drive.abs())?;
            let (amplitude, deviation) = (amplitudes[index], deviations[index]);
            let excess = (row.amplitude - amplitude) / deviation;
            let misses = DVector::from_vec(row.misses(drive, parameters[parameters.len() - 1]))
                + DVector::from_row_slice(&slope) * excess;
            let by_coefficients =
                here[index].by_coefficients.iter().map(|coefficient| row.components(drive, *coefficient));
            let by_drive = std::iter::once(vec![-1.0, 0.0][..slope.len()].to_vec());
            let columns: Vec<DVector<f64>> = by_coefficients.chain(by_drive).map(DVector::from_vec).collect();
            let (residuals, jacobian) = (&whitening * misses, &whitening * DMatrix::from_columns(&columns));
            Some(LinearRow { amplitude, slope, bend, deviation, whitening, residuals, jacobian })
        };
        (0..amplitudes.len()).map(of_row).collect()
    }

    /// Computes the rows with amplitudes without their errors, by residuals and leverages.
    fn rows(&self, linear: Vec<LinearRow>, mut data: impl Iterator<Item = (f64, f64)>) -> Vec<FoundRow> {
        let of_row = |(row, linear): (&ResponseRow, LinearRow)| {
            let (residuals, leverages): (Vec<f64>, Vec<f64>) = data.by_ref().take(linear.slope.len()).unzip();
            let slope = &linear.whitening * DVector::from_row_slice(&linear.slope);
            let excess = slope.dot(&DVector::from_row_slice(&residuals));
            FoundRow {
                amplitude: linear.amplitude,
                aim: row.amplitude - excess * linear.deviation,
                slope: linear.slope[0],
                bend: linear.bend[0],
                residuals,
                leverages,
            }
        };
        self.table.rows.iter().zip(linear).map(of_row).collect()
    }
}

/// L⁻¹ of the covariance L·Lᵀ of sums of independent errors with these standard deviations, and a further independent one in each component.
fn whitening(errors: &[Vec<f64>], least: f64) -> Option<DMatrix<f64>> {
    let size = errors[0].len();
    let covariance = DMatrix::from_fn(size, size, |i, k| {
        let variance = if i == k { least * least } else { 0.0 };
        variance + errors.iter().map(|error| error[i] * error[k]).sum::<f64>()
    });
    let triangle = covariance.cholesky()?.unpack();
    triangle.solve_lower_triangular(&DMatrix::identity(size, size))
}
