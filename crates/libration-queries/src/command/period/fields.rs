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
    /// The uncertainty of the amplitude, in radians, if it follows from a period.
    pub(super) uncertainty: Option<f64>,
    pub(super) small_angle_period: f64,
    pub(super) exact: SwingPeriod,
}

impl Swing {
    pub(super) fn new((amplitude, uncertainty): (Amplitude, Option<f64>), pendulum: &Pendulum) -> Self {
        let small_angle_period = pendulum.small_angle_period();
        Self { amplitude, uncertainty, small_angle_period, exact: pendulum.swing_period(&amplitude) }
    }

    /// An angle of the swing in radians, to the second digit of its uncertainty.
    fn radians(&self, angle: f64) -> String {
        match self.uncertainty {
            Some(uncertainty) => number::to_its_error(angle, uncertainty / 10.0, DIGITS),
            None => number::rounded(angle, DIGITS),
        }
    }

    /// The swings of many amplitudes.
    pub(super) fn all(given: &[(Amplitude, Option<f64>)], pendulum: &Pendulum) -> Vec<Self> {
        let small_angle_period = pendulum.small_angle_period();
        let amplitudes: Vec<Amplitude> = given.iter().map(|(amplitude, _)| *amplitude).collect();
        let mut exact = vec![SwingPeriod::default(); amplitudes.len()];
        pendulum.swing_periods(&amplitudes, &mut exact).expect("there is one for each");
        let swing =
            |(&(amplitude, uncertainty), exact)| Self { amplitude, uncertainty, small_angle_period, exact };
        given.iter().zip(exact).map(swing).collect()
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

/// The fields of a swing, with the uncertainty of an amplitude that follows from a period.
pub(super) fn of_swing(is_of_period: bool) -> Fields<Swing> {
    type Of = Field<Swing>;
    let uncertainty = Of::present(
        "amplitude_uncertainty_rad",
        "rad",
        "uncertainty of an amplitude that follows from a period: from the period's, or else from its rounding",
        |swing| swing.uncertainty,
    )
    .rounded("u(θ₀) / rad", 2)
    .line_of("uncertainty of θ₀", |swing| {
        let uncertainty = swing.uncertainty.unwrap_or(0.0);
        let [radians, degrees] = [uncertainty, uncertainty.to_degrees()].map(|angle| number::rounded(angle, 2));
        format!("{radians} rad = {degrees}°")
    });
    let amplitude = Fields::from([
        Of::number("amplitude_rad", "rad", "amplitude", |swing| swing.amplitude.radians())
            .numeral("θ₀ / °", |swing| number::short(swing.amplitude.angle().degrees(), 12))
            .line_of("amplitude θ₀", |swing| {
                let degrees = swing.amplitude.angle().degrees();
                let degrees = match swing.uncertainty {
                    Some(error) => number::to_its_error(degrees, error.to_degrees() / 10.0, 12),
                    None => number::short(degrees, 12),
                };
                format!("{} rad = {degrees}°", swing.radians(swing.amplitude.radians()))
            }),
        Of::number("complement_rad", "rad", "π minus the amplitude", |swing| swing.amplitude.complement())
            .rounded("π − θ₀ / rad", 8)
            .line_of("π − θ₀", |swing| swing.radians(swing.amplitude.complement())),
    ]);
    let amplitude = if is_of_period { amplitude.and([uncertainty]) } else { amplitude };
    amplitude.and([
        Of::number("small_angle_period_s", "s", "period of small swings, 2π√(l/g)", |swing| {
            swing.small_angle_period
        })
        .line(SMALL_ANGLE_PERIOD, DIGITS),
        Of::number("period_s", "s", "exact period at this amplitude", |swing| swing.exact.period)
            .rounded("T / s", 12)
            .line("exact period T", DIGITS),
        Of::number("frequency_hz", "Hz", "reciprocal of the exact period", |swing| {
            swing.exact.period.recip()
        })
        .only_json()
        .line("frequency 1/T", DIGITS),
        Of::number("ratio", "1", "exact period over the small-angle period", |swing| swing.exact.ratio)
            .rounded("T/T₀", 12)
            .line("T/T₀", DIGITS),
        Of::number("excess", "1", "that ratio minus 1, without cancellation", |swing| swing.exact.excess)
            .rounded("T/T₀ − 1", 12)
            .line("excess T/T₀ − 1", DIGITS),
        Of::number("nome", "1", "nome q of the elliptic functions of the motion", |swing| swing.exact.nome)
            .line("nome q", DIGITS),
        Of::number(
            "condition",
            "1",
            "relative change of the period per relative change of the amplitude",
            |swing| swing.exact.condition,
        )
        .line_of("condition", |swing| {
            let condition = number::rounded(swing.exact.condition, 6);
            format!("{condition} (relative change of T per relative change of θ₀)")
        }),
    ])
}

pub(super) fn of_formula<'a>() -> Fields<Estimate<'a>> {
    type Of<'a> = Field<Estimate<'a>>;
    Fields::from([
        Of::value("key", "", "short name of the formula", |estimate| estimate.formula.key().into())
            .only_json()
            .words("key", |estimate| estimate.formula.key().to_owned()),
        Of::number("ratio", "1", "period over the small-angle period by this formula", |estimate| {
            estimate.ratio
        })
        .in_csv_as("KEY_ratio"),
        Of::number("period_s", "s", "period by this formula", |estimate| estimate.period)
            .only_json()
            .rounded("T / s", 12),
        Of::number(
            "fractional_error",
            "1",
            "period by this formula over the exact one, minus 1",
            |estimate| estimate.fractional_error,
        )
        .in_csv_as("KEY_fractional_error")
        .rounded("error", 3),
        Of::unnamed().words("formula", |estimate| estimate.formula.name().to_owned()),
    ])
}

pub(crate) fn answers() -> Vec<Answers> {
    let json = [
        PendulumOptions::fields().described(""),
        of_swing(true).described("results[]."),
        of_formula().described("results[].formulas[]."),
    ];
    let csv = [of_swing(true).described_in_csv(), of_formula().described_in_csv()];
    vec![Answers { command: "period", option: "", json: json.concat(), csv: csv.concat() }]
}
