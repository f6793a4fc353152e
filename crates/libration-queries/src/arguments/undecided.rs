//! Refusals of files with the options that would decide.

use libration_lab::measurement::MeasurementError;

/// The reason why a file is refused, with marks of the options that would decide.
pub(crate) fn what_would_decide(error: &MeasurementError) -> String {
    let message = error.message(&|choice| format!("<--{choice}> "));
    match error {
        MeasurementError::HeaderWidth { .. } | MeasurementError::NeitherHeaderNorNumbers { .. } => {
            message + " (<--header>)"
        }
        MeasurementError::NotEven { .. } => message + " (without <--even-times>)",
        MeasurementError::CoarseTimes { .. } => message + ", or take them as they are (<--times-as-written>)",
        MeasurementError::NothingBetween { .. } => message + " (<--from>, <--to>)",
        MeasurementError::OnlyTimes(_) => message + " (times of a photogate are for <libration fit gates>)",
        MeasurementError::NotGateTimes { .. } => {
            message + " Tables of periods are for <libration fit periods> and <libration fit lengths>"
        }
        _ => message,
    }
}
