//! A measured response, checked once.

use super::required_drive::along;
use super::{ResponseFitError, ResponseModel};
use libration::algebra::Complex;

/// The errors of the amplitudes of a response.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum AmplitudeErrors {
    /// The same standard deviation for all amplitudes, determined from their scatter.
    #[default]
    Absolute,
    /// The same relative standard deviation for all amplitudes, determined from their scatter.
    Relative,
    /// The stated uncertainties.
    Stated,
}

/// The columns of a measured response.
#[derive(Clone, Copy, Debug, Default)]
pub struct ResponseColumns<'a> {
    /// Drive frequencies, in rad/s, in any order.
    pub frequencies: &'a [f64],
    /// Amplitudes of the response, in radians, metres or any other unit.
    pub amplitudes: &'a [f64],
    /// Phase lags of the response behind the drive, in radians; whole turns do not matter, and phases that lead are recognised
    /// by their sign.
    pub phases: Option<&'a [f64]>,
    /// Standard deviations of the frequencies, in rad/s; zero where a frequency is exact.
    pub frequency_uncertainties: Option<&'a [f64]>,
    /// Standard deviations of the amplitudes; positive.
    pub amplitude_uncertainties: Option<&'a [f64]>,
    /// Standard deviations of the phases, in radians; positive.
    pub phase_uncertainties: Option<&'a [f64]>,
    /// Errors of the amplitudes if their uncertainties are not given.
    pub unstated_errors: AmplitudeErrors,
}

/// Rows of frequency, amplitude and perhaps phase that a fit can use.
#[derive(Clone, Debug, PartialEq)]
pub struct ResponseTable {
    pub(super) rows: Vec<ResponseRow>,
    errors: AmplitudeErrors,
    leads: bool,
}

/// One measurement.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct ResponseRow {
    pub(super) frequency: f64,
    pub(super) amplitude: f64,
    /// Phase lag behind the drive, in radians.
    pub(super) phase: Option<f64>,
    pub(super) frequency_uncertainty: f64,
    /// Standard deviation; in units of the scatter where no uncertainty is stated.
    pub(super) amplitude_uncertainty: f64,
    pub(super) phase_uncertainty: f64,
}

impl ResponseTable {
    /// Checks these columns, and returns their rows.
    ///
    /// Without uncertainties all amplitudes have the same absolute error or, with [`AmplitudeErrors::Relative`], the same relative one; all phases
    /// count alike, each kind by its own scatter. With hardly more rows than parameters a phase counts as one of an amplitude of the same row: its
    /// standard deviation is that of the amplitude over the amplitude, as where both are of one sine through a noisy trace.
    ///
    /// # Errors
    /// Fails for columns of different lengths, a frequency or an amplitude that is not positive, an uncertainty that is not positive (of a frequency:
    /// negative), anything NaN or infinite, and uncertainties of amplitudes without those of the given phases, or the other way round.
    pub fn new(columns: &ResponseColumns<'_>) -> Result<Self, ResponseFitError> {
        columns.check()?;
        let errors =
            columns.amplitude_uncertainties.map_or(columns.unstated_errors, |_| AmplitudeErrors::Stated);
        let rows = (0..columns.frequencies.len()).map(|row| ResponseRow::new(columns, row));
        let mut rows = rows.collect::<Result<Vec<_>, _>>()?;
        // A drive that does work on a damped oscillator is ahead of it: its power is proportional to the sine of the lag.
        let power: f64 =
            rows.iter().filter_map(|row| Some(row.frequency * row.amplitude * libm::sin(row.phase?))).sum();
        let leads = power < 0.0;
        if leads {
            rows.iter_mut().for_each(|row| row.phase = row.phase.map(|phase| -phase));
        }
        Ok(Self { rows, errors, leads })
    }

    /// The number of rows.
    #[must_use]
    pub fn len(&self) -> usize {
        self.rows.len()
    }

    /// Returns `true` if there are no rows.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.rows.is_empty()
    }

    /// Returns `true` if the rows count by their uncertainties; otherwise all count alike, and their scatter is the uncertainty.
    #[must_use]
    pub fn is_weighted(&self) -> bool {
        self.errors == AmplitudeErrors::Stated
    }

    /// The errors that determine the weights of the amplitudes.
    #[must_use]
    pub fn amplitude_errors(&self) -> AmplitudeErrors {
        self.errors
    }

    /// Returns `true` if there are phases.
    #[must_use]
    pub fn has_phases(&self) -> bool {
        self.rows.iter().any(|row| row.phase.is_some())
    }

    /// Returns `true` if the given phases are leads, so that nearly all of them are negative.
    #[must_use]
    pub fn leads(&self) -> bool {
        self.leads
    }

    /// Number of fitted data: amplitudes and phases.
    pub(super) fn data(&self) -> usize {
        self.rows.iter().map(|row| 1 + usize::from(row.phase.is_some())).sum()
    }

    pub(super) fn largest_amplitude(&self) -> f64 {
        self.rows.iter().map(|row| row.amplitude).fold(0.0, f64::max)
    }

    /// The least and the greatest frequency.
    #[must_use]
    pub fn frequency_range(&self) -> [f64; 2] {
        let frequencies = || self.rows.iter().map(|row| row.frequency);
        [frequencies().fold(f64::INFINITY, f64::min), frequencies().fold(0.0, f64::max)]
    }

    /// Refuses amplitudes that the model cannot have, and too few rows.
    pub(super) fn check_for(&self, model: ResponseModel) -> Result<(), ResponseFitError> {
        let bound = model.amplitude_bound();
        if let Some(row) = self.rows.iter().position(|row| row.amplitude >= bound) {
            return Err(ResponseFitError::Amplitude { row: row + 1, amplitude: self.rows[row].amplitude });
        }
        let parameters = model.coefficients() + 1;
        let needed = parameters + usize::from(!self.is_weighted());
        if self.data() < needed {
            let needed = if self.has_phases() { needed.div_ceil(2) } else { needed };
            return Err(ResponseFitError::TooFewRows { rows: self.len(), needed, parameters, model });
        }
        Ok(())
    }
}

