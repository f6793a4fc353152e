//! Warnings about the times of a gate.

use std::fmt;

use super::{GatesFit, T0Source};
use crate::fit::beta::Beta;
use crate::fit::significance::{SIGNIFICANT, limit_of_chance};
use crate::fit::uncertain::Uncertain;
use libration::quantity::rounded;

/// Number of standard deviations of a time by which a last period must be below T0: a period is the difference of two times, with a scatter larger
/// by √2, so that this is beyond four standard deviations of a period.
const SHORT_BY_TIMINGS: f64 = 6.0;

/// A warning about the times of a gate.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum GatesWarning {
    /// Edges without a partner, left out.
    UnpairedEdges {
        /// Number of edges.
        edges: usize,
    },
    /// Passages that fit no pendulum, left out.
    DoubleTriggers {
        /// Number of passages.
        passages: usize,
    },
    /// Passages that were missed; periods across them are left out.
    MissedPassages {
        /// Number of passages.
        passages: usize,
    },
    /// A width was given, but T0 does not come from it.
    WidthUnused {
        /// `true` if the times are edges with speeds, which are then those of a pendulum that goes over the top.
        edges: bool,
    },
    /// No amplitude, without which T0 is not determined.
    NoAmplitude,
    /// The passages are too few to extrapolate the period to the swing whose amplitude is given: seven in a row are needed.
    TooFewToExtrapolate,
    /// The times do not determine their scatter: they are too few, or exactly even, by less than 1e-9 of a period.
    ScatterUnknown,
    /// β [differs from 1](Beta::differs_from_one), by more than a twentieth: R − 1 goes with the square of the amplitude, so that the
    /// width of the bob, to which all speeds are proportional, would be wrong by a fortieth.
    BetaNotOne {
        /// The number of uncertainties between β and 1.
        deviation: f64,
        /// The fraction by which the width is too large, if [an error of it](Beta::scale_error) can be the reason.
        width_error: Option<f64>,
    },
    /// The last period, the mean of both sides, is below T0 by more than their uncertainties (three of T0, six of a time), and no pendulum has
    /// a period below that of its small swings.
    PeriodBelowT0 {
        /// Last period, in seconds.
        last: f64,
        /// T0, in seconds.
        t0: f64,
    },
}

impl GatesWarning {
    /// A stable name.
    #[must_use]
    pub fn name(&self) -> &'static str {
        match self {
            Self::UnpairedEdges { .. } => "unpaired_edges",
            Self::DoubleTriggers { .. } => "double_triggers",
            Self::MissedPassages { .. } => "missed_passages",
            Self::WidthUnused { .. } => "width_of_no_use",
            Self::NoAmplitude => "no_amplitude",
            Self::TooFewToExtrapolate => "too_few_to_extrapolate",
            Self::ScatterUnknown => "scatter_unknown",
            Self::BetaNotOne { .. } => "beta_not_one",
            Self::PeriodBelowT0 { .. } => "period_below_t0",
        }
    }
}

impl fmt::Display for GatesWarning {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::UnpairedEdges { edges } => {
                write!(f, "unpaired edges of the gate, left out: {edges}")
            }
            Self::DoubleTriggers { passages } => {
                write!(f, "passages that do not fit the period (double triggers), left out: {passages}")
            }
            Self::MissedPassages { passages } => {
                write!(f, "missed passages, with the periods across them left out: {passages}")
            }
            Self::WidthUnused { edges: true } => f.write_str(
                "the width of the bob cannot be used: by the speeds at the gate the pendulum would go over the top; check the width of the bob",
            ),
            Self::WidthUnused { edges: false } => f.write_str(
                "the width of the bob cannot be used: the times are not edges of the gate, so the speeds are not known",
            ),
            Self::NoAmplitude => f.write_str(
                "the period of small swings is not known without an amplitude: give that of the first swing, or the width of the bob",
            ),
            Self::TooFewToExtrapolate => f.write_str(
                "the passages are too few to extrapolate the period to the first swing, whose amplitude is given, so that T0 is not known: record \
                 seven or more in a row, or give the width of the bob",
            ),
            Self::ScatterUnknown => f.write_str(
                "the scatter of the times is not known, since they are too few or exactly even: uncertainties from their scatter \
                 mean nothing",
            ),
            Self::BetaNotOne { deviation, width_error } => beta_not_one(f, deviation, width_error),
            Self::PeriodBelowT0 { last, t0 } => write!(
                f,
                "the last period, {} s, is below T0, {} s, which is impossible for a pendulum: check the amplitude or the width",
                rounded(last, 5),
                rounded(t0, 5)
            ),
        }
    }
}

