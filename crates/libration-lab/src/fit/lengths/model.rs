//! One law of the period against the length, fitted by weighted least squares: y = (T/2πR)² = (L + δ + κ/L)/g.

use std::f64::consts::PI;

use nalgebra::{DMatrix, DVector};

use super::table::{LengthRow, LengthTable};
use crate::fit::error::FitError;
use crate::fit::readings_of_fit::ReadingsOfFit;
use crate::fit::scatter::{self, Scatter};
use crate::fit::uncertain::Uncertain;
use crate::statistics::student::probability_beyond;
use crate::statistics::{akaike, count, is_settled, weighted_least_squares};

/// Rounds in which the weights are renewed; the error falls by a factor of (σ of g)/g or so each time.
const MOST_ROUNDS: usize = 100;
/// Rounds in which the offset falls to that with the bob; the error falls by q(3 + q)/(1 − q) each time, with q = 2r²/5x² at a distance x
/// from the pivot: by 0.8 or less from 1.45 radii on.
const ROUNDS_WITH_BOB: usize = 200;
/// Largest negligible change of the offset, relative to the shortest distance: rounding causes less.
const SETTLED: f64 = 1e-13;

/// Free parameters besides g.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum LengthModel {
    /// T² = 4π²R²L/g.
    Plain,
    /// T² = 4π²R²(L + δ)/g: the length was not measured to the centre of the bob.
    Offset,
    /// T² = 4π²R²(L + δ + κ/(L + δ))/g: κ is the moment of inertia of the bob about its centre over its mass.
    OffsetAndGyration,
    /// T² = 4π²R²(L + κ/L)/g: a bar turned about points at these distances from its centre of mass, κ being the square of its radius of gyration.
    Bar,
    /// The law of a bar with |L + δ| in place of L: the positions are measured from a mark, and the centre of mass is at −δ.
    BarOffset,
    /// The reversible pendulum, by Bessel's formula.
    Reversible,
}

impl LengthModel {
    /// Laws of a bob on a string, simpler ones first.
    pub const OF_STRINGS: [Self; 3] = [Self::Plain, Self::Offset, Self::OffsetAndGyration];
    /// Laws of a bar turned about several points.
    pub const OF_BARS: [Self; 2] = [Self::Bar, Self::BarOffset];

    /// Returns `true` if the law is that of a physical pendulum, with κ as large as the squares of the distances.
    #[must_use]
    pub fn is_of_bars(self) -> bool {
        matches!(self, Self::Bar | Self::BarOffset | Self::Reversible)
    }

    /// Name of the model: `plain`, `offset`, `offset+gyration`, `bar`, `bar+offset`, `reversible`.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Plain => "plain",
            Self::Offset => "offset",
            Self::OffsetAndGyration => "offset+gyration",
            Self::Bar => "bar",
            Self::BarOffset => "bar+offset",
            Self::Reversible => "reversible",
        }
    }

    /// Number of free parameters.
    pub(super) fn parameters(self) -> usize {
        match self {
            Self::Plain => 1,
            Self::Offset | Self::Bar | Self::Reversible => 2,
            Self::OffsetAndGyration | Self::BarOffset => 3,
        }
    }
}

