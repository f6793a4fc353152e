//! Fields of a series at one amplitude, of each of its terms, and of Padé approximants.

use super::{NOT_REACHED, Numbers, Quotient};
use crate::output::description::Answers;
use crate::output::field::{Field, Fields};
use crate::output::json;
use crate::output::number::{at_most, rounded, short};
use crate::output::series::{certainty, coefficient, radius_certainty};
use libration::algebra::Rational;
use libration::comparison::Method;
use libration::perturbation::{Certainty, PartialSum, Precision, Remainder};

/// A term of the series, with the sum up to it.
pub(super) struct Term<'a> {
    numbers: &'a Numbers<'a>,
    step: &'a PartialSum,
}

/// A Padé approximant at the amplitude.
pub(super) struct Approximant<'a> {
    numbers: &'a Numbers<'a>,
    pub(super) quotient: &'a Quotient,
}

impl<'a> Numbers<'a> {
    pub(super) fn terms(&'a self) -> Vec<Term<'a>> {
        self.evaluation.steps().iter().map(|step| Term { numbers: self, step }).collect()
    }

    pub(super) fn approximants(&'a self, pade: &'a [Quotient]) -> Vec<Approximant<'a>> {
        pade.iter().map(|quotient| Approximant { numbers: self, quotient }).collect()
    }

    /// The distance from the exact value to read, as far as that is known.
    fn error_text(&self, value: f64) -> String {
        match self.exact_value() {
            Some(exact) if (value - exact.value).abs() <= exact.uncertainty => {
                format!("below {}", at_most(exact.uncertainty))
            }
            Some(exact) => rounded(value - exact.value, 3),
            None => "unknown".to_owned(),
        }
    }
}

pub(super) fn of_numbers<'a>() -> Fields<Numbers<'a>> {
    type Of<'a> = Field<Numbers<'a>>;
    Fields::from([
        Of::value("oscillator", "", "key of the oscillator, null where its equation was typed", |numbers| {
            numbers.answer.subject.key.into()
        }),
        Of::value("equation", "", "equation of motion", |numbers| {
            numbers.answer.subject.equation.as_str().into()
        }),
        Of::value("order", "1", "highest power of the expansion", |numbers| {
            numbers.answer.expansion.order.into()
        }),
        Of::value("quantity", "", "quantity whose series is evaluated", |numbers| {
            numbers.relation.quantity().to_string().into()
        }),
        Of::value("amplitude_is", "", "variable of the power series", |numbers| {
            let variable = &numbers.answer.expansion.variable;
            if variable.is_strength() { variable.name().into() } else { "x_max".into() }
        }),
        Of::number("amplitude", "", "its value, in rad for angles", |numbers| numbers.amplitude),
        Of::known("exact", "", "value of the quantity by an independent method, or null", |numbers| {
            match &numbers.exact {
                Some(Ok(exact)) => Ok(exact.value),
                Some(Err(reason)) => Err(reason.to_string()),
                None => Err(NOT_REACHED.to_owned()),
            }
        }),
        Of::present("exact_uncertainty", "", "bound on the error of that value", |numbers| {
            numbers.exact_value().map(|exact| exact.uncertainty)
        }),
        Of::present_value(
            "exact_by",
            "",
            "the independent method: elliptic integrals, or integration of the equation of motion",
            |numbers| numbers.exact_value().map(|exact| method(exact.method).into()),
        ),
        Of::present_value(
            "encloses",
            "",
            "another equilibrium that the orbit encloses, or null",
            |numbers| numbers.exact_value().map(|exact| exact.encloses.map(json::number).into()),
        ),
        Of::note(Numbers::other_family),
        Of::present(
            "orbit_distance",
            "",
            "for a limit cycle: largest distance, at the same phase, of the displacement that the series gives from that of the periodic orbit to which Newton's method converges from there; left out where it does not converge",
            |numbers| numbers.orbit_distance().map(|orbit| orbit.distance),
        ),
        Of::present("orbit_distance_uncertainty", "", "error of that orbit's displacement", |numbers| {
            numbers.orbit_distance().map(|orbit| orbit.uncertainty)
        }),
        Of::note(Numbers::without_orbit),
        Of::known("radius", "", "radius of convergence, or null", radius),
        Of::value("radius_is", "", "proven or estimated, or null", |numbers| {
            numbers.radius.flatten().map(|radius| certainty(radius_certainty(&radius))).into()
        }),
        Of::value(
            "smallest_term_power",
            "1",
            "power of the smallest term, where a divergent series is best cut off",
            |numbers| numbers.evaluation.smallest_term().map(|step| step.power).into(),
        ),
        Of::nested("steps[].", &of_term(), |numbers| of_term().records(&numbers.terms())),
        Of::nested("pade[].", &of_approximant(), |numbers| {
            numbers.pade.as_ref().map(|pade| of_approximant().records(&numbers.approximants(pade))).into()
        }),
        Of::note(|numbers| numbers.pade.is_none().then(|| format!("pade is null: {NOT_REACHED}"))),
        Of::value(
            "terms_needed.TOLERANCE",
            "1",
            "terms beyond the first until the remainder stays below this fraction of the sum, or null",
            |numbers| {
                json::object(numbers.needed().map(|(tolerance, count)| (format!("{tolerance:e}"), count)))
            },
        ),
        Of::present_value(
            "interrupted",
            "",
            "true where Ctrl-C ended the work before all was known, else left out",
            |numbers| numbers.missing().map(|_| true.into()),
        ),
    ])
}

