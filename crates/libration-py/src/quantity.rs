//! Angles, lengths and accelerations as Python passes them: numbers in SI units, or text with a unit.

use std::ffi::CString;
use std::fmt::Display;

use libration::quantity::{Angle, BareRadians, Dimension, parse};
use pyo3::exceptions::PyUserWarning;
use pyo3::prelude::*;

use crate::errors::{QuantityError, refusal};

/// A number or a text, as `_numbers.number` returns it.
#[derive(FromPyObject)]
pub(crate) enum Given {
    Text(String),
    Number(f64),
}

/// An angle: radians, or a text such as `60deg` or `pi-1e-6`.
pub(crate) fn angle(py: Python<'_>, parameter: &str, given: &Given) -> PyResult<Angle> {
    let angle = match given {
        Given::Text(text) => {
            warn_of_bare_radians(py, text)?;
            text.parse()
        }
        Given::Number(radians) => {
            warn_of_whole_radians(py, &radians.to_string())?;
            Angle::from_radians(*radians)
        }
    };
    angle.map_err(|error| about(py, parameter, error))
}

/// Warns of a number that may have been meant as degrees: computed angles in radians are rarely whole numbers.
pub(crate) fn warn_of_whole_radians(py: Python<'_>, text: &str) -> PyResult<()> {
    let is_whole = text.parse::<f64>().is_ok_and(|radians| radians.fract().abs() <= 0.0);
    if is_whole { warn_of_bare_radians(py, text) } else { Ok(()) }
}

/// Warns of a text without a unit that may have been meant as degrees.
fn warn_of_bare_radians(py: Python<'_>, text: &str) -> PyResult<()> {
    let Some(doubt) = BareRadians::in_text(text) else { return Ok(()) };
    let message = CString::new(doubt.to_string())?;
    let level = py.import("libration._numbers")?.call_method0("outside")?.extract()?;
    PyErr::warn(py, &py.get_type::<PyUserWarning>(), &message, level)
}

/// A quantity in SI units: a number, or a text with a unit, such as `99.4cm`.
pub(crate) fn quantity(
    py: Python<'_>,
    parameter: &str,
    given: &Given,
    dimension: Dimension,
) -> PyResult<f64> {
    match given {
        Given::Text(text) => Ok(parse(text, dimension).map_err(|error| about(py, parameter, error))?.value),
        Given::Number(value) => Ok(*value),
    }
}

/// The error in an argument, with the name of the argument, as in `UsageError`.
fn about(py: Python<'_>, parameter: &str, error: impl Display) -> PyErr {
    let exception = refusal::<QuantityError>(format!("{parameter}: {error}"));
    let set = exception.value(py).setattr("parameters", (parameter,));
    set.err().unwrap_or(exception)
}
