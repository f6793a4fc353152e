//! Least squares with correlated rows: neighbours share passages, with the opposite sign, and extremes.
//!
//! The covariance has two parts of unknown size: what the noise of the values does to passages and extremes, and real
//! fluctuations of the half swings, where the cycles scatter more than the noise can explain. Their ratio is that of
//! the greatest restricted likelihood.
//!
//! The scatter of single periods is not the size of the whitened residuals: errors of passages that cycles share cancel in
//! the sum of many, so that the noise alone hardly lets the periods go up or down together, and a slow departure from the
//! law makes χ² as large as a hundred where no cycle is twice its noise away. The bar of a single period is the square root of
//! its own entry of the covariance, at the scale of the residuals as they are.
//!
//! Reference: H. D. Patterson and R. Thompson, *Recovery of inter-block information when block sizes are unequal*,
//! Biometrika 58, 545 (1971), doi:10.1093/biomet/58.3.545.

use nalgebra::{DMatrix, DVector};

use super::row::CycleRow;
use crate::fit::scatter::degrees_of_freedom;
use crate::statistics::{count, least_squares};
use libration::internals::progress::Watch;

/// Ratios of the variances that are tried: none, and 10^(k/8) from 1e-3 to 1e4.
const RATIOS: std::ops::RangeInclusive<i32> = -24..=32;
/// Increase of the logarithm of the likelihood above which fluctuations are accepted: chance reaches it in one of forty
/// traces without fluctuations.
const EVIDENCE: f64 = 2.0;
/// Fewest degrees of freedom with which fluctuations are distinguished from the noise. With 3, nothing changed in twelve of the recordings
/// (`mod.rs`); with 10, β of the strongly damped one moved by 1.4 uncertainties, and its uncertainty fell to 0.4 of itself.
const FEWEST_TO_TELL: usize = 6;

/// Coefficients of the columns.
#[derive(Clone, Debug)]
pub(super) struct Generalised {
    pub(super) coefficients: DVector<f64>,
    /// Covariance with the size of the errors that the data show.
    pub(super) covariance: DMatrix<f64>,
    /// χ² by the noise alone, per degree of freedom.
    pub(super) chi2_per_dof: Option<f64>,
    /// Degrees of freedom of the covariance: those of the scatter if it comes from the scatter, infinite if the noise explains the scatter.
    pub(super) degrees_of_freedom: f64,
    /// Scatter of single periods.
    pub(super) scatter: CycleScatter,
}

/// Scatter of single periods: the variance is that of the noise times `noise`, plus `fluctuation`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::fit) struct CycleScatter {
    pub(in crate::fit) noise: f64,
    /// The real fluctuations of a whole cycle, in s².
    pub(in crate::fit) fluctuation: f64,
}

/// Entries of a symmetric matrix next to its diagonal: with the row two before, the row before, and itself.
pub type Bands = Vec<[f64; 3]>;

/// Columns that may explain the periods; one of them is T/T0, with the noise of the amplitudes.
#[derive(Clone, Copy)]
pub(super) struct Explanation<'a> {
    pub(super) columns: &'a [Vec<f64>],
    /// Index of that column.
    pub(super) ratio: usize,
}

/// Periods, and the columns that are to explain them.
struct Equations<'a> {
    rows: &'a [CycleRow],
    columns: &'a [Vec<f64>],
    noise: Bands,
    fluctuation: Bands,
    /// The mean variance of a row by the noise, in which fluctuations are counted.
    typical: f64,
    /// Derivative of the period with respect to T/T0.
    slope: f64,
    ratio_column: usize,
}

