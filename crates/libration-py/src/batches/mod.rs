//! The library's batch functions as ufuncs, each with its documentation in `docs`.

mod elliptic;
mod motion;
mod period;

use std::ffi::CStr;

use pyo3::prelude::*;

use crate::ufunc::{Batch, ufunc};

/// The name of a ufunc and its documentation, from the file with this name.
macro_rules! documented {
    ($name:literal) => {
        $crate::batches::Documented::new(
            concat!($name, "\0"),
            concat!(include_str!(concat!("../docs/", $name, ".rst")), "\0"),
        )
    };
}
use documented;

#[derive(Clone, Copy)]
struct Documented {
    name: &'static CStr,
    documentation: &'static CStr,
}

impl Documented {
    const fn new(name: &'static str, documentation: &'static str) -> Self {
        Self { name: terminated(name), documentation: terminated(documentation) }
    }
}

const fn terminated(text: &'static str) -> &'static CStr {
    match CStr::from_bytes_with_nul(text.as_bytes()) {
        Ok(text) => text,
        Err(_) => panic!("a text has no NUL but at its end"),
    }
}

/// Adds all ufuncs to the module.
pub(crate) fn add_all(module: &Bound<'_, PyModule>) -> PyResult<()> {
    period::add_all(module)?;
    motion::add_all(module)?;
    elliptic::add_all(module)
}

fn add<const N: usize, const M: usize>(
    module: &Bound<'_, PyModule>,
    Documented { name, documentation }: Documented,
    batch: Batch<N, M>,
) -> PyResult<()> {
    let ufunc = ufunc(module.py(), name, documentation, batch)?;
    module.add(name.to_str().expect("names are ASCII"), ufunc)
}
