//! β of a law, fitted to a table of periods.

use nalgebra::{DMatrix, DVector};

use super::beta::Beta;
use super::effective_weights::{Weighted, settled};
use super::error::FitError;
use super::law::{Law, Point};
use super::period_table::{PeriodTable, Weighting};
use super::readings::RepeatedReadings;
use super::readings_of_fit::ReadingsOfFit;
use super::scatter::{self, Scatter};
use crate::statistics::{LinearFit, Undetermined, count, weighted_least_squares};

/// β with T0 left free.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ExcessScaleFit {
    /// β with uncertainties from those of the rows, [enlarged](Scatter) where they scatter more; without them from the scatter.
    pub beta: Beta,
    /// The uncertainty of β by the scatter alone: the standard deviation if all uncertainties have the wrong scale, by a factor
    /// above or below one. `None` without a degree of freedom.
    pub uncertainty_scaled: Option<f64>,
    /// The sum of the squared residuals over their effective variances; `None` without uncertainties.
    pub chi2: Option<f64>,
    /// Degrees of freedom: rows less two.
    pub dof: usize,
    scatter: Option<Scatter>,
}

impl ExcessScaleFit {
    /// χ² per degree of freedom; `None` without uncertainties or without a degree of freedom.
    #[must_use]
    pub fn chi2_per_dof(&self) -> Option<f64> {
        self.scatter().map(Scatter::chi2_per_dof)
    }

    /// Scatter of the rows compared with their uncertainties; `None` without uncertainties or without a degree of freedom.
    #[must_use]
    pub fn scatter(&self) -> Option<Scatter> {
        self.scatter
    }
}

/// Fits β and T0 in T = T0·[1 + β(R − 1)].
///
/// The model is the line T = T0 + (T0β)·(R − 1), solved with its full covariance; β is the quotient.
///
/// # Errors
/// Fails for fewer than two rows (three without uncertainties), equal amplitudes, and a law without a value.
pub fn fit_excess_scale(table: &PeriodTable, law: &Law<'_>) -> Result<ExcessScaleFit, FitError> {
    let needed = if table.weighting() == Weighting::Scatter { 3 } else { 2 };
    if table.len() < needed {
        return Err(FitError::TooFewRows { rows: table.len(), needed, parameters: "beta" });
    }
    let points = law.points(&table.rows)?;
    let (line, variances) =
        settled(&points, table.weighting(), "beta", |weights| Line::through(&points, weights))?;
    Ok(line.to_fit(&points, variances.as_deref(), table.readings()))
}

/// T = T0 + (T0β)·(R − 1).
struct Line(LinearFit);

impl Weighted for Line {
    fn scale(&self) -> f64 {
        self.0.coefficients[1]
    }

    /// A change far below the uncertainty of the slope, which may be zero.
    fn negligible(&self) -> f64 {
        1e-12 * (self.scale().abs() + self.0.covariance[(1, 1)].sqrt())
    }
}

impl Line {
    fn through(points: &[Point], weights: &[f64]) -> Result<Self, FitError> {
        let periods = DVector::from_fn(points.len(), |i, _| points[i].row.period);
        let fit = weighted_least_squares(Self::columns(points), periods, weights);
        fit.map(Self).map_err(|reason| match reason {
            Undetermined::Dependent { .. } | Undetermined::TooFewRows => FitError::EqualAmplitudes,
            Undetermined::NotFinite => FitError::NoConvergence("beta"),
        })
    }

    fn columns(points: &[Point]) -> DMatrix<f64> {
        DMatrix::from_fn(points.len(), 2, |i, k| if k == 0 { 1.0 } else { points[i].ratio - 1.0 })
    }

    /// The fit; without variances its weights are equal.
    fn to_fit(
        &self,
        points: &[Point],
        variances: Option<&[f64]>,
        readings: Option<&RepeatedReadings>,
    ) -> ExcessScaleFit {
        let (Self(fit), dof) = (self, points.len() - 2);
        let columns = Self::columns(points);
        let readings = readings.zip(variances).map(|(readings, variances)| {
            ReadingsOfFit::new(readings, vec![1.0; points.len()], &columns, variances, &fit.covariance)
        });
        let per_dof = (dof > 0).then(|| fit.chi2() / count(dof));
        let chi2 = variances.is_some().then(|| fit.chi2());
        let scatter = match &readings {
            Some(readings) => readings.scatter(fit.chi2(), dof),
            None => Scatter::new(chi2, dof),
        };
        let enlargement = scatter.map_or(1.0, Scatter::enlargement);
        // Unit weights: the variance of a row is the scatter about the line.
        let unit = if chi2.is_some() { enlargement * enlargement } else { per_dof.unwrap_or(f64::NAN) };
        let covariance = readings.as_ref().map_or_else(|| fit.covariance.clone(), ReadingsOfFit::covariance);
        let beta = |unit: f64, degrees_of_freedom: f64| {
            Beta::from_line(&fit.coefficients, &(&covariance * unit), degrees_of_freedom)
        };
        let of_scatter = match scatter {
            Some(scatter) => scatter.degrees_of_freedom(),
            None => scatter::degrees_of_freedom(chi2, dof),
        };
        let of_readings = readings.filter(|_| of_scatter.is_infinite()).map(|readings| {
            // dβ = (d(T0β) − β dT0)/T0.
            let t0 = fit.coefficients[0];
            let spread = beta(1.0, of_scatter).factor;
            readings
                .degrees_of_freedom(&[-spread.value / t0, 1.0 / t0], spread.uncertainty * spread.uncertainty)
        });
        ExcessScaleFit {
            beta: beta(unit, of_readings.unwrap_or(of_scatter)),
            uncertainty_scaled: per_dof.map(|per_dof| beta(per_dof, of_scatter).factor.uncertainty),
            chi2,
            dof,
            scatter,
        }
    }
}