/// Warnings of a fit with the width of the bob or without: a refuted model first, then in the order in which the times are processed.
pub(super) fn warnings(fit: &GatesFit, last_period: Option<f64>, has_width: bool) -> Vec<GatesWarning> {
    let speeds_failed = has_width && fit.t0_source != Some(T0Source::Speeds);
    [
        fit.beta.as_ref().and_then(doubtful_beta),
        (fit.unpaired > 0).then_some(GatesWarning::UnpairedEdges { edges: fit.unpaired }),
        (fit.double_triggers > 0).then_some(GatesWarning::DoubleTriggers { passages: fit.double_triggers }),
        (fit.missed > 0).then_some(GatesWarning::MissedPassages { passages: fit.missed }),
        speeds_failed.then_some(GatesWarning::WidthUnused { edges: fit.edges }),
        fit.t0.is_none().then_some(match fit.amplitude {
            Some(_) => GatesWarning::TooFewToExtrapolate,
            None => GatesWarning::NoAmplitude,
        }),
        is_scatter_unknown(fit).then_some(GatesWarning::ScatterUnknown),
        last_period.and_then(|last| period_below_t0(fit, last)),
    ]
    .into_iter()
    .flatten()
    .collect()
}

fn is_scatter_unknown(fit: &GatesFit) -> bool {
    /// Scatter relative to a period, below which it is rounding. For steps of a tenth of a microsecond it is more than ten times as large in
    /// periods of 2 s.
    const ROUNDING: f64 = 1e-9;
    fit.timing.is_none_or(|timing| timing < ROUNDING * fit.mean_period.value)
}

fn beta_not_one(f: &mut fmt::Formatter<'_>, deviation: f64, width_error: Option<f64>) -> fmt::Result {
    write!(
        f,
        "β is {} standard uncertainties from 1: the period does not follow the exact law at the amplitudes given by the \
         speeds at the gate;  ",
        rounded(deviation, 2)
    )?;
    match width_error {
        Some(part) => write!(
            f,
            "a width of the bob {} % too {} would do this",
            rounded(100.0 * part.abs(), 2),
            if part > 0.0 { "large" } else { "small" }
        ),
        None => f.write_str(
            "check the width of the bob and the distance of the gate from the pivot, and their units",
        ),
    }
}

fn doubtful_beta(beta: &Beta) -> Option<GatesWarning> {
    /// Smallest deviation of β from 1 that is reported: without an error of the width β was within a fiftieth of 1 in synthetic records, or within
    /// its uncertainties.
    const WORTH_A_WORD: f64 = 0.05;
    let is_doubtful = beta.differs_from_one() && (beta.factor.value - 1.0).abs() > WORTH_A_WORD;
    is_doubtful.then(|| GatesWarning::BetaNotOne {
        deviation: beta.deviation(),
        width_error: beta.scale_error().map(|amplitudes_too_small| -amplitudes_too_small),
    })
}

/// Compares T0 with the last period, which is the mean of both sides: that of one side changes with the amplitude if the gate is not at the centre.
fn period_below_t0(fit: &GatesFit, last: f64) -> Option<GatesWarning> {
    let Uncertain { value: t0, uncertainty } = fit.t0?;
    let least = t0 - limit_of_chance(SIGNIFICANT, fit.t0_degrees_of_freedom) * uncertainty;
    (least > last + SHORT_BY_TIMINGS * fit.timing.unwrap_or(0.0))
        .then_some(GatesWarning::PeriodBelowT0 { last, t0 })
}