/// g and the other free parameters of a law.
#[derive(Clone, Debug, PartialEq)]
pub struct LengthFit {
    /// The law.
    pub model: LengthModel,
    /// g in m/s². All uncertainties are [enlarged](Scatter) where the rows scatter more than theirs.
    pub g: Uncertain,
    /// δ, in metres, to be added to the lengths given.
    pub offset: Option<Uncertain>,
    /// κ, in m²; 2r²/5 for a ball, and k² of a bar.
    pub gyration: Option<Uncertain>,
    /// Correlation coefficient of g and δ.
    pub correlation: Option<f64>,
    /// The sum of the squared residuals over their effective variances; `None` without uncertainties.
    pub chi2: Option<f64>,
    /// Degrees of freedom.
    pub dof: usize,
    /// Akaike's criterion, corrected for few data; `None` where they are too few.
    pub aicc: Option<f64>,
    /// The probability that chance makes the last free parameter so large if it is zero (a *t* or F test); for the centre of a bar the probability
    /// of so large an improvement over a centre at zero.
    pub p_value: Option<f64>,
    /// Another centre of mass of a bar that the rows do not exclude, in metres, and g in m/s² with it.
    pub other_centre: Option<[f64; 2]>,
    /// Residuals of T from the law, in seconds, row by row.
    pub residuals: Vec<f64>,
    /// The standard deviations of these, in seconds, as stated; without uncertainties their scatter.
    pub standard_deviations: Vec<f64>,
    /// Degrees of freedom of the uncertainties of the periods by repeated readings; infinite without any.
    pub readings_degrees_of_freedom: f64,
    pub(super) scatter: Option<Scatter>,
}

impl LengthFit {
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

    /// Akaike's criterion of a fit to the periods of this table with [one uncertainty](LengthTable::of_equal_periods).
    pub(super) fn aicc_of(&self, table: &LengthTable) -> Option<f64> {
        aicc(self.chi2?, table.rows.len(), self.model.parameters(), table.weighted)
    }

    /// χ², or the sum of the squared residuals where no uncertainties are stated.
    pub(super) fn sum_of_squares(&self) -> f64 {
        self.chi2.unwrap_or_else(|| self.residuals.iter().map(|residual| residual * residual).sum())
    }

    /// The variance of a row in units of [`sum_of_squares`](Self::sum_of_squares): that of the scatter, and at least the stated one. `None` without
    /// a degree of freedom.
    pub(super) fn unit_variance(&self) -> Option<f64> {
        let per_dof = (self.dof > 0).then(|| self.sum_of_squares() / count(self.dof))?;
        Some(if self.chi2.is_some() { per_dof.max(1.0) } else { per_dof })
    }

    /// Degrees of freedom of the uncertainties: of the scatter of the rows where they come from that, else of repeated readings, and infinite where
    /// they come from stated ones.
    #[must_use]
    pub fn uncertainty_degrees_of_freedom(&self) -> f64 {
        let of_rows = match self.scatter() {
            Some(scatter) => scatter.degrees_of_freedom(),
            None => scatter::degrees_of_freedom(self.chi2, self.dof),
        };
        if of_rows.is_finite() { of_rows } else { self.readings_degrees_of_freedom }
    }
}

/// An unfinished solution: coefficients of L (with the known term of the bob), 1 and 1/L.
#[derive(Clone)]
pub(super) struct Solution {
    pub(super) coefficients: Vec<f64>,
    pub(super) columns: DMatrix<f64>,
    pub(super) covariance: DMatrix<f64>,
    pub(super) variances: Vec<f64>,
}

/// Free parameters besides g, and the correlation of g and δ.
struct Estimates {
    offset: Option<Uncertain>,
    gyration: Option<Uncertain>,
    correlation: Option<f64>,
}

/// Fits a law to the table, with the bob where its radius is known; `None` where there are too few rows, or the rows do not determine it.
///
/// # Errors
/// Fails for a bob that reaches the pivot.
pub(super) fn fit(
    table: &LengthTable,
    model: LengthModel,
    radius: Option<f64>,
) -> Result<Option<LengthFit>, FitError> {
    let (rows, width) = (&table.rows, model.parameters());
    if rows.len() < width + usize::from(!table.weighted) {
        return Ok(None);
    }
    let search = LawSearch { table, width };
    let Some(line) = search.without_bob() else { return Ok(None) };
    let best = match radius {
        Some(radius) => search.with_bob(line, radius)?,
        None => Some(line),
    };
    let gyration = radius.map_or(0.0, gyration);
    Ok(best.and_then(|(solution, offset)| solution.described(table, model, gyration, offset)))
}

