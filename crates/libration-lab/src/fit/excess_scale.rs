//! β of a law by a table of periods.

use super::beta::Beta;
use super::effective_weights::{Weighted, settled};
use super::law::{Law, Point};
use super::scatter::{self, Scatter};
use super::{FitError, PeriodTable, Weighting};
use crate::statistics::count;

/// β with T0 left free.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ExcessScaleFit {
    /// With uncertainties from those of the rows, [enlarged](Scatter) where they scatter more; without them from the scatter.
    pub beta: Beta,
    /// The uncertainty of β by the scatter in any case: the standard deviation if all uncertainties were wrong by one factor, be it
    /// above or below one. None without a degree of freedom.
    pub uncertainty_scaled: Option<f64>,
    /// The sum of the squared residuals over their effective variances; none without uncertainties.
    pub chi2: Option<f64>,
    /// Degrees of freedom: rows less two.
    pub dof: usize,
}

impl ExcessScaleFit {
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
}

/// β and T0 in T = T0·[1 + β(R − 1)].
///
/// The model is the line T = T0 + (T0β)·(R − 1), solved with its full covariance; β is the quotient.
///
/// # Errors
/// Fewer than two rows (three without uncertainties), all amplitudes equal, a law without a value.
pub fn excess_scale(table: &PeriodTable, law: &Law<'_>) -> Result<ExcessScaleFit, FitError> {
    let needed = if table.weighting() == Weighting::Scatter { 3 } else { 2 };
    if table.len() < needed {
        return Err(FitError::TooFewRows { found: table.len(), needed, parameters: "beta" });
    }
    let points = law.points(&table.rows)?;
    if points.iter().all(|point| point.ratio.to_bits() == points[0].ratio.to_bits()) {
        return Err(FitError::EqualAmplitudes);
    }
    let solve = |variances: &[f64]| Line::through(&points, variances);
    let (line, _) = settled(&points, table.weighting(), "beta", solve)?;
    Ok(line.to_fit(&points, table.weighting()))
}

/// T = mean + slope·(x − centre) with x = R − 1, and the variances of its uncorrelated two parameters.
struct Line {
    centre: f64,
    mean: f64,
    slope: f64,
    mean_variance: f64,
    slope_variance: f64,
    chi2: f64,
}

impl Weighted for Line {
    fn scale(&self) -> f64 {
        self.slope
    }

    /// Far less than its own uncertainty, of a slope that may be zero.
    fn negligible(&self) -> f64 {
        1e-12 * (self.slope.abs() + self.slope_variance.sqrt())
    }
}

impl Line {
    fn through(points: &[Point], variances: &[f64]) -> Self {
        let sum = |term: &dyn Fn(f64, f64) -> f64| -> f64 {
            points.iter().zip(variances).map(|(p, v)| term(p.ratio - 1.0, p.row.period) / v).sum()
        };
        let weight = sum(&|_, _| 1.0);
        let (centre, mean) = (sum(&|x, _| x) / weight, sum(&|_, t| t) / weight);
        let spread = sum(&|x, _| (x - centre) * (x - centre));
        let slope = sum(&|x, t| (x - centre) * (t - mean)) / spread;
        let residual = |x: f64, t: f64| t - mean - slope * (x - centre);
        let chi2 = sum(&|x, t| residual(x, t) * residual(x, t));
        Self { centre, mean, slope, mean_variance: 1.0 / weight, slope_variance: 1.0 / spread, chi2 }
    }

    fn to_fit(&self, points: &[Point], weighting: Weighting) -> ExcessScaleFit {
        let dof = points.len() - 2;
        let weighted = weighting != Weighting::Scatter;
        let per_dof = (dof > 0).then(|| self.chi2 / count(dof));
        let chi2 = weighted.then_some(self.chi2);
        let enlargement = scatter::enlargement(chi2, dof);
        // Unit weights: the variance of a row is the scatter about the line.
        let unit = if weighted { enlargement * enlargement } else { per_dof.unwrap_or(f64::NAN) };
        let t0 = self.mean - self.slope * self.centre;
        let t0_variance = self.mean_variance + self.centre * self.centre * self.slope_variance;
        let both = -self.centre * self.slope_variance;
        let covariance = |unit: f64| {
            [[t0_variance, both], [both, self.slope_variance]].map(|row| row.map(|entry| entry * unit))
        };
        let beta = |unit: f64| Beta::of_line([t0, self.slope], covariance(unit));
        ExcessScaleFit {
            beta: beta(unit),
            uncertainty_scaled: per_dof.map(|per_dof| beta(per_dof).factor.uncertainty),
            chi2,
            dof,
        }
    }
}
