//! Warnings about g and its uncertainty.

use std::fmt;

use super::{Budget, BudgetInput};
use crate::fit::gravity::{GRAVITY_ON_EARTH, is_nowhere_on_earth};
use crate::fit::mistake::GravityMistake;
use libration::quantity::{rounded, short};

/// A warning about g and its uncertainty.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum BudgetWarning {
    /// No model is refuted, and g is found nowhere on Earth, by [more than three](crate::fit::is_nowhere_on_earth) of its uncertainties. The period
    /// is the easier one of its two inputs to measure, so that the length is suspected.
    GravityContradicted {
        /// The length that was given, in m.
        length: f64,
        /// The length that gives the middle of [`GRAVITY_ON_EARTH`], in m.
        likely_length: f64,
        /// The mistake that would explain g, if it is not an error of the length.
        mistake: Option<GravityMistake>,
    },
    /// Inputs without an uncertainty, which count as exact.
    WithoutUncertainty {
        /// The inputs.
        inputs: Vec<BudgetInput>,
    },
    /// g is [not linear](Budget::is_linear) over the uncertainties of its inputs.
    NotLinear,
}

impl BudgetWarning {
    /// A stable name; `budget` for warnings about the uncertainty alone.
    #[must_use]
    pub fn name(&self) -> &'static str {
        match self {
            Self::GravityContradicted { .. } => "gravity_contradicted",
            Self::WithoutUncertainty { .. } | Self::NotLinear => "budget",
        }
    }
}

impl fmt::Display for BudgetWarning {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::GravityContradicted { mistake: Some(mistake), .. } => {
                let [least, greatest] = GRAVITY_ON_EARTH.map(|bound| rounded(bound, 3));
                write!(
                    f,
                    "gravity is {least} to {greatest} m/s² on Earth: this value is what {mistake} would give"
                )
            }
            Self::GravityContradicted { length, likely_length, mistake: None } => {
                let [least, greatest] = GRAVITY_ON_EARTH.map(|bound| rounded(bound, 3));
                write!(
                    f,
                    "gravity is {least} to {greatest} m/s² on Earth: if the period is right, the length is about {} m and not {} m. \
                     Check that it is the length of this run, from the pivot to the middle of the bob, and that periods are whole ones",
                    rounded(*likely_length, 3),
                    short(*length, 6)
                )
            }
            Self::WithoutUncertainty { inputs } => {
                let names: Vec<&str> = inputs.iter().map(|input| input.name()).collect();
                write!(f, "no uncertainty was given for {}: that of gravity is too small", names.join(", "))
            }
            Self::NotLinear => f.write_str(
                "the uncertainties are too large for linear propagation: that of gravity is approximate",
            ),
        }
    }
}

impl Budget {
    /// Warnings about g and its uncertainty, the gravest first.
    #[must_use]
    pub fn warnings(&self) -> Vec<BudgetWarning> {
        let likely = 0.5 * (GRAVITY_ON_EARTH[0] + GRAVITY_ON_EARTH[1]);
        // A refuted model is reason enough.
        let is_refuted =
            self.combined.contributions.iter().any(|contribution| contribution.input == BudgetInput::Model);
        let is_suspect = !is_refuted && is_nowhere_on_earth(self.gravity(), self.combined.degrees_of_freedom);
        let contradicted = is_suspect.then(|| BudgetWarning::GravityContradicted {
            length: self.length,
            likely_length: self.length * likely / self.g,
            mistake: GravityMistake::explaining(self.gravity(), GravityMistake::anywhere_on_earth()),
        });
        let inputs: Vec<BudgetInput> = self.combined.without_uncertainty().collect();
        let missing = (!inputs.is_empty()).then_some(BudgetWarning::WithoutUncertainty { inputs });
        let bent = (!self.is_linear()).then_some(BudgetWarning::NotLinear);
        contradicted.into_iter().chain(missing).chain(bent).collect()
    }
}
