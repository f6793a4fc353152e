//! Analysis of a table of periods: every law, the test of the exact one, and outliers.

use super::angle_unit::MistakenUnit;
use super::beta::Beta;
use super::budget::{MeasuredPeriod, PeriodDamping};
use super::contradiction::{Contradiction, Estimate};
use super::error::FitError;
use super::excess_scale::{ExcessScaleFit, fit_excess_scale};
use super::law::Law;
use super::outliers::{DEFAULT_OUTLIER_THRESHOLD, find_outliers};
use super::period_table::{PeriodTable, Weighting};
use super::scatter::ScatterWarning;
use super::small_angle_period::{LawFit, fit_small_angle_period};
use super::typical_amplitude::typical_amplitude;
use super::uncertain::Uncertain;
use libration::quantity::rounded;
use std::fmt;

/// Options for the fit of a table.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PeriodsOptions {
    /// Leaves out the rows farther from the exact law than this many robust standard deviations; if `None`,
    /// every row is kept, and outliers are only counted.
    pub reject_outliers: Option<f64>,
}

/// The results of a fit to a table of periods.
#[derive(Clone, Debug, PartialEq)]
pub struct PeriodFit {
    /// The rows that were fitted.
    pub table: PeriodTable,
    /// Source of the weights.
    pub weighting: Weighting,
    /// The outliers among the rows given, counted from zero, by [`PeriodsOptions::reject_outliers`] or
    /// [`DEFAULT_OUTLIER_THRESHOLD`].
    pub outliers: Vec<usize>,
    /// T0 under the exact law without the outliers, in s, if they were fitted and matter.
    pub without_outliers: Option<Uncertain>,
    /// T0 under the exact law; with a contradiction its uncertainty includes that of the model.
    pub exact: LawFit,
    /// T0 with β = 1 and with β free, where they contradict each other.
    pub contradiction: Option<Contradiction>,
    /// The unit of the amplitudes, where it is not the stated one.
    pub mistaken_unit: Option<MistakenUnit>,
    /// The standard uncertainty of T0 under the exact law by the rows alone, in s.
    pub uncertainty_of_rows: f64,
    /// T0 under the constant period.
    pub constant: LawFit,
    /// T0 under each other law, or the reason why there is none.
    pub others: Vec<(String, Result<LawFit, FitError>)>,
    /// The test of the exact law, or the reason why there is none.
    pub beta: Result<ExcessScaleFit, FitError>,
}

/// A warning about a table of periods.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum PeriodsWarning {
    /// The amplitudes are in a unit other than the stated one.
    MistakenUnit(MistakenUnit),
    /// β differs from 1 by more than [chance](super::SIGNIFICANT) makes it.
    ModelRefuted {
        /// β.
        beta: Uncertain,
        /// T0 with β = 1 and with β free.
        contradiction: Contradiction,
    },
    /// Rows that are far from the exact law and count all the same.
    Outliers {
        /// Number of these rows.
        rows: usize,
        /// T0 without them, in s.
        without: Uncertain,
    },
    /// The scatter of the rows.
    Scatter(ScatterWarning),
}

impl PeriodsWarning {
    /// A stable name.
    #[must_use]
    pub fn name(&self) -> &'static str {
        match self {
            Self::MistakenUnit(MistakenUnit::Radians) => "angles_are_radians",
            Self::MistakenUnit(MistakenUnit::Degrees) => "angles_are_degrees",
            Self::ModelRefuted { .. } => "model_refuted",
            Self::Outliers { .. } => "outliers_included",
            Self::Scatter(warning) => warning.name(),
        }
    }
}

impl fmt::Display for PeriodsWarning {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::MistakenUnit(MistakenUnit::Radians) => f.write_str(
                "these amplitudes are radians that were taken for degrees: as radians they follow the exact law",
            ),
            Self::MistakenUnit(MistakenUnit::Degrees) => f.write_str(
                "these amplitudes are degrees that were taken for radians: as degrees they follow the exact law",
            ),
            Self::ModelRefuted { beta, contradiction } => {
                let deviation = rounded(beta.deviation_from(1.0), 2);
                write!(
                    f,
                    "the exact law is rejected: β = {beta} is {deviation} standard uncertainties from 1. {contradiction}; the \
                     uncertainty of T₀ includes the difference"
                )
            }
            Self::Outliers { rows, without } => {
                let (rows, them) = if *rows == 1 { ("a row is", "it") } else { ("rows are", "them") };
                write!(f, "{rows} far from the exact law: without {them} T₀ is {without} s; check the numbers")
            }
            Self::Scatter(warning) => warning.fmt(f),
        }
    }
}

