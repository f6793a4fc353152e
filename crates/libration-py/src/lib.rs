//! The library for Python: the module `libration._native`, on which the package in `python/libration` is built.

mod asking;
mod batches;
mod errors;
mod expansion;
mod formulas;
mod motion;
mod progress;
mod quantity;
mod simulation;
mod sweeping;
mod ufunc;
mod ufunc_types;

use pyo3::prelude::*;

#[pymodule]
fn _native(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add("__version__", env!("CARGO_PKG_VERSION"))?;
    module.add("STANDARD_GRAVITY", libration::quantity::STANDARD_GRAVITY)?;
    module.add_class::<motion::NativeMotion>()?;
    module.add_class::<formulas::NativeFormula>()?;
    module.add_function(wrap_pyfunction!(motion::pendulum, module)?)?;
    module.add_function(wrap_pyfunction!(formulas::formula_keys, module)?)?;
    module.add_function(wrap_pyfunction!(formulas::simplest_formulas, module)?)?;
    module.add_class::<expansion::NativeExpansion>()?;
    module.add_function(wrap_pyfunction!(expansion::expand, module)?)?;
    module.add_function(wrap_pyfunction!(expansion::latex, module)?)?;
    module.add_class::<simulation::NativeSimulation>()?;
    module.add_function(wrap_pyfunction!(simulation::simulate, module)?)?;
    module.add_class::<asking::Chart>()?;
    module.add_function(wrap_pyfunction!(asking::ask, module)?)?;
    module.add_function(wrap_pyfunction!(asking::program, module)?)?;
    module.add_function(wrap_pyfunction!(asking::questions, module)?)?;
    module.add_function(wrap_pyfunction!(sweeping::sweep_plan, module)?)?;
    module.add_function(wrap_pyfunction!(sweeping::sweep_chunk, module)?)?;
    batches::add_all(module)
}
