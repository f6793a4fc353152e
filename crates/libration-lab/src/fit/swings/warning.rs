//! Warnings about the results of swings.

use crate::fit::budget::BudgetWarning;
use crate::fit::contradiction::Contradiction;
use crate::fit::cycles::{Coefficient, CyclesError, CyclesWarning};
use crate::fit::damping_model::DampingModel;
use libration::decay::DampingKind;

/// A warning about the results of swings.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Warning {
    /// The search did not end at a minimum.
    NotConverged,
    /// The angles are [radians that were taken for degrees](crate::fit::MistakenUnit).
    AnglesAreRadians {
        /// β of the angles in the unit in which they were read.
        beta: f64,
    },
    /// The angles are degrees that were taken for radians.
    AnglesAreDegrees {
        /// β of the angles in the unit in which they were read.
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
        fitted: [f64; 2],
    },
    /// A warning about gravity and its uncertainty.
    Budget(BudgetWarning),
    /// The residuals are more than a tenth of the swing itself, where errors of reading are a hundredth or so.
    PoorFit {
        /// Ratio of the residuals to the swing, as root mean squares.
        part: f64,
    },
    /// The damping [feeds energy](crate::fit::trace::TraceFit::dissipates) at some speeds, by more than two uncertainties.
    FeedsEnergy {
        /// Damping of the model.
        damping: DampingModel,
    },
    /// Coefficients of the damping are negative by more than two uncertainties, in a model that the data support
    /// [strongly enough](crate::fit::trace::Comparison::DECISIVE) or that was given.
    NegativeDamping {
        /// The negative coefficients, at least one.
        coefficients: Vec<Coefficient>,
    },
    /// A model explains the data better and is [not believed](crate::fit::trace::Comparison::better).
    BetterModelNotBelieved {
        /// Damping of that model.
        damping: DampingModel,
        /// Difference by which the criterion of the better model is lower.
        excess: f64,
        /// Kind of damping with a negative coefficient; `None` if the reason is that the damping supplies energy.
        negative: Option<DampingKind>,
    },
    /// Models that are not ruled out [contradict](crate::fit::trace::Comparison::contradicting) the preferred one.
    DampingNotSeparated {
        /// The preferred one.
        preferred: DampingModel,
        /// The models, at least one.
        rivals: Vec<DampingModel>,
    },
    /// The residuals are [not noise](crate::fit::trace::Autocorrelation::is_noise): for noise the warning is given for one trace in some ten
    /// thousand.
    ResidualsNotNoise {
        /// Number of rows over which they are correlated.
        rows: f64,
        /// Resulting factor of the uncertainty of ω0.
        inflation: f64,
    },
    /// The rows scatter by more than 3/2 of their stated uncertainties, or by less than 2/3 of them: a difference that changes
    /// the meaning of the uncertainties, and beyond chance for any trace of a few dozen rows.
    StatedUncertainties {
        /// The ratio of the scatter to the stated uncertainties.
        ratio: f64,
    },
    /// The amplitude falls by more than a tenth in a cycle, within which the exact law, which assumes a constant amplitude, then changes by a
    /// fifth of R − 1. This warning replaces those about β and the periods of cycles.
    StrongDamping {
        /// Relative fall of the amplitude in a cycle.
        fall: f64,
    },
    /// β [differs from 1](crate::fit::Beta::differs_from_one), and no strong damping, fitted scale or wrong unit explains it.
    BetaNotOne {
        /// Distance from 1 in uncertainties.
        deviation: f64,
        /// Relative error of the angles (positive where they are too small), if [a wrong scale](crate::fit::Beta::scale_error) can be the reason.
        scale_error: Option<f64>,
        /// The largest and the smallest amplitude, in radians.
        amplitudes: [f64; 2],
    },
    /// T0 by cycles differs from that of the whole motion, by more than chance and by more than a part in ten thousand, within which
    /// both methods may differ.
    PeriodsDisagree {
        /// T0 by cycles, in s.
        by_cycles: f64,
        /// T0 by the whole motion, in s.
        by_motion: f64,
        /// Difference in uncertainties of both.
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
    /// A simple pendulum with this period is shorter than a centimetre or longer than a hundred metres, which is implausible.
    ImplausibleLength {
        /// Length in m.
        length: f64,
    },
    /// Rows beyond five robust standard deviations from the motion.
    Outliers {
        /// Number of rows.
        rows: usize,
    },
    /// A warning about the cycles.
    Cycles {
        /// The name of the trace, where there are several.
        trace: Option<String>,
        /// The warning.
        warning: CyclesWarning,
    },
    /// A trace has no cycles.
    NoCycles {
        /// The name of the trace, where there are several.
        trace: Option<String>,
        /// Reason why the trace has no cycles.
        error: CyclesError,
    },
}

impl Warning {
    /// A stable name.
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