/// The fields of a term; `KEY` stands for the basis of the bounds.
pub(super) fn of_term<'a>() -> Fields<Term<'a>> {
    type Of<'a> = Field<Term<'a>>;
    Fields::from([
        Of::value("power", "1", "power of the term", |term| term.step.power.into())
            .numeral("power", |term| term.step.power.to_string()),
        Of::value("coefficient", "", "its coefficient, a fraction or a decimal", |term| {
            coefficient(term.coefficient(), term.precision()).into()
        })
        .numeral("coefficient", |term| shortened(term.coefficient(), term.precision())),
        Of::number("term", "", "the term", |term| term.step.term)
            .numeral("term", |term| in_range(term.step.term, 5)),
        Of::number("sum", "", "sum up to it", |term| term.step.sum)
            .numeral("sum so far", |term| in_range(term.step.sum, 15)),
        Of::nullable("error", "", "that sum minus the exact value, or null", |term| {
            term.numbers.error(term.step.sum)
        })
        .numeral("its error", |term| term.numbers.error_text(term.step.sum)),
        Of::nullable("bound", "", "proven bound on the remainder, or null", |term| {
            term.remainder(Certainty::Proven)
        })
        .numeral("|error| KEY", |term| match term.step.remainder {
            Remainder { size, .. } if size.is_finite() => rounded(size, 3),
            Remainder { certainty: Certainty::Proven, .. } => "no bound".to_owned(),
            Remainder { certainty: Certainty::Estimated, .. } => "unknown".to_owned(),
        }),
        Of::value(
            "bound_is",
            "",
            "proven, or estimated where no bound is known: an estimate covers the error in about 99 of 100 cases",
            |term| certainty(term.step.remainder.certainty).into(),
        ),
        Of::nullable(
            "estimate",
            "",
            "estimate of the remainder where no bound is known, too small in about 1 of 100 cases, in 2 of 100 at order 5 and below; or null",
            |term| term.remainder(Certainty::Estimated),
        ),
        Of::unnamed().words("", |term| if term.is_smallest() { "← smallest term" } else { "" }.to_owned()),
    ])
}

pub(super) fn of_approximant<'a>() -> Fields<Approximant<'a>> {
    type Of<'a> = Field<Approximant<'a>>;
    Fields::from([
        Of::value(
            "degrees[]",
            "1",
            "degrees of numerator and denominator of the Padé approximant",
            |approximant| json::list([approximant.quotient.degree; 2]),
        )
        .words("Padé", |approximant| format!("[{0}/{0}]", approximant.quotient.degree)),
        Of::number("value", "", "its value", |approximant| approximant.quotient.value)
            .numeral("value", |approximant| in_range(approximant.quotient.value, 15)),
        Of::nullable("error", "", "its value minus the exact one, or null", |approximant| {
            approximant.numbers.error(approximant.quotient.value)
        })
        .numeral("its error", |approximant| approximant.numbers.error_text(approximant.quotient.value)),
        Of::nullable(
            "pole_before",
            "",
            "position of a pole between zero and the amplitude, which makes the value worthless, or null",
            |approximant| approximant.quotient.pole_before,
        )
        .words("", |approximant| {
            let pole = approximant
                .quotient
                .pole_before
                .map(|pole| format!("has a pole before, at {}", short(pole, 5)));
            pole.unwrap_or_default()
        }),
    ])
}

pub(in crate::command::expand) fn answers() -> Answers {
    let (json, csv) = (of_numbers().described(""), of_term().described_in_csv());
    Answers { command: "expand", option: "--evaluate", json, csv }
}

impl Term<'_> {
    /// The remainder, if it is known with this certainty.
    fn remainder(&self, certainty: Certainty) -> Option<f64> {
        Some(self.step.remainder)
            .filter(|remainder| remainder.certainty == certainty)
            .map(|remainder| remainder.size)
    }

    fn coefficient(&self) -> &Rational {
        &self.numbers.relation.series()[self.step.power]
    }

    fn precision(&self) -> Precision {
        self.numbers.answer.expansion.precision
    }

    fn is_smallest(&self) -> bool {
        let smallest = self.numbers.evaluation.smallest_term();
        smallest.is_some_and(|smallest| smallest.power == self.step.power)
    }
}

/// A number as printed, or `beyond range`.
fn in_range(value: f64, digits: usize) -> String {
    if value.is_finite() { rounded(value, digits) } else { "beyond range".to_owned() }
}

/// Length above which coefficients are written as decimals.
const LONGEST_FRACTION: usize = 21;

/// A fraction if it is short, otherwise its leading decimals.
fn shortened(value: &Rational, precision: Precision) -> String {
    let exact = coefficient(value, precision);
    if exact.chars().count() <= LONGEST_FRACTION { exact } else { format!("{}…", value.to_decimal(10)) }
}

fn method(method: Method) -> &'static str {
    match method {
        Method::Elliptic => "elliptic integrals",
        Method::Integration => "integration of the equation of motion",
    }
}

fn radius(numbers: &Numbers<'_>) -> Result<f64, String> {
    match &numbers.radius {
        Some(Some(radius)) => Ok(radius.value()),
        Some(None) => Err("there are too few coefficients".to_owned()),
        None => Err(NOT_REACHED.to_owned()),
    }
}