/// κ of a ball.
pub(super) fn gyration(radius: f64) -> f64 {
    0.4 * radius * radius
}

/// The search for a law; a solution is combined with the offset used for its columns.
struct LawSearch<'a> {
    table: &'a LengthTable,
    width: usize,
}

impl LawSearch<'_> {
    fn without_bob(&self) -> Option<(Solution, f64)> {
        let first = vec![1.0; self.table.rows.len()];
        let mut current = (solve(&self.table.rows, self.width, 0.0, 0.0, &first)?, 0.0);
        for _ in 0..MOST_ROUNDS {
            let next = self.renewed(&current.0, 0.0)?;
            let [last, coefficients] = [&current, &next].map(|round| &round.0.coefficients);
            let settled = is_settled(last, coefficients, &next.0.covariance, 1.0);
            current = next;
            if settled {
                return Some(current);
            }
        }
        None
    }

    /// Iterates with the bob. It makes a pendulum slower, the more so the shorter it is, so that the offset is below that without it, and below
    /// that for any bob further down: from there it falls, and there is no solution once the bob reaches the pivot.
    fn with_bob(&self, line: (Solution, f64), radius: f64) -> Result<Option<(Solution, f64)>, FitError> {
        let shortest = self.table.rows.iter().map(|row| row.length).fold(f64::INFINITY, f64::min);
        let (mut last, mut settled) = (line, false);
        for _ in 0..ROUNDS_WITH_BOB {
            let distance = shortest + last.0.offset();
            if self.width > 1 && distance < radius {
                return Err(FitError::BobTooLarge { radius, distance });
            }
            if settled {
                return Ok(Some(last).filter(|accepted| !self.has_another(&accepted.0, radius, shortest)));
            }
            let before = last.0.offset();
            let Some(next) = self.renewed(&last.0, gyration(radius)) else { return Ok(None) };
            settled = (next.0.offset() - before).abs() <= SETTLED * distance;
            last = next;
        }
        Ok(None)
    }

    /// Returns `true` if an offset between this one and that of a bob that touches the pivot agrees with the bob as well, as below 1.3 radii, where
    /// the period rises more slowly with the length than without a bob.
    fn has_another(&self, solution: &Solution, radius: f64, shortest: f64) -> bool {
        let touching = radius - shortest;
        let next = self.with_offset(solution, gyration(radius), touching);
        self.width > 1 && next.is_none_or(|(next, _)| next.offset() < touching)
    }

    /// Solves with the weights and the offset of another solution.
    fn renewed(&self, last: &Solution, gyration: f64) -> Option<(Solution, f64)> {
        self.with_offset(last, gyration, last.offset())
    }

    /// Solves with the weights of another solution.
    fn with_offset(&self, last: &Solution, gyration: f64, offset: f64) -> Option<(Solution, f64)> {
        let rows = &self.table.rows;
        let variances = match self.table.weighted {
            true => rows.iter().map(|row| row.variance(last.coefficients[0])).collect(),
            false => last.variances.clone(),
        };
        Some((solve(rows, self.width, gyration, offset, &variances)?, offset))
    }
}

/// The columns of a row: the factors of 1/g, δ/g and κ/g.
fn columns(row: &LengthRow, width: usize, gyration: f64, offset: f64) -> Vec<f64> {
    let whole = row.length + offset;
    let all = [row.length + gyration / whole, 1.0, 1.0 / whole];
    all[..width].to_vec()
}

