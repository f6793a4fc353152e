//! What is doubtful about what swings say.

use crate::fit::budget::BudgetWarning;
use crate::fit::cycles::{Coefficient, CyclesError, CyclesWarning};
use crate::fit::{Contradiction, DampingKind, DampingModel};

/// What is doubtful about what swings say.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Warning {
    /// The search did not end at a minimum.
    NotConverged,
    /// The angles are [radians that were taken for degrees](crate::fit::MistakenUnit).
    AnglesAreRadians {
        /// Of the angles as they were taken.
        beta: f64,
    },
    /// The angles are degrees that were taken for radians.
    AnglesAreDegrees {
        /// Of the angles as they were taken.
        beta: f64,
    },
    /// Fits of the same data contradict each other by more than [chance](crate::fit::SIGNIFICANT).
    ModelRefuted(Contradiction),
    /// The pivot that was given is not the centre of the circle that the positions are on, by more than
    /// [the noise explains](crate::measurement::FittedPivot::contradicted_by). The difference is in the uncertainties.
    PivotContradicted {
        /// The pivot that was given, in the unit of the positions.
        given: [f64; 2],
        /// The centre of the circle, in the same unit.
        found: [f64; 2],
    },
    /// Of gravity and its uncertainty.
    Budget(BudgetWarning),
    /// The residuals are more than a tenth of the swing itself, where errors of reading are a hundredth or so.
    PoorFit {
        /// Which part, as root mean squares.
        part: f64,
    },
    /// The damping [feeds energy](crate::fit::trace::TraceFit::dissipates) at some speeds, by more than two uncertainties.
    FeedsEnergy {
        /// Of the model.
        damping: DampingModel,
    },
    /// Coefficients of the damping are negative by more than two uncertainties, which the data ask for
    /// [strongly enough](crate::fit::trace::Comparison::DECISIVE) or which was asked for.
    NegativeDamping {
        /// At least one.
        coefficients: Vec<Coefficient>,
    },
    /// A model explains the data better and is [not believed](crate::fit::trace::Comparison::better).
    BetterModelNotBelieved {
        /// Of that model.
        damping: DampingModel,
        /// By how much its criterion is lower.
        excess: f64,
        /// Whose coefficient is negative; none where it is that it feeds energy.
        negative: Option<DampingKind>,
    },
    /// Models are left that [contradict](crate::fit::trace::Comparison::contradicting) the preferred one.
    DampingNotSeparated {
        /// The preferred one.
        preferred: DampingModel,
        /// At least one.
        rivals: Vec<DampingModel>,
    },
    /// The residuals are [no noise](crate::fit::trace::Autocorrelation::is_noise): among noise one trace in some ten thousand is
    /// told so.
    ResidualsNotNoise {
        /// Over how many rows they are alike.
        rows: f64,
        /// By what that multiplies the uncertainty of ω0.
        inflation: f64,
    },
    /// The rows scatter by half as much again as their stated uncertainties, or by two thirds of them: a difference that changes
    /// what the uncertainties mean, and beyond chance for any trace of a few dozen rows.
    StatedUncertainties {
        /// The scatter over what is stated.
        ratio: f64,
    },
    /// In place of what β and the periods of cycles would say: the amplitude falls by more than a tenth in a cycle, within which the
    /// exact law, of a constant amplitude, then changes by a fifth of R − 1.
    StrongDamping {
        /// By which part the amplitude falls in a cycle.
        fall: f64,
    },
    /// β [differs from 1](crate::fit::Beta::differs_from_one), and no strong damping, fitted scale or wrong unit explains it.
    BetaNotOne {
        /// In uncertainties.
        deviation: f64,
        /// By which part the angles are too small, if [a wrong scale](crate::fit::Beta::scale_error) can be why.
        scale_error: Option<f64>,
        /// The largest and the smallest amplitude, in radians.
        amplitudes: [f64; 2],
    },
    /// T0 by cycles differs from that of the whole motion, by more than chance and by more than a part in ten thousand, within which
    /// both ways of measuring may differ.
    PeriodsDisagree {
        /// T0 by cycles, in s.
        by_cycles: f64,
        /// T0 by the whole motion, in s.
        by_motion: f64,
        /// In uncertainties of both.
        deviation: f64,
    },
    /// T0 by the cycles of one trace differs from that of another, by more than chance and by more than a hundredth: a length that
    /// changed by a fiftieth is another pendulum.
    DifferentPendulums {
        /// The trace with the shortest T0, and this, in s.
        shortest: (String, f64),
        /// The trace with the longest T0, and this, in s.
        longest: (String, f64),
    },
    /// A simple pendulum with this period is below a centimetre or above a hundred metres, which nobody builds.
    ImplausibleLength {
        /// In m.
        length: f64,
    },
    /// Rows beyond five robust standard deviations from the motion.
    Outliers {
        /// How many.
        rows: usize,
    },
    /// Of the cycles.
    Cycles {
        /// The name of the trace, where there are several.
        trace: Option<String>,
        /// What a reader should know of them.
        warning: CyclesWarning,
    },
    /// A trace has no cycles.
    NoCycles {
        /// The name of the trace, where there are several.
        trace: Option<String>,
        /// Why.
        error: CyclesError,
    },
}

impl Warning {
    /// A name that stays.
    #[must_use]
    pub fn name(&self) -> &'static str {
        match self {
            Self::NotConverged => "not_converged",
            Self::AnglesAreRadians { .. } => "angles_are_radians",
            Self::AnglesAreDegrees { .. } => "angles_are_degrees",
            Self::ModelRefuted(_) => "model_refuted",
            Self::PivotContradicted { .. } => "pivot_contradicted",
            Self::Budget(warning) => warning.name(),
            Self::PoorFit { .. } => "poor_fit",
            Self::FeedsEnergy { .. } => "feeds_energy",
            Self::NegativeDamping { .. } => "negative_damping",
            Self::BetterModelNotBelieved { .. } => "better_model_not_believed",
            Self::DampingNotSeparated { .. } => "damping_not_separated",
            Self::ResidualsNotNoise { .. } => "residuals_not_noise",
            Self::StatedUncertainties { .. } => "stated_uncertainties",
            Self::StrongDamping { .. } => "strong_damping",
            Self::BetaNotOne { .. } => "beta_not_one",
            Self::PeriodsDisagree { .. } => "periods_disagree",
            Self::DifferentPendulums { .. } => "different_pendulums",
            Self::ImplausibleLength { .. } => "implausible_length",
            Self::Outliers { .. } => "outliers",
            Self::Cycles { .. } | Self::NoCycles { .. } => "cycles",
        }
    }
}
