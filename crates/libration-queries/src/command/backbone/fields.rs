//! Fields of a backbone, and of each of its points.

use super::BackboneResult;
use crate::output::description::Answers;
use crate::output::field::{Field, Fields};
use crate::output::json;
use crate::output::number::{at_most, rounded, short, to_its_error};
use crate::output::series::{certainty, radius_certainty};
use libration::comparison::{BackbonePoint, ExactValue, OrbitFrequency};

/// A point of the backbone of a result.
pub(super) struct Point<'a> {
    answer: &'a BackboneResult,
    pub(super) point: &'a BackbonePoint,
}

impl BackboneResult {
    pub(super) fn listed(&self) -> impl Iterator<Item = Point<'_>> {
        self.points.iter().map(|point| Point { answer: self, point })
    }

    /// An amplitude as printed, in degrees if it is an angle.
    pub(super) fn amplitude_text(&self, amplitude: f64, digits: usize) -> String {
        if self.is_angle() {
            format!("{}°", short(amplitude.to_degrees(), digits))
        } else {
            short(amplitude, digits)
        }
    }
}

pub(super) fn of_backbone() -> Fields<BackboneResult> {
    type Of = Field<BackboneResult>;
    Fields::from([
        Of::value("oscillator", "", "key of the oscillator, null where its equation was typed", |result| {
            result.asked.key.into()
        })
        .line_of("oscillator", |result| result.asked.title.clone()),
        Of::value("equation", "", "equation of motion", |result| result.asked.equation.to_string().into())
            .line_of("equation", |result| result.asked.equation.to_string()),
        Of::value("parameters.NAME", "", "value of the parameter with this name, as text", |result| {
            json::object(result.asked.values.iter().cloned())
        }),
        Of::value("order", "1", "order of the perturbation series", |result| result.order.into()),
        Of::number("centre", "", "equilibrium that amplitudes are measured from", |result| {
            result.curve.centre()
        }),
        Of::value(
            "centre_is_equilibrium",
            "",
            "true if it is a stable equilibrium; if false, amplitudes are measured from 0",
            |result| result.curve.has_equilibrium().into(),
        ),
        Of::known(
            "omega0_rad_per_s",
            "rad/s",
            "angular frequency of small oscillations, or null",
            |result| result.curve.omega0().ok_or_else(|| no_series(result).unwrap_or_default()),
        ),
        Of::value("no_series", "", "reason why there is no series, or null", |result| {
            no_series(result).into()
        }),
        Of::present("series_radius", "", "amplitude below which the series converges", |result| {
            result.curve.radius().map(|radius| radius.value())
        }),
        Of::present_value("series_radius_is", "", "proven or estimated", |result| {
            result.curve.radius().map(|radius| certainty(radius_certainty(&radius)).into())
        }),
        Of::present_value(
            "interrupted",
            "",
            "true where Ctrl-C ended the work before the last amplitude, else left out",
            |result| result.interruption().map(|_| true.into()),
        ),
    ])
}

fn no_series(answer: &BackboneResult) -> Option<String> {
    answer.curve.no_series().map(ToString::to_string)
}

pub(super) const ORBIT: [&str; 3] = ["amplitude", "Ω by orbit", "uncertain by"];
pub(super) const SERIES: [&str; 2] = ["Ω by series", "its error"];
pub(super) const EXACT: &str = "Ω exactly";

