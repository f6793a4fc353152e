//! β of a law, fitted to a table of periods.

use nalgebra::{DMatrix, DVector};

use super::beta::Beta;
use super::effective_weights::{Weighted, settled};
use super::law::{Law, Point};
use super::scatter::{self, Scatter};
use super::{FitError, PeriodTable, RepeatedReadings, Weighting};
use crate::statistics::{LinearFit, Undetermined, count, weighted_least_squares};

/// β with T0 left free.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ExcessScaleFit {
    /// β with uncertainties from those of the rows, [enlarged](Scatter) where they scatter more; without them from the scatter.
    pub beta: Beta,
    /// The uncertainty of β by the scatter in any case: the standard deviation if all uncertainties were wrong by one factor, above
    /// or below one. `None` without a degree of freedom.
    pub uncertainty_scaled: Option<f64>,
    /// The sum of the squared residuals over their effective variances; `None` without uncertainties.
    pub chi2: Option<f64>,
    /// Degrees of freedom: rows less two.
    pub dof: usize,
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
        Scatter::new(self.chi2, self.dof)
    }
}

/// Fits β and T0 in T = T0·[1 + β(R − 1)].
///
/// The model is the line T = T0 + (T0β)·(R − 1), solved with its full covariance; β is the quotient.
///
/// # Errors
/// Fails for fewer than two rows (three without uncertainties), equal amplitudes, and a law without a value.
pub fn excess_scale(table: &PeriodTable, law: &Law<'_>) -> Result<ExcessScaleFit, FitError> {
    let needed = if table.weighting() == Weighting::Scatter { 3 } else { 2 };
    if table.len() < needed {
        return Err(FitError::TooFewRows { found: table.len(), needed, parameters: "beta" });
    }
    let points = law.points(&table.rows)?;
    let (line, _) = settled(&points, table.weighting(), "beta", |weights| Line::through(&points, weights))?;
    let readings = table.readings().map_or(f64::INFINITY, RepeatedReadings::pooled);
    Ok(line.to_fit(points.len() - 2, table.weighting(), readings))
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
        let columns =
            DMatrix::from_fn(points.len(), 2, |i, k| if k == 0 { 1.0 } else { points[i].ratio - 1.0 });
        let periods = DVector::from_fn(points.len(), |i, _| points[i].row.period);
        let fit = weighted_least_squares(columns, periods, weights);
        fit.map(Self).map_err(|reason| match reason {
            Undetermined::Dependent { .. } | Undetermined::TooFewRows => FitError::EqualAmplitudes,
            Undetermined::NotFinite => FitError::NoConvergence("beta"),
        })
    }

    fn to_fit(&self, dof: usize, weighting: Weighting, readings: f64) -> ExcessScaleFit {
        let Self(fit) = self;
        let weighted = weighting != Weighting::Scatter;
        let per_dof = (dof > 0).then(|| fit.chi2() / count(dof));
        let chi2 = weighted.then_some(fit.chi2());
        let enlargement = scatter::enlargement(chi2, dof);
        // Unit weights: the variance of a row is the scatter about the line.
        let unit = if weighted { enlargement * enlargement } else { per_dof.unwrap_or(f64::NAN) };
        let of_scatter = scatter::degrees_of_freedom(chi2, dof);
        let degrees_of_freedom = if of_scatter.is_finite() { of_scatter } else { readings };
        let beta =
            |unit: f64| Beta::from_line(&fit.coefficients, &(&fit.covariance * unit), degrees_of_freedom);
        ExcessScaleFit {
            beta: beta(unit),
            uncertainty_scaled: per_dof.map(|per_dof| beta(per_dof).factor.uncertainty),
            chi2,
            dof,
        }
    }
}
