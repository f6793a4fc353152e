//! Fields of an expansion: its series as lists of coefficients, each a text.

use super::answer::ExpandResult;
use super::subject::of_subject;
use crate::output::description::Answers;
use crate::output::field::{Field, Fields};
use crate::output::json;
use crate::output::series;
use libration::algebra::Rational;
use libration::perturbation::{
    AmplitudeSeries, Certificate, Expansion, ExpansionVariable, PhaseOrigin, Precision,
};
use serde_json::Value;

/// Coefficients by powers.
type SeriesTexts = Vec<String>;

/// A harmonic of the displacement.
struct Harmonic {
    k: usize,
    cos: SeriesTexts,
    sin: SeriesTexts,
}

/// The series that depend on an amplitude in the same way in every gauge.
struct OfAmplitude {
    frequency_ratio: SeriesTexts,
    period_ratio: SeriesTexts,
    epsilon: SeriesTexts,
    harmonics: Vec<Harmonic>,
}

/// One coefficient of a series.
pub(super) struct SeriesCoefficient {
    quantity: String,
    variable: String,
    power: usize,
    text: String,
}

pub(super) fn of_expansion<C: series::Coefficient>() -> Fields<ExpandResult<C>> {
    type Of<C> = Field<ExpandResult<C>>;
    let letters = Fields::from([
        Of::<C>::value("letters[]", "", "symbolic parameters, which appear in the coefficients", |answer| {
            answer.letters.as_ref().map_or(vec![], |letters| letters.names.clone()).into()
        }),
        Of::<C>::present_value(
            "constants.NAME",
            "",
            "with symbols: the constant that this name stands for in the coefficients",
            |answer| Some(json::object(answer.letters.as_ref()?.explained().cloned())),
        ),
    ]);
    of_subject().and(letters).and(of_setting()).and(of_series())
}

/// The fields of the equilibrium and the expansion parameter.
fn of_setting<C: series::Coefficient>() -> Fields<ExpandResult<C>> {
    type Of<C> = Field<ExpandResult<C>>;
    Fields::from([
        Of::<C>::value("order", "1", "highest power of the expansion", |answer| {
            answer.expansion.order.into()
        }),
        Of::<C>::value(
            "gauge",
            "",
            "meaning of the expansion parameter, null for the strength of a self-excited oscillator",
            |answer| match &answer.expansion.variable {
                ExpansionVariable::Epsilon(gauge) => gauge.to_string().into(),
                ExpansionVariable::Parameter(_) => Value::Null,
            },
        ),
        Of::<C>::value("variable", "", "name of the expansion parameter", |answer| answer.variable().into()),
        Of::<C>::value(
            "phase_origin",
            "",
            "point where the phase τ is zero: at the upper `turning point`, at a `passage` upward through the equilibrium, or where the `first \
             harmonic` has its maximum",
            |answer| phase_origin(answer.expansion.phase_origin).into(),
        ),
        Of::<C>::value(
            "precision",
            "",
            "`exact`, or the number of digits to which the coefficients are known",
            |answer| precision(answer.expansion.precision).into(),
        ),
        Of::<C>::value("equilibrium", "", "equilibrium x₀ about which it oscillates", |answer| {
            text(&answer.expansion, &answer.expansion.equilibrium).into()
        }),
        Of::<C>::value(
            "omega0_squared",
            "",
            "square of the angular frequency ω0 of small oscillations",
            |answer| text(&answer.expansion, &answer.expansion.omega0_squared).into(),
        ),
        Of::<C>::present_value(
            "omega0",
            "",
            "with symbols: the frequency ω0 of small oscillations, for positive symbols",
            |answer| answer.letters.as_ref().map(|letters| letters.omega0.clone().into()),
        ),
        Of::<C>::present_value(
            "omega0_name",
            "",
            "with symbols: the name that stands for ω0 in coefficients, null where none does",
            |answer| answer.letters.as_ref().map(|letters| letters.omega0_name.clone().into()),
        ),
    ])
}

