//! The exceptions of the package, defined in `python/libration/errors.py`, with the library's messages.

use std::fmt::Display;

use pyo3::import_exception;
use pyo3::prelude::*;

import_exception!(libration.errors, ExpansionError);
import_exception!(libration.errors, FormulaError);
import_exception!(libration.errors, MissingFile);
import_exception!(libration.errors, NoAnswer);
import_exception!(libration.errors, PendulumError);
import_exception!(libration.errors, QuantityError);
import_exception!(libration.errors, SimulationError);
import_exception!(libration.errors, UnknownKeyError);
import_exception!(libration.errors, UsageError);

/// An exception of the package.
pub(crate) trait Exception {
    fn with(message: String) -> PyErr;
}

macro_rules! exceptions {
    ($($name:ident),*) => {
        $(impl Exception for $name {
            fn with(message: String) -> PyErr {
                Self::new_err(message)
            }
        })*
    };
}

exceptions!(
    ExpansionError,
    FormulaError,
    MissingFile,
    NoAnswer,
    PendulumError,
    QuantityError,
    SimulationError,
    UnknownKeyError,
    UsageError
);

/// The library's message as an exception of this kind.
pub(crate) fn refusal<E: Exception>(error: impl Display) -> PyErr {
    E::with(error.to_string())
}
