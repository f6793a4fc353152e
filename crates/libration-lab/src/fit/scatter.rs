//! Whether rows scatter as their stated uncertainties say, and what is done where they scatter more: one rule for all tables.
//!
//! The measure is the Birge ratio √(χ²/dof). Where it is above one every uncertainty of the fit is multiplied by it, as if all
//! stated uncertainties were too small by one factor. Where it is below one nothing is made smaller: uncertainties that are common
//! to all rows do not show in their scatter.
//!
//! Reference: R. T. Birge, *The calculation of errors by the method of least squares*, Phys. Rev. 40, 207 (1932),
//! doi:10.1103/PhysRev.40.207; the Particle Data Group does the same, *Review of Particle Physics*, introduction, 5.2.2.

use crate::statistics::chi_squared::probability_beyond;
use crate::statistics::count;

/// A scatter is told to be another than the stated one when chance makes it so large, or so small, less often than this: one
/// table in a hundred whose uncertainties are right.
const BY_CHANCE: f64 = 0.01;

/// How rows scatter beside their stated uncertainties.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ScatterVerdict {
    /// Chance explains the difference.
    AsStated,
    /// More than chance explains.
    More,
    /// Less than chance explains.
    Less,
}

/// The scatter of rows about a law, in units of their stated uncertainties.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scatter {
    chi2: f64,
    dof: usize,
}

impl Scatter {
    /// Of rows with uncertainties; none without them, or without a degree of freedom.
    #[must_use]
    pub fn of(chi2: Option<f64>, dof: usize) -> Option<Self> {
        chi2.filter(|chi2| dof > 0 && chi2.is_finite()).map(|chi2| Self { chi2, dof })
    }

    /// √(χ²/dof).
    #[must_use]
    pub fn birge_ratio(self) -> f64 {
        (self.chi2 / count(self.dof)).sqrt()
    }

    /// By what the uncertainties of the fit are multiplied: the Birge ratio where it is above one, else one.
    #[must_use]
    pub fn enlargement(self) -> f64 {
        self.birge_ratio().max(1.0)
    }

    /// Whether chance explains it.
    #[must_use]
    pub fn verdict(self) -> ScatterVerdict {
        let as_large = probability_beyond(self.chi2, self.dof);
        match () {
            () if as_large < BY_CHANCE => ScatterVerdict::More,
            () if 1.0 - as_large < BY_CHANCE => ScatterVerdict::Less,
            () => ScatterVerdict::AsStated,
        }
    }

    /// Of the uncertainties of the fit: those of the scatter, where it is what they come from, else infinite, since stated
    /// uncertainties are taken as known.
    #[must_use]
    pub fn degrees_of_freedom(self) -> f64 {
        if self.verdict() == ScatterVerdict::More { count(self.dof) } else { f64::INFINITY }
    }

    /// What a reader should know where chance does not explain the scatter; `common` is what takes up an error that all rows share.
    #[must_use]
    pub fn warning(self, common: &str) -> Option<String> {
        let ratio = self.birge_ratio();
        match self.verdict() {
            ScatterVerdict::AsStated => None,
            ScatterVerdict::More => Some(format!(
                "the rows scatter {ratio:.2} times as much as their stated uncertainties: those of the result are enlarged by this \
                 factor, the Birge ratio"
            )),
            ScatterVerdict::Less => Some(format!(
                "the rows scatter only {ratio:.2} times as much as their stated uncertainties: these are perhaps common to all rows, \
                 and then belong to {common}"
            )),
        }
    }
}

/// The factor on the uncertainties of a fit with this χ², where there is one.
pub(super) fn enlargement(chi2: Option<f64>, dof: usize) -> f64 {
    Scatter::of(chi2, dof).map_or(1.0, Scatter::enlargement)
}

/// The degrees of freedom of the uncertainties of a fit: of the scatter where they come from it, and infinite where stated ones
/// explain it.
pub(super) fn degrees_of_freedom(chi2: Option<f64>, dof: usize) -> f64 {
    match chi2 {
        Some(_) => Scatter::of(chi2, dof).map_or(f64::INFINITY, Scatter::degrees_of_freedom),
        None => count(dof),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Of ten degrees of freedom one table in a hundred has a χ² above 23.209, and one below 2.558 (Abramowitz and Stegun, table
    /// 26.8).
    #[test]
    fn chance_decides_at_one_table_in_a_hundred() {
        let verdict = |chi2: f64| Scatter::of(Some(chi2), 10).unwrap().verdict();
        assert_eq!([23.20, 23.22].map(verdict), [ScatterVerdict::AsStated, ScatterVerdict::More]);
        assert_eq!([2.55, 2.57].map(verdict), [ScatterVerdict::Less, ScatterVerdict::AsStated]);
    }

    #[test]
    fn uncertainties_become_larger_and_never_smaller() {
        let of = |chi2: f64| Scatter::of(Some(chi2), 10).unwrap();
        assert!((of(199.0).enlargement() - 19.9_f64.sqrt()).abs() < 1e-15);
        let unity = |factor: f64| (factor - 1.0).abs() < 1e-15;
        assert!(unity(of(10.0).enlargement()) && unity(of(1.0).enlargement()));
        assert!((of(1.0).birge_ratio() - 0.1_f64.sqrt()).abs() < 1e-15);
        let ten = of(199.0).degrees_of_freedom();
        assert!((ten - 10.0).abs() < 1e-15 && of(11.0).degrees_of_freedom().is_infinite());
        assert!((degrees_of_freedom(None, 7) - 7.0).abs() < 1e-15);
        assert_eq!((Scatter::of(None, 3), Scatter::of(Some(1.0), 0)), (None, None));
    }

    #[test]
    fn only_what_chance_does_not_explain_is_told() {
        let warning = |chi2: f64| Scatter::of(Some(chi2), 10).unwrap().warning("the offset");
        assert!(warning(199.0).unwrap().contains("4.46 times"));
        assert!(warning(1.0).unwrap().contains("belong to the offset"));
        assert_eq!(warning(12.0), None);
    }
}
