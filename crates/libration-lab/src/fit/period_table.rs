//! Measured periods against amplitudes, checked once.

use std::fmt;

use super::error::FitError;
use super::readings::RepeatedReadings;

/// The standard deviations of the columns, where there are any.
#[derive(Clone, Copy, Debug, Default)]
pub struct Uncertainties<'a> {
    /// Standard deviations of the amplitudes, in radians; zero where an amplitude is exact.
    pub amplitudes: Option<&'a [f64]>,
    /// Standard deviations of the periods, in seconds; positive.
    pub periods: Option<&'a [f64]>,
}

/// Source of the weights of the rows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Weighting {
    /// The uncertainties of periods and amplitudes, together the effective variance.
    PeriodsAndAmplitudes,
    /// The uncertainties of the periods.
    Periods,
    /// The rounding of the periods, where the rows scatter less.
    Rounding,
    /// No uncertainties: all rows count alike, with their uncertainty from the scatter.
    Scatter,
}

/// Description of the weights, as a sentence for the report of a fit.
impl fmt::Display for Weighting {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::PeriodsAndAmplitudes => "weighted by the uncertainties of periods and amplitudes",
            Self::Periods => "weighted by the uncertainties of the periods",
            Self::Rounding => "weighted by the rounding of the periods, as the rows scatter less",
            Self::Scatter => {
                "without uncertainties of the periods all rows count alike and their scatter is the uncertainty, \
                 so that chi2 per degree of freedom would be 1 by construction and is not given"
            }
        })
    }
}

/// Rows of amplitude and period that a fit can use.
#[derive(Clone, Debug, PartialEq)]
pub struct PeriodTable {
    #[doc(hidden)]
    pub rows: Vec<Row>,
    weighting: Weighting,
    readings: Option<RepeatedReadings>,
    pub(super) rounding: Option<Vec<f64>>,
}

/// One measurement.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Row {
    pub(super) amplitude: f64,
    pub(super) period: f64,
    pub(super) amplitude_uncertainty: f64,
    /// Zero if the weights come from the scatter.
    pub(super) period_uncertainty: f64,
}

impl PeriodTable {
    /// Checks amplitudes in radians, whose sign does not count, and periods in seconds.
    ///
    /// # Errors
    /// Fails for columns of different lengths, an amplitude of π or more, a period that is not positive, an uncertainty
    /// that is not positive (of an amplitude: negative), and anything NaN or infinite.
    pub fn new(
        amplitudes: &[f64],
        periods: &[f64],
        uncertainties: Uncertainties<'_>,
    ) -> Result<Self, FitError> {
        same_length("periods", periods, amplitudes)?;
        if let Some(column) = uncertainties.amplitudes {
            same_length("uncertainties of the amplitudes", column, amplitudes)?;
        }
        if let Some(column) = uncertainties.periods {
            same_length("uncertainties of the periods", column, amplitudes)?;
        }
        let row = |i: usize| Row {
            amplitude: amplitudes[i].abs(),
            period: periods[i],
            amplitude_uncertainty: uncertainties.amplitudes.map_or(0.0, |column| column[i]),
            period_uncertainty: uncertainties.periods.map_or(0.0, |column| column[i]),
        };
        let rows: Vec<Row> = (0..amplitudes.len()).map(row).collect();
        let weighting = match (uncertainties.periods, uncertainties.amplitudes) {
            (Some(_), Some(_)) => Weighting::PeriodsAndAmplitudes,
            (Some(_), None) => Weighting::Periods,
            (None, _) => Weighting::Scatter,
        };
        for (i, row) in rows.iter().enumerate() {
            row.check(i + 1, weighting)?;
        }
        Ok(Self { rows, weighting, readings: None, rounding: None })
    }

