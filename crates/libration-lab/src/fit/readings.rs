//! Repeated readings: means, their standard uncertainties with degrees of freedom, outliers.
//!
//! The mean of k readings that scatter by s has u = s/√k with k − 1 degrees of freedom. Rows that scatter alike share one s, pooled over all
//! of them, with Σ(k − 1) degrees of freedom. u is not enlarged for few readings: the degrees of freedom enter the coverage factor. Rounding
//! to the step of the display is part of the scatter, and is added, undivided, only where the readings scatter less (GUM 4.3.10).
//!
//! Where Bartlett's test finds that the rows scatter differently, they count alike, and each has its own variance in the uncertainty and in the test of
//! the scatter about a law.
//!
//! Reference: JCGM 100:2008, 4.2, 4.3.10 and H.3.6; W. G. Cochran, Ann. Eugen. 11, 47 (1941), doi:10.1111/j.1469-1809.1941.tb02271.x, for
//! the largest of several variances; M. S. Bartlett, Proc. R. Soc. A 160, 268 (1937), doi:10.1098/rspa.1937.0109.

use crate::statistics::{chi_squared, count, fisher, mean, student};
use libration::internals::InOrder;

/// Probability that chance does the same in any row of a table, below which a row scatters unlike the others, or a reading is an outlier.
const BY_CHANCE: f64 = 0.01;
/// The same probability, below which an outlier makes its row scatter unlike the others.
const BY_BLUNDER: f64 = 1e-4;
/// Probability below which the variances of rows are taken as different, rather than different by chance: at one in twenty, 90.8 % of the intervals
/// of 95 % for g hold of five rows of three readings whose variances rise 25 times, at one in five 93.1 %.
const DIFFERENT_BY_CHANCE: f64 = 0.2;

/// The mean of the readings of a row.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MeanReading {
    /// The mean.
    pub mean: f64,
    /// The standard uncertainty of the row, with rounding if it matters.
    pub uncertainty: f64,
    /// The contribution of the scatter to the uncertainty.
    pub by_scatter: f64,
    /// The contribution of the scatter of this row alone if the rows scatter differently, otherwise `by_scatter`.
    pub by_own_scatter: f64,
    /// The contribution of rounding; zero if it is part of the scatter.
    pub by_rounding: f64,
    /// The mean in steps of the display, to the nearest whole one.
    pub steps: f64,
    /// Number of readings.
    pub count: usize,
    /// `true` if the row scatters more than the others, so that its uncertainty comes from its own readings.
    pub is_unlike: bool,
}

impl MeanReading {
    /// The mean of a quantity that is this fraction of the reading: a period is a tenth of ten.
    #[must_use]
    pub fn times(self, factor: f64) -> Self {
        Self {
            mean: self.mean * factor,
            uncertainty: self.uncertainty * factor,
            by_scatter: self.by_scatter * factor,
            by_own_scatter: self.by_own_scatter * factor,
            by_rounding: self.by_rounding * factor,
            ..self
        }
    }
}

/// Repeated readings of several rows.
#[derive(Clone, Debug, PartialEq)]
pub struct RepeatedReadings {
    /// The means, row by row.
    pub rows: Vec<MeanReading>,
    /// The standard deviation of a reading, pooled over the rows that scatter alike; over all where the rows scatter differently.
    pub deviation: f64,
    /// The degrees of freedom of the row.
    pub degrees_of_freedom: usize,
    /// `true` if the rows scatter differently: they have equal weights, and the uncertainty of a result comes from the scatter of each row.
    pub differ: bool,
    /// The standard uncertainty by rounding, if it is added.
    pub rounding: Option<f64>,
    /// Readings far from the others of their row: row and reading, counted from zero. They are not removed.
    pub outliers: Vec<(usize, usize)>,
}

impl RepeatedReadings {
    /// Evaluates readings, row by row, that are written in steps of this size; `None` where no row has two.
    ///
    /// # Examples
    /// ```
    /// use libration_lab::fit::RepeatedReadings;
    ///
    /// let readings = RepeatedReadings::new(&[vec![1.0, 1.2], vec![3.1, 2.9]], 0.01).unwrap();
    /// // s² is (0.02 + 0.02)/2 with two degrees of freedom.
    /// assert!((readings.deviation - 0.02_f64.sqrt()).abs() < 1e-12);
    /// assert!((readings.rows[0].uncertainty - 0.1).abs() < 1e-12);
    /// ```
    #[must_use]
    pub fn new(rows: &[Vec<f64>], step: f64) -> Option<Self> {
        let groups: Vec<RowReadings> = rows.iter().map(|row| RowReadings::new(row)).collect();
        let outliers = outliers(rows, &groups, step);
        Self::of_groups(&groups, step, outliers)
    }