fn of_series<C: series::Coefficient>() -> Fields<ExpandResult<C>> {
    type Of<C> = Field<ExpandResult<C>>;
    Fields::from([
        Of::<C>::present_value(
            "angular_frequency[]",
            "",
            "with symbols, where ω0 is a product of them: coefficients of the frequency itself",
            |answer| {
                Some(
                    answer
                        .letters
                        .as_ref()?
                        .frequency
                        .as_ref()?
                        .iter()
                        .map(written)
                        .collect::<SeriesTexts>()
                        .into(),
                )
            },
        ),
        Of::<C>::value(
            "frequency_ratio[]",
            "",
            "coefficients of the frequency over ω0, by powers of the expansion parameter",
            |answer| texts(&answer.expansion, &answer.expansion.frequency_ratio).into(),
        ),
        Of::<C>::nested(
            "harmonics.K.",
            &of_harmonic(
                "coefficients of cos Kτ in the displacement, by powers of the expansion parameter; τ = Ωt",
            ),
            |answer| by_number(&harmonics(&answer.expansion)),
        ),
        Of::<C>::value(
            "has_all_harmonics",
            "",
            "true if harmonics that are not given begin at higher powers; false where the force has two sides, and there are harmonics without end",
            |answer| answer.expansion.has_all_harmonics.into(),
        ),
        Of::<C>::value(
            "unit_squared",
            "",
            "square of the unit that harmonics and turning points are measured in",
            |answer| text(&answer.expansion, &answer.expansion.unit_squared).into(),
        ),
        Of::<C>::value("x_max[]", "", "coefficients of the upper turning point", |answer| {
            texts(&answer.expansion, &answer.expansion.x_max).into()
        }),
        Of::<C>::value("x_min[]", "", "coefficients of the lower turning point", |answer| {
            texts(&answer.expansion, &answer.expansion.x_min).into()
        }),
        Of::<C>::nested("of_amplitude.", &of_amplitude(), |answer| {
            in_amplitude(answer, &answer.expansion.of_amplitude)
        }),
        Of::<C>::nested("of_half_swing.", &of_amplitude(), |answer| {
            in_amplitude(answer, &answer.expansion.of_half_swing)
        }),
        Of::<C>::value(
            "certified",
            "",
            "true if an independent exact computation proves the coefficients",
            |answer| answer.expansion.certificate.is_proof().into(),
        ),
        Of::<C>::value("certificate", "", "the check that was made", |answer| {
            certificate(answer.expansion.certificate).into()
        }),
        Of::<C>::present_value(
            "interrupted",
            "",
            "true where Ctrl-C ended the work before the requested order, else left out",
            |answer| answer.interrupted.map(|_| true.into()),
        ),
    ])
}

fn of_harmonic(cosines: &'static str) -> Fields<Harmonic> {
    type Of = Field<Harmonic>;
    Fields::from([
        Of::value("cos[]", "", cosines, |harmonic| harmonic.cos.clone().into()),
        Of::value("sin[]", "", "those of sin Kτ", |harmonic| harmonic.sin.clone().into()),
    ])
}

fn of_amplitude() -> Fields<OfAmplitude> {
    type Of = Field<OfAmplitude>;
    const COSINES: &str =
        "coefficients of cos Kτ in the displacement, by powers of x_max or of half the swing";
    Fields::from([
        Of::value(
            "frequency_ratio[]",
            "",
            "coefficients of the frequency over ω0, by powers of x_max or of half the swing",
            |series| series.frequency_ratio.clone().into(),
        ),
        Of::value(
            "period_ratio[]",
            "",
            "coefficients of the period times ω0/2π, by powers of x_max or of half the swing",
            |series| series.period_ratio.clone().into(),
        ),
        Of::value(
            "epsilon[]",
            "",
            "coefficients of the expansion parameter, by powers of x_max or of half the swing",
            |series| series.epsilon.clone().into(),
        ),
        Of::nested("harmonics.K.", &of_harmonic(COSINES), |series| by_number(&series.harmonics)),
    ])
}

pub(super) fn of_coefficient() -> Fields<SeriesCoefficient> {
    type Of = Field<SeriesCoefficient>;
    Fields::from([
        Of::value("quantity", "", "quantity that is expanded", |coefficient| {
            coefficient.quantity.as_str().into()
        }),
        Of::value("variable", "", "variable of the power series", |coefficient| {
            coefficient.variable.as_str().into()
        }),
        Of::value("power", "1", "power", |coefficient| coefficient.power.into()),
        Of::value(
            "coefficient",
            "",
            "coefficient of that power: a fraction, a decimal, or a formula of symbols",
            |coefficient| coefficient.text.as_str().into(),
        ),
    ])
}

pub(super) fn answers() -> Answers {
    let (json, csv) = (of_expansion::<Rational>().described(""), of_coefficient().described_in_csv());
    Answers { command: "expand", option: "", json, csv }
}