fn solve(
    rows: &[LengthRow],
    width: usize,
    gyration: f64,
    offset: f64,
    variances: &[f64],
) -> Option<Solution> {
    let columns: Vec<Vec<f64>> = rows.iter().map(|row| columns(row, width, gyration, offset)).collect();
    let matrix = DMatrix::from_fn(rows.len(), width, |i, j| columns[i][j]);
    let values = DVector::from_fn(rows.len(), |i, _| rows[i].square());
    let weights: Vec<f64> = variances.iter().map(|variance| 1.0 / variance.sqrt()).collect();
    let fit = weighted_least_squares(matrix.clone(), values, &weights).ok()?;
    let coefficients: Vec<f64> = fit.coefficients.iter().copied().collect();
    let (covariance, variances) = (fit.covariance, variances.to_vec());
    let solution = Solution { coefficients, columns: matrix, covariance, variances };
    Some(solution).filter(|solution| solution.coefficients[0] > 0.0)
}

impl Solution {
    fn offset(&self) -> f64 {
        self.coefficients.get(1).map_or(0.0, |constant| constant / self.coefficients[0])
    }

    fn described(
        &self,
        table: &LengthTable,
        model: LengthModel,
        gyration: f64,
        offset: f64,
    ) -> Option<LengthFit> {
        let width = self.coefficients.len();
        let fitted = |row: &LengthRow| -> f64 {
            columns(row, width, gyration, offset).iter().zip(&self.coefficients).map(|(x, c)| x * c).sum()
        };
        let fitted: Vec<f64> = table.rows.iter().map(fitted).collect();
        self.with_estimates(table, model, &fitted, |solution, unit| Estimates {
            offset: (width > 1).then(|| solution.quotient(Some(1), unit)),
            gyration: (width > 2).then(|| solution.quotient(Some(2), unit)),
            correlation: (width > 1).then(|| solution.correlation()),
        })
    }

    /// The fit of a bar, whose coefficients are 1/g, κ/g and δ itself, with (T/2πR)² by the law.
    pub(super) fn described_bar(
        &self,
        table: &LengthTable,
        model: LengthModel,
        fitted: &[f64],
    ) -> Option<LengthFit> {
        let offset = |solution: &Self, unit: f64| Uncertain {
            value: solution.coefficients[2],
            uncertainty: (unit * solution.covariance[(2, 2)]).sqrt(),
        };
        let correlation = |solution: &Self| {
            -solution.covariance[(0, 2)] / (solution.covariance[(0, 0)] * solution.covariance[(2, 2)]).sqrt()
        };
        self.with_estimates(table, model, fitted, |solution, unit| Estimates {
            offset: (model == LengthModel::BarOffset).then(|| offset(solution, unit)),
            gyration: Some(solution.quotient(Some(1), unit)),
            correlation: (model == LengthModel::BarOffset).then(|| correlation(solution)),
        })
    }

    fn with_estimates(
        &self,
        table: &LengthTable,
        model: LengthModel,
        fitted: &[f64],
        estimates: impl FnOnce(&Self, f64) -> Estimates,
    ) -> Option<LengthFit> {
        let (rows, width) = (&table.rows, self.coefficients.len());
        let left: Vec<f64> = rows.iter().zip(fitted).map(|(row, fitted)| row.square() - fitted).collect();
        let chi2: f64 = left.iter().zip(&self.variances).map(|(r, v)| r * r / v).sum();
        let dof = rows.len() - width;
        let per_dof = (dof > 0).then(|| chi2 / count(dof));
        let stated = table.weighted.then_some(chi2);
        let readings = self.readings(table);
        let scatter = match &readings {
            Some(readings) => readings.scatter(chi2, dof),
            None => Scatter::new(stated, dof),
        };
        let covariance = readings.as_ref().map_or_else(|| self.covariance.clone(), ReadingsOfFit::covariance);
        // The relative variances of g and of the slope are equal.
        let degrees_of_freedom =
            |readings: &ReadingsOfFit<'_>| readings.degrees_of_freedom(&[1.0], covariance[(0, 0)]);
        let readings_degrees_of_freedom = readings.as_ref().map_or(f64::INFINITY, degrees_of_freedom);
        let solution = Self { covariance, ..self.clone() };
        let enlargement = scatter.map_or(1.0, Scatter::enlargement);
        // Unit weights: the variance of a row is the scatter about the law.
        let of_row = if table.weighted { 1.0 } else { per_dof? };
        let unit = of_row * enlargement * enlargement;
        // With y = (T/2πR)², dT = 2π²R²/T·dy.
        let to_seconds = |row: &LengthRow| 2.0 * PI * PI * row.ratio * row.ratio / row.period;
        let deviations =
            self.variances.iter().zip(rows).map(|(v, row)| (v * of_row).sqrt() * to_seconds(row));
        let estimates = estimates(&solution, unit);
        Some(LengthFit {
            model,
            g: solution.quotient(None, unit),
            offset: estimates.offset,
            gyration: estimates.gyration,
            correlation: estimates.correlation,
            chi2: stated,
            dof,
            aicc: aicc(chi2, rows.len(), width, table.weighted),
            p_value: per_dof.filter(|_| width > 1).map(|per_dof| solution.p_value(per_dof, dof)),
            other_centre: None,
            residuals: left.iter().zip(rows).map(|(r, row)| r * to_seconds(row)).collect(),
            standard_deviations: deviations.collect(),
            readings_degrees_of_freedom,
            scatter,
        })
    }

