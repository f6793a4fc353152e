//! What is said of an orbit, and of each of its harmonics.

use super::Answer;
use crate::output::description::Answers;
use crate::output::field::{Field, Fields};
use crate::output::json;
use crate::output::number::{at_most, rounded, to_its_error};
use libration::algebra::Complex;
use libration::orbit::{Floquet, Harmonic, OrbitKind, Stability};
use serde_json::Value;

/// One harmonic of one coordinate.
pub(super) struct Term<'a> {
    pub(super) coordinate: &'a str,
    pub(super) term: Harmonic,
    pub(super) remainder: f64,
}

impl Answer {
    pub(super) fn terms(&self) -> impl Iterator<Item = Term<'_>> {
        let all = self.model.coordinates().iter().zip(&self.harmonics);
        all.flat_map(|(coordinate, harmonics)| {
            let (name, remainder) = (coordinate.name.as_str(), harmonics.remainder);
            harmonics.terms.iter().map(move |&term| Term { coordinate: name, term, remainder })
        })
    }

    fn numbers(&self) -> usize {
        self.model.layout().numbers()
    }

    fn multipliers(&self) -> &[Complex] {
        self.orbit.floquet().map_or(&[], |floquet| &floquet.multipliers)
    }
}

pub(super) fn of_orbit() -> Fields<Answer> {
    type Of = Field<Answer>;
    Fields::from([
        Of::value("system", "", "key of the system, null where its equations were typed", |it| {
            it.model.key().into()
        })
        .line_of("system", |it| it.model.title().to_owned()),
        Of::value("equation", "", "equations of motion as they were understood", |it| {
            it.model.equation().to_string().into()
        })
        .line_of("equation", |it| it.model.equation().to_string()),
        Of::value("kind", "", "released, limit_cycle, driven, family or near", |it| kind(it.kind)[0].into())
            .line_of("orbit", |it| kind(it.kind)[1].to_owned()),
        Of::number("period_s", "s", "period", |it| it.orbit.period()).line_of("period", period),
        Of::number(
            "period_uncertainty_s",
            "s",
            "bound on its error, 0 where the drive sets it, null where the equations leave it open",
            |it| it.orbit.period_uncertainty(),
        ),
        Of::number("frequency", "rad/s", "2π over the period", |it| it.orbit.frequency())
            .line("angular frequency", 15),
        Of::value("state[]", "", "names of the state variables", |it| json::list(it.model.state_names())),
        Of::value("start[]", "", "state at the start of the orbit, in the order of those names", |it| {
            json::numbers(&it.orbit.start())
        })
        .line_of("start", start),
        Of::value(
            "closing_error[]",
            "",
            "how far each number of the state misses its start after a period",
            |it| json::numbers(&it.orbit.closing_error()),
        )
        .line_of("closes to", |it| {
            at_most(it.orbit.closing_error().into_iter().fold(f64::EPSILON, f64::max))
        }),
        Of::value(
            "minimum[]",
            "",
            "least value of each number of the state, to a thousandth of its swing",
            |it| json::list((0..it.numbers()).map(|number| json::number(it.orbit.range(number).0))),
        ),
        Of::value("maximum[]", "", "greatest value of each number of the state, as accurate", |it| {
            json::list((0..it.numbers()).map(|number| json::number(it.orbit.range(number).1)))
        }),
        Of::value(
            "multipliers[][]",
            "1",
            "Floquet multipliers by descending magnitude, real and imaginary part",
            |it| json::list(it.multipliers().iter().map(pair)),
        ),
        Of::value(
            "stability",
            "",
            "attracting, neutral or unstable; null where it was not asked for",
            |it| it.orbit.floquet().map(|floquet| words(floquet.stability)[0]).into(),
        )
        .line_of("stability", stability),
        Of::present(
            "multiplier_logarithm",
            "1",
            "logarithm of the multiplier of a cycle of one coordinate, which may be below all numbers",
            |it| it.orbit.floquet().and_then(|floquet| floquet.logarithm),
        ),
    ])
}

pub(super) fn of_term<'a>() -> Fields<Term<'a>> {
    type Of<'a> = Field<Term<'a>>;
    Fields::from([
        Of::value("coordinate", "", "coordinate it belongs to", |it| it.coordinate.into())
            .words("coordinate", |it| it.coordinate.to_owned()),
        Of::value("n", "1", "number of the harmonic, 0 for the mean", |it| it.term.n.into())
            .numeral("n", |it| it.term.n.to_string()),
        Of::number(
            "cosine",
            "",
            "coefficient of cos nΩt, the time counted from the start; the mean for n = 0",
            |it| it.term.cosine,
        )
        .rounded("cosine", 12),
        Of::number("sine", "", "coefficient of sin nΩt", |it| it.term.sine).rounded("sine", 12),
        Of::number("amplitude", "", "√(cosine² + sine²)", |it| it.term.amplitude()).rounded("amplitude", 6),
        Of::number("remainder", "", "no harmonic of the coordinate that is left out is larger", |it| {
            it.remainder
        }),
    ])
}

pub(crate) fn answers() -> Vec<Answers> {
    let json = [of_orbit().described(""), of_term().described("harmonics[].")].concat();
    vec![Answers { command: "orbit", option: "", json, csv: of_term().described_in_csv() }]
}

/// For machines, and for people.
fn kind(kind: OrbitKind) -> [&'static str; 2] {
    match kind {
        OrbitKind::Released => ["released", "released from rest"],
        OrbitKind::LimitCycle => ["limit_cycle", "a limit cycle"],
        OrbitKind::Driven => ["driven", "the answer to the drive"],
        OrbitKind::Family => ["family", "one of a family, through the start"],
        OrbitKind::Near => ["near", "closed near the guess"],
    }
}

fn words(stability: Stability) -> [&'static str; 2] {
    match stability {
        Stability::Attracting => ["attracting", "stable: all deviations die out"],
        Stability::Neutral => ["neutral", "neutral: no deviation grows exponentially, some stay"],
        Stability::Unstable => ["unstable", "unstable: deviations grow"],
    }
}

fn period(answer: &Answer) -> String {
    let (period, uncertainty) = (answer.orbit.period(), answer.orbit.period_uncertainty());
    if answer.kind == OrbitKind::Driven {
        return format!("{} s, set by the drive", rounded(period, 15));
    }
    if uncertainty.is_nan() {
        return format!("about {} s, of an error that the equations leave open", rounded(period, 4));
    }
    format!("{} s, to {}", to_its_error(period, uncertainty, 15), at_most(uncertainty))
}

fn start(answer: &Answer) -> String {
    let names = answer.model.state_names();
    let values = answer.orbit.start();
    let told = names.iter().zip(&values).map(|(name, value)| format!("{name} = {}", rounded(*value, 14)));
    told.collect::<Vec<_>>().join(", ")
}

fn stability(answer: &Answer) -> String {
    let Some(floquet) = answer.orbit.floquet() else {
        return "not computed for a release from rest: give a guess with --period".to_owned();
    };
    format!("{}; Floquet multipliers {}", words(floquet.stability)[1], listed(floquet))
}

fn listed(floquet: &Floquet) -> String {
    let one = |it: &Complex| match it.im {
        im if im.abs() > 0.0 => {
            format!("{} {} {}i", rounded(it.re, 10), if im > 0.0 { '+' } else { '−' }, rounded(im.abs(), 10))
        }
        _ => rounded(it.re, 10),
    };
    floquet.multipliers.iter().map(one).collect::<Vec<_>>().join(", ")
}

fn pair(number: &Complex) -> Value {
    json::numbers(&[number.re, number.im])
}
