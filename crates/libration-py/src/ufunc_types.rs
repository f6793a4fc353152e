//! Element types with which a ufunc computes, from the types of its arguments.
//!
//! # Method
//! NumPy alone would take the first loop to which all arguments can be cast safely: for integers of 8 and 16 bits,
//! booleans and `float16` this is the `float32` loop, and Python numbers in the same call would be rounded to
//! single precision. Here calls without single-precision arguments are computed in `float64`, and text and objects
//! are rejected with the name of their argument. NumPy decides on other types, and if the caller requests one.
#![expect(unsafe_code, reason = "a function that NumPy calls with its own structures")]

use std::ffi::{CStr, c_int};

use numpy::npyffi::{
    NPY_CASTING, NPY_TYPES, PY_ARRAY_API, PY_UFUNC_API, PyArray_Descr, PyArrayObject, PyUFuncObject,
};
use numpy::{PyArrayDescrMethods, PyUntypedArray, PyUntypedArrayMethods};
use pyo3::exceptions::PyTypeError;
use pyo3::ffi::PyObject;
use pyo3::prelude::*;

/// Makes the ufunc choose its types by [`resolve`].
pub(crate) fn choose_types(ufunc: &Bound<'_, PyAny>) {
    let ufunc = ufunc.as_ptr().cast::<PyUFuncObject>();
    // SAFETY: NumPy made the ufunc, and reads the field when the ufunc is called, which needs the interpreter, as this call does.
    unsafe { (*ufunc).fields.type_resolver = Some(resolve) };
}

/// The types of all arguments and results; -1 with an exception set if there are none.
///
/// # Safety
/// As for NumPy's `type_resolver`: attached to the interpreter, with as many
/// operands and entries of types as the ufunc has arguments and results.
unsafe extern "C" fn resolve(
    ufunc: *mut PyUFuncObject,
    casting: NPY_CASTING,
    operands: *mut *mut PyArrayObject,
    requested: *mut PyObject,
    types: *mut *mut PyArray_Descr,
) -> c_int {
    // SAFETY: guaranteed by the caller; an operand that is not null is an array.
    let (py, inputs, count) = unsafe {
        let (py, of) = (Python::assume_attached(), &(*ufunc).fields);
        let operand = |i| Bound::from_borrowed_ptr_or_opt(py, (*operands.add(i)).cast());
        let array = |i| Some(operand(i)?.cast_into_unchecked::<PyUntypedArray>());
        let inputs: Option<Vec<_>> = (0..usize::try_from(of.nin).unwrap_or(0)).map(array).collect();
        (py, inputs.unwrap_or_default(), usize::try_from(of.nargs).unwrap_or(0))
    };
    if let Some(wrong) = inputs.iter().position(|input| is_text(input) || is_object(input)) {
        // SAFETY: the name and the documentation of a ufunc live as long as the ufunc.
        let documentation = unsafe { CStr::from_ptr((*ufunc).fields.doc) }.to_string_lossy();
        refusal(&documentation, wrong, &inputs[wrong]).restore(py);
        return -1;
    }
    if requested.is_null() && !inputs.is_empty() && inputs.iter().all(is_double) {
        for i in 0..count {
            // SAFETY: guaranteed by the caller; each entry gets a reference of its own.
            unsafe { *types.add(i) = PY_ARRAY_API.PyArray_DescrFromType(py, NPY_TYPES::NPY_DOUBLE as c_int) };
        }
        return 0;
    }
    // SAFETY: guaranteed by the caller.
    unsafe { PY_UFUNC_API.PyUFunc_DefaultTypeResolver(py, ufunc, casting, operands, requested, types) }
}

type Input<'py> = Bound<'py, PyUntypedArray>;

fn is_among(input: &Input<'_>, types: &[NPY_TYPES]) -> bool {
    types.iter().any(|kind| *kind as c_int == input.dtype().num())
}

fn is_text(input: &Input<'_>) -> bool {
    is_among(input, &[NPY_TYPES::NPY_STRING, NPY_TYPES::NPY_UNICODE])
}

fn is_object(input: &Input<'_>) -> bool {
    is_among(input, &[NPY_TYPES::NPY_OBJECT])
}

/// Returns `true` for booleans, integers of any size, half and double precision.
fn is_double(input: &Input<'_>) -> bool {
    let integers = NPY_TYPES::NPY_BOOL as c_int..=NPY_TYPES::NPY_ULONGLONG as c_int;
    integers.contains(&input.dtype().num()) || is_among(input, &[NPY_TYPES::NPY_HALF, NPY_TYPES::NPY_DOUBLE])
}

fn refusal(documentation: &str, argument: usize, input: &Input<'_>) -> PyErr {
    let mut names = documentation.lines().filter_map(|line| line.strip_suffix(" : array_like"));
    let name = names.nth(argument).unwrap_or("argument");
    PyTypeError::new_err(if is_text(input) {
        let text = first(input)
            .and_then(|array| array.call_method0("item")?.repr())
            .map_or("text".into(), |text| text.to_string());
        format!(
            "{name}: got {text}: give a number or an array of numbers, in SI units and radians: numpy.radians(60) for 60deg"
        )
    } else {
        let kind = first(input)
            .and_then(|object| object.get_type().name())
            .map_or("objects".into(), |kind| kind.to_string());
        format!(
            "{name}: got {kind}: give a float or an array of floats, such as numpy.asarray(values, dtype=float)"
        )
    })
}

fn first<'py>(input: &Input<'py>) -> PyResult<Bound<'py, PyAny>> {
    input.getattr("flat")?.get_item(0)
}
