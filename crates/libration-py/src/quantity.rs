//! Angles, lengths and accelerations as Python gives them: numbers in SI units, or texts with units.

use std::ffi::CString;

use libration::quantity::{Angle, BareRadians, Dimension, parse};
use pyo3::exceptions::{PyTypeError, PyUserWarning};
use pyo3::prelude::*;

use crate::errors::{QuantityError, refusal};

/// An angle: radians, or a text such as `60deg` or `pi-1e-6`.
#[derive(Clone, Copy)]
pub(crate) struct GivenAngle(pub(crate) Angle);

impl<'a, 'py> FromPyObject<'a, 'py> for GivenAngle {
    type Error = PyErr;
    fn extract(given: Borrowed<'a, 'py, PyAny>) -> PyResult<Self> {
        let angle = match given.extract::<String>() {
            Ok(text) => {
                say_if_bare(given.py(), &text)?;
                text.parse()
            }
            Err(_) => Angle::from_radians(number(&given, "an angle, such as 1.0 or \"60deg\"")?),
        };
        Ok(Self(angle.map_err(refusal::<QuantityError>)?))
    }
}

/// Warns of a text without a unit that may have been meant as degrees.
fn say_if_bare(py: Python<'_>, text: &str) -> PyResult<()> {
    let Some(doubt) = BareRadians::in_text(text) else { return Ok(()) };
    let message = CString::new(doubt.to_string())?;
    PyErr::warn(py, &py.get_type::<PyUserWarning>(), &message, 2)
}

/// A quantity in SI units: a number, or a text with a unit, such as `99.4cm`.
pub(crate) fn quantity(given: &Bound<'_, PyAny>, dimension: Dimension) -> PyResult<f64> {
    match given.extract::<String>() {
        Ok(text) => Ok(parse(&text, dimension).map_err(refusal::<QuantityError>)?.value),
        Err(_) => number(given, &format!("{dimension}, such as {}", dimension.examples())),
    }
}

/// Any object with a `__float__`.
fn number(given: &Bound<'_, PyAny>, wanted: &str) -> PyResult<f64> {
    given.extract().map_err(|_| {
        let kind = given.get_type().name().map_or_else(|_| "object".to_owned(), |name| name.to_string());
        PyTypeError::new_err(format!("got {kind}: give {wanted}"))
    })
}