impl ResponseColumns<'_> {
    fn check(&self) -> Result<(), ResponseFitError> {
        let expected = self.frequencies.len();
        for (column, values) in [
            ("amplitudes", Some(self.amplitudes)),
            ("phases", self.phases),
            ("uncertainties of the frequencies", self.frequency_uncertainties),
            ("uncertainties of the amplitudes", self.amplitude_uncertainties),
            ("uncertainties of the phases", self.phase_uncertainties),
        ] {
            let length = values.map_or(expected, <[f64]>::len);
            if length != expected {
                return Err(ResponseFitError::LengthMismatch { column, rows: length, expected });
            }
        }
        if self.unstated_errors == AmplitudeErrors::Stated && self.amplitude_uncertainties.is_none() {
            return Err(ResponseFitError::NoUncertainties);
        }
        match (self.amplitude_uncertainties, self.phases.and(self.phase_uncertainties)) {
            (Some(_), None) if self.phases.is_some() => {
                Err(ResponseFitError::OneUncertainty { given: "amplitudes", missing: "phases" })
            }
            (None, Some(_)) => {
                Err(ResponseFitError::OneUncertainty { given: "phases", missing: "amplitudes" })
            }
            _ => Ok(()),
        }
    }
}

impl ResponseRow {
    fn new(columns: &ResponseColumns<'_>, index: usize) -> Result<Self, ResponseFitError> {
        let row = index + 1;
        let usable = |value: f64| value > 0.0 && value.is_finite();
        let (frequency, amplitude) = (columns.frequencies[index], columns.amplitudes[index]);
        for (of, value) in [("frequency", frequency), ("amplitude", amplitude)] {
            if !usable(value) {
                return Err(ResponseFitError::NotPositive { row, of, value });
            }
        }
        let phase = columns.phases.map(|column| column[index]);
        if let Some(phase) = phase.filter(|phase| !phase.is_finite()) {
            return Err(ResponseFitError::Phase { row, phase });
        }
        let frequency_uncertainty = columns.frequency_uncertainties.map_or(0.0, |column| column[index]);
        if !(0.0..f64::INFINITY).contains(&frequency_uncertainty) {
            let hint = "give zero or a positive number";
            let uncertainty = frequency_uncertainty;
            return Err(ResponseFitError::Uncertainty { row, of: "frequency", uncertainty, hint });
        }
        let amplitude_uncertainty = match (columns.amplitude_uncertainties, columns.unstated_errors) {
            (Some(column), _) => column[index],
            (None, AmplitudeErrors::Relative) => amplitude,
            (None, AmplitudeErrors::Absolute | AmplitudeErrors::Stated) => 1.0,
        };
        let phase_uncertainty = match columns.phases.and(columns.phase_uncertainties) {
            Some(column) => column[index],
            None => 1.0 / amplitude,
        };
        for (of, uncertainty) in [("amplitude", amplitude_uncertainty), ("phase", phase_uncertainty)] {
            if !usable(uncertainty) {
                let hint = "give a positive number in every row, or none in any";
                return Err(ResponseFitError::Uncertainty { row, of, uncertainty, hint });
            }
        }
        Ok(Self {
            frequency,
            amplitude,
            phase,
            frequency_uncertainty,
            amplitude_uncertainty,
            phase_uncertainty,
        })
    }

    /// The misses, which vanish if the required drive is the acting one: the difference of the amplitudes, and that of the phases times the
    /// amplitude.
    pub(super) fn misses(&self, required: Complex, drive: f64) -> Vec<f64> {
        let size = required.abs();
        let off = |phase: f64| size * (required * Complex::unit(-phase)).argument();
        [size - drive].into_iter().chain(self.phase.map(off)).collect()
    }

    /// Change of the misses with the required drive, where the phases are nearly the same.
    pub(super) fn components(&self, required: Complex, change: Complex) -> Vec<f64> {
        let across = Complex::new(-required.im, required.re);
        [along(required, change)].into_iter().chain(self.phase.map(|_| along(across, change))).collect()
    }
}
