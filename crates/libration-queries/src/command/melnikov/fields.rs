//! Fields of a Melnikov function, its thresholds, and resonances.

use super::{Crossing, MelnikovResult};
use crate::output::description::Answers;
use crate::output::field::{Field, Fields};
use crate::output::json;
use crate::output::number::{at_most, short, to_its_error};
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
    pub(super) resonance: &'a DriveResonance,
    next: Option<&'a DriveResonance>,
}

impl MelnikovResult {
    pub(super) fn neighbours(&self) -> impl Iterator<Item = Neighbours<'_>> {
        let numbered = self.resonances.iter().enumerate();
        numbered.map(|(index, resonance)| Neighbours { resonance, next: self.resonances.get(index + 1) })
    }
}

impl Neighbours<'_> {
    pub(super) fn overlap(&self) -> Option<f64> {
        self.next.and_then(|next| self.resonance.overlap(next))
    }
}

pub(super) fn of_answer() -> Fields<MelnikovResult> {
    type Of = Field<MelnikovResult>;
    Fields::from([
        Of::value("system", "", "key of the system, null where its equations were typed", |result| {
            result.model.key().into()
        })
        .line_of("system", |result| result.model.title().to_owned()),
        Of::value("equation", "", "equation of motion as it was read", |result| {
            result.model.equation().to_string().into()
        })
        .line_of("equation", |result| result.model.equation().to_string()),
        Of::value("parameter", "", "name of the parameter of --over, or null", |result| {
            result.at.as_ref().map(|(name, _)| name.as_str()).into()
        }),
        Of::nullable(
            "value",
            "",
            "value of the parameter at which function and resonances are given, or null",
            |result| result.at.as_ref().map(|(_, value)| *value),
        )
        .line_of("at", |result| {
            result
                .at
                .as_ref()
                .map_or_else(String::new, |(name, value)| format!("{name} = {}", short(*value, 16)))
        }),
        Of::number("omega0_rad_per_s", "rad/s", "angular frequency of the smallest swings", |result| {
            result.pendulum.omega0()
        }),
        Of::number(
            "centre_rad",
            "rad",
            "angle at which the unperturbed pendulum hangs, from which the angles of motions are counted",
            |result| result.pendulum.centre(),
        ),
        Of::nullable(
            "drive_angular_frequency_rad_per_s",
            "rad/s",
            "angular frequency of the drive, or null without one",
            |result| result.pendulum.frequency(),
        )
        .line_of("frequencies", |result| {
            let drive = result.pendulum.frequency();
            let drive = drive.map_or_else(
                || "no drive".to_owned(),
                |frequency| format!("drive {} rad/s", short(frequency, 10)),
            );
            let elsewhere = match result.pendulum.centre() {
                0.0 => String::new(),
                centre => format!(", hangs at {} rad", short(centre, 10)),
            };
            format!("ω0 = {} rad/s, {drive}{elsewhere}", short(result.pendulum.omega0(), 10))
        }),
        Of::value(
            "closed_form",
            "",
            "true if the integrals are found by residues, false by quadrature",
            |result| result.pendulum.is_closed().into(),
        )
        .line_of("integrals", |result| {
            if result.pendulum.is_closed() { "in closed form, by residues" } else { "by quadrature" }
                .to_owned()
        }),
        Of::nested("separatrices[].", &of_separatrix(), |result| {
            of_separatrix().records(&result.separatrices)
        }),
        Of::nested("thresholds[].", &of_crossing(), |result| {
            of_crossing().records(result.thresholds.iter().flatten())
        }),
    ])
}

