//! Fields of an orbit, and of each of its harmonics.

use super::OrbitResult;
use crate::output::description::Answers;
use crate::output::field::{Field, Fields};
use crate::output::json;
use crate::output::number::{at_most, rounded, to_its_error};
use libration::algebra::Complex;
use libration::orbit::{Floquet, Harmonic, OrbitKind, Stability};
use serde_json::Value;

/// One harmonic of one coordinate.
pub(super) struct HarmonicTerm<'a> {
    pub(super) coordinate: &'a str,
    pub(super) term: Harmonic,
    pub(super) remainder: f64,
    pub(super) error: f64,
}

impl OrbitResult {
    pub(super) fn terms(&self) -> impl Iterator<Item = HarmonicTerm<'_>> {
        let all = self.model.coordinates().iter().zip(&self.harmonics);
        all.flat_map(|(coordinate, harmonics)| {
            let (name, remainder, error) = (coordinate.name.as_str(), harmonics.remainder, harmonics.error);
            harmonics.terms.iter().map(move |&term| HarmonicTerm { coordinate: name, term, remainder, error })
        })
    }

    fn numbers(&self) -> usize {
        self.model.layout().numbers()
    }

    fn multipliers(&self) -> &[Complex] {
        self.orbit.floquet().map_or(&[], |floquet| &floquet.multipliers)
    }
}

pub(super) fn of_orbit() -> Fields<OrbitResult> {
    type Of = Field<OrbitResult>;
    Fields::from([
        Of::value("system", "", "key of the system, null where its equations were typed", |result| {
            result.model.key().into()
        })
        .line_of("system", |result| result.model.title().to_owned()),
        Of::value("equation", "", "equations of motion as they were read", |result| {
            result.model.equation().to_string().into()
        })
        .line_of("equation", |result| result.model.equation().to_string()),
        Of::value(
            "kind",
            "",
            "released, limit_cycle, passed (unstable; no cycle was found to which the motion settles), driven, family or near",
            |result| kind(result.kind)[0].into(),
        )
        .line_of("orbit", |result| kind(result.kind)[1].to_owned()),
        Of::number("period_s", "s", "period", |result| result.orbit.period()).line_of("period", period),
        Of::number(
            "period_uncertainty_s",
            "s",
            "bound on its error, 0 where the drive sets it, null where the equations do not determine it",
            |result| result.orbit.period_uncertainty(),
        ),
        Of::number("angular_frequency_rad_per_s", "rad/s", "2π over the period", |result| result.orbit.frequency())
            .line_of("angular frequency", angular_frequency),
        Of::value("state[]", "", "names of the state variables", |result| json::list(result.model.state_names())),
        Of::value("start[]", "", "state at the start of the orbit, in the order of those names", |result| {
            json::numbers(&result.orbit.start())
        })
        .line_of("start", start),
        Of::value("start_error[]", "", "errors of the start, 0 where it is given", |result| {
            json::numbers(result.orbit.start_errors())
        }),
        Of::value(
            "closing_error[]",
            "",
            "closing error of each state component after a period",
            |result| json::numbers(&result.orbit.closing_error()),
        )
        .line_of("closes to", |result| {
            at_most(result.orbit.closing_error().into_iter().fold(f64::EPSILON, f64::max))
        }),
        Of::value("minimum[]", "", "minimum of each component of the state", |result| {
            json::list((0..result.numbers()).map(|number| json::number(result.orbit.range(number).0)))
        }),
        Of::value("maximum[]", "", "maximum of each component of the state", |result| {
            json::list((0..result.numbers()).map(|number| json::number(result.orbit.range(number).1)))
        }),
        Of::value(
            "state_error[]",
            "",
            "largest error of each component on the orbit, at the same part of the period; that of minimum and maximum",
            |result| json::numbers(result.orbit.state_errors()),
        ),
        Of::value(
            "multipliers[][]",
            "1",
            "Floquet multipliers by descending magnitude, real and imaginary part",
            |result| json::list(result.multipliers().iter().map(pair)),
        ),
        Of::value("multiplier_errors[]", "1", "errors of the multipliers, in their order", |result| {
            json::numbers(result.orbit.floquet().map_or(&[], |floquet| &floquet.errors))
        }),
        Of::value(
            "stability",
            "",
            "attracting, neutral, unstable or undetermined (within the errors of the multipliers); null where it was not requested",
            |result| result.orbit.floquet().map(|floquet| floquet.stability.name()).into(),
        )
        .line_of("stability", stability),
        Of::present(
            "multiplier_logarithm",
            "1",
            "logarithm of the multiplier of a cycle of one coordinate, which may be below the range of numbers",
            |result| result.orbit.floquet().and_then(|floquet| floquet.logarithm),
        ),
    ])
}

