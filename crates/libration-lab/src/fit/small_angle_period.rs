//! T0 under a law T = T0·R(A).

use super::effective_weights::{Weighted, settled};
use super::law::{Law, Point};
use super::scatter::{self, Scatter};
use super::{FitError, PeriodTable, Weighting};
use crate::statistics::count;

/// T0 under one law.
#[derive(Clone, Debug, PartialEq)]
pub struct LawFit {
    /// Of the law.
    pub key: String,
    /// The period of small swings, in seconds.
    pub t0: f64,
    /// Its standard deviation, in seconds: from the uncertainties of the rows, [enlarged](Scatter) where they scatter more, or
    /// without them from the scatter.
    pub t0_uncertainty: f64,
    /// The sum of the squared residuals over their effective variances; none without uncertainties.
    pub chi2: Option<f64>,
    /// Degrees of freedom: rows less one.
    pub dof: usize,
    /// The root mean square of the residuals, in seconds.
    pub rms: f64,
    /// T − T0·R(A) of each row, in seconds.
    pub residuals: Vec<f64>,
    /// The effective standard deviation of each row, in seconds; without uncertainties the scatter
    /// √(Σ residual²/dof).
    pub standard_deviations: Vec<f64>,
}

impl LawFit {
    /// χ² per degree of freedom; none without uncertainties or without a degree of freedom.
    #[must_use]
    pub fn chi2_per_dof(&self) -> Option<f64> {
        self.scatter().map(Scatter::chi2_per_dof)
    }

    /// How the rows scatter beside their uncertainties; none without uncertainties or without a degree of freedom.
    #[must_use]
    pub fn scatter(&self) -> Option<Scatter> {
        Scatter::of(self.chi2, self.dof)
    }

    /// Of the uncertainty of T0: infinite where it comes from stated uncertainties.
    #[must_use]
    pub fn uncertainty_degrees_of_freedom(&self) -> f64 {
        scatter::degrees_of_freedom(self.chi2, self.dof)
    }
}

/// T0 under the law.
///
/// # Errors
/// No rows, a single row without an uncertainty, a law without a value at one of the amplitudes.
pub fn small_angle_period(table: &PeriodTable, law: &Law<'_>) -> Result<LawFit, FitError> {
    let needed = if table.weighting() == Weighting::Scatter { 2 } else { 1 };
    if table.len() < needed {
        return Err(FitError::TooFewRows { found: table.len(), needed, parameters: "T0" });
    }
    let points = law.points(&table.rows)?;
    let solve = |variances: &[f64]| T0(weighted_t0(&points, variances));
    let (T0(t0), variances) = settled(&points, table.weighting(), "T0", solve)?;
    let residuals: Vec<f64> = points.iter().map(|point| point.row.period - t0 * point.ratio).collect();
    let dof = points.len() - 1;
    let variances = variances.unwrap_or_else(|| vec![sum_of_squares(&residuals) / count(dof); points.len()]);
    let chi2: f64 = residuals.iter().zip(&variances).map(|(r, v)| r * r / v).sum();
    let chi2 = (table.weighting() != Weighting::Scatter).then_some(chi2);
    Ok(LawFit {
        key: law.key().into(),
        t0,
        t0_uncertainty: scatter::enlargement(chi2, dof) / information(&points, &variances).sqrt(),
        chi2,
        dof,
        rms: (sum_of_squares(&residuals) / count(residuals.len())).sqrt(),
        residuals,
        standard_deviations: variances.iter().map(|v| v.sqrt()).collect(),
    })
}

/// T0 in the making.
struct T0(f64);

impl Weighted for T0 {
    fn scale(&self) -> f64 {
        self.0
    }

    fn negligible(&self) -> f64 {
        1e-13 * self.0.abs()
    }
}

/// Σ R T/σ² over Σ R²/σ².
fn weighted_t0(points: &[Point], variances: &[f64]) -> f64 {
    let moment: f64 = points.iter().zip(variances).map(|(p, v)| p.ratio * p.row.period / v).sum();
    moment / information(points, variances)
}

/// Σ R²/σ², the inverse of the variance of T0.
fn information(points: &[Point], variances: &[f64]) -> f64 {
    points.iter().zip(variances).map(|(p, v)| p.ratio * p.ratio / v).sum()
}

fn sum_of_squares(values: &[f64]) -> f64 {
    values.iter().map(|x| x * x).sum()
}