    /// Evaluates rows of which only mean, standard deviation and number of the readings are known; `None` if no row has two readings.
    ///
    /// # Examples
    /// ```
    /// use libration_lab::fit::{ReadingSummary, RepeatedReadings};
    ///
    /// let summary = |mean| ReadingSummary { mean, deviation: 0.02_f64.sqrt(), count: 2 };
    /// let summarised = RepeatedReadings::of_summaries(&[summary(1.1), summary(3.0)], 0.01).unwrap();
    /// let readings = RepeatedReadings::new(&[vec![1.0, 1.2], vec![3.1, 2.9]], 0.01).unwrap();
    /// assert!((summarised.rows[0].uncertainty / readings.rows[0].uncertainty - 1.0).abs() < 1e-12);
    /// ```
    #[must_use]
    pub fn of_summaries(rows: &[ReadingSummary], step: f64) -> Option<Self> {
        let groups: Vec<RowReadings> = rows.iter().map(ReadingSummary::group).collect();
        Self::of_groups(&groups, step, vec![])
    }

    fn of_groups(groups: &[RowReadings], step: f64, outliers: Vec<(usize, usize)>) -> Option<Self> {
        if groups.iter().all(|group| group.dof == 0) {
            return None;
        }
        let unlike = with_outlier(groups, step, &outliers);
        let differ = unlike.is_none() && differ(groups.iter(), step);
        let alike = Pool::of(
            groups.iter().enumerate().filter(|(row, _)| Some(*row) != unlike).map(|(_, group)| group),
        );
        let deviation = alike.variance().sqrt();
        let rounding = Some(step / 12.0_f64.sqrt()).filter(|rounding| *rounding > deviation);
        let row = |(row, group): (usize, &RowReadings)| {
            let is_unlike = Some(row) == unlike;
            let spread = if is_unlike { group.variance().sqrt() } else { deviation };
            let by_scatter = spread / count(group.count).sqrt();
            let alone = (group.variance() / count(group.count)).sqrt();
            let by_own_scatter = if differ && group.dof > 0 { alone } else { by_scatter };
            let by_rounding = rounding.unwrap_or(0.0);
            let uncertainty = libm::hypot(by_scatter, by_rounding);
            let (mean, count) = (group.mean, group.count);
            let steps = if step > 0.0 { (mean / step).round() } else { 0.0 };
            MeanReading {
                mean,
                uncertainty,
                by_scatter,
                by_own_scatter,
                by_rounding,
                steps,
                count,
                is_unlike,
            }
        };
        Some(Self {
            rows: groups.iter().enumerate().map(row).collect(),
            deviation,
            degrees_of_freedom: alike.dof,
            differ,
            rounding,
            outliers,
        })
    }

    /// The degrees of freedom of the pooled deviation; infinite where rounding makes more than half of the uncertainty.
    #[must_use]
    pub fn pooled(&self) -> f64 {
        if self.rounding.is_some() { f64::INFINITY } else { count(self.degrees_of_freedom) }
    }

    /// The degrees of freedom of the scatter of a row.
    #[must_use]
    pub fn degrees_of_freedom_of(&self, row: usize) -> usize {
        if self.is_by_itself(row) { self.rows[row].count - 1 } else { self.degrees_of_freedom }
    }

    /// Returns `true` if the uncertainty of a row comes from its own scatter.
    fn is_by_itself(&self, row: usize) -> bool {
        self.rows[row].is_unlike || (self.differ && self.rows[row].count > 1)
    }
}

/// Effective degrees of freedom, after Welch and Satterthwaite, of Σ cᵢxᵢ with the variance `total`, where xᵢ are these means with these c; rows
/// with the same scatter share one s. Infinite if no part of the variance comes from scatter.
#[must_use]
pub fn effective_degrees_of_freedom(readings: &RepeatedReadings, coefficients: &[f64], total: f64) -> f64 {
    let part = |(row, c): (usize, &f64)| {
        (row, (c * readings.rows[row].by_own_scatter) * (c * readings.rows[row].by_own_scatter))
    };
    let parts: Vec<(usize, f64)> = coefficients.iter().enumerate().map(part).collect();
    let pooled: f64 =
        parts.iter().filter(|(row, _)| !readings.is_by_itself(*row)).map(|(_, part)| part).sum();
    let single_rows = parts.iter().filter(|(row, _)| readings.is_by_itself(*row));
    let separate: f64 =
        single_rows.map(|(row, part)| part * part / count(readings.degrees_of_freedom_of(*row))).sum();
    let spread = separate + pooled * pooled / count(readings.degrees_of_freedom.max(1));
    if spread > 0.0 { total * total / spread } else { f64::INFINITY }
}

/// The part of the variance of Σ cᵢxᵢ, where xᵢ are these means with these c, that comes from rows rounded to the same step: they share one
/// rounding error.
#[must_use]
pub fn shared_rounding(readings: &RepeatedReadings, coefficients: &[f64]) -> f64 {
    let error = |(row, c): (&MeanReading, &f64)| (row.steps, c * row.by_rounding);
    let mut errors: Vec<(f64, f64)> = readings.rows.iter().zip(coefficients).map(error).collect();
    errors.put_in_order(|one, other| one.0.total_cmp(&other.0));
    let of_step = |rows: &[(f64, f64)]| {
        let [sum, squares] = rows.iter().fold([0.0, 0.0], |[sum, squares], (_, rounding)| {
            [sum + rounding, squares + rounding * rounding]
        });
        sum * sum - squares
    };
    errors.chunk_by(|one, other| one.0.total_cmp(&other.0).is_eq()).map(of_step).sum()
}

