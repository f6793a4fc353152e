//! A trace: measured values of one swing, in the order of time.

use super::FittedPivot;

/// Reason why columns are not a trace.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum TraceError {
    /// Columns of different lengths, or none.
    #[error("columns of {0:?} rows do not make a trace: give as many values as times, and at least one")]
    Lengths(Vec<usize>),
    /// A number that is not finite.
    #[error("{0:?} is not a finite number: leave the row out")]
    NotFinite(f64),
    /// A time that is not after the one before.
    #[error("the time {after:?} s follows {before:?} s: give times that increase")]
    TimesNotIncreasing {
        /// The time before, in seconds.
        before: f64,
        /// The time after it, in seconds.
        after: f64,
    },
    /// An uncertainty that is not positive.
    #[error("an uncertainty of {0:?} is not usable: give positive ones, or none at all")]
    Uncertainty(f64),
}

/// Quantity of the numbers of a trace.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Observable {
    /// The angle, in radians; its zero is not known.
    Angle,
    /// The angular velocity, in radians per second, as a gyroscope gives it.
    AngularVelocity,
}

/// Measurement of one swing. Units are radians and seconds.
///
/// # Examples
/// ```
/// use libration_lab::measurement::{Observable, Trace};
/// let trace = Trace::new("swing", Observable::Angle, vec![0.0, 0.1, 0.2], vec![0.5, 0.4, 0.2], None)?;
/// assert_eq!(trace.len(), 3);
/// assert!(Trace::new("back in time", Observable::Angle, vec![0.1, 0.0], vec![0.5, 0.4], None).is_err());
/// # Ok::<(), libration_lab::measurement::TraceError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Trace {
    name: String,
    observable: Observable,
    times: Vec<f64>,
    values: Vec<f64>,
    uncertainties: Option<Vec<f64>>,
    clock_uncertainty: f64,
    fitted_pivot: Option<FittedPivot>,
}

impl Trace {
    /// The trace of these columns, with a name for messages.
    ///
    /// # Errors
    /// Columns of different lengths or empty, numbers that are not finite, times that do not increase, uncertainties
    /// that are not positive.
    pub fn new(
        name: &str,
        observable: Observable,
        times: Vec<f64>,
        values: Vec<f64>,
        uncertainties: Option<Vec<f64>>,
    ) -> Result<Self, TraceError> {
        let columns = [Some(&times), Some(&values), uncertainties.as_ref()].into_iter().flatten();
        let lengths: Vec<usize> = columns.clone().map(Vec::len).collect();
        if times.is_empty() || lengths.iter().any(|&length| length != times.len()) {
            return Err(TraceError::Lengths(lengths));
        }
        if let Some(&value) = columns.flatten().find(|value| !value.is_finite()) {
            return Err(TraceError::NotFinite(value));
        }
        if let Some(pair) = times.windows(2).find(|pair| pair[1] <= pair[0]) {
            return Err(TraceError::TimesNotIncreasing { before: pair[0], after: pair[1] });
        }
        if let Some(&value) = uncertainties.iter().flatten().find(|&&value| value <= 0.0) {
            return Err(TraceError::Uncertainty(value));
        }
        let name = name.to_owned();
        Ok(Self {
            name,
            observable,
            times,
            values,
            uncertainties,
            clock_uncertainty: 0.0,
            fitted_pivot: None,
        })
    }

    /// The trace under another name.
    #[must_use]
    pub fn named(self, name: &str) -> Self {
        Self { name: name.to_owned(), ..self }
    }

    /// The trace with this relative standard uncertainty of the scale of its times.
    #[must_use]
    pub fn with_clock_uncertainty(self, clock_uncertainty: f64) -> Self {
        Self { clock_uncertainty, ..self }
    }

    /// Relative standard uncertainty of the scale of all times; zero if it is not known.
    #[must_use]
    pub fn clock_uncertainty(&self) -> f64 {
        self.clock_uncertainty
    }

    /// The trace with angles about a fitted pivot.
    ///
    /// # Errors
    /// More or fewer derivatives than rows.
    pub fn with_fitted_pivot(self, pivot: FittedPivot) -> Result<Self, TraceError> {
        let lengths = [self.len(), pivot.derivatives.len()];
        if lengths[0] != lengths[1] {
            return Err(TraceError::Lengths(lengths.to_vec()));
        }
        Ok(Self { fitted_pivot: Some(pivot), ..self })
    }

    /// The pivot, if it was fitted to positions or contradicts them.
    #[must_use]
    pub fn fitted_pivot(&self) -> Option<&FittedPivot> {
        self.fitted_pivot.as_ref()
    }

    /// The trace with each value increased by its entry in this column, about a pivot without uncertainty.
    pub(crate) fn shifted(&self, by: &[f64]) -> Self {
        let values = self.values.iter().zip(by).map(|(value, by)| value + by).collect();
        Self { values, fitted_pivot: None, ..self.clone() }
    }

    /// Name of the trace.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Quantity of its numbers.
    #[must_use]
    pub fn observable(&self) -> Observable {
        self.observable
    }

    /// The times, in seconds, increasing.
    #[must_use]
    pub fn times(&self) -> &[f64] {
        &self.times
    }

    /// The angles or angular velocities, in radians and seconds.
    #[must_use]
    pub fn values(&self) -> &[f64] {
        &self.values
    }

    /// The standard uncertainty of each value, where the instrument gave one.
    #[must_use]
    pub fn uncertainties(&self) -> Option<&[f64]> {
        self.uncertainties.as_deref()
    }

    /// Number of rows; at least one.
    #[must_use]
    #[expect(clippy::len_without_is_empty, reason = "a trace is never empty")]
    pub fn len(&self) -> usize {
        self.times.len()
    }

    /// The rows selected by `keep`, which gets their indices from zero.
    ///
    /// # Errors
    /// No row is left.
    pub fn only(&self, keep: impl Fn(usize) -> bool) -> Result<Self, TraceError> {
        let chosen = |column: &[f64]| -> Vec<f64> {
            (0..column.len()).filter(|&row| keep(row)).map(|row| column[row]).collect()
        };
        let uncertainties = self.uncertainties.as_deref().map(chosen);
        let part =
            Self::new(&self.name, self.observable, chosen(&self.times), chosen(&self.values), uncertainties)?
                .with_clock_uncertainty(self.clock_uncertainty);
        let rows: Vec<usize> = (0..self.len()).filter(|&row| keep(row)).collect();
        match &self.fitted_pivot {
            Some(pivot) => part.with_fitted_pivot(pivot.of_rows(&rows)),
            None => Ok(part),
        }
    }
}
