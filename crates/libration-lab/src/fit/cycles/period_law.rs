//! T = T0·[1 + β(R − 1)] fitted to the cycles, whose errors are not independent: cycles share passages with those before
//! and after them, with the opposite sign, and extremes with their neighbours.

use super::CyclesError;
use super::generalised::{CycleScatter, Explanation, Generalised, fit};
use super::row::{CycleRow, Share, Side, Source};
use crate::fit::beta::Beta;
use crate::fit::law::Law;
use crate::fit::uncertain::Uncertain;
use crate::statistics::{mean, median, robust_deviation};
use libration::internals::progress::Watch;

/// Rounds in which the weights are renewed; the error falls by a factor of about (σ of T0)/T0 each time: with 3 and 10 nothing changed.
const ROUNDS: usize = 5;
/// Largest part of the variance of T/T0 from the noise of the amplitudes: above it, its effect on β is not known well enough to be
/// corrected.
const MOST_NOISE: f64 = 0.05;

/// T0 under the exact law.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::fit) struct PeriodLaw {
    /// The period of small swings, in seconds; its uncertainty comes from the scatter of the cycles where that is larger than the noise explains.
    pub(in crate::fit) t0: Uncertain,
    /// χ² by the noise alone per degree of freedom; `None` without a degree of freedom.
    pub(in crate::fit) chi2_per_dof: Option<f64>,
    /// Degrees of freedom of the uncertainty of T0.
    pub(in crate::fit) degrees_of_freedom: f64,
    /// Scatter of the periods.
    pub(in crate::fit) scatter: CycleScatter,
}

impl Side {
    pub(in crate::fit) fn new(number: usize, amplitude: Uncertain) -> Self {
        let Uncertain { value: amplitude, uncertainty } = amplitude;
        let slope = 0.5 * Law::exact().slope_at(amplitude);
        Self { number, amplitude, variance: uncertainty * uncertainty, slope }
    }
}

impl CycleRow {
    pub(in crate::fit) fn new(times: [f64; 2], passages: [(usize, f64); 2], sides: [Side; 2]) -> Self {
        let ratio = 0.5 * sides.iter().map(|side| Law::exact().ratio_at(side.amplitude)).sum::<f64>();
        let [begin, end] = times;
        let passages = passages.into_iter().zip([-1.0, 1.0]).map(|((number, variance), of_period)| Share {
            source: Source::Passage(number),
            variance,
            of_period,
            of_ratio: 0.0,
        });
        let amplitudes = sides.map(|side| Share {
            source: Source::Amplitude(side.number),
            variance: side.variance,
            of_period: 0.0,
            of_ratio: side.slope,
        });
        let errors = passages.chain(amplitudes).collect();
        Self { time: 0.5 * (begin + end), period: end - begin, errors, sides, ratio }
    }

    /// Returns the row with other errors.
    pub(in crate::fit) fn with_errors(self, errors: Vec<Share>) -> Self {
        Self { errors, ..self }
    }

    /// The period of small swings by this row alone.
    pub(super) fn small_angle_period(&self) -> f64 {
        self.period / self.ratio
    }

    /// Fraction of the half swings of one row that belong to the other too.
    pub(super) fn half_swings_with(&self, other: &Self) -> f64 {
        self.shared_sides(other).map(|_| 0.5).sum()
    }

    fn shared_sides(&self, other: &Self) -> impl Iterator<Item = (Side, Side)> {
        let pairs = self.sides.into_iter().flat_map(|side| other.sides.map(|shared| (side, shared)));
        pairs.filter(|(side, shared)| side.number == shared.number)
    }
}

