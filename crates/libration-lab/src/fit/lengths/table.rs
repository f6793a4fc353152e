//! Measured periods against lengths, checked once.

use crate::fit::error::FitError;
use crate::fit::law::Law;
use crate::fit::readings::RepeatedReadings;
use crate::statistics::root_mean_square;
use libration::quantity::Quantity;

/// Periods against lengths. Lengths are metres, periods seconds, amplitudes radians.
#[derive(Clone, Copy, Debug, Default)]
pub struct LengthColumns<'a> {
    /// Distances from the pivot to a mark fixed to the bob; for a bar positions of the pivots, which may be negative.
    pub lengths: &'a [f64],
    /// Full periods.
    pub periods: &'a [f64],
    /// Standard uncertainties of the lengths, zero or more.
    pub length_uncertainties: Option<&'a [f64]>,
    /// Standard uncertainties of the periods, above zero.
    pub period_uncertainties: Option<&'a [f64]>,
    /// Amplitudes, one for each row or one for all; empty for swings small enough.
    pub amplitudes: &'a [Quantity],
}

/// A table of periods against lengths that can be fitted.
#[derive(Clone, Debug, PartialEq)]
pub struct LengthTable {
    pub(super) rows: Vec<LengthRow>,
    pub(super) weighted: bool,
    /// Repeated readings from which the uncertainties of the periods come.
    pub(super) readings: Option<RepeatedReadings>,
    /// Standard uncertainties of the periods by their rounding.
    rounding: Option<Vec<f64>>,
}

/// One measurement: y = (T/2πR)² is (L + δ)/g.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct LengthRow {
    pub(super) length: f64,
    pub(super) period: f64,
    pub(super) length_uncertainty: f64,
    /// Uncertainty of the period, including that of the amplitude; zero when the weights come from the scatter.
    pub(super) period_uncertainty: f64,
    /// T/T0 at the amplitude.
    pub(super) ratio: f64,
    /// The amplitude, in radians.
    pub(super) amplitude: f64,
}

impl LengthTable {
    /// Checks these columns, and returns them as a table.
    ///
    /// # Errors
    /// Fails for columns of different lengths, a length that is zero or a period that is not positive, an unusable uncertainty, and an amplitude
    /// of π or more.
    pub fn new(columns: &LengthColumns<'_>) -> Result<Self, FitError> {
        let expected = columns.lengths.len();
        let same = |column: &'static str, length: usize| match length == expected {
            true => Ok(()),
            false => Err(FitError::LengthMismatch { column, rows: length, expected }),
        };
        same("periods", columns.periods.len())?;
        same("uncertainties of the lengths", columns.length_uncertainties.map_or(expected, <[f64]>::len))?;
        same("uncertainties of the periods", columns.period_uncertainties.map_or(expected, <[f64]>::len))?;
        if columns.amplitudes.len() > 1 {
            same("amplitudes", columns.amplitudes.len())?;
        }
        let weighted = columns.period_uncertainties.is_some();
        let rows =
            (0..expected).map(|row| LengthRow::new(columns, row, weighted)).collect::<Result<_, _>>()?;
        Ok(Self { rows, weighted, readings: None, rounding: None })
    }

    /// The table with standard uncertainties of the periods by their rounding, in seconds, which count where no others are stated and the rows
    /// scatter less about a law; ignored unless all are above zero.
    #[must_use]
    pub fn with_rounding(self, rounding: Vec<f64>) -> Self {
        let is_usable = rounding.len() == self.rows.len() && rounding.iter().all(|step| *step > 0.0);
        Self { rounding: Some(rounding).filter(|_| is_usable), ..self }
    }

    /// The table with uncertainties of its periods by their rounding, if the scatter is smaller and nothing else is known.
    pub(super) fn weighted_by_rounding(&self, scatter: f64) -> Option<Self> {
        let rounding = self.rounding.as_ref().filter(|_| !self.weighted)?;
        let typical = root_mean_square(rounding.iter().copied());
        let rows = self.rows.iter().zip(rounding);
        let rows = rows.map(|(row, rounding)| LengthRow { period_uncertainty: *rounding, ..*row }).collect();
        (scatter < typical).then_some(Self { rows, weighted: true, ..self.clone() })
    }

    /// The table with the same uncertainty of all periods, 1 s, where none are stated: laws that are fitted to it compare by their residuals in
    /// seconds.
    pub(super) fn of_equal_periods(&self) -> Self {
        if self.weighted {
            return self.clone();
        }
        let equal = |row: &LengthRow| LengthRow { period_uncertainty: 1.0, length_uncertainty: 0.0, ..*row };
        Self { rows: self.rows.iter().map(equal).collect(), weighted: true, ..self.clone() }
    }

    /// Adds the repeated readings from which the uncertainties of the periods come; ignored if their rows are not those of the table.
    #[must_use]
    pub fn with_readings(self, readings: RepeatedReadings) -> Self {
        let readings = Some(readings).filter(|table| table.rows.len() == self.rows.len() && self.weighted);
        Self { readings, ..self }
    }

    /// The table with periods that are longer by this, in seconds, row by row; unchanged rows beyond the last one.
    #[must_use]
    pub fn shifted(&self, shifts: impl Iterator<Item = f64>) -> Self {
        let mut rows = self.rows.clone();
        for (row, shift) in rows.iter_mut().zip(shifts) {
            row.period += shift;
        }
        Self { rows, ..self.clone() }
    }

    /// The table with (T/2π)² divided by these factors, row by row.
    pub(super) fn divided(&self, factors: &[f64]) -> Self {
        let mut rows = self.rows.clone();
        for (row, factor) in rows.iter_mut().zip(factors) {
            let root = factor.sqrt();
            row.period /= root;
            row.period_uncertainty /= root;
        }
        Self { rows, ..self.clone() }
    }

    /// The table of these rows only, counted from zero.
    #[must_use]
    pub fn only(&self, rows: &[usize]) -> Self {
        let rounding = self.rounding.as_ref();
        let rounding = rounding.map(|all| rows.iter().filter_map(|&row| all.get(row).copied()).collect());
        let readings = self.readings.clone().map(|all| RepeatedReadings {
            rows: rows.iter().filter_map(|&row| all.rows.get(row).copied()).collect(),
            outliers: vec![],
            ..all
        });
        let rows = rows.iter().filter_map(|&row| self.rows.get(row).copied()).collect();
        Self { rows, rounding, readings, ..*self }
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

    /// The first row whose length is negative, counted from one, with that length.
    pub(super) fn negative(&self) -> Option<(usize, f64)> {
        let negative = self.rows.iter().position(|row| row.length < 0.0)?;
        Some((negative + 1, self.rows[negative].length))
    }

    /// The table with the absolute values of its lengths.
    pub(super) fn of_positive_lengths(&self) -> Self {
        let positive = |row: &LengthRow| LengthRow { length: row.length.abs(), ..*row };
        Self { rows: self.rows.iter().map(positive).collect(), ..self.clone() }
    }

    /// The periods of small swings at these lengths, T/R, in seconds.
    pub fn small_angle_periods(&self) -> impl Iterator<Item = f64> {
        self.rows.iter().map(|row| row.period / row.ratio)
    }

    /// Returns `true` if the rows count by their uncertainties; otherwise all count alike, and their scatter is the uncertainty.
    #[must_use]
    pub fn is_weighted(&self) -> bool {
        self.weighted
    }
}

