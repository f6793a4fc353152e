//! Series with numbers for all parameters, listed or evaluated.

use super::answer::ExpandResult;
use super::{Expand, Format, LISTED, evaluate};
use crate::arguments::Chosen;
use crate::output::number::short;
use crate::output::series::{certainty, radius_certainty};
use crate::parallel::{self, unless_cancelled};
use crate::query_error::{QueryError, option};
use libration::comparison::{SeriesComparison, SeriesQuantity};
use libration::oscillator::{Kind, Oscillator};
use libration::perturbation::{
    Expansion, ExpansionError, Gauge, SymbolicExpansionError, expand, expand_with_constants,
};
use libration::progress::{Progress, Stage, Status};
use std::io::Write;
use std::sync::Mutex;

/// Order up to which an expansion is evaluated.
const EVALUATED: usize = 31;
/// Order for expansions in which no powers vanish, so that they have as many terms.
const EVALUATED_OF_TWO_SIDES: usize = 15;

impl Expand {
    /// Writes the result, and states what is missing after a cancellation. The error is returned if a slow flow may be the result instead.
    pub(super) fn answer_in_numbers(
        &self,
        out: &mut dyn Write,
        chosen: Chosen,
    ) -> Result<Result<Option<String>, ExpansionError>, QueryError> {
        let amplitude =
            self.evaluate.as_ref().map(|text| chosen.amplitude(&option("evaluate"), text)).transpose()?;
        let usual = match (&amplitude, chosen.oscillator.kind()) {
            (None, _) => LISTED,
            (Some(_), Kind::TwoSided) => EVALUATED_OF_TWO_SIDES,
            (Some(_), _) => EVALUATED,
        };
        let order = self.order.unwrap_or(usual);
        let oscillator = chosen.oscillator.clone();
        if amplitude.is_none() && self.formats.format().and_then(Format::language).is_none() {
            let exact = with_orders_shown(order, |progress| {
                expand_with_constants(&oscillator, order, &self.gauge(), progress)
            });
            let exact = match exact {
                Err(SymbolicExpansionError::Expansion(error)) if is_of_cycles(&error) => {
                    return Ok(Err(error));
                }
                Err(SymbolicExpansionError::Expansion(error)) => return Err(refusal(error)),
                Err(SymbolicExpansionError::Interrupted { .. }) => {
                    return Err(refusal(ExpansionError::Interrupted { known: None }));
                }
                exact => exact.map_err(|error| QueryError::no_result("expansion", error))?,
            };
            if let Some(expansion) = exact {
                let answer = ExpandResult::with_letters(oscillator.equation(), chosen, expansion, None);
                self.write(out, &answer, String::new)?;
                return Ok(Ok(None));
            }
        }
        let answer = match expanded(&chosen.oscillator, order, &self.gauge()) {
            Ok(expansion) => ExpandResult::new(chosen, expansion, None),
            Err(ExpansionError::Interrupted { known: Some(partial) }) => {
                ExpandResult::new(chosen, *partial, Some(order))
            }
            Err(error) if is_of_cycles(&error) => return Ok(Err(error)),
            Err(error) => return Err(refusal(error)),
        };
        if let Some(amplitude) = amplitude {
            return evaluate::write(out, self.form.form(), &answer, &oscillator, self.quantity, &amplitude)
                .map(Ok);
        }
        self.write(out, &answer, || validity(&oscillator, &answer.expansion))?;
        Ok(Ok(answer.missing_orders()))
    }
}

pub(super) fn refusal(error: ExpansionError) -> QueryError {
    match error {
        ExpansionError::Interrupted { .. } => {
            QueryError::cancelled("interrupted before any order was confirmed")
        }
        error => QueryError::no_result("expansion", &error).with_remedies(&error.remedies()),
    }
}

/// The known range of convergence of the series of the period.
fn validity(oscillator: &Oscillator, expansion: &Expansion) -> String {
    let relation = SeriesComparison::new(oscillator, expansion, SeriesQuantity::Period);
    let radius = unless_cancelled("the radius of convergence", |_| relation.radius()).flatten();
    let variable = if expansion.variable.is_strength() { "strengths" } else { "amplitudes" };
    match radius {
        None => {
            format!("the radius of convergence of the series is not known; they are for small {variable}")
        }
        Some(radius) if radius.value().is_infinite() => {
            format!("the series of the period converges for all {variable}")
        }
        Some(radius) => {
            let certainty = certainty(radius_certainty(&radius));
            let below = short(radius.value(), 6);
            format!(
                "the series of the period converges for {variable} below {below} ({certainty}), slowly near it"
            )
        }
    }
}

fn expanded(oscillator: &Oscillator, order: usize, gauge: &Gauge) -> Result<Expansion, ExpansionError> {
    with_orders_shown(order, |progress| expand(oscillator, order, gauge, progress))
}

/// The result of a computation, with a progress line during long work, until it is cancelled.
pub(super) fn with_orders_shown<T: Send>(order: usize, compute: impl FnOnce(&dyn Progress) -> T + Send) -> T {
    let latest = Mutex::new(None);
    let how_far = || latest.lock().ok().and_then(|latest| *latest).map_or_else(String::new, in_words);
    let how_far = || format!("order {order}: {}", how_far());
    let progress = |status: Status| {
        if let Ok(mut latest) = latest.lock() {
            *latest = Some(status);
        }
        parallel::update(&how_far)
    };
    parallel::with_progress(how_far, || compute(&progress))
}

fn in_words(Status { stage, done: order, .. }: Status) -> String {
    match stage {
        Stage::Prime { done } => format!("{done} primes done, order {order} modulo the next"),
        Stage::Fractions { primes } => format!("fractions from {primes} primes"),
        Stage::Floats { bits } => format!("order {order} with {bits} bits"),
        _ => format!("checking order {order}"),
    }
}

/// `true` if there is no limit cycle to expand.
const fn is_of_cycles(error: &ExpansionError) -> bool {
    matches!(error, ExpansionError::NotPolynomial | ExpansionError::NoLimitCycle { .. })
}
