//! The amplitude of an option `--amplitude`.

use crate::failure::Failure;
use libration::pendulum::Amplitude;
use libration::quantity::Angle;

/// The amplitude that the option `--amplitude` gives.
pub(crate) fn one_amplitude(angle: &Angle) -> Result<Amplitude, Failure> {
    Amplitude::new(*angle).map_err(|error| Failure::no_answer("--amplitude", error))
}
