//! Comparison of the rows' scatter with their stated uncertainties, and enlargement of the latter where it is larger: one rule for all tables.
//!
//! The measure is the Birge ratio √(χ²/dof). Where it is above one every uncertainty of the fit is multiplied by it, as if all
//! stated uncertainties were too small by one factor. Where it is below one nothing is made smaller: uncertainties that are common
//! to all rows do not show in their scatter.
//!
//! Reference: R. T. Birge, *The calculation of errors by the method of least squares*, Phys. Rev. 40, 207 (1932),
//! doi:10.1103/PhysRev.40.207; the Particle Data Group does the same, *Review of Particle Physics*, introduction, 5.2.2.

use std::fmt;

use crate::statistics::chi_squared::probability_beyond;
use crate::statistics::{count, fisher};
use libration::quantity::rounded;

/// Probability below which a scatter counts as different from the stated one: that of so large, or so small, a scatter in a
/// table whose uncertainties are right.
const BY_CHANCE: f64 = 0.01;

/// Result of the comparison of the rows' scatter with their stated uncertainties.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ScatterVerdict {
    /// Chance explains the difference.
    AsStated,
    /// More than chance explains.
    More,
    /// Less than chance explains.
    Less,
}

/// The Birge ratio by which an uncertainty is multiplied, and the reason why it is above one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Enlargement {
    /// The rows scatter by more than chance explains.
    ByScatter(f64),
    /// The rows scatter as stated: for few of them the ratio is above one as often as not.
    WithinChance(f64),
}

impl fmt::Display for Enlargement {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::ByScatter(ratio) => {
                write!(
                    f,
                    "uncertainties enlarged {} times: the rows scatter more than their uncertainties",
                    rounded(*ratio, 3)
                )
            }
            Self::WithinChance(ratio) => write!(
                f,
                "uncertainties include the Birge ratio {}: the rows scatter as stated, within what their number allows",
                rounded(*ratio, 3)
            ),
        }
    }
}

/// A warning about rows whose scatter is not explained by chance.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum ScatterWarning {
    /// The rows scatter more than stated, with a probability of one in a hundred for right uncertainties.
    More {
        /// The Birge ratio.
        ratio: f64,
    },
    /// The rows scatter less than stated, with a probability of one in a hundred for right uncertainties.
    Less {
        /// The Birge ratio.
        ratio: f64,
        /// Quantity that absorbs an error common to all rows.
        common: &'static str,
    },
    /// No uncertainties are stated and the rows do not scatter: by less than 1e-12 of themselves, which is rounding.
    Without,
}

impl ScatterWarning {
    /// A stable name.
    #[must_use]
    pub fn name(&self) -> &'static str {
        match self {
            Self::More { .. } => "rows_scatter_more",
            Self::Less { .. } => "rows_scatter_less",
            Self::Without => "rows_without_scatter",
        }
    }
}

impl fmt::Display for ScatterWarning {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::More { ratio } => write!(
                f,
                "the rows scatter {ratio:.2} times as much as their uncertainties: those of the result are enlarged by this \
                 factor, the Birge ratio"
            ),
            Self::Less { ratio, common } => write!(
                f,
                "the rows scatter only {ratio:.2} times as much as their uncertainties: they may be common to all rows, \
                 and then belong to {common}"
            ),
            Self::Without => f.write_str(
                "the rows do not scatter at all, as where they are rounded to steps that are too coarse: an uncertainty from their \
                 scatter means nothing; give each row one, at least a third of the last digit that is written",
            ),
        }
    }
}

/// χ² expected for rows whose variances are estimates.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct ExpectedChi2 {
    /// The expected value by those estimates.
    pub(super) value: f64,
    /// Degrees of freedom of χ².
    pub(super) degrees_of_freedom: f64,
    /// Degrees of freedom of the expected value.
    pub(super) of_value: f64,
}

/// The scatter of rows about a law, in units of their stated uncertainties.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scatter {
    chi2: f64,
    dof: usize,
    /// χ² expected from repeated readings, if they give the uncertainties.
    readings: Option<ExpectedChi2>,
}

impl Scatter {
    /// Returns the scatter of rows with uncertainties; `None` without them, or without a degree of freedom.
    #[must_use]
    pub fn new(chi2: Option<f64>, dof: usize) -> Option<Self> {
        chi2.filter(|chi2| dof > 0 && chi2.is_finite()).map(|chi2| Self { chi2, dof, readings: None })
    }