/// Summary of the readings of a row.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ReadingSummary {
    /// The mean.
    pub mean: f64,
    /// The standard deviation of a single reading.
    pub deviation: f64,
    /// Number of readings.
    pub count: usize,
}

impl ReadingSummary {
    fn group(&self) -> RowReadings {
        let dof = self.count.saturating_sub(1);
        RowReadings {
            mean: self.mean,
            count: self.count.max(1),
            dof,
            squares: self.deviation * self.deviation * count(dof),
        }
    }
}

/// The readings of a row.
struct RowReadings {
    mean: f64,
    count: usize,
    dof: usize,
    squares: f64,
}

impl RowReadings {
    fn new(readings: &[f64]) -> Self {
        let mean = mean(readings.iter().copied());
        let squares = readings.iter().map(|reading| (reading - mean) * (reading - mean)).sum();
        Self { mean, count: readings.len(), dof: readings.len().saturating_sub(1), squares }
    }

    fn variance(&self) -> f64 {
        self.squares / count(self.dof.max(1))
    }
}

/// Sum of squares of several rows.
#[derive(Clone, Copy, Default)]
struct Pool {
    squares: f64,
    dof: usize,
}

impl Pool {
    fn of<'a>(groups: impl Iterator<Item = &'a RowReadings>) -> Self {
        groups.fold(Self::default(), |sum, group| Self {
            squares: sum.squares + group.squares,
            dof: sum.dof + group.dof,
        })
    }

    fn variance(self) -> f64 {
        self.squares / count(self.dof.max(1))
    }
}

/// The row that an outlier alone makes scatter more than the others, which scatter alike: by an F test of its variance over theirs.
fn with_outlier(groups: &[RowReadings], step: f64, outliers: &[(usize, usize)]) -> Option<usize> {
    let others = |row: usize| {
        groups.iter().enumerate().filter(move |(other, _)| *other != row).map(|(_, group)| group)
    };
    let tested = groups.iter().filter(|group| group.dof > 0).count();
    let is_more = |row: usize| {
        let pool = Pool::of(others(row));
        let ratio = groups[row].variance() / pool.variance();
        pool.squares > 0.0
            && fisher::probability_beyond(ratio, groups[row].dof, pool.dof) * count(tested) < BY_BLUNDER
    };
    let row = outliers.first()?.0;
    let is_only = tested > 2 && outliers.iter().all(|outlier| outlier.0 == row);
    (is_only && is_more(row) && !differ(others(row), step)).then_some(row)
}

/// Returns `true` if the rows scatter differently, by Bartlett's test over all of them with variances of at least that of rounding. `false` if
/// rounding causes most of the scatter.
fn differ<'a>(groups: impl Iterator<Item = &'a RowReadings>, step: f64) -> bool {
    let rounding = step * step / 12.0;
    let tested = groups.filter(|group| group.dof > 0);
    let variances: Vec<(f64, f64)> =
        tested.map(|group| (count(group.dof), group.variance().max(rounding))).collect();
    let all: f64 = variances.iter().map(|(dof, _)| dof).sum();
    let pooled = variances.iter().map(|(dof, variance)| dof * variance).sum::<f64>() / all;
    if variances.len() < 2 || pooled <= rounding || variances.iter().any(|(_, variance)| *variance <= 0.0) {
        return false;
    }
    let ratio: f64 = variances.iter().map(|(dof, variance)| -dof * libm::log(variance / pooled)).sum();
    let inverse = variances.iter().map(|(dof, _)| 1.0 / dof).sum::<f64>() - 1.0 / all;
    let correction = 1.0 + inverse / (3.0 * count(variances.len() - 1));
    chi_squared::probability_beyond(ratio / correction, variances.len() - 1) < DIFFERENT_BY_CHANCE
}

/// The readings whose distance from the others of their row exceeds the largest that chance explains: Student's t with the scatter of all other
/// readings, at least that of rounding.
fn outliers(rows: &[Vec<f64>], groups: &[RowReadings], step: f64) -> Vec<(usize, usize)> {
    let all = Pool::of(groups.iter());
    let tested: usize = groups.iter().filter(|group| group.dof > 0).map(|group| group.count).sum();
    let is_outlier = |row: usize, reading: usize| {
        let group = &groups[row];
        if group.dof == 0 || all.dof < 2 {
            return false;
        }
        let (left, deviation) = (1.0 - 1.0 / count(group.count), rows[row][reading] - group.mean);
        let others = (all.squares - deviation * deviation / left).max(0.0) / count(all.dof - 1);
        let t = deviation / (left * others.max(step * step / 12.0)).sqrt();
        student::probability_beyond(t, all.dof - 1) * count(tested) < BY_CHANCE
    };
    let readings_of_rows =
        (0..rows.len()).flat_map(|row| (0..rows[row].len()).map(move |reading| (row, reading)));
    readings_of_rows.filter(|&(row, reading)| is_outlier(row, reading)).collect()
}
