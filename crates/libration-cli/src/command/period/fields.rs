//! Fields of a swing, and of each formula for its period.

use crate::arguments::PendulumOptions;
use crate::output::description::Answers;
use crate::output::field::{Field, Fields};
use crate::output::number;
use libration::pendulum::{Amplitude, Pendulum, SwingPeriod};
use libration::period_formulas::PeriodFormula;

/// A pendulum released at an amplitude.
#[derive(Clone, Copy, Debug)]
pub(super) struct Swing {
    pub(super) amplitude: Amplitude,
    pub(super) small_angle_period: f64,
    pub(super) exact: SwingPeriod,
}

impl Swing {
    pub(super) fn new(amplitude: Amplitude, pendulum: &Pendulum) -> Self {
        let small_angle_period = pendulum.small_angle_period();
        Self { amplitude, small_angle_period, exact: pendulum.swing_period(&amplitude) }
    }

    /// The swings of many amplitudes.
    pub(super) fn all(amplitudes: &[Amplitude], pendulum: &Pendulum) -> Vec<Self> {
        let small_angle_period = pendulum.small_angle_period();
        let mut exact = vec![SwingPeriod::default(); amplitudes.len()];
        pendulum.swing_periods(amplitudes, &mut exact).expect("there is one for each");
        let swing = |(&amplitude, exact)| Self { amplitude, small_angle_period, exact };
        amplitudes.iter().zip(exact).map(swing).collect()
    }
}

/// The period of a swing by one formula.
#[derive(Clone, Copy, Debug)]
pub(super) struct Estimate<'a> {
    pub(super) formula: &'a PeriodFormula,
    pub(super) period: f64,
    pub(super) ratio: f64,
    pub(super) fractional_error: f64,
}

pub(super) const SMALL_ANGLE_PERIOD: &str = "small-angle period T₀";
pub(super) const DIGITS: usize = 15;

pub(super) fn of_swing() -> Fields<Swing> {
    type Of = Field<Swing>;
    Fields::from([
        Of::number("amplitude_rad", "rad", "amplitude", |it| it.amplitude.radians())
            .numeral("θ₀ / °", |it| number::short(it.amplitude.angle().degrees(), 12))
            .line_of("amplitude θ₀", |it| {
                let radians = number::rounded(it.amplitude.radians(), DIGITS);
                format!("{radians} rad = {}°", number::short(it.amplitude.angle().degrees(), 12))
            }),
        Of::number("complement_rad", "rad", "π minus the amplitude", |it| it.amplitude.complement())
            .rounded("π − θ₀ / rad", 8)
            .line("π − θ₀", DIGITS),
        Of::number("small_angle_period_s", "s", "period of small swings, 2π√(l/g)", |it| {
            it.small_angle_period
        })
        .line(SMALL_ANGLE_PERIOD, DIGITS),
        Of::number("period_s", "s", "exact period at this amplitude", |it| it.exact.period)
            .rounded("T / s", 12)
            .line("exact period T", DIGITS),
        Of::number("frequency_hz", "Hz", "reciprocal of the exact period", |it| it.exact.period.recip())
            .only_json()
            .line("frequency 1/T", DIGITS),
        Of::number("ratio", "1", "exact period over the small-angle period", |it| it.exact.ratio)
            .rounded("T/T₀", 12)
            .line("T/T₀", DIGITS),
        Of::number("excess", "1", "that ratio minus 1, without cancellation", |it| it.exact.excess)
            .rounded("T/T₀ − 1", 12)
            .line("excess T/T₀ − 1", DIGITS),
        Of::number("nome", "1", "nome q of the elliptic functions of the motion", |it| it.exact.nome)
            .line("nome q", DIGITS),
        Of::number(
            "condition",
            "1",
            "relative change of the period per relative change of the amplitude",
            |it| it.exact.condition,
        )
        .line_of("condition", |it| {
            let condition = number::rounded(it.exact.condition, 6);
            format!("{condition} (relative change of T per relative change of θ₀)")
        }),
    ])
}

pub(super) fn of_formula<'a>() -> Fields<Estimate<'a>> {
    type Of<'a> = Field<Estimate<'a>>;
    Fields::from([
        Of::value("key", "", "short name of the formula", |it| it.formula.key().into())
            .only_json()
            .words("key", |it| it.formula.key().to_owned()),
        Of::number("ratio", "1", "period over the small-angle period by this formula", |it| it.ratio)
            .in_csv_as("KEY_ratio"),
        Of::number("period_s", "s", "period by this formula", |it| it.period)
            .only_json()
            .rounded("T / s", 12),
        Of::number("fractional_error", "1", "period by this formula over the exact one, minus 1", |it| {
            it.fractional_error
        })
        .in_csv_as("KEY_fractional_error")
        .rounded("error", 3),
        Of::unnamed().words("formula", |it| it.formula.name().to_owned()),
    ])
}

pub(crate) fn answers() -> Vec<Answers> {
    let json = [
        PendulumOptions::fields().described(""),
        of_swing().described("results[]."),
        of_formula().described("results[].formulas[]."),
    ];
    let csv = [of_swing().described_in_csv(), of_formula().described_in_csv()];
    vec![Answers { command: "period", option: "", json: json.concat(), csv: csv.concat() }]
}
