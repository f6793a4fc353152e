//! Warnings in words.

use std::fmt;

use super::Warning;
use crate::fit::cycles::Coefficient;
use crate::fit::damping_model::{DampingModel, alternatives};
use crate::fit::trace::Comparison;
use libration::decay::DampingKind;
use libration::quantity::rounded;

impl fmt::Display for Warning {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NotConverged => {
                f.write_str("the fit did not converge to a minimum: its results are unreliable")
            }
            Self::AnglesAreRadians { beta } => angles_are_radians(f, *beta),
            Self::AnglesAreDegrees { beta } => write!(
                f,
                "these angles are degrees that were taken for radians: β is {}, and with degrees the periods follow the exact law. T₀ \
                 and all angles given here are wrong",
                rounded(*beta, 4)
            ),
            Self::ModelRefuted(contradiction) => write!(
                f,
                "the model is rejected: {contradiction}. The uncertainty of T₀ includes the difference"
            ),
            Self::PivotContradicted { given: [x, y], fitted: [u, v] } => write!(
                f,
                "the pivot that was given, ({x}, {y}), contradicts the positions: they are on a circle about ({}, {}). The difference is in the \
                 uncertainties; check the pivot and its unit, or leave it out to have the circle fitted",
                rounded(*u, 5),
                rounded(*v, 5)
            ),
            Self::Budget(warning) => warning.fmt(f),
            Self::PoorFit { part } => write!(
                f,
                "the residuals are {} % of the swing itself: the model does not describe what was seen, and its numbers mean little. \
                 Check columns and units, or leave out what is not a free swing",
                rounded(100.0 * part, 2)
            ),
            Self::FeedsEnergy { damping } => write!(
                f,
                "the model `{damping}` feeds energy to the pendulum at some speeds, which friction cannot do: choose another model"
            ),
            Self::NegativeDamping { coefficients } => negative_damping(f, coefficients),
            Self::BetterModelNotBelieved { damping, excess, negative } => {
                better_model(f, *damping, *excess, *negative)
            }
            Self::DampingNotSeparated { preferred, rivals } => not_separated(f, *preferred, rivals),
            Self::ResidualsNotNoise { rows, inflation } => residuals(f, *rows, *inflation),
            Self::StatedUncertainties { ratio } => write!(
                f,
                "the rows scatter {} times as much as their stated uncertainties: these are too {}",
                rounded(*ratio, 2),
                if *ratio > 1.0 { "small" } else { "large" }
            ),
            Self::StrongDamping { fall } => strong_damping(f, *fall),
            Self::BetaNotOne { deviation, scale_error, amplitudes } => {
                beta(f, *deviation, *scale_error, *amplitudes)
            }
            Self::PeriodsDisagree { by_cycles, by_motion, deviation } => {
                periods_disagree(f, *by_cycles, *by_motion, *deviation)
            }
            Self::DifferentPendulums { shortest, longest } => different_pendulums(f, shortest, longest),
            Self::ImplausibleLength { length } => write!(
                f,
                "a simple pendulum with this period would be {} m long: check the unit of the times",
                rounded(*length, 2)
            ),
            Self::Outliers { rows } => outliers(f, *rows),
            Self::Cycles { trace, warning } => write!(f, "cycles{}: {warning}", named(trace)),
            Self::NoCycles { trace, error } => write!(f, "cycles{}: {error}", named(trace)),
        }
    }
}

fn named(trace: &Option<String>) -> String {
    trace.as_ref().map_or(String::new(), |name| format!(" of {name}"))
}

fn angles_are_radians(f: &mut fmt::Formatter<'_>, beta: f64) -> fmt::Result {
    write!(
        f,
        "these angles are radians that were taken for degrees: β is {}, where (180/π)² = 3283 is what that mistake makes of \
         small angles, and with radians the periods follow the exact law. T₀ and all angles given here are wrong",
        rounded(beta, 4)
    )
}

fn not_separated(
    f: &mut fmt::Formatter<'_>,
    preferred: DampingModel,
    rivals: &[DampingModel],
) -> fmt::Result {
    write!(
        f,
        "{preferred} damping cannot be distinguished from {} with these data: T₀ is averaged over these models, and their \
         coefficients may differ by more than the uncertainties say",
        alternatives(rivals)
    )
}

fn strong_damping(f: &mut fmt::Formatter<'_>, fall: f64) -> fmt::Result {
    write!(
        f,
        "the amplitude falls by {} % in a cycle: with such strong damping the periods of single cycles follow the exact law \
         only roughly, so β means little; the fit of the whole motion is what counts",
        rounded(100.0 * fall, 2)
    )
}