impl PeriodFit {
    /// Warnings about the law and the rows, the gravest first.
    #[must_use]
    pub fn warnings(&self) -> Vec<PeriodsWarning> {
        /// Largest relative uncertainty of T0, for rows with equal values, that counts as rounding.
        const ROUNDING: f64 = 1e-12;
        let of_scatter = self.exact.scatter().and_then(|scatter| scatter.warning("T₀"));
        let is_without =
            self.weighting == Weighting::Scatter && self.uncertainty_of_rows < ROUNDING * self.exact.t0.value;
        let of_scatter = of_scatter.or_else(|| is_without.then_some(ScatterWarning::Without));
        self.mistaken_unit
            .map(PeriodsWarning::MistakenUnit)
            .into_iter()
            .chain(
                self.without_outliers
                    .map(|without| PeriodsWarning::Outliers { rows: self.outliers.len(), without }),
            )
            .chain(self.refuted())
            .chain(of_scatter.map(PeriodsWarning::Scatter))
            .collect()
    }

    fn refuted(&self) -> Option<PeriodsWarning> {
        let contradiction = self.contradiction.clone().filter(Contradiction::refutes)?;
        let beta = self.beta.as_ref().ok()?.beta.factor;
        Some(PeriodsWarning::ModelRefuted { beta, contradiction })
    }

    /// The relative change of T0 if each period is longer by its shift, in seconds, row by row; `None` for another number of rows.
    #[must_use]
    pub fn relative_shift(&self, shifts: &[f64]) -> Option<f64> {
        if shifts.len() != self.table.len() {
            return None;
        }
        let rows = self.table.amplitudes().zip(&self.exact.standard_deviations).zip(shifts);
        let sums = rows.fold([0.0, 0.0], |[shift, whole], ((amplitude, deviation), shift_of_row)| {
            let ratio = Law::exact().ratio_at(amplitude);
            let weight = ratio / (deviation * deviation);
            [shift + weight * shift_of_row, whole + weight * ratio]
        });
        Some(sums[0] / sums[1] / self.exact.t0.value)
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
            t0: Uncertain { uncertainty: self.uncertainty_of_rows, ..self.exact.t0 }.into(),
            model: self
                .contradiction
                .as_ref()
                .map(|contradiction| contradiction.uncertainty() / self.exact.t0.value),
            amplitude: typical_amplitude(ratios),
            angle_scale,
            clock,
            shared_timing: None,
            degrees_of_freedom: self.exact.uncertainty_degrees_of_freedom(),
            damping,
        }
    }
}

/// Fits the exact law, the constant period and these other laws to the table.
///
/// # Errors
/// Fails for no rows, or a single one without an uncertainty; also when too few are left without outliers.
pub fn fit_periods(
    table: &PeriodTable,
    others: &[Law<'_>],
    options: &PeriodsOptions,
) -> Result<PeriodFit, FitError> {
    let exact = Law::exact();
    let outliers =
        find_outliers(table, &exact, options.reject_outliers.unwrap_or(DEFAULT_OUTLIER_THRESHOLD))?;
    let table = if options.reject_outliers.is_some() { table.without(&outliers) } else { table.clone() };
    let mut of_exact = fit_small_angle_period(&table, &exact)?;
    let scatter = of_exact.standard_deviations.first().copied().unwrap_or(f64::INFINITY);
    let table = table.weighted_by_rounding(scatter).unwrap_or(table);
    if table.weighting() == Weighting::Rounding {
        of_exact = fit_small_angle_period(&table, &exact)?;
    }
    let is_included = options.reject_outliers.is_none() && !outliers.is_empty();
    let without =
        is_included.then(|| fit_small_angle_period(&table.without(&outliers), &exact).ok()).flatten();
    let beta = fit_excess_scale(&table, &exact);
    let uncertainty_of_rows = of_exact.t0.uncertainty;
    let contradiction = beta.as_ref().ok().and_then(|beta| contradiction(of_exact.t0, &beta.beta));
    if let Some(contradiction) = &contradiction {
        of_exact.t0 = of_exact.t0.with_error(contradiction.uncertainty());
    }
    let mistaken_unit = beta.as_ref().ok().and_then(|beta| MistakenUnit::of(beta.beta.factor.value, &table));
    Ok(PeriodFit {
        weighting: table.weighting(),
        outliers,
        without_outliers: without.map(|fit| fit.t0),
        exact: of_exact,
        contradiction,
        mistaken_unit,
        uncertainty_of_rows,
        constant: fit_small_angle_period(&table, &Law::constant())?,
        others: others.iter().map(|law| (law.key().into(), fit_small_angle_period(&table, law))).collect(),
        beta,
        table,
    })
}

/// Compares T0 with β = 1 and with β free from the same rows: they contradict each other if β is far from 1.
fn contradiction(of_exact: Uncertain, free: &Beta) -> Option<Contradiction> {
    let degrees_of_freedom = free.degrees_of_freedom;
    let estimate = |name: &str, t0| Estimate { name: name.to_owned(), t0, degrees_of_freedom };
    let pair = [estimate("β = 1", of_exact), estimate("β free", free.t0)];
    Contradiction::of(pair.each_ref(), free.deviation(), degrees_of_freedom)
}
