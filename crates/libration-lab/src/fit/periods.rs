//! A table of periods explained: every law, the test of the exact one, and what does not belong.

use super::budget::{MeasuredPeriod, PeriodDamping};
use super::excess_scale::{ExcessScaleFit, excess_scale};
use super::law::Law;
use super::outliers::{DEFAULT_OUTLIER_THRESHOLD, outliers};
use super::scatter::ScatterWarning;
use super::small_angle_period::{LawFit, small_angle_period};
use super::typical_amplitude::typical_amplitude;
use super::{FitError, PeriodTable, Weighting};

/// How a table is fitted.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PeriodsOptions {
    /// Leaves out the rows that lie further from the exact law than this many robust standard deviations;
    /// every row is kept when not given, and outliers are only counted.
    pub reject_outliers: Option<f64>,
}

/// What a table of periods says.
#[derive(Clone, Debug, PartialEq)]
pub struct PeriodFit {
    /// The rows that were fitted.
    pub table: PeriodTable,
    /// Where the weights come from.
    pub weighting: Weighting,
    /// The outliers among the rows given, counted from zero, by [`PeriodsOptions::reject_outliers`] or
    /// [`DEFAULT_OUTLIER_THRESHOLD`].
    pub outliers: Vec<usize>,
    /// T0 under the exact law.
    pub exact: LawFit,
    /// T0 under the constant period.
    pub constant: LawFit,
    /// T0 under each other law, or why there is none.
    pub others: Vec<(String, Result<LawFit, FitError>)>,
    /// The test of the exact law, or why there is none.
    pub beta: Result<ExcessScaleFit, FitError>,
}

impl PeriodFit {
    /// What a reader should know of the rows.
    #[must_use]
    pub fn warnings(&self) -> Vec<ScatterWarning> {
        /// Of T0: rounding errors leave less than this of rows that are alike.
        const ROUNDING: f64 = 1e-12;
        let of_scatter = self.exact.scatter().and_then(|scatter| scatter.warning("T₀"));
        let is_without = self.weighting == Weighting::Scatter && self.exact.t0.relative() < ROUNDING;
        of_scatter.or_else(|| is_without.then_some(ScatterWarning::Without)).into_iter().collect()
    }

    /// T0 under the exact law for a budget of g, with the amplitude whose T/T0 is the mean of those measured; the relative
    /// uncertainties are those of all angles and of the clock.
    #[must_use]
    pub fn measured_period(
        &self,
        angle_scale: Option<f64>,
        clock: Option<f64>,
        damping: PeriodDamping,
    ) -> MeasuredPeriod {
        let ratios = self.table.amplitudes().map(|amplitude| Law::exact().ratio_at(amplitude));
        MeasuredPeriod {
            t0: self.exact.t0.into(),
            amplitude: typical_amplitude(ratios),
            angle_scale,
            clock,
            degrees_of_freedom: self.exact.uncertainty_degrees_of_freedom(),
            damping,
        }
    }
}

/// Fits the exact law, the constant period and these other laws to the table.
///
/// # Errors
/// No rows, or a single one without an uncertainty; also when no more are left without outliers.
pub fn periods(
    table: &PeriodTable,
    others: &[Law<'_>],
    options: &PeriodsOptions,
) -> Result<PeriodFit, FitError> {
    let exact = Law::exact();
    let outliers = outliers(table, &exact, options.reject_outliers.unwrap_or(DEFAULT_OUTLIER_THRESHOLD))?;
    let table = if options.reject_outliers.is_some() { table.without(&outliers) } else { table.clone() };
    Ok(PeriodFit {
        weighting: table.weighting(),
        outliers,
        exact: small_angle_period(&table, &exact)?,
        constant: small_angle_period(&table, &Law::constant())?,
        others: others.iter().map(|law| (law.key().into(), small_angle_period(&table, law))).collect(),
        beta: excess_scale(&table, &exact),
        table,
    })
}