impl LengthRow {
    fn new(columns: &LengthColumns<'_>, index: usize, weighted: bool) -> Result<Self, FitError> {
        let row = index + 1;
        let usable = |x: f64| x > 0.0 && x.is_finite();
        let (length, period) = (columns.lengths[index], columns.periods[index]);
        if !usable(length.abs()) {
            return Err(FitError::LengthOfRow { row, length });
        }
        if !usable(period) {
            return Err(FitError::Period { row, period });
        }
        let length_uncertainty = columns.length_uncertainties.map_or(0.0, |column| column[index]);
        if !(0.0..f64::INFINITY).contains(&length_uncertainty) {
            let hint = "give zero or a positive number of metres";
            return Err(FitError::Uncertainty { row, of: "length", uncertainty: length_uncertainty, hint });
        }
        let stated = columns.period_uncertainties.map_or(0.0, |column| column[index]);
        if weighted && !usable(stated) {
            let hint = "give a positive number of seconds in every row, or none in any";
            return Err(FitError::Uncertainty { row, of: "period", uncertainty: stated, hint });
        }
        let amplitude = columns.amplitudes.get(index).or(columns.amplitudes.first());
        let (ratio, relative) = ratio(amplitude, row)?;
        let amplitude = amplitude.map_or(0.0, |amplitude| amplitude.value.abs());
        let period_uncertainty = if weighted { libm::hypot(stated, period * relative) } else { 0.0 };
        Ok(Self { length, period, length_uncertainty, period_uncertainty, ratio, amplitude })
    }

    /// (T/2πR)², in s².
    pub(super) fn square(&self) -> f64 {
        let reduced = self.period / (self.ratio * std::f64::consts::TAU);
        reduced * reduced
    }

    /// The variance of (T/2πR)² less (L + δ)/g, when 1/g is this.
    pub(super) fn variance(&self, slope: f64) -> f64 {
        let of_square = 2.0 * self.square() * self.period_uncertainty / self.period;
        let of_length = slope * self.length_uncertainty;
        of_square * of_square + of_length * of_length
    }
}

/// T/T0 at an amplitude, and its relative uncertainty.
fn ratio(amplitude: Option<&Quantity>, row: usize) -> Result<(f64, f64), FitError> {
    let Some(&Quantity { value, uncertainty }) = amplitude else { return Ok((1.0, 0.0)) };
    let amplitude = value.abs();
    if !(0.0..std::f64::consts::PI).contains(&amplitude) {
        return Err(FitError::Amplitude { row, amplitude });
    }
    let ratio = Law::exact().ratio_at(amplitude);
    Ok((ratio, Law::exact().slope_at(amplitude) * uncertainty.unwrap_or(0.0) / ratio))
}