    /// Adds the repeated readings from which the uncertainties of the periods come, and with them the degrees of freedom of T0; ignored if their
    /// rows are not those of the table.
    #[must_use]
    pub fn with_readings(self, readings: RepeatedReadings) -> Self {
        let readings = Some(readings).filter(|table| table.rows.len() == self.rows.len());
        Self { readings, ..self }
    }

    /// Adds standard uncertainties of the periods by their rounding, in seconds, used if no others are stated and the rows scatter less; ignored
    /// unless they are one positive number for each row.
    #[must_use]
    pub fn with_rounding(self, rounding: Vec<f64>) -> Self {
        let is_usable = rounding.len() == self.rows.len() && rounding.iter().all(|step| *step > 0.0);
        Self { rounding: Some(rounding).filter(|_| is_usable), ..self }
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

    /// The amplitudes, in radians, in the order of the rows.
    pub fn amplitudes(&self) -> impl Iterator<Item = f64> {
        self.rows.iter().map(|row| row.amplitude)
    }

    /// Source of the weights.
    #[must_use]
    pub fn weighting(&self) -> Weighting {
        self.weighting
    }

    /// The table without these rows, counted from zero.
    #[must_use]
    pub fn without(&self, left_out: &[usize]) -> Self {
        let readings = self.readings.clone().map(|readings| RepeatedReadings {
            rows: kept(&readings.rows, left_out),
            outliers: vec![],
            ..readings
        });
        let rounding = self.rounding.as_ref().map(|rounding| kept(rounding, left_out));
        Self { rows: kept(&self.rows, left_out), weighting: self.weighting, readings, rounding }
    }

    /// The repeated readings of the periods.
    #[must_use]
    pub fn readings(&self) -> Option<&RepeatedReadings> {
        self.readings.as_ref()
    }

    /// The table with uncertainties of its periods by their rounding, if the scatter is smaller and nothing else is known.
    pub(super) fn weighted_by_rounding(&self, scatter: f64) -> Option<Self> {
        let rounding = self.rounding.as_ref().filter(|_| self.weighting == Weighting::Scatter)?;
        let mean = crate::statistics::root_mean_square(rounding.iter().copied());
        let rows = self.rows.iter().zip(rounding);
        let rows = rows.map(|(row, rounding)| Row { period_uncertainty: *rounding, ..*row }).collect();
        (scatter < mean).then_some(Self { rows, weighting: Weighting::Rounding, ..self.clone() })
    }
}

impl Row {
    fn check(&self, row: usize, weighting: Weighting) -> Result<(), FitError> {
        let usable = |x: f64| x > 0.0 && x.is_finite();
        if !(0.0..std::f64::consts::PI).contains(&self.amplitude) {
            return Err(FitError::Amplitude { row, amplitude: self.amplitude });
        }
        if !usable(self.period) {
            return Err(FitError::Period { row, period: self.period });
        }
        if weighting != Weighting::Scatter && !usable(self.period_uncertainty) {
            let hint = "give a positive number of seconds in every row, or none in any";
            return Err(FitError::Uncertainty {
                row,
                of: "period",
                uncertainty: self.period_uncertainty,
                hint,
            });
        }
        if !(0.0..f64::INFINITY).contains(&self.amplitude_uncertainty) {
            let hint = "give zero or a positive number in the unit of the amplitude";
            let uncertainty = self.amplitude_uncertainty;
            return Err(FitError::Uncertainty { row, of: "amplitude", uncertainty, hint });
        }
        Ok(())
    }
}

fn kept<T: Copy>(rows: &[T], left_out: &[usize]) -> Vec<T> {
    rows.iter().enumerate().filter(|(i, _)| !left_out.contains(i)).map(|(_, row)| *row).collect()
}

fn same_length(column: &'static str, values: &[f64], amplitudes: &[f64]) -> Result<(), FitError> {
    if values.len() == amplitudes.len() {
        return Ok(());
    }
    Err(FitError::LengthMismatch { column, rows: values.len(), expected: amplitudes.len() })
}