/// Fits T0 under the exact law.
pub(in crate::fit) fn exact(rows: &[CycleRow], watch: &Watch<'_>) -> Option<PeriodLaw> {
    let columns = vec![rows.iter().map(|row| row.ratio).collect::<Vec<f64>>()];
    let solution = settled(rows, &columns, 0, watch)?;
    let t0 = Uncertain { value: solution.coefficients[0], uncertainty: solution.covariance[(0, 0)].sqrt() };
    let Generalised { chi2_per_dof, degrees_of_freedom, scatter, .. } = solution;
    Some(PeriodLaw { t0, chi2_per_dof, degrees_of_freedom, scatter })
}

/// Fits β, the test of the exact law.
pub(in crate::fit) fn beta(rows: &[CycleRow], watch: &Watch<'_>) -> Result<Beta, CyclesError> {
    let excess: Vec<f64> = rows.iter().map(|row| row.ratio - 1.0).collect();
    let high = excess.iter().copied().fold(0.0, f64::max);
    let low = excess.iter().copied().fold(f64::INFINITY, f64::min);
    let open = CyclesError::EqualAmplitudes { cycles: rows.len() };
    // T/T0 differs by 1e-9 between amplitudes of 0 and 0.007°: no clock shows it, and rounding would decide.
    if rows.len() < 3 || high - low <= 1e-9 {
        return Err(open);
    }
    amplitudes_tell(rows.iter().map(|row| (row.ratio, row.ratio_variance())))?;
    let columns = vec![vec![1.0; rows.len()], excess];
    let solution = settled(rows, &columns, 1, watch).ok_or(open)?;
    Ok(Beta::from_line(&solution.coefficients, &solution.covariance, solution.degrees_of_freedom))
}

/// Refuses amplitudes of which more than 5 % of the variance of T/T0 is noise: a regression on values with errors is biased
/// towards 0 by that fraction.
fn amplitudes_tell(ratios: impl Iterator<Item = (f64, f64)>) -> Result<(), CyclesError> {
    let (ratios, variances): (Vec<f64>, Vec<f64>) = ratios.unzip();
    let mean = mean(ratios.iter().copied());
    let spread: f64 = ratios.iter().map(|ratio| (ratio - mean) * (ratio - mean)).sum();
    let noise_part = variances.iter().sum::<f64>() / spread;
    if noise_part > MOST_NOISE { Err(CyclesError::NoisyAmplitudes { noise_part }) } else { Ok(()) }
}

/// Fits with the weights for one value of the coefficient.
fn settled(
    rows: &[CycleRow],
    columns: &[Vec<f64>],
    coefficient: usize,
    watch: &Watch<'_>,
) -> Option<Generalised> {
    let mut slope = median(rows.iter().map(CycleRow::small_angle_period).collect())?;
    let mut last = None;
    for _ in 0..ROUNDS {
        let renewed = fit(rows, slope, Explanation { columns, ratio: coefficient }, watch)?;
        slope = renewed.coefficients[coefficient];
        last = Some(renewed);
    }
    last
}

/// Fewest rows among which outliers are detected. With 5 nothing changed in twelve of the recordings
/// (`mod.rs`); with 12 one of eight cycles kept its two outliers, and β was less certain by a factor of 1.65.
const FEWEST_TO_JUDGE: usize = 8;

/// The rows whose distance from the exact law is more than `threshold` robust standard deviations, or `threshold` of their
/// own uncertainties if these are larger.
pub(super) fn outliers(rows: &[CycleRow], threshold: f64) -> Vec<usize> {
    let periods: Vec<f64> = rows.iter().map(|row| row.small_angle_period()).collect();
    let Some(middle) = median(periods.clone()) else { return vec![] };
    let deviations: Vec<f64> = periods.iter().map(|period| period - middle).collect();
    let Some(scatter) = robust_deviation(&deviations).filter(|_| rows.len() >= FEWEST_TO_JUDGE) else {
        return vec![];
    };
    let deviation = |row: usize| scatter.max(rows[row].noise_with(&rows[row], middle).sqrt());
    (0..rows.len()).filter(|&row| deviations[row].abs() > threshold * deviation(row)).collect()
}
