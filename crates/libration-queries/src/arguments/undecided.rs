//! Refusals of files with the options that would decide.

use libration::quantity::alternatives;
use libration_lab::measurement::{Choice, MeasurementError};

/// The reason why a file is refused, with marks for the options that would decide.
pub(crate) fn what_would_decide(error: &MeasurementError) -> String {
    let message = error.message(&setting);
    match error {
        MeasurementError::HeaderWidth { .. } | MeasurementError::NeitherHeaderNorNumbers { .. } => {
            message + " (<--header>)"
        }
        MeasurementError::NotEven { .. } => message + " (without <--even-times>)",
        MeasurementError::CoarseTimes { .. } => message + ", or take them as they are (<--times-as-written>)",
        MeasurementError::NothingBetween { .. } | MeasurementError::GateClockRestarts { .. } => {
            message + " (<--from>, <--to>)"
        }
        MeasurementError::OnlyTimes(_) => message + " (times of a photogate are for <libration fit gates>)",
        MeasurementError::GateSignal { number, .. } => {
            format!("{message}: use <libration fit gates> with <--signal={number}>")
        }
        MeasurementError::NotGateTimes { .. } => {
            message + " Tables of periods are for <libration fit periods> and <libration fit lengths>"
        }
        _ => message,
    }
}

/// The mark of a choice with its values. Names of sheets may contain the character that ends a mark.
fn setting(choice: Choice, values: &[&str]) -> String {
    match values.iter().any(|value| value.contains(['<', '>', '|'])) {
        true => format!("<--{choice}> {}", alternatives(values)),
        false => format!("<--{choice}={}>", values.join("|")),
    }
}
