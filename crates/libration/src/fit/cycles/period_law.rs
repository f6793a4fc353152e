//! T = T0·[1 + β(R − 1)] through the cycles, whose errors are not independent: cycles share passages with those before
//! and after them, with the opposite sign, and extremes with their neighbours.

use super::CyclesError;
use super::local_fit::robust_deviation;
use crate::fit::Law;

const MOST_ROUNDS: usize = 50;

/// A cycle with what its errors come from.
#[derive(Clone, Copy, Debug)]
pub(super) struct Row {
    /// Of its middle.
    pub(super) time: f64,
    pub(super) period: f64,
    /// Numbers and variances of the passages it begins and ends with.
    pub(super) passages: [(usize, f64); 2],
    /// Numbers, amplitudes and variances of its two extremes.
    pub(super) extremes: [(usize, f64, f64); 2],
}

/// T0 under the exact law.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct PeriodLaw {
    /// The period of small swings, in seconds.
    pub(super) t0: f64,
    /// In seconds; enlarged by √(χ²/dof) where the cycles scatter more than their uncertainties say.
    pub(super) t0_uncertainty: f64,
    /// χ² per degree of freedom; none where there is no degree of freedom.
    pub(super) chi2_per_dof: Option<f64>,
}

/// The test of the exact law: T = T0·[1 + β(R − 1)].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Beta {
    /// 1 for the exact law, 0 for a constant period.
    pub beta: f64,
    /// With the uncertainties of the amplitudes, and enlarged by √(χ²/dof) where the cycles scatter more than they say.
    pub uncertainty: f64,
    /// The period of small swings that goes with β, in seconds.
    pub t0: f64,
    /// In seconds, enlarged as the other.
    pub t0_uncertainty: f64,
    /// Of T0 and β.
    pub correlation: f64,
    /// χ² per degree of freedom; none where there is no degree of freedom.
    pub chi2_per_dof: Option<f64>,
}

impl Row {
    /// The mean of T/T0 for the two half swings.
    pub(super) fn ratio(&self) -> f64 {
        0.5 * self.extremes.iter().map(|extreme| Law::exact().ratio_at(extreme.1)).sum::<f64>()
    }

    fn slope(&self, side: usize) -> f64 {
        0.5 * Law::exact().slope_at(self.extremes[side].1)
    }
}

/// T0 under the exact law.
pub(super) fn exact(rows: &[Row]) -> Option<PeriodLaw> {
    let mut t0 = rows.iter().map(|row| row.period / row.ratio()).sum::<f64>() / count(rows.len());
    let columns = vec![rows.iter().map(Row::ratio).collect::<Vec<f64>>()];
    let mut fit = None;
    for _ in 0..MOST_ROUNDS {
        let renewed = Generalised::fit(rows, t0, &columns)?;
        let step = renewed.coefficients[0] - t0;
        t0 = renewed.coefficients[0];
        fit = Some(renewed);
        if step.abs() <= 1e-13 * t0.abs() {
            break;
        }
    }
    let fit = fit?;
    let t0_uncertainty = (fit.scale() * fit.covariance[0][0]).sqrt();
    Some(PeriodLaw { t0, t0_uncertainty, chi2_per_dof: fit.chi2_per_dof() })
}

/// The test of the exact law.
pub(super) fn beta(rows: &[Row]) -> Result<Beta, CyclesError> {
    let excess: Vec<f64> = rows.iter().map(|row| row.ratio() - 1.0).collect();
    let (low, high) =
        excess.iter().fold((f64::INFINITY, 0.0), |(low, high): (f64, f64), &x| (low.min(x), high.max(x)));
    if rows.len() < 3 || high - low <= 1e-9 {
        return Err(CyclesError::EqualAmplitudes { cycles: rows.len() });
    }
    let columns = vec![vec![1.0; rows.len()], excess];
    let mut slope = rows.iter().map(|row| row.period / row.ratio()).sum::<f64>() / count(rows.len());
    let mut fit = None;
    for _ in 0..MOST_ROUNDS {
        let renewed = Generalised::fit(rows, slope, &columns)
            .ok_or(CyclesError::EqualAmplitudes { cycles: rows.len() })?;
        let step = renewed.coefficients[1] - slope;
        slope = renewed.coefficients[1];
        let settled = step.abs() <= 1e-9 * renewed.covariance[1][1].sqrt();
        fit = Some(renewed);
        if settled {
            break;
        }
    }
    fit.map(|fit| Beta::of(&fit)).ok_or(CyclesError::EqualAmplitudes { cycles: rows.len() })
}

impl Beta {
    /// β is the quotient of slope and T0.
    fn of(fit: &Generalised) -> Self {
        let (t0, beta) = (fit.coefficients[0], fit.coefficients[1] / fit.coefficients[0]);
        let [own, both, slope] = [fit.covariance[0][0], fit.covariance[0][1], fit.covariance[1][1]];
        let variance = (slope - 2.0 * beta * both + beta * beta * own) / (t0 * t0);
        Self {
            beta,
            uncertainty: (fit.scale() * variance).sqrt(),
            t0,
            t0_uncertainty: (fit.scale() * own).sqrt(),
            correlation: (both - beta * own) / t0 / (own * variance).sqrt(),
            chi2_per_dof: fit.chi2_per_dof(),
        }
    }
}

/// Among fewer rows than this none can be said to be far from the others.
const FEWEST_TO_JUDGE: usize = 8;

