//! Gravity by ω0 and the length of the pendulum, or the length by ω0 alone.

use std::f64::consts::TAU;

use super::options::SwingsOptions;
use crate::fit::budget::{Budget, BudgetError, MeasuredPeriod, PeriodDamping, evaluate_budget};
use crate::fit::cycles::{Cycles, CyclesError};
use crate::fit::trace::{DampingKind, ParameterKind, TraceFit};
use crate::fit::typical_amplitude::typical_amplitude;
use crate::fit::uncertain::Uncertain;
use libration::quantity::{Quantity, STANDARD_GRAVITY};

/// Gravity by ω0 and the length of the pendulum, or the length by ω0 alone.
#[derive(Clone, Debug, PartialEq)]
pub enum FittedPendulum {
    /// The length is known.
    Gravity {
        /// Gravity with the budget of its uncertainty.
        budget: Budget,
        /// The length that was given, in m.
        length: Quantity,
    },
    /// The length, in m, of a simple pendulum where gravity is [the standard one](STANDARD_GRAVITY).
    Length(Uncertain),
}

/// Computes gravity or the length from the period of small swings of this fit; `model` is its relative standard uncertainty by fits that
/// contradict each other.
pub(super) fn pendulum_of(
    fit: &TraceFit,
    t0: Uncertain,
    model: Option<f64>,
    cycles: &[Result<Cycles, CyclesError>],
    options: &SwingsOptions<'_>,
) -> Result<FittedPendulum, BudgetError> {
    let Some(apparatus) = options.apparatus else {
        return Ok(FittedPendulum::Length(length(t0.with_error(model.unwrap_or(0.0) * t0.value))));
    };
    let ratios =
        cycles.iter().flatten().flat_map(|of_trace| of_trace.cycles.iter().map(|cycle| cycle.period_ratio));
    let period = MeasuredPeriod {
        t0: t0.into(),
        model,
        amplitude: typical_amplitude(ratios),
        // The uncertainty of a fitted scale is part of T0's already.
        angle_scale: fit.parameter(ParameterKind::Scale).map_or(options.angle_scale, |_| Some(0.0)),
        clock: options.clock,
        shared_timing: None,
        degrees_of_freedom: fit.parameters[0].degrees_of_freedom,
        damping: damping(fit),
    };
    let budget = evaluate_budget(&apparatus, &period, options.correlations)?;
    Ok(FittedPendulum::Gravity { budget, length: apparatus.length })
}

/// Length of a simple pendulum in standard gravity.
fn length(t0: Uncertain) -> Uncertain {
    let value = STANDARD_GRAVITY * (t0.value / TAU) * (t0.value / TAU);
    Uncertain { value, uncertainty: 2.0 * value * t0.relative() }
}

/// The damping that T0 contains: a fit of damped motion gives T0 without damping, an undamped one leaves the damping in it.
fn damping(fit: &TraceFit) -> PeriodDamping {
    match fit.damping.count() {
        0 => PeriodDamping::Unknown,
        _ => PeriodDamping::Fitted(
            fit.damping_coefficient(DampingKind::Linear).map_or(0.0, |linear| linear.estimate.value),
        ),
    }
}
