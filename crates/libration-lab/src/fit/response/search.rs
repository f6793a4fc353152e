//! Least squares with errors in amplitude, frequency and phase.
//!
//! The amplitude that a row would have without its error is found with the parameters: the required drive is linearised there, and
//! its difference from the acting drive is weighted by its effective variance, which at a fold, where the amplitude changes nothing to
//! first order, is that of second order. Amplitudes and weights are fixed while the parameters are solved for, and are renewed until nothing
//! changes (M. Lybanon, Am. J. Phys. 52, 22 (1984), doi:10.1119/1.13822).

use super::ResponseFitError;
use super::found_row::FoundRow;
use super::model::ResponseModel;
use super::required_drive::{Asked, Law, OneHarmonic, RequiredDrive};
use super::scatters::Scatters;
use super::table::{ResponseTable, Row};
use crate::statistics::levenberg_marquardt::{Effort, Linearised, ResidualsError, minimum};
use crate::statistics::{Design, ROUNDING};
use libration::algebra::Complex;
use libration::internals::progress::Watch;
use nalgebra::{DMatrix, DVector};

/// Largest negligible change of a parameter, relative to its uncertainty.
const SETTLED: f64 = 1e-3;
/// Largest negligible relative change of the scatter.
const SETTLED_SCATTER: f64 = 1e-3;
/// Three points with these distances in standard deviations stand for a normal distribution up to its fifth moment.
const SPREAD: f64 = 1.732_050_807_568_877_2;
/// Least deviation relative to the required drive: smaller errors are rounding.
const LEAST_DEVIATION: f64 = 1e-12;
const EFFORT: Effort = Effort { tolerance: 1e-6, patience: 40 };

/// The best parameters under a law.
#[derive(Clone, Debug)]
pub(super) struct Found {
    /// ω0², c, perhaps κ, and A.
    pub(super) parameters: Vec<f64>,
    /// Covariance of the parameters, where the uncertainties of the rows are right.
    pub(super) covariance: DMatrix<f64>,
    pub(super) chi2: f64,
    /// Factors of the uncertainties of the rows: the scatter where none are stated, otherwise one.
    pub(super) scatters: Scatters,
    /// The misfit that is minimised: χ², or where no uncertainties are stated −2 times the logarithm of the likelihood.
    pub(super) misfit: f64,
    pub(super) rows: Vec<FoundRow>,
    /// `true` if hardly anything changed in the last round.
    pub(super) settled: bool,
}

impl Found {
    /// The parameters, with the damping replaced by the root of its square's standard deviation where that is larger: at zero damping, amplitudes
    /// do not depend on it to first order.
    pub(super) fn with_damping(&self) -> Vec<f64> {
        let mut parameters = self.parameters.clone();
        let of_square = 2.0 * parameters[1].abs() * self.covariance[(1, 1)].sqrt();
        parameters[1] = parameters[1].max(of_square.sqrt());
        parameters
    }
}

/// The part of a step that is taken. Next to a fold a whole step may lead to the other side, and the next one back: a step that turns back
/// halves the part, one that goes on doubles it, up to a whole.
#[derive(Clone, Debug)]
struct Relaxation {
    part: f64,
    last: Option<DVector<f64>>,
}

impl Default for Relaxation {
    fn default() -> Self {
        Self { part: 1.0, last: None }
    }
}

impl Relaxation {
    /// Returns the part for the next step.
    fn part(&mut self, step: &DVector<f64>) -> f64 {
        if let Some(last) = &self.last {
            self.part = if step.dot(last) < 0.0 { 0.5 * self.part } else { (2.0 * self.part).min(1.0) };
        }
        self.last = Some(step.clone());
        self.part
    }
}

/// A table under a law.
pub(super) struct Search<'a> {
    pub(super) table: &'a ResponseTable,
    pub(super) model: ResponseModel,
    pub(super) law: &'a dyn Law,
    pub(super) watch: &'a Watch<'a>,
    /// Rounds in which amplitudes and weights are renewed.
    pub(super) rounds: usize,
}