/// The coefficients of all series, in the order of JSON; of harmonics in an amplitude without the cosines or the sines that all vanish.
pub(super) fn coefficients<C: series::Coefficient>(answer: &ExpandResult<C>) -> Vec<SeriesCoefficient> {
    let expansion = &answer.expansion;
    let mut all = vec![];
    let mut add = |quantity: String, variable: &str, series: SeriesTexts| {
        let each = series.into_iter().enumerate();
        all.extend(each.map(|(power, text)| SeriesCoefficient {
            quantity: quantity.clone(),
            variable: variable.to_owned(),
            power,
            text,
        }));
    };
    let variable = &answer.variable();
    add("frequency_ratio".to_owned(), variable, texts(expansion, &expansion.frequency_ratio));
    for Harmonic { k, cos, sin } in harmonics(expansion) {
        add(format!("cos_{k}"), variable, cos);
        add(format!("sin_{k}"), variable, sin);
    }
    add("x_max".to_owned(), variable, texts(expansion, &expansion.x_max));
    add("x_min".to_owned(), variable, texts(expansion, &expansion.x_min));
    for (name, of) in [("x_max", &expansion.of_amplitude), ("half_swing", &expansion.of_half_swing)] {
        let Some(of) = of else { continue };
        let of = OfAmplitude::new(expansion, of);
        add("frequency_ratio".to_owned(), name, of.frequency_ratio);
        add("period_ratio".to_owned(), name, of.period_ratio);
        add("epsilon".to_owned(), name, of.epsilon);
        for Harmonic { k, cos, sin } in of.harmonics {
            match expansion.phase_origin {
                PhaseOrigin::Passage => add(format!("sin_{k}"), name, sin),
                PhaseOrigin::TurningPoint | PhaseOrigin::FirstHarmonic => add(format!("cos_{k}"), name, cos),
            }
        }
    }
    all
}

fn text<C: series::Coefficient>(expansion: &Expansion<C>, value: &C) -> String {
    value.written(expansion.precision)
}

fn written<C: series::Coefficient>(value: &C) -> String {
    value.written(Precision::Exact)
}

fn texts<C: series::Coefficient>(expansion: &Expansion<C>, series: &[C]) -> SeriesTexts {
    series.iter().map(|value| text(expansion, value)).collect()
}

fn harmonics<C: series::Coefficient>(expansion: &Expansion<C>) -> Vec<Harmonic> {
    let texts = |series: &[C]| texts(expansion, series);
    let harmonics = expansion.harmonics.iter();
    harmonics
        .map(|harmonic| Harmonic { k: harmonic.k, cos: texts(&harmonic.cos), sin: texts(&harmonic.sin) })
        .collect()
}

fn by_number(harmonics: &[Harmonic]) -> Value {
    let fields = of_harmonic("");
    json::object(harmonics.iter().map(|harmonic| (harmonic.k.to_string(), fields.record(harmonic))))
}

fn in_amplitude<C: series::Coefficient>(answer: &ExpandResult<C>, of: &Option<AmplitudeSeries<C>>) -> Value {
    let of = of.as_ref().map(|of| OfAmplitude::new(&answer.expansion, of));
    of.map_or(Value::Null, |of| of_amplitude().record(&of).into())
}

impl OfAmplitude {
    fn new<C: series::Coefficient>(expansion: &Expansion<C>, of: &AmplitudeSeries<C>) -> Self {
        let texts = |series: &[C]| texts(expansion, series);
        let harmonic = |(k, series): &(usize, Vec<C>)| {
            let nothing = vec![written(&Rational::from(0)); series.len()];
            match expansion.phase_origin {
                PhaseOrigin::Passage => Harmonic { k: *k, cos: nothing, sin: texts(series) },
                PhaseOrigin::TurningPoint | PhaseOrigin::FirstHarmonic => {
                    Harmonic { k: *k, cos: texts(series), sin: nothing }
                }
            }
        };
        Self {
            frequency_ratio: texts(&of.frequency_ratio),
            period_ratio: texts(&of.period_ratio),
            epsilon: texts(&of.epsilon),
            harmonics: of.harmonics.iter().map(harmonic).collect(),
        }
    }
}

fn phase_origin(origin: PhaseOrigin) -> &'static str {
    match origin {
        PhaseOrigin::TurningPoint => "turning point",
        PhaseOrigin::Passage => "passage",
        PhaseOrigin::FirstHarmonic => "first harmonic",
    }
}

fn precision(precision: Precision) -> String {
    match precision {
        Precision::Exact => "exact".to_owned(),
        Precision::Digits(digits) => format!("{digits} digits"),
    }
}

fn certificate(certificate: Certificate) -> &'static str {
    match certificate {
        Certificate::PlainRationals => "plain rationals",
        Certificate::Potential => "potential",
        Certificate::FirstIntegral => "first integral",
        Certificate::FreshPrimes => "fresh primes",
        Certificate::TwoPrecisions => "two precisions",
        Certificate::Quadrature => "quadrature",
        Certificate::Digits => "digits",
        Certificate::Substitution => "substitution",
        Certificate::Unchecked => "none",
    }
}