/// Fits the coefficients of the columns, when the period changes by `slope`·R′ with the amplitude.
pub(super) fn fit(
    rows: &[CycleRow],
    slope: f64,
    Explanation { columns, ratio: ratio_column }: Explanation<'_>,
    watch: &Watch<'_>,
) -> Option<Generalised> {
    let noise = bands(rows, |one, other| one.noise_with(other, slope));
    let typical = noise.iter().map(|entries| entries[2]).sum::<f64>() / count(rows.len());
    let fluctuation = bands(rows, |one, other| typical * one.half_swings_with(other));
    let equations = Equations { rows, columns, noise, fluctuation, typical, slope, ratio_column };
    let dof = rows.len().saturating_sub(columns.len());
    let by_noise = equations.solve(0.0)?;
    let chi2_per_dof = (dof > 0).then(|| by_noise.chi2 / count(dof));
    let enlarged = chi2_per_dof.unwrap_or(1.0).max(1.0);
    if dof < FEWEST_TO_TELL || enlarged <= 1.0 {
        return Some(equations.described(by_noise, enlarged, chi2_per_dof));
    }
    let ratios = RATIOS.map(|eighths| libm::exp10(f64::from(eighths) / 8.0));
    let solutions = ratios.filter_map(|ratio| {
        watch.go_on().ok()?;
        equations.solve(ratio)
    });
    let best = solutions.max_by(|a, b| a.likelihood.total_cmp(&b.likelihood));
    match best.filter(|best| best.likelihood > by_noise.likelihood + EVIDENCE) {
        Some(best) => {
            let scale = best.chi2 / count(dof);
            Some(equations.described(best, scale, chi2_per_dof))
        }
        None => Some(equations.described(by_noise, enlarged, chi2_per_dof)),
    }
}

/// The solution for one ratio of the variances.
struct VarianceSolution {
    coefficients: DVector<f64>,
    /// (XᵀV⁻¹X)⁻¹.
    inverse: DMatrix<f64>,
    chi2: f64,
    /// Ratio of the variance of the fluctuations to the typical one of the noise.
    ratio: f64,
    /// The logarithm of the restricted likelihood, without the terms that are the same for all ratios.
    likelihood: f64,
}

impl Equations<'_> {
    /// Describes a solution with the covariance at the scale of the whitened residuals.
    fn described(&self, solution: VarianceSolution, scale: f64, chi2_per_dof: Option<f64>) -> Generalised {
        let scatter = self.scatter(&solution);
        let attenuation = solution.inverse.column(self.ratio_column) * self.mean_score(solution.ratio);
        let coefficients = solution.coefficients - attenuation;
        let dof = self.rows.len().saturating_sub(self.columns.len());
        let degrees_of_freedom = match solution.ratio {
            0.0 => degrees_of_freedom(chi2_per_dof.map(|per_dof| per_dof * count(dof)), dof),
            _ => count(dof),
        };
        let covariance = solution.inverse * scale;
        Generalised { coefficients, covariance, chi2_per_dof, degrees_of_freedom, scatter }
    }

    /// Mean of the amplitude noise's contribution to xᵀV⁻¹e, where x is the column of T/T0 and e the residuals: both contain the noise, so
    /// that without this correction the coefficient would be drawn towards 0. It is tr(V⁻¹K) with their covariance K (W. A. Fuller,
    /// *Measurement Error Models*, Wiley 1987, section 2.2).
    fn mean_score(&self, ratio: f64) -> f64 {
        let Some(factor) = Factor::new(&self.noise, &self.fluctuation, ratio) else { return 0.0 };
        let covariance = |n: usize, m: usize| self.rows[n].ratio_noise_with(&self.rows[m], self.slope);
        let with_earlier = |(n, inverse): (usize, [f64; 3])| {
            let pair = |back: usize| n.checked_sub(back).map_or(0.0, |m| covariance(n, m) + covariance(m, n));
            0.5 * inverse[2] * pair(0) + inverse[1] * pair(1) + inverse[0] * pair(2)
        };
        factor.inverse().into_iter().enumerate().map(with_earlier).sum()
    }

    /// The noise and the fluctuations in their proportion, scaled so that the squares of the residuals have their expected
    /// size, Vₖₖ − xₖᵀ(XᵀV⁻¹X)⁻¹xₖ; on average never less than the noise.
    fn scatter(&self, solution: &VarianceSolution) -> CycleScatter {
        let fluctuation = solution.ratio * self.typical;
        let (mut squares, mut expected, mut noise_part) = (0.0, 0.0, 0.0);
        for (row, noise) in self.noise.iter().map(|entries| entries[2]).enumerate() {
            let factors =
                DVector::from_iterator(self.columns.len(), self.columns.iter().map(|column| column[row]));
            let residual = self.rows[row].period - factors.dot(&solution.coefficients);
            let by_fit = factors.dot(&(&solution.inverse * &factors));
            let variance = noise + fluctuation;
            squares += residual * residual / variance;
            expected += 1.0 - by_fit / variance;
            noise_part += noise / variance;
        }
        let least = noise_part / count(self.rows.len());
        let scale = if expected > 0.0 { least.max(squares / expected) } else { least };
        CycleScatter { noise: scale, fluctuation: scale * fluctuation }
    }

    fn solve(&self, ratio: f64) -> Option<VarianceSolution> {
        let factor = Factor::new(&self.noise, &self.fluctuation, ratio)?;
        let columns: Vec<DVector<f64>> = self.columns.iter().map(|column| factor.whitened(column)).collect();
        let periods: Vec<f64> = self.rows.iter().map(|row| row.period).collect();
        let fit = least_squares(&DMatrix::from_columns(&columns), &factor.whitened(&periods)).ok()?;
        let chi2 = fit.chi2();
        let dof = count(self.rows.len().saturating_sub(columns.len()));
        let logarithms = factor.log_determinant() + fit.log_determinant + dof * libm::log(chi2);
        let (coefficients, inverse) = (fit.coefficients, fit.covariance);
        Some(VarianceSolution { coefficients, inverse, chi2, ratio, likelihood: -0.5 * logarithms })
    }
}

