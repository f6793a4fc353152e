//! Fields of a decay, of its turning points, and of its whole cycles.

use super::report::{Cycle, NumberedTurn, Report};
use super::slow_flow;
use crate::arguments::PendulumOptions;
use crate::output::description::Answers;
use crate::output::field::{Field, Fields};
use libration::decay::{Decay, DecayEnding, PowerLawTerm};
use libration::pendulum::Amplitude;
use serde_json::Value;
use std::f64::consts::TAU;

/// A turning point of a decay.
pub(super) struct Turning<'a> {
    pub(super) decay: &'a Decay,
    pub(super) row: NumberedTurn<'a>,
}

/// A decay with its derived results.
pub(super) struct Found<'a> {
    pub(super) decay: &'a Decay,
    pub(super) report: &'a Report,
}

const QUALITY: &str = "ω0/c of linear damping alone, 2πE/ΔE at the release of any other";

impl Found<'_> {
    /// Q: ω0/c of linear damping alone, 2πE/ΔE at the release of any other.
    pub(super) fn quality(&self) -> f64 {
        match self.decay.damping().terms() {
            [only] if only.exponent.total_cmp(&1.0).is_eq() => {
                self.decay.pendulum().angular_frequency() / only.coefficient
            }
            _ => quality_at(self.decay, &self.decay.start()),
        }
    }
}

/// 2πE/ΔE of the undamped cycle.
fn quality_at(decay: &Decay, amplitude: &Amplitude) -> f64 {
    TAU / decay.loss_in_a_cycle(amplitude)
}

/// The fields before the terms of the damping.
pub(super) fn of_pendulum() -> Fields<Decay> {
    type Of = Field<Decay>;
    Fields::from([Of::number(
        "omega0_rad_per_s",
        "rad/s",
        "angular frequency of small undamped swings, √(g/l)",
        |decay| decay.pendulum().angular_frequency(),
    )
    .line("ω0", 13)])
}

pub(super) fn of_term() -> Fields<PowerLawTerm> {
    type Of = Field<PowerLawTerm>;
    Fields::from([
        Of::number("exponent", "1", "power n of the velocity in the term c·θ′|θ′|ⁿ⁻¹", |term| {
            term.exponent
        }),
        Of::number(
            "coefficient",
            "rad¹⁻ⁿ sⁿ⁻²",
            "coefficient c of the term, per moment of inertia",
            |term| term.coefficient,
        ),
    ])
}

pub(super) fn of_decay<'a>() -> Fields<Found<'a>> {
    type Of<'a> = Field<Found<'a>>;
    Fields::from([
        Of::number(
            "sticking_amplitude_rad",
            "rad",
            "largest amplitude at which dry friction holds the pendulum",
            |answer| answer.decay.sticking_amplitude(),
        ),
        Of::number("quality", "1", QUALITY, |answer| answer.quality()),
        Of::value(
            "ending",
            "",
            "reason why the swings end: sticks, vanishes or creeps; null where they go on",
            |answer| match answer.report.ending {
                None => Value::Null,
                Some(DecayEnding::Sticks | DecayEnding::StopsOnTheWay { .. }) => "sticks".into(),
                Some(DecayEnding::Vanishes) => "vanishes".into(),
                Some(_) => "creeps".into(),
            },
        ),
        Of::number("rest_time_s", "s", "time at which dry friction stops the pendulum, or null", |answer| {
            answer.report.rest().map_or(f64::NAN, |(time, _)| time)
        }),
        Of::number("rest_angle_rad", "rad", "distance from the bottom at which it does, or null", |answer| {
            answer.report.rest().map_or(f64::NAN, |(_, angle)| angle)
        }),
        Of::number(
            "largest_error_averaged_rad",
            "rad",
            "largest error of the averaged law at a turning point",
            |answer| answer.report.largest_error(|turn| turn.averaged).0,
        ),
        Of::number(
            "largest_error_small_amplitude_rad",
            "rad",
            "largest error of the law of small amplitudes at a turning point",
            |answer| answer.report.largest_error(|turn| turn.small).0,
        ),
    ])
}

pub(super) fn of_turning<'a>() -> Fields<Turning<'a>> {
    type Of<'a> = Field<Turning<'a>>;
    Fields::from([
        Of::number("cycle", "1", "cycles since the release: 0, 0.5, 1, …", |turn| turn.row.cycle)
            .short("cycle", 12),
        Of::number("time_s", "s", "time of the turning point", |turn| turn.row.turn.point.time)
            .rounded("t / s", 9),
        Of::number(
            "amplitude_rad",
            "rad",
            "amplitude there, by integrating the equation of motion",
            |turn| turn.row.turn.point.amplitude.radians(),
        )
        .degrees("amplitude / °", 8),
        Of::number("averaged_rad", "rad", "amplitude at that time by the averaged law", |turn| {
            turn.row.turn.averaged
        })
        .degrees("averaged / °", 8),
        Of::number(
            "small_amplitude_rad",
            "rad",
            "amplitude at that time by the law of small amplitudes",
            |turn| turn.row.turn.small,
        )
        .degrees("small amplitudes / °", 8),
        Of::number(
            "loss_in_a_cycle",
            "1",
            "fraction of its energy that a cycle of the undamped motion at that amplitude would lose",
            |turn| turn.decay.loss_in_a_cycle(&turn.row.turn.point.amplitude),
        ),
        Of::number("quality", "1", "2πE/ΔE of the undamped cycle at that amplitude", |turn| {
            quality_at(turn.decay, &turn.row.turn.point.amplitude)
        })
        .only_json(),
    ])
}

/// The fields at the end of each whole cycle.
pub(super) fn of_cycle() -> Fields<Cycle> {
    type Of = Field<Cycle>;
    Fields::from([
        Of::number(
            "duration_of_the_cycle_s",
            "s",
            "duration of the cycle that ends there, given for whole cycles",
            |cycle| cycle.duration,
        )
        .rounded("time of the cycle / s", 8),
        Of::number(
            "exact_period_s",
            "s",
            "exact undamped period at the amplitude in the middle of that cycle",
            |cycle| cycle.exact_period,
        )
        .rounded("exact T / s", 8),
    ])
}

pub(crate) fn answers() -> Vec<Answers> {
    let json = [
        PendulumOptions::fields().described(""),
        of_pendulum().described(""),
        of_term().described("damping[]."),
        of_decay().described(""),
        of_turning().described("turning_points[]."),
        of_cycle().described("turning_points[]."),
        // With --order.
        slow_flow::of_all().described(""),
        slow_flow::of_turn().described("turning_points[]."),
        slow_flow::of_cycle().described("turning_points[]."),
    ];
    let csv = [
        of_turning().described_in_csv(),
        of_cycle().described_in_csv(),
        slow_flow::of_turn().described_in_csv(),
        slow_flow::of_cycle().described_in_csv(),
    ];
    vec![Answers { command: "decay", option: "", json: json.concat(), csv: csv.concat() }]
}