    /// The scatter of rows whose uncertainties come from repeated readings with these degrees of freedom, if they are finite: such uncertainties
    /// are measured and not judged, so that they are enlarged only if chance does not explain the scatter, by an F test.
    #[must_use]
    pub fn of_readings(self, degrees_of_freedom: f64) -> Self {
        self.expected(ExpectedChi2 {
            value: count(self.dof),
            degrees_of_freedom: count(self.dof),
            of_value: degrees_of_freedom,
        })
    }

    /// The scatter of rows whose readings give this expected χ².
    pub(super) fn expected(self, expected: ExpectedChi2) -> Self {
        /// Degrees of freedom above which the F test is that of χ².
        const MOST: f64 = 1e4;
        let of_value = expected.of_value.clamp(1.0, MOST);
        let readings = expected.of_value.is_finite().then_some(ExpectedChi2 { of_value, ..expected });
        Self { readings, ..self }
    }

    /// √(χ²/dof).
    #[must_use]
    pub fn birge_ratio(self) -> f64 {
        self.chi2_per_dof().sqrt()
    }

    /// Factor of the uncertainties of the fit: the Birge ratio if it is above one, otherwise one; with repeated readings one if chance explains the
    /// scatter.
    #[must_use]
    pub fn enlargement(self) -> f64 {
        match self.readings {
            Some(_) if self.verdict() != ScatterVerdict::More => 1.0,
            _ => self.birge_ratio().max(1.0),
        }
    }

    /// Returns `true` if chance explains the scatter.
    #[must_use]
    pub fn verdict(self) -> ScatterVerdict {
        let as_large = match self.readings {
            Some(ExpectedChi2 { value, degrees_of_freedom, of_value }) => {
                fisher::probability_beyond_any(self.chi2 / value, degrees_of_freedom, of_value)
            }
            None => probability_beyond(self.chi2, self.dof),
        };
        match () {
            () if as_large < BY_CHANCE => ScatterVerdict::More,
            () if 1.0 - as_large < BY_CHANCE => ScatterVerdict::Less,
            () => ScatterVerdict::AsStated,
        }
    }

    /// Degrees of freedom of the fit's uncertainties: those of the scatter, where they come from it, otherwise infinite, since stated
    /// uncertainties are taken as known.
    #[must_use]
    pub fn degrees_of_freedom(self) -> f64 {
        if self.verdict() == ScatterVerdict::More { count(self.dof) } else { f64::INFINITY }
    }

    /// χ² per degree of freedom, the square of the Birge ratio.
    #[must_use]
    pub fn chi2_per_dof(self) -> f64 {
        self.chi2 / count(self.dof)
    }

    /// The enlargement with its reason; `None` where nothing is enlarged.
    #[must_use]
    pub fn enlarged(self) -> Option<Enlargement> {
        let ratio = Some(self.enlargement()).filter(|ratio| *ratio > 1.0)?;
        Some(match self.verdict() {
            ScatterVerdict::More => Enlargement::ByScatter(ratio),
            ScatterVerdict::AsStated | ScatterVerdict::Less => Enlargement::WithinChance(ratio),
        })
    }

    /// Returns a warning if chance does not explain the scatter; `common` is the quantity that absorbs an error common to all rows.
    #[must_use]
    pub fn warning(self, common: &'static str) -> Option<ScatterWarning> {
        let ratio = self.birge_ratio();
        match self.verdict() {
            ScatterVerdict::AsStated => None,
            ScatterVerdict::More => Some(ScatterWarning::More { ratio }),
            ScatterVerdict::Less => Some(ScatterWarning::Less { ratio, common }),
        }
    }
}

/// The factor of the uncertainties of a fit with this χ², if there is one.
pub(super) fn enlargement(chi2: Option<f64>, dof: usize) -> f64 {
    Scatter::new(chi2, dof).map_or(1.0, Scatter::enlargement)
}

/// The degrees of freedom of the uncertainties of a fit: of the scatter where they come from it, and infinite where stated ones
/// explain it.
pub fn degrees_of_freedom(chi2: Option<f64>, dof: usize) -> f64 {
    match chi2 {
        Some(_) => Scatter::new(chi2, dof).map_or(f64::INFINITY, Scatter::degrees_of_freedom),
        None => count(dof),
    }
}
