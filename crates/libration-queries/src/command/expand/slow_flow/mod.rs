//! The slow flow of a weakly damped or excited oscillator: equations for amplitude and phase.

mod fields;
mod formulas;
mod leading_cycles;
pub(crate) mod listing;
mod query;

use super::Format;
use super::subject::{About, Subject};
use crate::arguments::Asked;
use crate::interrupt::Cancellation;
use crate::output::description::Answers;
use crate::output::formulas::{self as written, Heading};
use crate::output::{Form, json};
use crate::parallel;
use crate::query_error::{QueryError, option};
use libration::comparison::{LeadingLimitCycles, LeadingLimitCyclesError};
use libration::perturbation::{Gauge, SlowFlow, SlowFlowError, slow_flow};
use std::io::Write;

/// Default order of a slow flow in the damping.
pub(super) const DAMPING_ORDER: usize = 2;

/// A slow flow with the words for it.
pub(super) struct SlowFlowResult {
    subject: Subject,
    flow: SlowFlow,
    /// Limit cycles by the work over exact orbits.
    leading: Result<LeadingLimitCycles, LeadingLimitCyclesError>,
}

pub(super) fn answers() -> Answers {
    fields::answers()
}

impl SlowFlowResult {
    pub(super) fn new(
        asked: Asked,
        small: Option<&str>,
        [order, damping_order]: [usize; 2],
        gauge: &Gauge,
    ) -> Result<Self, QueryError> {
        let Asked { equation, about, key, title, values, read_as } = asked;
        if about.is_some() {
            let reason = "a slow flow is given about the stable equilibrium nearest to zero";
            return Err(QueryError::usage(option("about"), reason));
        }
        let how_far = || format!("slow flow to order {order}");
        let flow = parallel::with_progress(how_far, || {
            slow_flow(&equation, small, order, damping_order, gauge, &Cancellation)
        })
        .map_err(failure)?;
        let how_far = || "work over exact orbits".to_owned();
        let leading =
            parallel::with_progress(how_far, || LeadingLimitCycles::new(&equation, small, &Cancellation));
        if leading == Err(LeadingLimitCyclesError::Interrupted) {
            return Err(failure(SlowFlowError::Interrupted));
        }
        let subject = Subject::new(&equation, (key, title), values, read_as);
        Ok(Self { subject, flow, leading })
    }
}

impl About for SlowFlowResult {
    fn subject(&self) -> &Subject {
        &self.subject
    }
}

fn failure(error: SlowFlowError) -> QueryError {
    match error {
        SlowFlowError::Interrupted => QueryError::cancelled("interrupted before the slow flow was known"),
        SlowFlowError::Gauge(_) => QueryError::usage(option("gauge"), error),
        SlowFlowError::UnknownParameter { .. } => QueryError::usage(option("small"), error),
        SlowFlowError::WhichIsSmall { .. } => {
            QueryError::usage(option("small"), format!("{error}, such as <--small> c"))
        }
        SlowFlowError::WithoutValue { .. } => QueryError::usage(option("set"), error),
        other => QueryError::no_result("slow flow", &other).with_remedies(&other.remedies()),
    }
}

pub(super) fn write(
    out: &mut dyn Write,
    form: Form,
    format: Option<Format>,
    answer: &SlowFlowResult,
) -> Result<(), QueryError> {
    match (format, form) {
        (Some(Format::Latex), _) => listing::write_latex(out, answer)?,
        (Some(format), _) => {
            let heading = Heading { module: "slow_flow", equations: &answer.subject.equation, latex: &[] };
            written::write(out, format, &heading, &answer.formulas())?;
        }
        (None, Form::Json) => json::document(out, fields::of_flow().record(answer))?,
        (None, Form::Csv) => fields::of_coefficient().write_csv(out, &fields::coefficients(answer))?,
        (None, Form::Table) => listing::write(out, answer)?,
    }
    Ok(())
}
