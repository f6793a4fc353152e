//! The amplitude of an option `--amplitude`, alone or in place of a column.

use crate::query_error::{QueryError, option};
use libration::pendulum::Amplitude;
use libration::quantity::Angle;

/// The amplitude that the option `--amplitude` gives.
pub(crate) fn one_amplitude(angle: &Angle) -> Result<Amplitude, QueryError> {
    Amplitude::new(*angle).map_err(|error| QueryError::no_result(option("amplitude"), error))
}

/// The column of amplitudes, or the one that the option gives for all rows; empty if neither is there.
pub(crate) fn column_or_one_amplitude(
    column: Option<Vec<f64>>,
    amplitude: Option<&Angle>,
) -> Result<Vec<f64>, QueryError> {
    match (column, amplitude) {
        (Some(_), Some(_)) => Err(QueryError::usage(
            option("amplitude"),
            "a column of amplitudes is given too: leave out one of them",
        )),
        (Some(column), None) => Ok(column),
        (None, Some(amplitude)) => Ok(vec![one_amplitude(amplitude)?.angle().radians()]),
        (None, None) => Ok(vec![]),
    }
}
