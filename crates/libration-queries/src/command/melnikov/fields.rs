//! Fields of a Melnikov function, its thresholds, and resonances.

use super::{Crossing, MelnikovResult};
use crate::output::description::Answers;
use crate::output::field::{Field, Fields};
use crate::output::json;
use crate::output::number::{at_most, rounded, short};
use libration::algebra::Complex;
use libration::melnikov::{DriveResonance, Melnikov};

/// A harmonic of the function: its number, coefficient and error.
struct MelnikovHarmonic {
    number: usize,
    value: Complex,
    error: f64,
}

/// A resonance with the next one of its kind.
pub(super) struct Neighbours<'a> {
    pub(super) own: &'a DriveResonance,
    next: Option<&'a DriveResonance>,
}

impl MelnikovResult {
    pub(super) fn neighbours(&self) -> impl Iterator<Item = Neighbours<'_>> {
        let own = self.resonances.iter().enumerate();
        own.map(|(place, own)| Neighbours { own, next: self.resonances.get(place + 1) })
    }
}

impl Neighbours<'_> {
    pub(super) fn overlap(&self) -> Option<f64> {
        self.next.and_then(|next| self.own.overlap(next))
    }
}

pub(super) fn of_answer() -> Fields<MelnikovResult> {
    type Of = Field<MelnikovResult>;
    Fields::from([
        Of::value("system", "", "key of the system, null where its equations were typed", |it| {
            it.model.key().into()
        })
        .line_of("system", |it| it.model.title().to_owned()),
        Of::value("equation", "", "equation of motion as it was read", |it| {
            it.model.equation().to_string().into()
        })
        .line_of("equation", |it| it.model.equation().to_string()),
        Of::value("parameter", "", "name of the parameter of --over, or null", |it| {
            it.at.as_ref().map(|(name, _)| name.as_str()).into()
        }),
        Of::nullable(
            "value",
            "",
            "value of the parameter at which function and resonances are given, or null",
            |it| it.at.as_ref().map(|(_, value)| *value),
        )
        .line_of("at", |it| {
            it.at
                .as_ref()
                .map_or_else(String::new, |(name, value)| format!("{name} = {}", rounded(*value, 16)))
        }),
        Of::number("omega0_rad_per_s", "rad/s", "angular frequency of the smallest swings", |it| {
            it.pendulum.omega0()
        }),
        Of::nullable(
            "drive_angular_frequency_rad_per_s",
            "rad/s",
            "angular frequency of the drive, or null without one",
            |it| it.pendulum.frequency(),
        )
        .line_of("frequencies", |it| {
            let drive = it.pendulum.frequency();
            let drive =
                drive.map_or_else(|| "no drive".to_owned(), |it| format!("drive {} rad/s", short(it, 10)));
            format!("ω0 = {} rad/s, {drive}", short(it.pendulum.omega0(), 10))
        }),
        Of::value(
            "closed_form",
            "",
            "true if the integrals are found by residues, false by quadrature",
            |it| it.pendulum.is_closed().into(),
        )
        .line_of("integrals", |it| {
            if it.pendulum.is_closed() { "in closed form, by residues" } else { "by quadrature" }.to_owned()
        }),
        Of::nested("separatrices[].", &of_separatrix(), |it| of_separatrix().records(&it.separatrices)),
        Of::nested("thresholds[].", &of_crossing(), |it| {
            of_crossing().records(it.thresholds.iter().flatten())
        }),
    ])
}

fn of_separatrix() -> Fields<Melnikov> {
    type Of = Field<Melnikov>;
    Fields::from([
        Of::number("direction", "", "1 where the angle grows, -1 on the other separatrix", |it| it.direction),
        Of::number("mean_rad2_per_s2", "rad²/s²", "part of M that does not depend on the phase", |it| {
            it.mean
        }),
        Of::number("mean_error_rad2_per_s2", "rad²/s²", "bound on its error", |it| it.mean_error),
        Of::nested("harmonics[].", &of_harmonic(), |it| {
            let terms = (1..).zip(&it.harmonics).zip(&it.harmonic_errors);
            let terms = terms.map(|((number, value), error)| MelnikovHarmonic {
                number,
                value: *value,
                error: *error,
            });
            of_harmonic().records(&terms.collect::<Vec<_>>())
        }),
        Of::number("minimum_rad2_per_s2", "rad²/s²", "least value of M", |it| it.mean + it.extremes()[0]),
        Of::number("maximum_rad2_per_s2", "rad²/s²", "greatest value of M", |it| {
            it.mean + it.extremes()[1]
        }),
        Of::value(
            "simple_zeros",
            "",
            "true if M has simple zeros: the manifolds cross; null at the threshold",
            |it| it.has_simple_zeros().into(),
        ),
        Of::nullable(
            "threshold_factor",
            "1",
            "factor of the phase-dependent part above which there are simple zeros, or null where there is none",
            |it| Some(it.threshold_factor()).filter(|factor| factor.is_finite()),
        ),
        Of::value(
            "zeros_rad[]",
            "rad",
            "phases of the drive at the passage of the bottom at which M vanishes",
            |it| json::list(it.zeros().into_iter().map(|(phase, _)| json::number(phase))),
        ),
    ])
}

fn of_harmonic() -> Fields<MelnikovHarmonic> {
    type Of = Field<MelnikovHarmonic>;
    Fields::from([
        Of::value("n", "1", "number of the harmonic of the drive", |it| it.number.into()),
        Of::number("cosine_rad2_per_s2", "rad²/s²", "coefficient of cos(n*phase)", |it| it.value.re),
        Of::number("sine_rad2_per_s2", "rad²/s²", "coefficient of sin(n*phase)", |it| -it.value.im),
        Of::number("error_rad2_per_s2", "rad²/s²", "bound on their error", |it| it.error),
    ])
}