fn periods_disagree(
    f: &mut fmt::Formatter<'_>,
    by_cycles: f64,
    by_motion: f64,
    deviation: f64,
) -> fmt::Result {
    write!(
        f,
        "T₀ by single cycles, {} s, is {} standard uncertainties from that of the whole motion, {} s",
        rounded(by_cycles, 6),
        rounded(deviation, 2),
        rounded(by_motion, 6)
    )
}

fn different_pendulums(
    f: &mut fmt::Formatter<'_>,
    shortest: &(String, f64),
    longest: &(String, f64),
) -> fmt::Result {
    write!(
        f,
        "the traces are not of one pendulum: by its cycles {} has T₀ {} s, and {} has {} s. Fit them one by one",
        shortest.0,
        rounded(shortest.1, 5),
        longest.0,
        rounded(longest.1, 5)
    )
}

fn outliers(f: &mut fmt::Formatter<'_>, rows: usize) -> fmt::Result {
    let are = if rows == 1 { "row is an outlier" } else { "rows are outliers" };
    write!(f, "{rows} {are}, further than five robust standard deviations from the motion")
}

fn negative_damping(f: &mut fmt::Formatter<'_>, coefficients: &[Coefficient]) -> fmt::Result {
    let names: Vec<&str> = coefficients.iter().map(|coefficient| coefficient.term.name()).collect();
    let values: Vec<String> = coefficients.iter().map(ToString::to_string).collect();
    write!(
        f,
        "the {} damping is negative, {}: drag cannot drive. The friction may fall as the speed rises, or the term describes an \
         effect that the model lacks",
        names.join(" and "),
        values.join(" and ")
    )
}

fn better_model(
    f: &mut fmt::Formatter<'_>,
    damping: DampingModel,
    excess: f64,
    negative: Option<DampingKind>,
) -> fmt::Result {
    let why = match negative {
        Some(term) => format!("its {} damping is negative", term.name()),
        None => "it feeds energy to the pendulum at some speeds".to_owned(),
    };
    let how_much = match excess {
        excess if excess < Comparison::INDISTINGUISHABLE => "slightly better",
        excess if excess < Comparison::UNSUPPORTED => "better",
        _ => "much better",
    };
    write!(
        f,
        "`{damping}` fits the data {how_much} (AICc lower by {}) but is not preferred, since {why}: the pendulum or the instrument \
         has an effect that is in no model",
        rounded(excess, 3)
    )
}

fn residuals(f: &mut fmt::Formatter<'_>, rows: f64, inflation: f64) -> fmt::Result {
    /// Number of rows over which residuals must be correlated: those that repeat with the swing, or change sign from row to row, are correlated
    /// over no more than one row.
    const ALIKE: f64 = 1.5;
    let how = match rows {
        rows if rows < ALIKE => "they follow a pattern".to_owned(),
        rows => format!("they are alike over about {} rows", rounded(rows, 2)),
    };
    write!(
        f,
        "the residuals are not noise: {how}, so the model lacks an effect of the pendulum or of the instrument.  "
    )?;
    match inflation {
        inflation if inflation < ALIKE => {
            f.write_str("A systematic error may be larger than the uncertainties")
        }
        inflation => write!(
            f,
            "For ω₀ that makes {} times the uncertainty it would have if the rows were independent, which is allowed for; a systematic \
             error may be larger still",
            rounded(inflation, 2)
        ),
    }
}

fn beta(
    f: &mut fmt::Formatter<'_>,
    deviation: f64,
    scale_error: Option<f64>,
    amplitudes: [f64; 2],
) -> fmt::Result {
    write!(
        f,
        "β is {} standard uncertainties from 1: the period does not change with the amplitude as the exact law says. ",
        rounded(deviation, 2)
    )?;
    match scale_error {
        Some(part) => {
            let (percent, how) = (rounded(100.0 * part.abs(), 2), if part > 0.0 { "small" } else { "large" });
            write!(f, "Angles measured {percent} % too {how} would do this")
        }
        None => {
            let [largest, smallest] = amplitudes.map(|size| rounded(size.to_degrees(), 3));
            write!(
                f,
                "A scale of the angles is not wrong by that much; with amplitudes from {largest}° to {smallest}° only, anything that \
                 changes the period in time looks like this"
            )
        }
    }
}
