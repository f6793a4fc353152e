//! Fields of a motion, of its state at a time, and of the approximations then.

use crate::arguments::PendulumOptions;
use crate::output::description::Answers;
use crate::output::field::{Field, Fields};
use crate::output::number;
use libration::pendulum::{ApproximateMotion, Motion, State};

/// The state at a time.
#[derive(Clone, Copy, Debug)]
pub(super) struct StateAtTime {
    pub(super) time: f64,
    pub(super) state: State,
}

/// The angle by an approximate motion at a time, with the exact one.
#[derive(Clone, Copy, Debug)]
pub(super) struct ApproximateAngle<'a> {
    pub(super) motion: &'a ApproximateMotion,
    pub(super) angle: f64,
    pub(super) exact: f64,
}

pub(super) fn of_motion() -> Fields<Motion> {
    type Of = Field<Motion>;
    const DIGITS: usize = 13;
    Fields::from([
        Of::value("regime", "", "rest, libration, separatrix or rotation", |motion| {
            motion.regime().to_string().into()
        })
        .line_of("regime", |motion| motion.regime().to_string()),
        Of::number("period_s", "s", "period of the motion, in rotation the time of a turn", Motion::period)
            .line("period", DIGITS),
        Of::number(
            "energy_ratio",
            "1",
            "energy from the bottom over that of the separatrix, E/2mgl",
            Motion::energy_ratio,
        )
        .line_of("energy / 2mgl", |motion| {
            format!("{} (1 on the separatrix)", number::rounded(motion.energy_ratio(), DIGITS))
        }),
        Of::known("amplitude_rad", "rad", "amplitude, of a libration", |motion| {
            let amplitude = motion.amplitude().map(|amplitude| amplitude.radians());
            amplitude.ok_or_else(|| "only a libration has an amplitude".to_owned())
        })
        .line_of("amplitude", |motion| {
            motion.amplitude().map_or_else(String::new, |amplitude| {
                let degrees = number::short(amplitude.angle().degrees(), 12);
                format!("{} rad = {degrees}°", number::rounded(amplitude.radians(), DIGITS))
            })
        }),
        Of::number("action_rad2_per_s", "rad²/s", "action ∮θ′dθ/2π, per moment of inertia", Motion::action),
    ])
}

pub(super) fn of_sample() -> Fields<StateAtTime> {
    type Of = Field<StateAtTime>;
    Fields::from([
        Of::number("time_s", "s", "time from the start", |moment| moment.time).short("t / s", 12),
        Of::number("angle_rad", "rad", "angle, turns counted", |moment| moment.state.angle)
            .rounded("θ / rad", 10)
            .degrees("θ / °", 10),
        Of::value("turns", "1", "whole turns in the angle", |moment| moment.state.turns.into())
            .numeral("turns", |moment| moment.state.turns.to_string()),
        Of::number("angle_in_turn_rad", "rad", "angle without its whole turns, from −π to π", |moment| {
            moment.state.angle_in_turn
        }),
        Of::number("complement_rad", "rad", "distance from the top, π − |angle in the turn|", |moment| {
            moment.state.complement
        })
        .rounded("π − |θ| / rad", 6),
        Of::number("velocity_rad_per_s", "rad/s", "angular velocity", |moment| moment.state.velocity)
            .rounded("θ′ / (rad/s)", 10),
    ])
}

pub(super) fn of_approximation<'a>() -> Fields<ApproximateAngle<'a>> {
    type Of<'a> = Field<ApproximateAngle<'a>>;
    Fields::from([
        Of::value("key", "", "short name of the approximate motion", |angle| angle.motion.key().into())
            .only_json(),
        Of::number("angle_rad", "rad", "angle of the approximate motion", |angle| angle.angle)
            .in_csv_as("KEY_angle_rad")
            .rounded("KEY / rad", 10),
        Of::number("error_rad", "rad", "angle of the approximate motion minus the exact one", |angle| {
            angle.angle - angle.exact
        })
        .in_csv_as("KEY_error_rad")
        .rounded("error of KEY / rad", 3),
    ])
}

pub(crate) fn answers() -> Vec<Answers> {
    let json = [
        PendulumOptions::fields().described(""),
        of_motion().described(""),
        of_sample().described("samples[]."),
        of_approximation().described("samples[].approximations[]."),
    ];
    let csv = [of_sample().described_in_csv(), of_approximation().described_in_csv()];
    vec![Answers { command: "motion", option: "", json: json.concat(), csv: csv.concat() }]
}
