//! One quantity measured by several groups: the weighted mean, and the group that stands out.
//!
//! The mean has the weights 1/uᵢ² of the independent parts of the uncertainties, which the Birge ratio of the groups enlarges. What all groups
//! share, such as one clock, is added once, after the mean.
//!
//! Reference: R. T. Birge, Phys. Rev. 40, 207 (1932), doi:10.1103/PhysRev.40.207.

use super::scatter::Scatter;
use super::uncertain::Uncertain;
use crate::statistics::{count, student};

/// Probability, in a class, below which the distance of the farthest group is not explained by chance, so that it stands out.
const BY_CHANCE: f64 = 0.01;

/// Result of a group.
#[derive(Clone, Debug, PartialEq)]
pub struct GroupResult {
    /// The name of the group.
    pub name: String,
    /// Number of its rows.
    pub rows: usize,
    /// Its value, with the standard uncertainty of the contributions that are not common to all groups.
    pub value: Uncertain,
    /// Degrees of freedom of that uncertainty.
    pub degrees_of_freedom: f64,
}

/// The weighted mean of the results of groups.
#[derive(Clone, Debug, PartialEq)]
pub struct GroupMean {
    /// The mean, with the part of its standard uncertainty that comes from the groups, enlarged by the Birge ratio.
    pub value: Uncertain,
    /// The part that all groups share.
    pub shared: f64,
    /// The scatter of the groups compared with their uncertainties.
    pub scatter: Scatter,
    /// Effective degrees of freedom of the standard uncertainty.
    pub degrees_of_freedom: f64,
    /// Index of the group that is farther from the mean of the others than chance explains; `None` for two groups, which only differ from each
    /// other.
    pub standing_out: Option<usize>,
}

impl GroupMean {
    /// The mean of two groups or more with uncertainties above zero; `shared` is the standard uncertainty of their common errors.
    ///
    /// # Examples
    /// ```
    /// use libration_lab::fit::{GroupMean, GroupResult, Uncertain};
    ///
    /// let group = |name: &str, value, uncertainty| GroupResult {
    ///     name: name.into(),
    ///     rows: 5,
    ///     value: Uncertain { value, uncertainty },
    ///     degrees_of_freedom: 10.0,
    /// };
    /// let mean = GroupMean::new(&[group("A", 9.80, 0.02), group("B", 9.83, 0.04)], 0.01).unwrap();
    /// assert!((mean.value.value - 9.806).abs() < 1e-12);
    /// ```
    #[must_use]
    pub fn new(groups: &[GroupResult], shared: f64) -> Option<Self> {
        let is_usable =
            |result: &GroupResult| result.value.value.is_finite() && result.value.uncertainty > 0.0;
        if groups.len() < 2 || !groups.iter().all(is_usable) {
            return None;
        }
        let mean = weighted(groups.iter());
        let pull = |result: &GroupResult| (result.value.value - mean.value) / result.value.uncertainty;
        let chi2 = groups.iter().map(|group| pull(group) * pull(group)).sum();
        let scatter = Scatter::new(Some(chi2), groups.len() - 1)?;
        let uncertainty = mean.uncertainty * scatter.enlargement();
        let total = uncertainty * uncertainty + shared * shared;
        let of_mean = Some(scatter.degrees_of_freedom()).filter(|degrees| degrees.is_finite());
        let of_mean = of_mean.unwrap_or_else(|| welch(groups.iter(), mean.uncertainty));
        let ratio = total / (uncertainty * uncertainty);
        Some(Self {
            value: Uncertain { uncertainty, ..mean },
            shared,
            scatter,
            degrees_of_freedom: of_mean * ratio * ratio,
            standing_out: standing_out(groups),
        })
    }

    /// The mean with its whole standard uncertainty.
    #[must_use]
    pub fn total(&self) -> Uncertain {
        self.value.with_error(self.shared)
    }

    /// The expanded uncertainty, within which the true value is with a probability of 95 %.
    #[must_use]
    pub fn expanded(&self) -> f64 {
        student::quantile(1.0 - super::COVERAGE_PROBABILITY, self.degrees_of_freedom)
            * self.total().uncertainty
    }
}

fn weighted<'a>(groups: impl Iterator<Item = &'a GroupResult>) -> Uncertain {
    let weight = |result: &GroupResult| 1.0 / (result.value.uncertainty * result.value.uncertainty);
    let (sum, weights) = groups.fold((0.0, 0.0), |(sum, weights), group| {
        (sum + weight(group) * group.value.value, weights + weight(group))
    });
    Uncertain { value: sum / weights, uncertainty: 1.0 / weights.sqrt() }
}

/// Effective degrees of freedom of the weighted mean with this uncertainty, after Welch and Satterthwaite.
fn welch<'a>(groups: impl Iterator<Item = &'a GroupResult>, uncertainty: f64) -> f64 {
    // The part of a group is (wᵢuᵢ/Σw)² = u⁴/uᵢ².
    let part = |result: &GroupResult| {
        let part = uncertainty * uncertainty / (result.value.uncertainty * result.value.uncertainty);
        part * part / result.degrees_of_freedom
    };
    1.0 / groups.map(part).sum::<f64>()
}

/// The group that is farthest from the mean of the others, by Student's distribution, if chance does not explain that.
fn standing_out(groups: &[GroupResult]) -> Option<usize> {
    if groups.len() < 3 {
        return None;
    }
    let probability = |index: usize| {
        let others =
            || groups.iter().enumerate().filter(move |(other, _)| *other != index).map(|(_, group)| group);
        let (group, mean) = (&groups[index], weighted(others()));
        let [variance, rest] =
            [group.value.uncertainty, mean.uncertainty].map(|uncertainty| uncertainty * uncertainty);
        let spread =
            variance * variance / group.degrees_of_freedom + rest * rest / welch(others(), mean.uncertainty);
        let freedom =
            if spread > 0.0 { (variance + rest) * (variance + rest) / spread } else { f64::INFINITY };
        student::probability_beyond_any((group.value.value - mean.value) / (variance + rest).sqrt(), freedom)
    };
    let all = (0..groups.len()).map(|index| (index, probability(index)));
    let (index, least) = all.min_by(|one, other| one.1.total_cmp(&other.1))?;
    (least * count(groups.len()) < BY_CHANCE).then_some(index)
}