pub(super) fn of_crossing() -> Fields<Crossing> {
    type Of = Field<Crossing>;
    Fields::from([
        Of::number("direction", "", "1 on the separatrix where the angle grows, -1 on the other", |it| {
            it.threshold.direction
        })
        .words("separatrix", |it| separatrix(it.threshold.direction).to_owned()),
        Of::number("value", "", "value of the parameter at which simple zeros appear or vanish", |it| {
            it.threshold.value
        })
        .rounded("threshold", 16),
        Of::number("error", "", "bound on the error of that value as a first-order threshold", |it| {
            it.threshold.error
        })
        .numeral("to", |it| at_most(it.threshold.error)),
        Of::value("above", "", "true if the manifolds cross above the value, false if below", |it| {
            it.threshold.above.into()
        })
        .words("manifolds cross", |it| if it.threshold.above { "above" } else { "below" }.to_owned()),
        Of::nullable("tangency", "", "value at which the manifolds themselves touch, or null", |it| {
            it.tangency.as_ref().ok().map(|it| it.value)
        })
        .rounded("they touch at", 14),
        Of::nullable("tangency_error", "", "its error, or null", |it| {
            it.tangency.as_ref().ok().map(|it| it.error)
        })
        .numeral("to", |it| it.tangency.as_ref().map_or_else(|_| String::new(), |it| at_most(it.error))),
        Of::nullable(
            "tangency_phase_rad",
            "rad",
            "phase of the drive at which the motion in both manifolds passes the bottom, or null",
            |it| it.tangency.as_ref().ok().map(|it| it.phase),
        ),
        Of::nullable("tangency_velocity_rad_per_s", "rad/s", "its velocity there, or null", |it| {
            it.tangency.as_ref().ok().map(|it| it.velocity)
        }),
        Of::nullable(
            "tangency_place_error",
            "",
            "error bound of phase and velocity there, in rad and rad/s, or null",
            |it| it.tangency.as_ref().ok().map(|it| it.place_error),
        ),
        Of::value("no_tangency", "", "reason why no tangency is known, or null", |it| {
            it.tangency.as_ref().err().map(ToString::to_string).into()
        }),
    ])
}

pub(super) fn of_resonance<'a>() -> Fields<Neighbours<'a>> {
    type Of<'a> = Field<Neighbours<'a>>;
    Fields::from([
        Of::value("motion_periods", "1", "p: periods or turns of the motion", |it| {
            it.own.motion_periods.into()
        }),
        Of::value("drive_periods", "1", "q: number of periods of the drive", |it| {
            it.own.drive_periods.into()
        })
        .words("p:q", |it| format!("{}:{}", it.own.motion_periods, it.own.drive_periods)),
        Of::value("regime", "", "libration or rotation", |it| it.own.motion.regime().to_string().into())
            .words("motion", |it| match it.own.direction {
                back if back < 0.0 => "rotation back".to_owned(),
                _ => it.own.motion.regime().to_string(),
            }),
        Of::number("direction", "", "1 or -1 for rotation, 0 for libration", |it| it.own.direction),
        Of::number("angular_frequency_rad_per_s", "rad/s", "frequency of the unperturbed motion", |it| {
            it.own.motion.frequency()
        })
        .rounded("frequency / (rad/s)", 8),
        Of::nullable("amplitude_rad", "rad", "its amplitude, null for rotation", |it| {
            it.own.motion.amplitude().map(|amplitude| amplitude.radians())
        })
        .degrees("amplitude / °", 7),
        Of::number("energy_ratio", "1", "its energy over that of the separatrix", |it| {
            it.own.motion.energy_ratio()
        }),
        Of::number("action_rad2_per_s", "rad²/s", "its action per m*l^2", |it| it.own.motion.action())
            .rounded("action / (rad²/s)", 8),
        Of::number("angular_frequency_slope", "1", "derivative of the frequency by the action", |it| {
            it.own.motion.frequency_slope()
        }),
        Of::number(
            "mean_power_rad2_per_s3",
            "rad²/s³",
            "energy per m*l^2 and time from the perturbation at any phase",
            |it| it.own.mean_power,
        ),
        Of::number("resonant_power_rad2_per_s3", "rad²/s³", "addition to it at the best phase", |it| {
            it.own.resonant_power
        }),
        Of::number("error_rad2_per_s3", "rad²/s³", "bound on the error of both powers", |it| it.own.error),
        Of::number(
            "half_width_rad2_per_s",
            "rad²/s",
            "half the width in the action, without damping",
            |it| it.own.half_width,
        )
        .rounded("half-width / (rad²/s)", 6),
        Of::number(
            "half_width_error_rad2_per_s",
            "rad²/s",
            "bound on the error of half_width as a first-order half-width",
            |it| it.own.half_width_error(),
        ),
        Of::number(
            "angular_frequency_half_width_rad_per_s",
            "rad/s",
            "half the width in the frequency",
            |it| it.own.half_width_in_frequency(),
        ),
        Of::number(
            "threshold_factor",
            "1",
            "factor of the drive above which it sustains the motion against the damping",
            |it| it.own.threshold_factor(),
        ),
        Of::nullable(
            "overlap",
            "1",
            "half-widths of this and the next resonance over their distance, or null for the last of a kind",
            Neighbours::overlap,
        )
        .rounded("overlap with the next", 4),
    ])
}

pub(super) fn separatrix(direction: f64) -> &'static str {
    if direction > 0.0 { "upper" } else { "lower" }
}

pub(crate) fn answers() -> Vec<Answers> {
    let json = [of_answer().described(""), of_resonance().described("resonances[].")].concat();
    vec![Answers { command: "melnikov", option: "", json, csv: of_resonance().described_in_csv() }]
}
