//! The amplitude of an option `--amplitude`.

use crate::query_error::{QueryError, option};
use libration::pendulum::Amplitude;
use libration::quantity::Angle;

/// The amplitude that the option `--amplitude` gives.
pub(crate) fn one_amplitude(angle: &Angle) -> Result<Amplitude, QueryError> {
    Amplitude::new(*angle).map_err(|error| QueryError::no_result(option("amplitude"), error))
}