/// The lower triangle L of a covariance `L·Lᵀ`.
#[derive(Debug)]
pub struct Factor(Bands);

impl Factor {
    /// Factors the sum of the first matrix and `ratio` times the second.
    pub fn new(noise: &Bands, fluctuation: &Bands, ratio: f64) -> Option<Self> {
        let mut factor: Bands = Vec::with_capacity(noise.len());
        for (n, (noise, fluctuation)) in noise.iter().zip(fluctuation).enumerate() {
            let [second, first, diagonal] = [0, 1, 2].map(|k| noise[k] + ratio * fluctuation[k]);
            let before = |back: usize| n.checked_sub(back).map_or([0.0, 0.0, 1.0], |m| factor[m]);
            let second = second / before(2)[2];
            let first = (first - second * before(1)[1]) / before(1)[2];
            let pivot = diagonal - first * first - second * second;
            if pivot <= 0.0 || !pivot.is_finite() {
                return None;
            }
            factor.push([second, first, pivot.sqrt()]);
        }
        Some(Self(factor))
    }

    /// L⁻¹ times a column.
    pub fn whitened(&self, column: &[f64]) -> DVector<f64> {
        let mut white: Vec<f64> = Vec::with_capacity(column.len());
        for (n, (&value, [second, first, diagonal])) in column.iter().zip(&self.0).enumerate() {
            let before = |back: usize| n.checked_sub(back).map_or(0.0, |m| white[m]);
            white.push((value - second * before(2) - first * before(1)) / diagonal);
        }
        DVector::from_vec(white)
    }

    /// The entries of (L·Lᵀ)⁻¹ in the bands, from the last row on (K. Takahashi, J. Fagan, M.-S. Chen, 8th PICA Conference, 1973).
    pub fn inverse(&self) -> Bands {
        let rows = self.0.len();
        let mut inverse: Bands = vec![[0.0; 3]; rows + 2];
        for n in (0..rows).rev() {
            let below = |down: usize| self.0.get(n + down).map_or(0.0, |entries| entries[2 - down]);
            let (diagonal, first, second) = (self.0[n][2], below(1), below(2));
            let [one, both, two] = [inverse[n + 1][2], inverse[n + 2][1], inverse[n + 2][2]];
            let beside = -(first * one + second * both) / diagonal;
            let further = -(first * both + second * two) / diagonal;
            inverse[n + 1][1] = beside;
            inverse[n + 2][0] = further;
            inverse[n][2] = (1.0 / diagonal - first * beside - second * further) / diagonal;
        }
        inverse.truncate(rows);
        inverse
    }

    /// The logarithm of the determinant of the covariance.
    pub fn log_determinant(&self) -> f64 {
        self.0.iter().map(|entries| 2.0 * libm::log(entries[2])).sum()
    }
}

fn bands(rows: &[CycleRow], covariance: impl Fn(&CycleRow, &CycleRow) -> f64) -> Bands {
    let entry = |n: usize, back: usize| n.checked_sub(back).map_or(0.0, |m| covariance(&rows[m], &rows[n]));
    (0..rows.len()).map(|n| [entry(n, 2), entry(n, 1), entry(n, 0)]).collect()
}