pub(super) fn of_term<'a>() -> Fields<HarmonicTerm<'a>> {
    type Of<'a> = Field<HarmonicTerm<'a>>;
    Fields::from([
        Of::value("coordinate", "", "coordinate it belongs to", |term| term.coordinate.into())
            .words("coordinate", |term| term.coordinate.to_owned()),
        Of::value("n", "1", "number of the harmonic, 0 for the mean", |term| term.term.n.into())
            .numeral("n", |term| term.term.n.to_string()),
        Of::number(
            "cosine",
            "",
            "coefficient of cos nΩt, the time counted from the start; the mean for n = 0",
            |term| term.term.cosine,
        )
        .numeral("cosine", |term| to_its_error(term.term.cosine, term.error, 12)),
        Of::number("sine", "", "coefficient of sin nΩt", |term| term.term.sine)
            .numeral("sine", |term| to_its_error(term.term.sine, term.error, 12)),
        Of::number("amplitude", "", "√(cosine² + sine²)", |term| term.term.amplitude())
            .numeral("amplitude", |term| to_its_error(term.term.amplitude(), term.error, 6)),
        Of::number("error", "", "error of cosine and sine", |term| term.error)
            .numeral("to", |term| at_most(term.error)),
        Of::number("remainder", "", "upper bound on the omitted harmonics of the coordinate", |term| {
            term.remainder
        }),
    ])
}

pub(crate) fn answers() -> Vec<Answers> {
    let json = [of_orbit().described(""), of_term().described("harmonics[].")].concat();
    vec![Answers { command: "orbit", option: "", json, csv: of_term().described_in_csv() }]
}

/// The kind of an orbit as a value of its field, and in words.
fn kind(kind: OrbitKind) -> [&'static str; 2] {
    match kind {
        OrbitKind::Released => ["released", "released from rest"],
        OrbitKind::LimitCycle => ["limit_cycle", "a limit cycle"],
        OrbitKind::Passed => {
            ["passed", "an unstable cycle that the motion passes; it settles to none that was found"]
        }
        OrbitKind::Driven => ["driven", "the response to the drive"],
        OrbitKind::Family => ["family", "one of a family, through the start"],
        OrbitKind::Near => ["near", "closed near the guess"],
    }
}

fn in_words(stability: Stability) -> &'static str {
    match stability {
        Stability::Attracting => "stable: all deviations die out",
        Stability::Neutral => "neutral: no deviation grows exponentially, some stay",
        Stability::Unstable => "unstable: deviations grow",
        Stability::Undetermined => "undetermined: a multiplier is on the unit circle within its error",
    }
}

fn period(answer: &OrbitResult) -> String {
    let (period, uncertainty) = (answer.orbit.period(), answer.orbit.period_uncertainty());
    if answer.kind == OrbitKind::Driven {
        return format!("{} s, set by the drive", rounded(period, 15));
    }
    if uncertainty.is_nan() {
        return format!("about {} s, of an error that the equations do not determine", rounded(period, 4));
    }
    format!("{} s, to {}", to_its_error(period, uncertainty, 15), at_most(uncertainty))
}

fn angular_frequency(answer: &OrbitResult) -> String {
    let relative = answer.orbit.period_uncertainty() / answer.orbit.period();
    let frequency = answer.orbit.frequency();
    match relative.is_nan() {
        true => format!("about {} rad/s", rounded(frequency, 4)),
        false => format!("{} rad/s", to_its_error(frequency, relative * frequency, 15)),
    }
}

fn start(answer: &OrbitResult) -> String {
    let names = answer.model.state_names();
    let values = answer.orbit.start();
    let errors = answer.orbit.start_errors();
    let components = names.iter().zip(&values).zip(errors);
    let told =
        components.map(|((name, value), error)| format!("{name} = {}", to_its_error(*value, *error, 14)));
    let largest = errors.iter().copied().fold(0.0, f64::max);
    let to = if largest > 0.0 { format!("; to {}", at_most(largest)) } else { String::new() };
    told.collect::<Vec<_>>().join(", ") + &to
}

fn stability(answer: &OrbitResult) -> String {
    let Some(floquet) = answer.orbit.floquet() else {
        return crate::call::in_words("not computed for a release from rest: give a guess with <--period>");
    };
    format!("{}; Floquet multipliers {}", in_words(floquet.stability), listed(floquet))
}

fn listed(floquet: &Floquet) -> String {
    let one = |(multiplier, error): (&Complex, &f64)| {
        let part = |x: f64| to_its_error(x, *error, 10);
        match multiplier.im {
            im if im.abs() > *error => {
                format!("{} {} {}i", part(multiplier.re), if im > 0.0 { '+' } else { '−' }, part(im.abs()))
            }
            _ => part(multiplier.re),
        }
    };
    floquet.multipliers.iter().zip(&floquet.errors).map(one).collect::<Vec<_>>().join(", ")
}

fn pair(number: &Complex) -> Value {
    json::numbers(&[number.re, number.im])
}
