//! T0 under a law T = T0·R(A).

use super::effective_weights::{Weighted, settled};
use super::error::FitError;
use super::law::{Law, Point};
use super::period_table::{PeriodTable, Weighting};
use super::readings::shared_rounding;
use super::readings_of_fit::ReadingsOfFit;
use super::scatter::{self, Scatter};
use super::uncertain::Uncertain;
use crate::statistics::{LinearFit, count, root_mean_square, weighted_least_squares};
use nalgebra::{DMatrix, DVector};

/// T0 under one law.
#[derive(Clone, Debug, PartialEq)]
pub struct LawFit {
    /// Key of the law.
    pub key: String,
    /// The period of small swings, in seconds; its uncertainty comes from those of the rows, [enlarged](Scatter) where they scatter
    /// more, or without them from the scatter.
    pub t0: Uncertain,
    /// The sum of the squared residuals over their effective variances; `None` without uncertainties.
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
    /// Degrees of freedom of the uncertainty of T0 by those of repeated readings; infinite without any.
    pub readings_degrees_of_freedom: f64,
    scatter: Option<Scatter>,
}

impl LawFit {
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

    /// Degrees of freedom of the uncertainty of T0: of the scatter of the rows where it comes from that, else of repeated readings, and infinite
    /// where it comes from stated uncertainties.
    #[must_use]
    pub fn uncertainty_degrees_of_freedom(&self) -> f64 {
        let of_rows = match self.scatter() {
            Some(scatter) => scatter.degrees_of_freedom(),
            None => scatter::degrees_of_freedom(self.chi2, self.dof),
        };
        if of_rows.is_finite() { of_rows } else { self.readings_degrees_of_freedom }
    }
}

/// Fits T0 under the law.
///
/// # Errors
/// Fails for no rows, a single row without an uncertainty, and a law without a value at one of the amplitudes.
pub fn fit_small_angle_period(table: &PeriodTable, law: &Law<'_>) -> Result<LawFit, FitError> {
    let needed = if table.weighting() == Weighting::Scatter { 2 } else { 1 };
    if table.len() < needed {
        return Err(FitError::TooFewRows { rows: table.len(), needed, parameters: "T0" });
    }
    let points = law.points(&table.rows)?;
    let solve = |weights: &[f64]| T0::through(&points, weights);
    let (T0(fit), variances) = settled(&points, table.weighting(), "T0", solve)?;
    let t0 = fit.coefficients[0];
    let residuals: Vec<f64> = points.iter().map(|point| point.row.period - t0 * point.ratio).collect();
    let dof = points.len() - 1;
    let weighted = table.weighting() != Weighting::Scatter;
    // Unit weights: the variance of a row is the scatter about the law.
    let unit = if weighted { 1.0 } else { fit.chi2() / count(dof) };
    let chi2 = weighted.then_some(fit.chi2());
    let variances = variances.unwrap_or_else(|| vec![unit; points.len()]);
    let variance = unit * fit.covariance[(0, 0)];
    // T0 = Σ cᵢTᵢ with these c.
    let c: Vec<f64> = points.iter().zip(&variances).map(|(point, v)| variance * point.ratio / v).collect();
    let readings = table.readings().filter(|_| weighted);
    let columns = DMatrix::from_fn(points.len(), 1, |i, _| points[i].ratio);
    let of_readings = readings.map(|reading| {
        ReadingsOfFit::new(reading, vec![1.0; points.len()], &columns, &variances, &fit.covariance)
    });
    let variance = of_readings.as_ref().map_or(variance, |of_fit| of_fit.covariance()[(0, 0)]);
    let readings_degrees_of_freedom =
        of_readings.as_ref().map_or(f64::INFINITY, |of_fit| of_fit.degrees_of_freedom(&[1.0], variance));
    let scatter = match &of_readings {
        Some(readings) => readings.scatter(fit.chi2(), dof),
        None => Scatter::new(chi2, dof),
    };
    let enlargement = scatter.map_or(1.0, Scatter::enlargement);
    let of_rounding = readings.map_or(0.0, |readings| shared_rounding(readings, &c));
    Ok(LawFit {
        readings_degrees_of_freedom,
        scatter,
        key: law.key().into(),
        t0: Uncertain {
            value: t0,
            uncertainty: libm::hypot(enlargement * variance.sqrt(), of_rounding.max(0.0).sqrt()),
        },
        chi2,
        dof,
        rms: root_mean_square(residuals.iter().copied()),
        residuals,
        standard_deviations: variances.iter().map(|v| v.sqrt()).collect(),
    })
}

/// T = T0·R.
struct T0(LinearFit);

impl T0 {
    fn through(points: &[Point], weights: &[f64]) -> Result<Self, FitError> {
        let ratios = DMatrix::from_fn(points.len(), 1, |i, _| points[i].ratio);
        let periods = DVector::from_fn(points.len(), |i, _| points[i].row.period);
        weighted_least_squares(ratios, periods, weights).map(Self).map_err(|_| FitError::NoConvergence("T0"))
    }
}

impl Weighted for T0 {
    fn scale(&self) -> f64 {
        self.0.coefficients[0]
    }

    fn negligible(&self) -> f64 {
        // Some hundred rounding errors: the coefficients come from a linear solution.
        1e-13 * self.scale().abs()
    }
}
