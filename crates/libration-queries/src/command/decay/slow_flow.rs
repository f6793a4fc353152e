//! The slow flow compared with a decay: options and output.

use crate::interrupt::Cancellation;
use crate::output::field::{Field, Fields};
use crate::output::number::short;
use crate::parallel;
use crate::query_error::{QueryError, option};
use libration::comparison::{SlowDecay, SlowDecayError};
use libration::decay::Decay;
use libration::perturbation::SlowFlowError;

/// The slow flow at a turning point of the integrated motion.
#[derive(Clone, Copy, Debug)]
pub(crate) struct SlowTurn {
    /// Amplitude at its time, in radians.
    pub(crate) amplitude: f64,
    pub(crate) phase: f64,
    /// Amplitude of the slow flow minus that of the integration, in radians.
    pub(crate) amplitude_error: f64,
    pub(crate) phase_error: f64,
}

/// The cycle of the slow flow with one of the integrated motion, in seconds.
#[derive(Clone, Copy, Debug)]
pub(crate) struct SlowCycle {
    pub(crate) duration: f64,
    pub(crate) error: f64,
}

/// Comparison of the slow flow with all turning points.
pub(super) struct Compared<'a> {
    pub(super) slow: &'a SlowDecay,
    /// Largest errors of the amplitude and of the phase, in radians.
    pub(super) largest_errors: [f64; 2],
}

pub(super) fn follow(decay: &Decay, [order, damping_order]: [usize; 2]) -> Result<SlowDecay, QueryError> {
    let how_far = || format!("slow flow to order {order}");
    let slow_flow =
        parallel::with_progress(how_far, || SlowDecay::new(decay, order, damping_order, &Cancellation));
    slow_flow.map_err(|error| match error {
        SlowDecayError::SlowFlow(SlowFlowError::Interrupted) => {
            QueryError::cancelled("interrupted before the slow flow was known")
        }
        SlowDecayError::Exponent(_) => QueryError::usage(option("order"), error),
        other => QueryError::no_result("slow flow", other),
    })
}

pub(super) fn of_all<'a>() -> Fields<Compared<'a>> {
    type Of<'a> = Field<Compared<'a>>;
    Fields::from([
        Of::value(
            "slow_flow_order",
            "1",
            "highest power of the amplitude in the slow flow, as given by --order",
            |comparison| comparison.slow.flow().order.into(),
        ),
        Of::value(
            "slow_flow_damping_order",
            "1",
            "highest power of the damping in the slow flow",
            |comparison| comparison.slow.flow().parameter_order.into(),
        ),
        Of::number(
            "largest_error_slow_flow_rad",
            "rad",
            "largest error of the slow flow's amplitude at a turning point",
            |comparison| comparison.largest_errors[0],
        ),
        Of::number(
            "largest_phase_error_slow_flow_rad",
            "rad",
            "largest error of the slow flow's phase at a turning point",
            |comparison| comparison.largest_errors[1],
        ),
    ])
}

pub(super) fn of_turn() -> Fields<SlowTurn> {
    type Of = Field<SlowTurn>;
    Fields::from([
        Of::number("slow_flow_rad", "rad", "amplitude at that time by the slow flow", |turn| turn.amplitude)
            .degrees("slow flow / °", 8),
        Of::number("slow_flow_error_rad", "rad", "difference from the integrated amplitude", |turn| {
            turn.amplitude_error
        }),
        Of::number("slow_flow_phase_rad", "rad", "phase at that time by the slow flow", |turn| turn.phase),
        Of::number(
            "slow_flow_phase_error_rad",
            "rad",
            "difference from the phase of the turning point, a multiple of π",
            |turn| turn.phase_error,
        )
        .short("error of the phase / rad", 3),
    ])
}

pub(super) fn of_cycle() -> Fields<SlowCycle> {
    type Of = Field<SlowCycle>;
    Fields::from([
        Of::number("slow_flow_duration_s", "s", "time of that cycle by the slow flow", |cycle| {
            cycle.duration
        })
        .rounded("slow flow / s", 8),
        Of::number("slow_flow_duration_error_s", "s", "difference from the integrated time", |cycle| {
            cycle.error
        }),
    ])
}

/// The accuracy of the slow flow, in a line.
pub(super) fn line(Compared { slow, largest_errors: [amplitude, phase] }: &Compared<'_>) -> String {
    let [order, damping_order] = [slow.flow().order, slow.flow().parameter_order];
    let orders = format!("to the power {order} of the amplitude and {damping_order} of the damping");
    if amplitude.is_nan() {
        return format!(
            "{orders}: it ends before the motion, for which the damping or the amplitude is too large"
        );
    }
    let (degrees, phase) = (short(amplitude.to_degrees(), 2), short(*phase, 2));
    format!("{orders}: error at most {degrees}°, and {phase} rad of the phase")
}