/// A row linearised about an amplitude.
struct Weighed {
    amplitude: f64,
    /// Change of the misses over one standard deviation of the amplitude.
    slope: Vec<f64>,
    bend: Vec<f64>,
    /// Standard deviation of the measured amplitude.
    deviation: f64,
    /// L⁻¹ of the covariance L·Lᵀ of the misses.
    whitening: DMatrix<f64>,
}

impl Weighed {
    /// Difference of the measured amplitude from this one, in standard deviations.
    fn excess(&self, row: &Row) -> f64 {
        (row.amplitude - self.amplitude) / self.deviation
    }
}

impl Search<'_> {
    /// Searches the best parameters from this start.
    pub(super) fn near(&self, start: &[f64]) -> Result<Found, ResponseFitError> {
        let failed = || ResponseFitError::NoConvergence(self.model);
        let mut about = DVector::from_row_slice(start);
        let mut amplitudes: Vec<f64> = self.table.rows.iter().map(|row| row.amplitude).collect();
        let mut scatters = Scatters::first(self.table);
        let mut of_parameters = Relaxation::default();
        let mut of_rows = vec![Relaxation::default(); amplitudes.len()];
        for round in 1..=self.rounds {
            self.watch.go_on().map_err(|_| ResponseFitError::Interrupted)?;
            let weighed = self.weighed(&about, &amplitudes, &scatters).ok_or_else(failed)?;
            let evaluate =
                |at: &DVector<f64>| self.linearised(at, &weighed).ok_or(ResidualsError::OutOfDomain);
            let least = minimum(about.clone(), EFFORT, evaluate).map_err(|_| failed())?;
            let design = Design::new(&least.linearised.jacobian, ROUNDING);
            let covariance = design.map_err(|_| ResponseFitError::Undetermined(self.model))?.covariance();
            let step = &least.parameters - &about;
            let change = step.component_div(&covariance.diagonal().map(f64::sqrt)).amax();
            let rows = self.rows(weighed, &least.linearised, &covariance);
            let before = scatters;
            scatters = before.renewed(self.table, &rows, about.len());
            let settled = change <= SETTLED && scatters.is_near(&before, SETTLED_SCATTER);
            if settled || round == self.rounds {
                let chi2 = least.linearised.residuals.norm_squared();
                let misfit = if self.table.is_weighted() { chi2 } else { before.misfit(self.table, &rows) };
                let parameters = least.parameters.as_slice().to_vec();
                return Ok(Found { parameters, covariance, chi2, scatters: before, misfit, rows, settled });
            }
            let in_deviations = step.component_div(&covariance.diagonal().map(f64::sqrt));
            about += step * of_parameters.part(&in_deviations);
            // Without phases the damping counts by its square.
            if !self.table.has_phases() {
                about[1] = about[1].abs();
            }
            let aims = self.within_bounds(&rows, &scatters);
            for ((amplitude, aim), relaxation) in amplitudes.iter_mut().zip(aims).zip(&mut of_rows) {
                let step = aim - *amplitude;
                *amplitude += step * relaxation.part(&DVector::from_element(1, step));
            }
        }
        Err(failed())
    }

    /// Limits the amplitudes without their errors to those that the model can have.
    fn within_bounds(&self, rows: &[FoundRow], scatters: &Scatters) -> Vec<f64> {
        const FARTHEST: f64 = 0.5;
        let bound = self.model.amplitude_bound();
        let within = |(row, found): (&Row, &FoundRow)| {
            let measured = row.amplitude;
            let farthest = FARTHEST * measured.min(bound - measured);
            let spread = (6.0 * scatters.of_amplitude(row, found.amplitude)).min(farthest);
            found.aim.clamp(measured - spread, measured + spread)
        };
        self.table.rows.iter().zip(rows).map(within).collect()
    }

    fn required(
        &self,
        law: &dyn Law,
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

    /// Linearises the rows about these amplitudes.
    fn weighed(
        &self,
        parameters: &DVector<f64>,
        amplitudes: &[f64],
        scatters: &Scatters,
    ) -> Option<Vec<Weighed>> {
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
        let of_row = |place: usize| {
            let row = &self.table.rows[place];
            let part = deviations[place] / steps[place];
            let slope = row.components(here[place].drive, here[place].by_amplitude.scaled(deviations[place]));
            let [below, level, above] = balanced.each_ref().map(|all| row.misses(all[place].drive, 0.0));
            let bend = |k: usize| 0.5 * part * part * (above[k] + below[k] - 2.0 * level[k]);
            let bend: Vec<f64> = (0..slope.len()).map(bend).collect();
            let asked = Asked { frequency: row.frequency, amplitude: amplitudes[place] };
            let by_frequency = here[place].by_frequency(&asked, self.coefficients(parameters));
            let drive = here[place].drive;
            let across = Complex::new(-drive.im, drive.re).scaled(scatters.of_phase(row));
            let errors = [
                slope.clone(),
                bend.iter().map(|bend| std::f64::consts::SQRT_2 * bend).collect(),
                row.components(drive, by_frequency.scaled(row.frequency_uncertainty)),
                row.components(drive, across),
            ];
            let whitening = whitening(&errors, LEAST_DEVIATION * drive.abs())?;
            let (amplitude, deviation) = (amplitudes[place], deviations[place]);
            Some(Weighed { amplitude, slope, bend, deviation, whitening })
        };
        (0..amplitudes.len()).map(of_row).collect()
    }

    fn linearised(&self, parameters: &DVector<f64>, weighed: &[Weighed]) -> Option<Linearised> {
        let amplitudes: Vec<f64> = weighed.iter().map(|row| row.amplitude).collect();
        let required = self.required(self.law, &amplitudes, parameters)?;
        let drive = parameters[parameters.len() - 1];
        let (mut residuals, mut jacobian) = (vec![], vec![]);
        for ((row, weighed), required) in self.table.rows.iter().zip(weighed).zip(required) {
            let misses = DVector::from_vec(row.misses(required.drive, drive));
            let shift = DVector::from_row_slice(&weighed.slope) * weighed.excess(row);
            residuals.extend((&weighed.whitening * (misses + shift)).iter());
            let by_coefficients =
                required.by_coefficients.iter().map(|it| row.components(required.drive, *it));
            let by_drive = std::iter::once(vec![-1.0, 0.0][..weighed.slope.len()].to_vec());
            let columns: Vec<DVector<f64>> = by_coefficients.chain(by_drive).map(DVector::from_vec).collect();
            let block = &weighed.whitening * DMatrix::from_columns(&columns);
            jacobian.extend(block.row_iter().map(|row| row.into_owned()));
        }
        Some(Linearised { residuals: DVector::from_vec(residuals), jacobian: DMatrix::from_rows(&jacobian) })
    }

    /// Computes the rows with amplitudes without their errors.
    fn rows(
        &self,
        weighed: Vec<Weighed>,
        linearised: &Linearised,
        covariance: &DMatrix<f64>,
    ) -> Vec<FoundRow> {
        let leverages = linearised.jacobian.row_iter().map(|row| (row * covariance).dot(&row));
        let mut data = linearised.residuals.iter().copied().zip(leverages);
        let of_row = |(row, weighed): (&Row, Weighed)| {
            let (own, leverages): (Vec<f64>, Vec<f64>) = data.by_ref().take(weighed.slope.len()).unzip();
            let slope = &weighed.whitening * DVector::from_row_slice(&weighed.slope);
            let excess = slope.dot(&DVector::from_row_slice(&own));
            FoundRow {
                amplitude: weighed.amplitude,
                aim: row.amplitude - excess * weighed.deviation,
                slope: weighed.slope[0],
                bend: weighed.bend[0],
                residuals: own,
                leverages,
            }
        };
        self.table.rows.iter().zip(weighed).map(of_row).collect()
    }
}

/// L⁻¹ of the covariance L·Lᵀ of sums of independent errors with these standard deviations, and a further independent one in each component.
fn whitening(errors: &[Vec<f64>], least: f64) -> Option<DMatrix<f64>> {
    let size = errors[0].len();
    let covariance = DMatrix::from_fn(size, size, |i, k| {
        let own = if i == k { least * least } else { 0.0 };
        own + errors.iter().map(|error| error[i] * error[k]).sum::<f64>()
    });
    let triangle = covariance.cholesky()?.unpack();
    triangle.solve_lower_triangular(&DMatrix::identity(size, size))
}