fn of_separatrix() -> Fields<Melnikov> {
    type Of = Field<Melnikov>;
    Fields::from([
        Of::number("direction", "", "1 where the angle grows, -1 on the other separatrix", |melnikov| {
            melnikov.direction
        }),
        Of::number(
            "mean_rad2_per_s2",
            "rad²/s²",
            "part of M that does not depend on the phase",
            |melnikov| melnikov.mean,
        ),
        Of::number("mean_error_rad2_per_s2", "rad²/s²", "bound on its error", |melnikov| {
            melnikov.mean_error
        }),
        Of::nested("harmonics[].", &of_harmonic(), |melnikov| {
            let terms = (1..).zip(&melnikov.harmonics).zip(&melnikov.harmonic_errors);
            let terms = terms.map(|((number, value), error)| MelnikovHarmonic {
                number,
                value: *value,
                error: *error,
            });
            of_harmonic().records(&terms.collect::<Vec<_>>())
        }),
        Of::number("minimum_rad2_per_s2", "rad²/s²", "least value of M", |melnikov| {
            melnikov.mean + melnikov.extremes()[0]
        }),
        Of::number("maximum_rad2_per_s2", "rad²/s²", "greatest value of M", |melnikov| {
            melnikov.mean + melnikov.extremes()[1]
        }),
        Of::value(
            "simple_zeros",
            "",
            "true if M has simple zeros: the manifolds cross; null at the threshold",
            |melnikov| melnikov.has_simple_zeros().into(),
        ),
        Of::nullable(
            "threshold_factor",
            "1",
            "factor of the phase-dependent part above which there are simple zeros, or null where there is none",
            |melnikov| Some(melnikov.threshold_factor()).filter(|factor| factor.is_finite()),
        ),
        Of::value(
            "zeros_rad[]",
            "rad",
            "phases of the drive at the passage of the bottom at which M vanishes",
            |melnikov| json::list(melnikov.zeros().into_iter().map(|(phase, _)| json::number(phase))),
        ),
    ])
}

fn of_harmonic() -> Fields<MelnikovHarmonic> {
    type Of = Field<MelnikovHarmonic>;
    Fields::from([
        Of::value("n", "1", "number of the harmonic of the drive", |harmonic| harmonic.number.into()),
        Of::number("cosine_rad2_per_s2", "rad²/s²", "coefficient of cos(n*phase)", |harmonic| {
            harmonic.value.re
        }),
        Of::number("sine_rad2_per_s2", "rad²/s²", "coefficient of sin(n*phase)", |harmonic| {
            -harmonic.value.im
        }),
        Of::number("error_rad2_per_s2", "rad²/s²", "bound on their error", |harmonic| harmonic.error),
    ])
}

pub(super) fn of_crossing() -> Fields<Crossing> {
    type Of = Field<Crossing>;
    Fields::from([
        Of::number(
            "direction",
            "",
            "1 on the separatrix where the angle grows, -1 on the other",
            |crossing| crossing.threshold.direction,
        )
        .words("separatrix", |crossing| separatrix(crossing.threshold.direction).to_owned()),
        Of::number(
            "value",
            "",
            "value of the parameter at which simple zeros appear or vanish",
            |crossing| crossing.threshold.value,
        )
        .numeral("threshold", |crossing| {
            to_its_error(crossing.threshold.value, crossing.threshold.error, 16)
        }),
        Of::number("error", "", "bound on the error of that value as a first-order threshold", |crossing| {
            crossing.threshold.error
        })
        .numeral("to", |crossing| at_most(crossing.threshold.error)),
        Of::value("above", "", "true if the manifolds cross above the value, false if below", |crossing| {
            crossing.threshold.above.into()
        })
        .words("manifolds cross", |crossing| {
            if crossing.threshold.above { "above" } else { "below" }.to_owned()
        }),
        Of::nullable("tangency", "", "value at which the manifolds themselves touch, or null", |crossing| {
            crossing.tangency.as_ref().ok().map(|tangency| tangency.value)
        })
        .numeral("they touch at", |crossing| {
            let tangency = crossing.tangency.as_ref();
            tangency
                .map_or_else(|_| String::new(), |tangency| to_its_error(tangency.value, tangency.error, 14))
        }),
        Of::nullable("tangency_error", "", "its error, or null", |crossing| {
            crossing.tangency.as_ref().ok().map(|tangency| tangency.error)
        })
        .numeral("to", |crossing| {
            crossing.tangency.as_ref().map_or_else(|_| String::new(), |tangency| at_most(tangency.error))
        }),
        Of::nullable(
            "tangency_phase_rad",
            "rad",
            "phase of the drive at which the motion in both manifolds passes the bottom, or null",
            |crossing| crossing.tangency.as_ref().ok().map(|tangency| tangency.phase),
        ),
        Of::nullable("tangency_velocity_rad_per_s", "rad/s", "its velocity there, or null", |crossing| {
            crossing.tangency.as_ref().ok().map(|tangency| tangency.velocity)
        }),
        Of::nullable(
            "tangency_place_error",
            "",
            "error bound of phase and velocity there, in rad and rad/s, or null",
            |crossing| crossing.tangency.as_ref().ok().map(|tangency| tangency.place_error),
        ),
        Of::value("no_tangency", "", "reason why no tangency is known, or null", |crossing| {
            crossing.tangency.as_ref().err().map(ToString::to_string).into()
        }),
    ])
}

