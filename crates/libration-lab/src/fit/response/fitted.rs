//! The results of a fit of a response.

use super::found_row::FoundRow;
use super::required_drive::{AllHarmonics, Asked, DriveMethod, RequiredDrive, along};
use super::search::ResponseMinimum;
use super::table::{ResponseRow, ResponseTable};
use super::{MeasuredAmplitude, ResponseModel};
use crate::fit::scatter::{self, Scatter};
use crate::fit::uncertain::Uncertain;
use crate::statistics::{akaike, count};
use libration::orbit::Stability;
use nalgebra::{DMatrix, DVector};

/// The parameters of an oscillator under a drive.
#[derive(Clone, Debug, PartialEq)]
pub struct ResponseFit {
    /// The oscillator.
    pub model: ResponseModel,
    /// Definition of the amplitude.
    pub measured: MeasuredAmplitude,
    /// ω0, in rad/s: of small free oscillations without damping. All uncertainties are [enlarged](Scatter) where the rows scatter more
    /// than theirs.
    pub natural_frequency: Uncertain,
    /// c of the acceleration −c·x′, in 1/s.
    pub damping: Uncertain,
    /// κ of the acceleration −κ·x³, in 1/s² over the square of the unit of the amplitude, for Duffing's oscillator.
    pub cubic: Option<Uncertain>,
    /// A, the amplitude of the driving acceleration, in the unit of the amplitude over s².
    pub drive: Uncertain,
    /// Covariance of the natural frequency, the damping, the cubic coefficient if there is one, and the drive.
    pub covariance: Vec<Vec<f64>>,
    /// The sum of the squared residuals in standard deviations; `None` without uncertainties.
    pub chi2: Option<f64>,
    /// Degrees of freedom: amplitudes and phases less parameters.
    pub dof: usize,
    /// The standard deviation of the amplitudes by their scatter, where no uncertainties are stated: with
    /// [`AmplitudeErrors::Relative`](super::AmplitudeErrors) relative to the amplitude.
    pub amplitude_scatter: Option<f64>,
    /// Akaike's criterion, corrected for few data; `None` where they are too few.
    pub aicc: Option<f64>,
    /// Fitted responses, row by row.
    pub rows: Vec<FittedAnswer>,
}

/// The fitted response of a row.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FittedAnswer {
    /// The amplitude by the fit, on the same branch as the measured one.
    pub amplitude: f64,
    /// Residual in standard deviations: of the amplitude, or of amplitude and phase together.
    pub residual: f64,
    /// Phase lag of the fitted response's fundamental behind the drive, in radians.
    pub phase: f64,
    /// The behaviour of small deviations from this response.
    pub stability: Stability,
    /// `true` if it is between the folds, where no response is stable: by more than three standard deviations of the amplitude.
    pub between_folds: bool,
    /// Distance in rad/s of the frequency beyond the fold at which its branch ends, if it exceeds three of their uncertainties.
    pub beyond_fold: Option<f64>,
}

impl ResponseFit {
    /// Quality factor: ω0/c.
    #[must_use]
    pub fn quality(&self) -> Uncertain {
        let (omega, damping) = (self.natural_frequency.value, self.damping.value);
        let value = omega / damping;
        let uncertainty = self.spread(&[1.0 / damping, -value / damping]);
        Uncertain { value, uncertainty }
    }

    /// χ² per degree of freedom; `None` without uncertainties or without a degree of freedom.
    #[must_use]
    pub fn chi2_per_dof(&self) -> Option<f64> {
        self.scatter().map(Scatter::chi2_per_dof)
    }

    /// Scatter of the rows compared with their uncertainties; `None` without uncertainties or without a degree of freedom.
    #[must_use]
    pub fn scatter(&self) -> Option<Scatter> {
        Scatter::new(self.chi2, self.dof)
    }

    /// ω0², c, perhaps κ, and A.
    pub(super) fn parameters(&self) -> Vec<f64> {
        let omega = self.natural_frequency.value;
        let cubic = self.cubic.map(|cubic| cubic.value);
        [omega * omega, self.damping.value].into_iter().chain(cubic).chain([self.drive.value]).collect()
    }

    /// The standard deviation of a function of ω0², c, perhaps κ, and A with this gradient.
    pub(super) fn deviation(&self, gradient: &[f64]) -> f64 {
        let mut slopes = gradient.to_vec();
        slopes[0] *= 2.0 * self.natural_frequency.value;
        self.spread(&slopes)
    }

    /// The standard deviation of a function with these slopes, in the order of the covariance.
    fn spread(&self, slopes: &[f64]) -> f64 {
        let along = |row: &Vec<f64>| row.iter().zip(slopes).map(|(entry, slope)| entry * slope).sum::<f64>();
        let variance: f64 = self.covariance.iter().zip(slopes).map(|(row, slope)| slope * along(row)).sum();
        variance.max(0.0).sqrt()
    }
}