pub(super) fn of_point<'a>() -> Fields<Point<'a>> {
    type Of<'a> = Field<Point<'a>>;
    Fields::from([
        Of::number("amplitude", "", "amplitude, in rad for angles", |point| point.point.amplitude)
            .numeral(ORBIT[0], |point| point.answer.amplitude_text(point.point.amplitude, 10)),
        Of::nullable("angular_frequency_rad_per_s", "rad/s", "angular frequency by the orbit, or null", |point| {
            point.orbit().map(|orbit| orbit.frequency)
        })
        .numeral(ORBIT[1], |point| {
            let frequency = |orbit: &OrbitFrequency| to_its_error(orbit.frequency, orbit.uncertainty, 15);
            point.orbit().map_or_else(|| "none".to_owned(), frequency)
        }),
        Of::present("angular_frequency_uncertainty_rad_per_s", "rad/s", "bound on the error of that frequency", |point| {
            point.orbit().map(|orbit| orbit.uncertainty)
        })
        .numeral(ORBIT[2], |point| point.orbit().map_or_else(String::new, |orbit| at_most(orbit.uncertainty))),
        Of::present(
            "other_turning_point",
            "",
            "displacement from the centre at the other turning point",
            |point| point.orbit().map(|orbit| orbit.other_side),
        ),
        Of::present_value("encloses", "", "another equilibrium that the orbit encloses, or null", |point| {
            point.orbit().map(|orbit| orbit.encloses.map(json::number).into())
        })
        .only_json(),
        Of::present_value("no_orbit", "", "reason why there is no orbit", |point| {
            point.point.orbit.as_ref().err().map(|reason| reason.to_string().into())
        })
        .only_json(),
        Of::nullable("series_angular_frequency_rad_per_s", "rad/s", "angular frequency by the perturbation series, or null", |point| {
            point.point.series.as_ref().map(|series| series.frequency)
        })
        .rounded(SERIES[0], 15)
        .or("none"),
        Of::unnamed().numeral(SERIES[1], error),
        Of::present_value(
            "series_remainder_rad_per_s",
            "rad/s",
            "bound on the remainder of the series, or an estimate of it, too small in about 1 of 100 cases; or null",
            |point| point.point.series.as_ref().map(|series| json::number(series.remainder.size)),
        )
        .only_json(),
        Of::present_value("series_remainder_is", "", "proven or estimated", |point| {
            point.point.series.as_ref().map(|series| certainty(series.remainder.certainty).into())
        })
        .only_json(),
        Of::note(enclosing),
        Of::known(
            "exact",
            "rad/s",
            "angular frequency of the pendulum by elliptic integrals, else null",
            |point| match &point.point.exact {
                Some(exact) => exact.as_ref().map(|exact| exact.value).map_err(ToString::to_string),
                None => Err(String::new()),
            },
        )
        .rounded(EXACT, 15)
        .or("none"),
        Of::present("exact_uncertainty", "rad/s", "bound on the error of that frequency", |point| {
            point.exact().map(|exact| exact.uncertainty)
        }),
    ])
}

pub(crate) fn answers() -> Vec<Answers> {
    let json = [of_backbone().described(""), of_point().described("points[].")].concat();
    vec![Answers { command: "backbone", option: "", json, csv: of_point().described_in_csv() }]
}

impl Point<'_> {
    fn orbit(&self) -> Option<&OrbitFrequency> {
        self.point.orbit.as_ref().ok()
    }

    pub(super) fn exact(&self) -> Option<&ExactValue> {
        self.point.exact.as_ref()?.as_ref().ok()
    }

    /// Another equilibrium that the orbit encloses.
    pub(super) fn encloses(&self) -> Option<f64> {
        self.orbit()?.encloses
    }
}

fn enclosing(point: &Point<'_>) -> Option<String> {
    let equilibrium = short(point.encloses()?, 6);
    Some(format!(
        "the orbit also encloses the equilibrium at {equilibrium}, so that the series does not apply"
    ))
}

/// The distance of the series from the exact value, or else from the orbit.
fn error(point: &Point<'_>) -> String {
    let orbit = point.orbit().map(|orbit| (orbit.frequency, orbit.uncertainty));
    let best = point.exact().map(|exact| (exact.value, exact.uncertainty)).or(orbit);
    match (&point.point.series, best) {
        (Some(series), Some((value, uncertainty))) if (series.frequency - value).abs() <= uncertainty => {
            format!("below {}", at_most(uncertainty))
        }
        (Some(series), Some((value, _))) => rounded(series.frequency - value, 2),
        _ => "unknown".to_owned(),
    }
}
