//! Amplitudes in a unit other than the stated one: with the right unit the periods follow the exact law.

use std::f64::consts::PI;

use super::excess_scale::fit_excess_scale;
use super::law::Law;
use super::period_table::Row;
use super::period_table::{PeriodTable, Uncertainties};

const DEGREES_PER_RADIAN: f64 = 180.0 / PI;
/// Smallest β of small angles in radians that were taken as degrees: it is (180/π)² = 3283, and nothing else makes β so large. For degrees taken as
/// radians it is the reciprocal.
const BETA_OF_RADIANS: f64 = 1000.0;
/// Largest deviation of β from 1 with the right unit, unless it is within three of its uncertainties.
const BETA_OF_A_PENDULUM: f64 = 0.15;

/// A unit of the amplitudes that was mistaken for another one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MistakenUnit {
    /// The numbers are radians, and were taken for degrees.
    Radians,
    /// The numbers are degrees, and were taken for radians.
    Degrees,
}

impl MistakenUnit {
    /// Returns the mistaken unit of amplitudes that give this β.
    pub(super) fn of(beta: f64, table: &PeriodTable) -> Option<Self> {
        match beta {
            _ if beta > BETA_OF_RADIANS => {
                follows_exact_law(table, DEGREES_PER_RADIAN, stated(table), 1.0).then_some(Self::Radians)
            }
            // Where degrees are taken for radians the sizes of errors belong to another shape of swing, so that the scatter of the periods is used
            // instead. A β of zero would be as near to one as that of degrees, were its uncertainty one.
            _ if beta.abs() < 1.0 / BETA_OF_RADIANS => {
                follows_exact_law(table, 1.0 / DEGREES_PER_RADIAN, [None, None], 0.3).then_some(Self::Degrees)
            }
            _ => None,
        }
    }
}

/// The uncertainties of amplitudes and periods.
type UncertaintyColumns = [Option<Vec<f64>>; 2];

fn column(table: &PeriodTable, of: impl Fn(&Row) -> f64) -> Vec<f64> {
    table.rows.iter().map(of).collect()
}

fn stated(table: &PeriodTable) -> UncertaintyColumns {
    let of_periods = column(table, |row| row.period_uncertainty);
    let is_stated = of_periods.iter().all(|&period| period > 0.0);
    [Some(column(table, |row| row.amplitude_uncertainty)), is_stated.then_some(of_periods)]
}

/// Returns `true` if the periods follow the exact law where the amplitudes are multiplied by this factor, with an uncertainty of β below the given one.
fn follows_exact_law(
    table: &PeriodTable,
    factor: f64,
    uncertainties: UncertaintyColumns,
    most_uncertain: f64,
) -> bool {
    let [of_amplitudes, of_periods] = uncertainties;
    let of_amplitudes =
        of_amplitudes.map(|column| column.into_iter().map(|value| factor * value).collect::<Vec<f64>>());
    let (amplitudes, periods) =
        (column(table, |row| factor * row.amplitude), column(table, |row| row.period));
    let uncertainties =
        Uncertainties { amplitudes: of_amplitudes.as_deref(), periods: of_periods.as_deref() };
    let table = PeriodTable::new(&amplitudes, &periods, uncertainties);
    let fit = table.ok().and_then(|table| fit_excess_scale(&table, &Law::exact()).ok());
    fit.is_some_and(|fit| {
        let beta = fit.beta.factor;
        let uncertainty = beta.uncertainty.max(fit.uncertainty_scaled.unwrap_or(0.0));
        (beta.value - 1.0).abs() < BETA_OF_A_PENDULUM.max(3.0 * uncertainty) && uncertainty < most_uncertain
    })
}
