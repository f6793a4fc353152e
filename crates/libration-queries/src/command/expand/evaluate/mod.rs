//! `libration expand --evaluate`: a series in numbers, term by term, with the exact value.

mod fields;
mod table;

pub(super) use fields::answers;

use super::answer::ExpandResult;
use crate::output::number::short;
use crate::output::{Form, json};
use crate::parallel::unless_cancelled;
use crate::query_error::{QueryError, option};
use libration::comparison::{
    CycleDistance, ExactValue, ExactValueError, Radius, SeriesComparison, SeriesQuantity,
};
use libration::oscillator::Oscillator;
use libration::perturbation::SeriesEvaluation;
use libration::progress::{Progress, Status};
use libration::quantity::Displacement;
use std::io::Write;

/// The relative errors for which the terms are counted.
const TOLERANCES: [f64; 4] = [1e-3, 1e-6, 1e-9, 1e-12];

/// Padé approximants up to this degree above and below.
const HIGHEST_DEGREE: usize = 16;

/// The values of a relation at one amplitude. Values that were not computed before a cancellation are `None`.
struct Numbers<'a> {
    answer: &'a ExpandResult,
    relation: &'a SeriesComparison<'a>,
    amplitude: f64,
    evaluation: SeriesEvaluation,
    exact: Option<Result<ExactValue, ExactValueError>>,
    /// The distance of a limit cycle from the orbit next to it.
    distance: Option<Result<CycleDistance, ExactValueError>>,
    radius: Option<Option<Radius>>,
    pade: Option<Vec<Quotient>>,
}

/// Text for values that were not computed before a cancellation.
const NOT_REACHED: &str = "not computed: interrupted";

/// A Padé approximant [n/n] at the amplitude.
struct Quotient {
    degree: usize,
    value: f64,
    /// A pole between zero and the amplitude, which makes the value worthless.
    pole_before: Option<f64>,
}

/// Writes the series of a quantity at an amplitude, or at a strength of self-excitation, and states what is missing after a cancellation.
pub(super) fn write(
    out: &mut dyn Write,
    form: Form,
    answer: &ExpandResult,
    oscillator: &Oscillator,
    quantity: SeriesQuantity,
    amplitude: &Displacement,
) -> Result<Option<String>, QueryError> {
    let relation = SeriesComparison::new(oscillator, &answer.expansion, quantity);
    if relation.series().iter().all(libration::algebra::Rational::is_zero) {
        return Err(QueryError::no_result(option("quantity"), format!("{quantity} {}", absent(answer))));
    }
    let numbers = Numbers::new(answer, &relation, amplitude)?;
    match form {
        Form::Json => json::document(out, fields::of_numbers().record(&numbers))?,
        Form::Csv => fields::of_term().write_csv(out, &numbers.terms())?,
        Form::Table => table::write(out, &numbers)?,
    }
    Ok(numbers.missing())
}

/// A statement of the nonzero harmonics, for a harmonic that is zero.
fn absent(answer: &ExpandResult) -> String {
    let present: Vec<String> =
        answer.expansion.harmonics.iter().take(6).map(|harmonic| format!("a{}", harmonic.k)).collect();
    format!("is zero to this order; nonzero harmonics are {}", present.join(", "))
}

impl<'a> Numbers<'a> {
    fn new(
        answer: &'a ExpandResult,
        relation: &'a SeriesComparison<'a>,
        exactly: &Displacement,
    ) -> Result<Self, QueryError> {
        let amplitude = exactly.to_f64();
        let exact = unless_cancelled("the exact value", |progress| relation.exact_from(exactly, progress));
        if let Some(Err(refusal @ ExactValueError::Amplitude(_))) = &exact {
            return Err(QueryError::no_result(option("evaluate"), refusal));
        }
        let distance = unless_cancelled("the orbit next to the series", |progress| {
            relation.cycle_distance(exactly, progress)
        })
        .flatten();
        let evaluation = relation.evaluation_at(amplitude);
        // A constant is its own approximant.
        let highest = if evaluation.steps().len() > 1 { HIGHEST_DEGREE } else { 0 };
        let radius = unless_cancelled("the radius of convergence", |_| relation.radius());
        let pade = unless_cancelled("Padé approximants", |progress| {
            quotients(relation, highest, amplitude, progress)
        });
        Ok(Self { answer, relation, amplitude, evaluation, exact, distance, radius, pade })
    }

    /// The exact value, if there is one and it was computed.
    fn exact_value(&self) -> Option<&ExactValue> {
        self.exact.as_ref()?.as_ref().ok()
    }

    /// The difference between a value and the exact one; `None` if there is no exact value.
    fn error(&self, value: f64) -> Option<f64> {
        self.exact_value().map(|exact| value - exact.value)
    }

    /// A note that the exact motion does not belong to the family of the series.
    fn other_family(&self) -> Option<String> {
        let equilibrium = self.exact_value()?.encloses?;
        Some(format!(
            "the motion also encloses the equilibrium at {}, so that the series does not apply",
            short(equilibrium, 6)
        ))
    }

    /// The distance of a limit cycle from the nearest orbit, if there is one.
    fn orbit_distance(&self) -> Option<&CycleDistance> {
        self.distance.as_ref()?.as_ref().ok()
    }

    /// The warning that no periodic orbit is near the limit cycle of the series.
    fn without_orbit(&self) -> Option<String> {
        let reason = match self.distance.as_ref()? {
            Ok(distance) if distance.is_near() => return None,
            Ok(distance) => format!(
                "the one to which Newton's method converges from it is {} away, {} of half the swing",
                short(distance.distance, 3),
                short(distance.distance / distance.half_swing, 2)
            ),
            Err(reason) => reason.to_string(),
        };
        Some(format!("no periodic orbit is near the limit cycle that the series gives here: {reason}"))
    }

    /// The parts missing after a cancellation; `None` if the result is complete.
    fn missing(&self) -> Option<String> {
        let parts = [
            ("the exact value", self.exact.is_none()),
            ("the radius of convergence", self.radius.is_none()),
            ("the Padé approximants", self.pade.is_none()),
        ];
        let missing: Vec<&str> =
            parts.iter().filter(|(_, is_missing)| *is_missing).map(|part| part.0).collect();
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

fn quotients(
    relation: &SeriesComparison<'_>,
    highest: usize,
    amplitude: f64,
    progress: &dyn Progress,
) -> Vec<Quotient> {
    let degrees = (1..=highest).take_while(|_| progress.update(Status::default()).is_continue());
    degrees.filter_map(|degree| quotient(relation, degree, amplitude)).collect()
}

fn quotient(relation: &SeriesComparison<'_>, degree: usize, amplitude: f64) -> Option<Quotient> {
    let approximant = relation.approximant(degree)?;
    let pole_before = approximant.first_pole().filter(|pole| *pole <= amplitude);
    Some(Quotient { degree, value: approximant.value_at(amplitude), pole_before })
}
