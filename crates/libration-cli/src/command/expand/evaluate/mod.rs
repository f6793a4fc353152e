//! `libration expand --evaluate`: a series in numbers, term by term, beside the exact value.

mod fields;
mod table;

pub(super) use fields::answers;

use super::Answer;
use crate::failure::Failure;
use crate::output::number::short;
use crate::output::{Form, json};
use crate::parallel;
use libration::comparison::{ExactValue, NoExactValue, Radius, SeriesComparison, SeriesQuantity};
use libration::perturbation::SeriesEvaluation;
use libration::quantity::Displacement;
use std::io::Write;
use std::sync::Arc;

/// The relative errors for which the terms are counted.
const TOLERANCES: [f64; 4] = [1e-3, 1e-6, 1e-9, 1e-12];

/// Padé approximants up to this degree above and below.
const HIGHEST_DEGREE: usize = 16;

/// A relation at one amplitude, with all that is said about it. `None` is what Ctrl-C came before.
struct Numbers<'a> {
    answer: &'a Answer,
    relation: &'a SeriesComparison<'a>,
    amplitude: f64,
    evaluation: SeriesEvaluation,
    exact: Option<Result<ExactValue, NoExactValue>>,
    radius: Option<Option<Radius>>,
    pade: Option<Vec<Quotient>>,
}

/// Said of what Ctrl-C came before.
const NOT_REACHED: &str = "not computed: interrupted";

/// A Padé approximant [n/n] at the amplitude.
struct Quotient {
    degree: usize,
    value: f64,
    /// A pole between zero and the amplitude, which makes the value worthless.
    pole_before: Option<f64>,
}

/// Writes the series of a quantity at an amplitude, or at a strength of self-excitation, and tells what the answer lacks when Ctrl-C
/// was pressed.
pub(super) fn write(
    out: &mut dyn Write,
    form: Form,
    answer: Arc<Answer>,
    quantity: SeriesQuantity,
    amplitude: &Displacement,
) -> Result<Option<String>, Failure> {
    let relation = SeriesComparison::new(&answer.oscillator, &answer.expansion, quantity);
    if relation.series().iter().all(libration::algebra::Rational::is_zero) {
        return Err(Failure::no_answer("--quantity", format!("{quantity} {}", absent(&answer))));
    }
    let numbers = Numbers::new(&answer, &relation, amplitude)?;
    match form {
        Form::Json => json::document(out, fields::of_numbers().record(&numbers))?,
        Form::Csv => fields::of_term().write_csv(out, &numbers.terms())?,
        Form::Table => table::write(out, &numbers)?,
    }
    Ok(numbers.missing())
}

/// Which harmonics there are in the place of one that is not.
fn absent(answer: &Answer) -> String {
    let present: Vec<String> =
        answer.expansion.harmonics.iter().take(6).map(|harmonic| format!("a{}", harmonic.k)).collect();
    format!("is zero to this order; harmonics that are not: {}", present.join(", "))
}

impl<'a> Numbers<'a> {
    fn new(
        answer: &'a Arc<Answer>,
        relation: &'a SeriesComparison<'a>,
        exactly: &Displacement,
    ) -> Result<Self, Failure> {
        let amplitude = exactly.to_f64();
        let work = Work { answer: Arc::clone(answer), quantity: relation.quantity() };
        let exact = work.exact(exactly.clone());
        if let Some(Err(refusal @ NoExactValue::Amplitude(_))) = &exact {
            return Err(Failure::no_answer("--evaluate", refusal));
        }
        let evaluation = relation.evaluation_at(amplitude);
        // A constant is its own approximant.
        let highest = if evaluation.steps().len() > 1 { HIGHEST_DEGREE } else { 0 };
        let radius = work.radius();
        let pade = work.quotients(highest, amplitude);
        Ok(Self { answer, relation, amplitude, evaluation, exact, radius, pade })
    }

    /// The exact value, where there is one and it was reached.
    fn known(&self) -> Option<&ExactValue> {
        self.exact.as_ref()?.as_ref().ok()
    }

    /// How far a value is from the exact one; `None` when there is none.
    fn error(&self, value: f64) -> Option<f64> {
        self.known().map(|exact| value - exact.value)
    }

    /// That the exact motion is not what the series is for.
    fn other_family(&self) -> Option<String> {
        let place = self.known()?.encloses?;
        Some(format!(
            "the motion goes around another equilibrium too, at {}: it is not of the family that the series is for",
            short(place, 6)
        ))
    }

    /// What Ctrl-C came before; `None` when nothing lacks.
    fn missing(&self) -> Option<String> {
        let parts = [
            ("the exact value", self.exact.is_none()),
            ("the radius of convergence", self.radius.is_none()),
            ("the Padé approximants", self.pade.is_none()),
        ];
        let missing: Vec<&str> = parts.iter().filter(|(_, is_missing)| *is_missing).map(|it| it.0).collect();
        let orders = self.answer.missing_orders();
        if missing.is_empty() {
            return orders;
        }
        let written = orders.unwrap_or_else(|| "the series is written".to_owned());
        Some(format!("{written}, without {}", missing.join(", ")))
    }

    fn needed(&self) -> impl Iterator<Item = (f64, Option<usize>)> {
        TOLERANCES.into_iter().map(|tolerance| (tolerance, self.evaluation.corrections_needed(tolerance)))
    }
}

/// What may take long and nobody waits for after Ctrl-C, for which it has an answer of its own.
struct Work {
    answer: Arc<Answer>,
    quantity: SeriesQuantity,
}

impl Work {
    fn exact(&self, amplitude: Displacement) -> Option<Result<ExactValue, NoExactValue>> {
        self.done("the exact value", move |relation| relation.exact_from(&amplitude))
    }

    fn radius(&self) -> Option<Option<Radius>> {
        self.done("the radius of convergence", |relation| relation.radius())
    }

    fn quotients(&self, highest: usize, amplitude: f64) -> Option<Vec<Quotient>> {
        self.done("Padé approximants", move |relation| {
            (1..=highest).filter_map(|degree| quotient(relation, degree, amplitude)).collect()
        })
    }

    fn done<R: Send + 'static>(
        &self,
        what: &str,
        work: impl FnOnce(&SeriesComparison<'_>) -> R + Send + 'static,
    ) -> Option<R> {
        let Self { answer, quantity } = self;
        let (answer, quantity) = (Arc::clone(answer), *quantity);
        parallel::until_asked(what, move || {
            work(&SeriesComparison::new(&answer.oscillator, &answer.expansion, quantity))
        })
    }
}

fn quotient(relation: &SeriesComparison<'_>, degree: usize, amplitude: f64) -> Option<Quotient> {
    let approximant = relation.approximant(degree)?;
    let pole_before = approximant.first_pole().filter(|pole| *pole <= amplitude);
    Some(Quotient { degree, value: approximant.value_at(amplitude), pole_before })
}