pub(super) fn of_resonance<'a>() -> Fields<Neighbours<'a>> {
    type Of<'a> = Field<Neighbours<'a>>;
    Fields::from([
        Of::value("motion_periods", "1", "p: periods or turns of the motion", |neighbours| {
            neighbours.resonance.motion_periods.into()
        }),
        Of::value("drive_periods", "1", "q: number of periods of the drive", |neighbours| {
            neighbours.resonance.drive_periods.into()
        })
        .words("p:q", |neighbours| {
            format!("{}:{}", neighbours.resonance.motion_periods, neighbours.resonance.drive_periods)
        }),
        Of::value("regime", "", "libration or rotation", |neighbours| {
            neighbours.resonance.motion.regime().to_string().into()
        })
        .words("motion", |neighbours| match neighbours.resonance.direction {
            back if back < 0.0 => "rotation back".to_owned(),
            _ => neighbours.resonance.motion.regime().to_string(),
        }),
        Of::number("direction", "", "1 or -1 for rotation, 0 for libration", |neighbours| {
            neighbours.resonance.direction
        }),
        Of::number(
            "angular_frequency_rad_per_s",
            "rad/s",
            "frequency of the unperturbed motion",
            |neighbours| neighbours.resonance.motion.frequency(),
        )
        .rounded("frequency / (rad/s)", 8),
        Of::nullable("amplitude_rad", "rad", "its amplitude, null for rotation", |neighbours| {
            neighbours.resonance.motion.amplitude().map(|amplitude| amplitude.radians())
        })
        .degrees("amplitude / °", 7),
        Of::number("energy_ratio", "1", "its energy over that of the separatrix", |neighbours| {
            neighbours.resonance.motion.energy_ratio()
        }),
        Of::number("action_rad2_per_s", "rad²/s", "its action per m*l^2", |neighbours| {
            neighbours.resonance.motion.action()
        })
        .rounded("action / (rad²/s)", 8),
        Of::number(
            "angular_frequency_slope",
            "1",
            "derivative of the frequency by the action",
            |neighbours| neighbours.resonance.motion.frequency_slope(),
        ),
        Of::number(
            "mean_power_rad2_per_s3",
            "rad²/s³",
            "energy per m*l^2 and time from the perturbation at any phase",
            |neighbours| neighbours.resonance.mean_power,
        ),
        Of::number(
            "resonant_power_rad2_per_s3",
            "rad²/s³",
            "addition to it at the best phase",
            |neighbours| neighbours.resonance.resonant_power,
        ),
        Of::number("error_rad2_per_s3", "rad²/s³", "bound on the error of both powers", |neighbours| {
            neighbours.resonance.error
        }),
        Of::number(
            "half_width_rad2_per_s",
            "rad²/s",
            "half the width in the action, without damping",
            |neighbours| neighbours.resonance.half_width,
        )
        .rounded("half-width / (rad²/s)", 6),
        Of::number(
            "half_width_error_rad2_per_s",
            "rad²/s",
            "bound on the error of half_width as a first-order half-width",
            |neighbours| neighbours.resonance.half_width_error(),
        ),
        Of::number(
            "angular_frequency_half_width_rad_per_s",
            "rad/s",
            "half the width in the frequency",
            |neighbours| neighbours.resonance.half_width_in_frequency(),
        ),
        Of::number(
            "threshold_factor",
            "1",
            "factor of the drive above which it sustains the motion against the damping",
            |neighbours| neighbours.resonance.threshold_factor(),
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
