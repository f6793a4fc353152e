//! Warnings about a fit of amplitudes.

use std::fmt;

use crate::fit::damping_model::{DampingModel, alternatives};
use crate::fit::scatter::ScatterWarning;
use libration::quantity::rounded;

/// A warning about a fit of amplitudes.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum AmplitudesWarning {
    /// The rows prefer another law to the given one.
    LawRefuted {
        /// The given law.
        given: DampingModel,
        /// The law that the rows prefer.
        preferred: DampingModel,
        /// Difference of the criterion.
        difference: f64,
    },
    /// The errors of neighbouring rows are alike.
    ResidualsNotWhite {
        /// Number of neighbouring rows that share one error.
        rows_per_error: f64,
    },
    /// The rows scatter more or less than stated, or not at all.
    Scatter(ScatterWarning),
    /// Other laws that the rows do not exclude.
    LawsNotSeparated(Vec<DampingModel>),
    /// Too few rows for laws with several kinds of damping.
    TooFewRowsToCompare,
    /// The amplitude falls no more than chance allows.
    DampingNotResolved {
        /// The probability that chance makes the fall as large.
        chance: f64,
    },
    /// The damping is too strong for an average over a cycle.
    StrongDamping {
        /// The smallest Q of the table.
        quality: f64,
    },
    /// The first amplitudes are too near the top for an average over a cycle, by their uncertainty.
    AveragedNearTop {
        /// Upper estimate of the error of the law, in radians.
        error: f64,
        /// Amplitude from which on the error is a third of the uncertainty of a row, in radians.
        from: f64,
    },
}

impl AmplitudesWarning {
    /// A stable name.
    #[must_use]
    pub fn name(&self) -> &'static str {
        match self {
            Self::LawRefuted { .. } => "law_refuted",
            Self::ResidualsNotWhite { .. } => "residuals_not_white",
            Self::Scatter(warning) => warning.name(),
            Self::LawsNotSeparated(_) => "laws_not_separated",
            Self::TooFewRowsToCompare => "too_few_rows_to_compare",
            Self::DampingNotResolved { .. } => "damping_not_resolved",
            Self::StrongDamping { .. } => "strong_damping",
            Self::AveragedNearTop { .. } => "averaged_near_top",
        }
    }
}

impl fmt::Display for AmplitudesWarning {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::LawRefuted { given, preferred, difference } => write!(
                f,
                "the rows refute {given} damping: {preferred} damping fits them better (AICc lower by {}); the difference is in \
                 the uncertainty of Q",
                rounded(*difference, 2)
            ),
            Self::ResidualsNotWhite { rows_per_error } => write!(
                f,
                "the residuals are not white noise: {} neighbouring rows share one error, and all uncertainties include that; \
                 look at the residuals for another law, a wrong zero of the scale or a misread row",
                rounded(*rows_per_error, 2)
            ),
            Self::Scatter(warning) => warning.fmt(f),
            Self::LawsNotSeparated(laws) => write!(
                f,
                "the rows do not exclude {} damping: the difference is in the uncertainty of Q, and not in \
                 that of the coefficients",
                alternatives(laws)
            ),
            Self::TooFewRowsToCompare => f.write_str(
                "the rows are too few to compare damping of several kinds: give more amplitudes, or the law",
            ),
            Self::DampingNotResolved { chance } => write!(
                f,
                "the fall of the amplitude is not significant: chance makes it as large with a probability of {}; measure for a \
                 longer time",
                rounded(*chance, 2)
            ),
            Self::StrongDamping { quality } => write!(
                f,
                "Q is as low as {}: the fall is averaged over a cycle, and the coefficients may err by 0.2/Q² of \
                 themselves; fit the motion itself",
                rounded(*quality, 2)
            ),
            Self::AveragedNearTop { error, from } => write!(
                f,
                "the fall is averaged over a cycle, which errs near the top: by up to {} rad at the largest amplitude, more than a third of the uncertainty of a row; \
                 coefficients and further kinds of damping may come from this error; leave out amplitudes above {:.0}°, or fit the motion itself",
                rounded(*error, 1),
                from.to_degrees()
            ),
        }
    }
}
