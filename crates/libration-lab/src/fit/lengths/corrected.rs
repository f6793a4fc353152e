//! Corrections of a table of lengths: the periods that the pendulums would have without the effects that the law does not contain.
//!
//! A pendulum of length h has g = 4π²h(1 + κ/h²)F/T0² with the factor F of all effects but the moment of inertia of the bob, which is part of the law.
//! The period T/√F belongs to the law alone. F depends on h = |L + δ|, and of a bar on κ, both of which are fitted: a few rounds settle them.

use super::model::LengthFit;
use super::{LengthModel, LengthTable, LengthsOptions, bar, model, reversible};
use crate::fit::budget::{self, Apparatus, BudgetEffect, MeasuredPeriod, TableBudget, Values};
use crate::fit::error::FitError;
use crate::statistics::mean;
use libration::quantity::Quantity;

/// Largest number of rounds; each reduces the error by the size of the corrections.
const ROUNDS: usize = 20;
/// Largest negligible relative change of g.
const SETTLED: f64 = 1e-12;
/// Largest relative change of g in the last round for which the result is accepted: rounding in fits whose rows hardly determine the offset may
/// exceed [`SETTLED`], and no g is known to a billionth.
const ACCEPTED: f64 = 1e-9;

/// One law of a table with its corrections.
pub(super) struct CorrectedLaw<'a> {
    pub(super) table: &'a LengthTable,
    pub(super) options: &'a LengthsOptions,
    pub(super) model: LengthModel,
}

impl CorrectedLaw<'_> {
    /// The fit to the table with its uncorrected periods.
    fn fit_to(&self, table: &LengthTable, radius: Option<f64>) -> Option<LengthFit> {
        match self.model {
            LengthModel::Reversible => {
                reversible::reversible(table, self.options.edges).ok().map(|fit| fit.0)
            }
            bar if bar.is_of_bars() => bar::fit(table, bar),
            string => model::fit(table, string, radius).ok().flatten(),
        }
    }

    /// The table with corrected periods.
    ///
    /// # Errors
    /// A correction that is impossible, rows that determine no law, and corrections so large that the rounds do not settle them.
    pub(super) fn table(
        &self,
        values: &Values,
        left_out: Option<BudgetEffect>,
    ) -> Result<LengthTable, FitError> {
        let shifted = self.shifted(values);
        let radius = self.radius(values, left_out);
        let mut factors = vec![1.0; shifted.rows.len()];
        let (mut gravity, mut change) = (f64::NAN, f64::INFINITY);
        for _ in 0..ROUNDS {
            let table = shifted.divided(&factors);
            let fit = self.fit_to(&table, radius).ok_or(FitError::CorrectionsTooLarge)?;
            let gyration = self.gyration(&fit, &table, values, left_out);
            let next = self.factors(&fit, &shifted, gyration, values, left_out);
            let next = next.ok_or(FitError::CorrectionsOfRow)?;
            change = if next == factors { 0.0 } else { (fit.g.value / gravity - 1.0).abs() };
            (factors, gravity) = (next, fit.g.value);
            if change <= SETTLED {
                break;
            }
        }
        if change <= ACCEPTED { Ok(shifted.divided(&factors)) } else { Err(FitError::CorrectionsTooLarge) }
    }

    /// g by these values.
    fn gravity(&self, values: &Values, left_out: Option<BudgetEffect>) -> f64 {
        let table = self.table(values, left_out).ok();
        let fit = table.and_then(|table| self.fit_to(&table, self.radius(values, left_out)));
        fit.map_or(f64::NAN, |fit| fit.g.value) / (values.clock * values.clock)
    }

    /// Radius of a ball with the moment of inertia of the bob; `None` for a bob of no size.
    fn radius(&self, values: &Values, left_out: Option<BudgetEffect>) -> Option<f64> {
        let is_used = left_out != Some(BudgetEffect::FiniteBob) && !self.model.is_of_bars();
        Some(values.bob.radius_of_ball()).filter(|radius| is_used && *radius > 0.0)
    }

    /// The table with its periods changed by the common error of all readings.
    fn shifted(&self, values: &Values) -> LengthTable {
        let Some(shifts) = &self.options.shared_timing else { return self.table.clone() };
        let part = (values.shared_timing - 1.0) / self.options.relative_shift(self.table).unwrap_or(1.0);
        self.table.shifted(shifts.iter().map(|shift| part * shift))
    }

    /// κ of the law that is fitted to the corrected table.
    fn gyration(
        &self,
        fit: &LengthFit,
        corrected: &LengthTable,
        values: &Values,
        left_out: Option<BudgetEffect>,
    ) -> f64 {
        match self.model {
            LengthModel::Reversible => reversible::gyration(corrected, fit.g.value),
            model if model.is_of_bars() => fit.gyration.map_or(0.0, |gyration| gyration.value),
            _ if left_out == Some(BudgetEffect::FiniteBob) => 0.0,
            _ => values.bob.gyration(),
        }
    }

    /// F of all rows of the table with the measured periods.
    fn factors(
        &self,
        fit: &LengthFit,
        table: &LengthTable,
        gyration: f64,
        values: &Values,
        left_out: Option<BudgetEffect>,
    ) -> Option<Vec<f64>> {
        let offset = fit.offset.map_or(0.0, |offset| offset.value);
        let values = if self.model.is_of_bars() { values.with_gyration(gyration) } else { *values };
        let factor = |row: &super::table::LengthRow| {
            let height = (row.length + offset).abs();
            let at = values.at(height, row.period / row.ratio, row.amplitude);
            let factor = at.factor_without(left_out) / (1.0 + gyration / (height * height));
            (factor > 0.0 && factor.is_finite()).then_some(factor)
        };
        table.rows.iter().map(factor).collect()
    }

    /// The corrections of g, each with its contribution to the uncertainty, for the fitted law.
    pub(super) fn budget(&self, fit: &LengthFit) -> Result<TableBudget, FitError> {
        let offset = fit.offset.map_or(0.0, |offset| offset.value);
        let rows = &self.table.rows;
        let exactly = |value: f64| Quantity { value, uncertainty: None };
        let length = exactly(mean(rows.iter().map(|row| (row.length + offset).abs())));
        let amplitude = mean(rows.iter().map(|row| row.amplitude));
        let period = MeasuredPeriod {
            amplitude: (amplitude > 0.0).then_some(amplitude),
            clock: self.options.clock,
            shared_timing: self.options.relative_shift(self.table),
            ..MeasuredPeriod::of_small_swings(exactly(mean(rows.iter().map(|row| row.period / row.ratio))))
        };
        let typical = Apparatus { length, corrections: self.options.corrections };
        let law = |values: &Values, left_out: Option<BudgetEffect>| {
            // Without corrections only the clock and the readings change g.
            if values.correct_nothing() && values.shared_timing.total_cmp(&1.0).is_eq() {
                return fit.g.value / (values.clock * values.clock);
            }
            self.gravity(values, left_out)
        };
        Ok(budget::of_table(&typical, &period, self.model.is_of_bars(), &law)?)
    }
}