/// Describes the solution with all harmonics; `None` if some row no longer has a required drive.
pub(super) fn described(
    table: &ResponseTable,
    law: &AllHarmonics,
    minimum: &ResponseMinimum,
) -> Option<ResponseFit> {
    let (model, parameters) = (law.model(), &minimum.parameters);
    let dof = table.data() - parameters.len();
    let chi2 = table.is_weighted().then_some(minimum.chi2);
    let enlargement = scatter::enlargement(chi2, dof);
    let omega = parameters[0].sqrt();
    // The parameters become ω0 instead of its square, and a positive c, which without phases counts by its square.
    let damping = parameters[1].abs();
    let part = if table.has_phases() {
        1.0
    } else {
        part_by_square(damping, enlargement * minimum.covariance[(1, 1)].sqrt())
    };
    let scales: Vec<f64> = [0.5 / omega, part * parameters[1].signum()]
        .into_iter()
        .chain(std::iter::repeat(1.0))
        .take(parameters.len())
        .collect();
    let covariance: DMatrix<f64> = DMatrix::from_fn(parameters.len(), parameters.len(), |i, k| {
        enlargement * enlargement * scales[i] * minimum.covariance[(i, k)] * scales[k]
    });
    let uncertain =
        |index: usize, value: f64| Uncertain { value, uncertainty: covariance[(index, index)].sqrt() };
    let data = count(table.data());
    let aicc = match chi2 {
        Some(chi2) => akaike::of_chi_squared(chi2, data, parameters.len()),
        None => {
            // A scatter of the phases is a further unknown.
            let unknown = parameters.len() + 1 + usize::from(table.has_phases());
            akaike::cost(data, count(unknown)).map(|cost| minimum.misfit + cost)
        }
    };
    let last = parameters.len() - 1;
    let mut fit = ResponseFit {
        model,
        measured: law.measured(),
        natural_frequency: uncertain(0, omega),
        damping: uncertain(1, damping),
        cubic: (last > 2).then(|| uncertain(2, parameters[2])),
        drive: uncertain(last, parameters[last]),
        covariance: covariance.row_iter().map(|row| row.iter().copied().collect()).collect(),
        chi2,
        dof,
        amplitude_scatter: minimum.scatters.unstated(),
        aicc,
        rows: vec![],
    };
    let asked: Vec<Asked> = table
        .rows
        .iter()
        .zip(&minimum.rows)
        .map(|(row, estimate)| Asked { frequency: row.frequency, amplitude: estimate.amplitude })
        .collect();
    let required = law.required(&asked, &fit.parameters()[..last])?;
    let rows = table.rows.iter().zip(&minimum.rows).zip(required);
    fit.rows = rows.map(|((row, estimate), required)| answer(&fit, row, estimate, &required)).collect();
    Some(fit)
}

/// Factor of a standard deviation that is greater than its value, where only the square of the value is determined: the distance from the
/// value to the root of the square plus its standard deviation, over `deviation`.
fn part_by_square(value: f64, deviation: f64) -> f64 {
    let above = (value * (value + 2.0 * deviation)).sqrt() - value;
    if value < deviation { above / deviation } else { 1.0 }
}

fn answer(
    fit: &ResponseFit,
    row: &ResponseRow,
    estimate: &FoundRow,
    required: &RequiredDrive,
) -> FittedAnswer {
    let sign = estimate.residuals[0].signum();
    FittedAnswer {
        amplitude: estimate.amplitude,
        residual: sign * DVector::from_row_slice(&estimate.residuals).norm(),
        phase: required.drive.argument(),
        stability: required.stability,
        between_folds: estimate.slope < -2.0 * FAR * estimate.bend.abs(),
        beyond_fold: beyond_fold(fit, row, estimate, required),
    }
}

/// Number of standard deviations that is more than chance.
const FAR: f64 = 3.0;
/// Distance of an amplitude from an extremum of the required drive, in standard deviations, within which there is a fold.
const NEAR: f64 = 4.0;

/// The distance of the frequency beyond the end of the branch, if there is one: the required drive is taken as a parabola of the amplitude, and the
/// branch has ended if the parabola does not reach the acting drive.
fn beyond_fold(
    fit: &ResponseFit,
    row: &ResponseRow,
    estimate: &FoundRow,
    required: &RequiredDrive,
) -> Option<f64> {
    let parameters = fit.parameters();
    let (drive, coefficients) = parameters.split_last()?;
    let steps = -estimate.slope / (2.0 * estimate.bend);
    let nearest = required.drive.abs() - drive + 0.5 * estimate.slope * steps;
    if !(steps.abs() < NEAR && nearest * estimate.bend > 0.0) {
        return None;
    }
    let radial = |change| along(required.drive, change);
    let mut gradient: Vec<f64> =
        required.by_coefficients.iter().map(|coefficient| radial(*coefficient)).collect();
    gradient.push(-1.0);
    let asked = Asked { frequency: row.frequency, amplitude: estimate.amplitude };
    let by_frequency = radial(required.by_frequency(&asked, coefficients));
    let uncertainty = libm::hypot(fit.deviation(&gradient), by_frequency * row.frequency_uncertainty);
    (nearest.abs() > FAR * uncertainty).then(|| (nearest / by_frequency).abs())
}
