//! The slow flow with symbolic parameters, several small terms and a drive.

mod fields;
mod listing;
mod query;

use super::subject::{About, Subject};
use crate::output::description::Answers;
use crate::query_error::{QueryError, option};
use libration::perturbation::{
    LeftOutReason, StateLeftOut, SteadyStates, SymbolicSlowFlow, SymbolicSlowFlowError,
};

/// A slow flow with the words for it.
pub(super) struct SymbolicFlowResult {
    subject: Subject,
    flow: SymbolicSlowFlow,
    /// Small parameters with their orders.
    small: Vec<(String, usize)>,
    values: Option<FlowValues>,
}

/// The slow flow with numbers for all symbols.
pub(super) struct FlowValues {
    drive_frequency: Option<f64>,
    detuning: f64,
    /// `None` if the relation is not known.
    states: Option<SteadyStates>,
}

impl About for SymbolicFlowResult {
    fn subject(&self) -> &Subject {
        &self.subject
    }
}

pub(super) fn answers() -> Answers {
    fields::answers()
}

pub(in crate::command) fn failure(error: &SymbolicSlowFlowError) -> QueryError {
    use SymbolicSlowFlowError as Error;
    match error {
        Error::Interrupted => QueryError::cancelled("interrupted before the slow flow was known"),
        Error::Order(_) | Error::KinkOrder(_) => QueryError::usage(option("order"), error),
        Error::UnknownParameter { .. } | Error::NothingSmall => QueryError::usage(option("small"), error),
        Error::Resonance(..) | Error::NoDrive => QueryError::usage(option("resonance"), error),
        Error::SeveralEquations(_) => {
            let reason = format!("{error}; <libration resonance> gives that of coupled coordinates");
            QueryError::no_result("slow flow", reason)
        }
        Error::NoResonance => QueryError::usage(
            option("resonance"),
            format!(
                "{error}; <libration simulate> follows the motion, <libration response> the response curve"
            ),
        ),
        Error::NoOscillation(_) => QueryError::no_result("slow flow", error)
            .with_hint("<--about> names another equilibrium, such as <--about> 1"),
        _ => QueryError::no_result("slow flow", error),
    }
}

/// The reason why a steady state is omitted.
fn why_left_out(left: &StateLeftOut) -> String {
    match left.reason {
        LeftOutReason::OfLowestOrder { absent_at } => {
            format!("order {absent_at} has no state near it: the series does not reach it")
        }
        _ => format!(
            "its terms of higher orders are more than half of those of the lowest: the series to order {} does not show \
             whether the equation has this state",
            left.order
        ),
    }
}