/// The rows that lie further from the exact law than `threshold` robust standard deviations, or than that many of their
/// own uncertainties where those are larger.
pub(super) fn outliers(rows: &[Row], threshold: f64) -> Vec<usize> {
    let periods: Vec<f64> = rows.iter().map(|row| row.period / row.ratio()).collect();
    let Some(middle) = super::local_fit::median(periods.clone()) else { return vec![] };
    let deviations: Vec<f64> = periods.iter().map(|period| period - middle).collect();
    let Some(scatter) = robust_deviation(&deviations).filter(|_| rows.len() >= FEWEST_TO_JUDGE) else {
        return vec![];
    };
    let own = |row: usize| scatter.max(covariance(&rows[row], &rows[row], middle).sqrt());
    (0..rows.len()).filter(|&row| deviations[row].abs() > threshold * own(row)).collect()
}

/// Least squares with the covariance of the rows.
struct Generalised {
    coefficients: Vec<f64>,
    covariance: [[f64; 2]; 2],
    chi2: f64,
    dof: usize,
}

impl Generalised {
    /// Coefficients of these columns when the period changes by `slope`·R′ with the amplitude.
    fn fit(rows: &[Row], slope: f64, columns: &[Vec<f64>]) -> Option<Self> {
        let factor = Factor::of(rows, slope)?;
        let columns: Vec<Vec<f64>> = columns.iter().map(|column| factor.whitened(column)).collect();
        let right = factor.whitened(&rows.iter().map(|row| row.period).collect::<Vec<_>>());
        let product = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(x, y)| x * y).sum::<f64>();
        let (coefficients, covariance) = match &columns[..] {
            [only] => {
                let square = product(only, only);
                (vec![product(only, &right) / square], [[1.0 / square, 0.0], [0.0; 2]])
            }
            [first, second] => {
                let [a, b, c] = [product(first, first), product(first, second), product(second, second)];
                let [p, q] = [product(first, &right), product(second, &right)];
                let determinant = a * c - b * b;
                let inverse = [[c / determinant, -b / determinant], [-b / determinant, a / determinant]];
                let solution = inverse.map(|line| line[0] * p + line[1] * q);
                (solution.to_vec(), inverse)
            }
            _ => return None,
        };
        let residual = |row: usize| {
            let fitted: f64 = columns.iter().zip(&coefficients).map(|(column, c)| column[row] * c).sum();
            right[row] - fitted
        };
        let chi2 = (0..rows.len()).map(|row| residual(row) * residual(row)).sum();
        let usable = coefficients.iter().all(|x| x.is_finite());
        usable.then_some(Self {
            coefficients,
            covariance,
            chi2,
            dof: rows.len().saturating_sub(columns.len()),
        })
    }

    fn chi2_per_dof(&self) -> Option<f64> {
        (self.dof > 0).then(|| self.chi2 / count(self.dof))
    }

    /// By what the variances are enlarged.
    fn scale(&self) -> f64 {
        self.chi2_per_dof().unwrap_or(1.0).max(1.0)
    }
}

/// The lower triangle L of the covariance `L·Lᵀ`, in which a row has entries with itself and the two rows before.
struct Factor(Vec<[f64; 3]>);

impl Factor {
    fn of(rows: &[Row], slope: f64) -> Option<Self> {
        let mut factor: Vec<[f64; 3]> = Vec::with_capacity(rows.len());
        for (n, row) in rows.iter().enumerate() {
            let before = |back: usize| n.checked_sub(back).map(|m| covariance(&rows[m], row, slope));
            let with = |back: usize| n.checked_sub(back).map(|m| factor[m]);
            // Entries with the row two before, the row before, and itself.
            let second = match (before(2), with(2)) {
                (Some(covariance), Some(other)) => covariance / other[2],
                _ => 0.0,
            };
            let first = match (before(1), with(1)) {
                (Some(covariance), Some(other)) => (covariance - second * other[1]) / other[2],
                _ => 0.0,
            };
            let own = covariance(row, row, slope) - first * first - second * second;
            if own <= 0.0 || !own.is_finite() {
                return None;
            }
            factor.push([second, first, own.sqrt()]);
        }
        Some(Self(factor))
    }

    /// L⁻¹ of a column.
    fn whitened(&self, column: &[f64]) -> Vec<f64> {
        let mut white: Vec<f64> = Vec::with_capacity(column.len());
        for (n, &value) in column.iter().enumerate() {
            let [second, first, own] = self.0[n];
            let before = |back: usize| n.checked_sub(back).map_or(0.0, |m| white[m]);
            white.push((value - second * before(2) - first * before(1)) / own);
        }
        white
    }
}

/// The covariance of the residuals of two rows.
fn covariance(one: &Row, other: &Row, slope: f64) -> f64 {
    let mut sum = 0.0;
    for (i, (passage, variance)) in one.passages.iter().enumerate() {
        for (j, (shared, _)) in other.passages.iter().enumerate() {
            if passage == shared {
                sum += if i == j { *variance } else { -variance };
            }
        }
    }
    for (i, (extreme, _, variance)) in one.extremes.iter().enumerate() {
        for (j, (shared, ..)) in other.extremes.iter().enumerate() {
            if extreme == shared {
                sum += slope * slope * one.slope(i) * other.slope(j) * variance;
            }
        }
    }
    sum
}

#[expect(clippy::cast_precision_loss, reason = "no trace in memory has 2^53 rows")]
fn count(rows: usize) -> f64 {
    rows as f64
}
