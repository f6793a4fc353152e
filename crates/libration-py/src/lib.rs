//! The library for Python: the module `libration._native`, on which the package in `python/libration` stands.

mod batches;
mod ufunc;

use pyo3::prelude::*;

#[pymodule]
fn _native(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add("__version__", env!("CARGO_PKG_VERSION"))?;
    batches::add_all(module)
}