    /// The repeated readings of the periods in this solution.
    fn readings<'a>(&'a self, table: &'a LengthTable) -> Option<ReadingsOfFit<'a>> {
        let readings = table.readings.as_ref()?;
        // With y = (T/2πR)², dy = 2y·dT/T.
        let rows = table.rows.iter().zip(&readings.rows);
        let factors = rows.map(|(row, reading)| 2.0 * row.square() / reading.mean).collect();
        Some(ReadingsOfFit::new(readings, factors, &self.columns, &self.variances, &self.covariance))
    }

    /// 1/a, or c/a with the coefficient c of this index, and its uncertainty.
    fn quotient(&self, of: Option<usize>, unit: f64) -> Uncertain {
        let slope = self.coefficients[0];
        let value = of.map_or(1.0, |k| self.coefficients[k]) / slope;
        let of_coefficient = of.map_or(0.0, |k| self.covariance[(k, k)]);
        let both = of.map_or(0.0, |k| self.covariance[(0, k)]);
        let variance =
            (of_coefficient - 2.0 * value * both + value * value * self.covariance[(0, 0)]) / (slope * slope);
        Uncertain { value, uncertainty: (unit * variance).sqrt() }
    }

    /// Correlation coefficient of g = 1/a and δ = c/a.
    fn correlation(&self) -> f64 {
        let (slope, offset) = (self.coefficients[0], self.coefficients[1] / self.coefficients[0]);
        let [of_slope, both] = [self.covariance[(0, 0)], self.covariance[(0, 1)]];
        let of_g = of_slope / (slope * slope * slope * slope);
        let of_offset =
            (self.covariance[(1, 1)] - 2.0 * offset * both + offset * offset * of_slope) / (slope * slope);
        let covariance = -(both - offset * of_slope) / (slope * slope * slope);
        covariance / (of_g * of_offset).sqrt()
    }

    /// Probability of the last coefficient by the scatter, so that a common factor of all uncertainties does not matter.
    fn p_value(&self, per_dof: f64, dof: usize) -> f64 {
        let last = self.coefficients.len() - 1;
        let deviation = (per_dof * self.covariance[(last, last)]).sqrt();
        probability_beyond(self.coefficients[last] / deviation, dof)
    }
}

/// Akaike's criterion with the stated variances, or with that of the scatter.
fn aicc(chi2: f64, rows: usize, parameters: usize, weighted: bool) -> Option<f64> {
    let data = count(rows);
    match weighted {
        true => akaike::of_chi_squared(chi2, data, parameters),
        false => akaike::of_scatter(chi2 / data, data, parameters),
    }
}
