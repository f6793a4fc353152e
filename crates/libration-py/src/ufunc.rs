//! NumPy's universal functions over batches of the library; with `ufunc_types` the only unsafe code of this crate.
//!
//! NumPy calls a loop with the first address, the stride in bytes and the number of elements of each array.
//! The loop copies a block of the inputs to the stack, calls the batch function, and copies its outputs back.
//! The batch function thus has slices of `f64` whatever the arrays are; outputs that overlap the inputs, as
//! far as NumPy allows it, never appear in a Rust slice. NumPy has released the interpreter's lock meanwhile.
//!
//! # Method
//! NumPy broadcasts, casts and buffers. Blocks have 8, 256 or 2048 elements, depending on the length of the call. The kernels
//! compute both sides of selections and therefore set meaningless floating-point flags: a loop restores the flags, and raises
//! `invalid` if an output is NaN and no input is. A panic becomes a Python exception; for this the package has a separate
//! profile (`Cargo.toml`). `python/libration/_native.pyi` declares the types, which NumPy's annotations of ufuncs do not.
#![expect(unsafe_code, reason = "loops over NumPy's arrays, and the flags of floating-point exceptions")]

#[cfg(target_arch = "x86_64")]
use std::arch::asm;
use std::array;
use std::ffi::{CStr, c_char, c_int, c_void};
use std::hint::black_box;

use libration::elliptic::LengthMismatch;
use numpy::npyffi::{NPY_TYPES, PY_UFUNC_API, PyUFuncGenericFunction, npy_intp};
use pyo3::prelude::*;

use crate::ufunc_types::choose_types;

/// A function of N inputs with M outputs, over slices of one length.
pub(crate) type Batch<const N: usize, const M: usize> =
    fn([&[f64]; N], [&mut [f64]; M]) -> Result<(), LengthMismatch>;

/// Elements per call of a batch function. The quantities of a common modulus are prepared once per batch; for `ellipj` this takes 3.3 µs, as
/// much as 260 elements. Six arrays of such blocks fit into the second-level cache.
const BLOCK: usize = 2048;
/// Block length for calls with few elements, which clear less memory: six full arrays take 2 µs, as much as 160 elements of `ellipj`.
const MIDDLE_BLOCK: usize = 256;
/// Block length for calls with one or a few numbers.
const SMALL_BLOCK: usize = 8;

/// The batch function as an `np.ufunc` with loops for `float32` and `float64`, between which `ufunc_types` chooses.
pub(crate) fn ufunc<'py, const N: usize, const M: usize>(
    py: Python<'py>,
    name: &'static CStr,
    documentation: &'static CStr,
    batch: Batch<N, M>,
) -> PyResult<Bound<'py, PyAny>> {
    let loops: [PyUFuncGenericFunction; 2] = [Some(inner_loop::<f32, N, M>), Some(inner_loop::<f64, N, M>)];
    let types = [f32::TYPE, f64::TYPE].map(|number| vec![number; N + M]).concat();
    let (loops, types) = (Box::leak(Box::new(loops)), Vec::leak(types));
    let batch: &'static mut Batch<N, M> = Box::leak(Box::new(batch));
    let data = Box::leak(Box::new([std::ptr::from_mut(batch).cast::<c_void>(); 2]));
    // SAFETY: the loops have NumPy's type, and their data are as they expect; loops, data, types, name
    // and documentation live as long as the process; the numbers are correct: two loops, each with a
    // type for every input and output. The result is a new reference, or null with an exception set.
    let ufunc = unsafe {
        let pointer = PY_UFUNC_API.PyUFunc_FromFuncAndData(
            py,
            loops.as_mut_ptr(),
            data.as_mut_ptr(),
            types.as_mut_ptr(),
            count_of(data.len()),
            count_of(N),
            count_of(M),
            NO_IDENTITY,
            name.as_ptr(),
            documentation.as_ptr(),
            0,
        );
        Bound::from_owned_ptr_or_err(py, pointer)?
    };
    choose_types(&ufunc);
    Ok(ufunc)
}

/// `PyUFunc_None` of NumPy: reductions have no initial value.
const NO_IDENTITY: c_int = -1;

fn count_of(arrays: usize) -> c_int {
    c_int::try_from(arrays).expect("ufuncs have few arrays")
}

/// A type of number in NumPy's arrays.
trait Number: Copy {
    const TYPE: c_char;
    fn to_f64(self) -> f64;
    fn from_f64(value: f64) -> Self;
}

impl Number for f64 {
    const TYPE: c_char = NPY_TYPES::NPY_DOUBLE as c_char;
    fn to_f64(self) -> f64 {
        self
    }
    fn from_f64(value: f64) -> Self {
        value
    }
}

impl Number for f32 {
    const TYPE: c_char = NPY_TYPES::NPY_FLOAT as c_char;
    fn to_f64(self) -> f64 {
        f64::from(self)
    }
    #[expect(clippy::cast_possible_truncation, reason = "the nearest f32")]
    fn from_f64(value: f64) -> Self {
        value as Self
    }
}

/// Elements of one array, a step in bytes apart.
#[derive(Clone, Copy)]
struct Strided {
    first: *mut c_char,
    step: npy_intp,
}

impl Strided {
    /// # Safety
    /// The array has an element of this type at this index.
    #[inline(always)]
    unsafe fn at<T>(self, element: usize) -> *mut T {
        self.first.wrapping_offset(self.step.wrapping_mul(element.cast_signed())).cast()
    }

    /// Visits the array. If elements of this type are contiguous, the stride is passed
    /// as a compile-time constant, so that the compiler can process several at once.
    #[inline(always)]
    fn walk<T>(self, visit: impl FnOnce(Self)) {
        let dense = Self { step: size_of::<T>().cast_signed(), ..self };
        if self.step == dense.step { visit(dense) } else { visit(self) }
    }

    /// # Safety
    /// The array has at least as many elements of type `T` from `start` on as the block.
    unsafe fn read<T: Number>(self, start: usize, block: &mut [f64]) {
        self.walk::<T>(|array| {
            for (i, value) in block.iter_mut().enumerate() {
                // SAFETY: guaranteed by the caller; alignment is not required.
                *value = unsafe { array.at::<T>(start + i).read_unaligned() }.to_f64();
            }
        });
    }

    /// # Safety
    /// As for [`Self::read`], and the elements may be written.
    unsafe fn write<T: Number>(self, start: usize, block: &[f64]) {
        self.walk::<T>(|array| {
            for (i, value) in block.iter().enumerate() {
                // SAFETY: guaranteed by the caller; alignment is not required.
                unsafe { array.at::<T>(start + i).write_unaligned(T::from_f64(*value)) };
            }
        });
    }
}

/// Inner loop that NumPy calls.
///
/// # Safety
/// `data` is a `Batch<N, M>`. `arguments` and `steps` have N + M entries, `dimensions` has one, the number of elements. Each array has this
/// number of elements of type `T` from its argument on, one stride apart, and the last M arrays may be written.
unsafe extern "C" fn inner_loop<T: Number, const N: usize, const M: usize>(
    arguments: *mut *mut c_char,
    dimensions: *mut npy_intp,
    steps: *mut npy_intp,
    data: *mut c_void,
) {
    // SAFETY: guaranteed by the caller.
    let (batch, count, arrays) = unsafe {
        let strided = |i: usize| Strided { first: *arguments.add(i), step: *steps.add(i) };
        (
            *data.cast::<Batch<N, M>>(),
            *dimensions,
            (array::from_fn(strided), array::from_fn(|i| strided(N + i))),
        )
    };
    let count = usize::try_from(count).unwrap_or(0);
    let flags = Flags::now();
    // SAFETY: guaranteed by the caller.
    let invalid = unsafe {
        if count <= SMALL_BLOCK {
            blocks::<T, N, M, SMALL_BLOCK>(batch, arrays, count)
        } else if count <= MIDDLE_BLOCK {
            blocks::<T, N, M, MIDDLE_BLOCK>(batch, arrays, count)
        } else {
            blocks::<T, N, M, BLOCK>(batch, arrays, count)
        }
    };
    flags.restore();
    if invalid {
        raise_invalid();
    }
}

/// Processes the arrays block by block; returns `true` if an output element is NaN and no input element is.
///
/// # Safety
/// Each array has `count` elements of type `T`; those of the second kind may be written.
unsafe fn blocks<T: Number, const N: usize, const M: usize, const SIZE: usize>(
    batch: Batch<N, M>,
    (inputs, outputs): ([Strided; N], [Strided; M]),
    count: usize,
) -> bool {
    let mut invalid = false;
    let (mut arguments, mut values) = ([[0.0; SIZE]; N], [[0.0; SIZE]; M]);
    for start in (0..count).step_by(SIZE) {
        let length = SIZE.min(count - start);
        for (input, block) in inputs.iter().zip(&mut arguments) {
            // SAFETY: these elements are below the count.
            unsafe { input.read::<T>(start, &mut block[..length]) };
        }
        batch(
            arguments.each_ref().map(|block| &block[..length]),
            values.each_mut().map(|block| &mut block[..length]),
        )
        .expect("blocks of one length");
        for (output, block) in outputs.iter().zip(&values) {
            // SAFETY: these elements are below the count.
            unsafe { output.write::<T>(start, &block[..length]) };
        }
        invalid |= has_new_nan(&arguments, &values, length);
    }
    invalid
}

/// Returns `true` if some element is NaN in an output and in no input.
fn has_new_nan<const N: usize, const M: usize, const SIZE: usize>(
    inputs: &[[f64; SIZE]; N],
    outputs: &[[f64; SIZE]; M],
    length: usize,
) -> bool {
    // In the usual case there is no NaN, which one pass without branches detects.
    let no_number =
        |block: &[f64; SIZE]| block[..length].iter().fold(false, |has_nan, value| has_nan | value.is_nan());
    if !outputs.iter().any(no_number) {
        return false;
    }
    let any = |blocks: &[[f64; SIZE]], i: usize| blocks.iter().any(|block| block[i].is_nan());
    (0..length).any(|i| any(outputs, i) && !any(inputs, i))
}

/// The floating-point exception flags, from which NumPy derives its warnings.
/// The kernels set some meaningless ones, since selections compute both sides.
struct Flags(Word);

#[cfg(target_arch = "x86_64")]
type Word = u32;
#[cfg(not(target_arch = "x86_64"))]
type Word = u64;

/// Reads and writes the register directly: C's functions also handle a unit that is not used here, and take a fifth of a microsecond.
#[cfg(target_arch = "x86_64")]
impl Flags {
    fn now() -> Self {
        let mut word = 0;
        // SAFETY: the instruction writes four bytes to the address, those of `word`.
        unsafe { asm!("stmxcsr [{}]", in(reg) &raw mut word, options(nostack, preserves_flags)) };
        Self(word)
    }

    fn restore(&self) {
        // SAFETY: the word was read from the register, whose rounding modes and masks have not changed since.
        unsafe { asm!("ldmxcsr [{}]", in(reg) &raw const self.0, options(nostack, preserves_flags)) };
    }
}

/// `FE_ALL_EXCEPT`, the same on all systems for other processors.
#[cfg(not(target_arch = "x86_64"))]
const ALL_FLAGS: c_int = 0x1f;

#[cfg(not(target_arch = "x86_64"))]
#[cfg_attr(unix, link(name = "m"))]
unsafe extern "C" {
    fn fegetexceptflag(flags: *mut u64, which: c_int) -> c_int;
    fn fesetexceptflag(flags: *const u64, which: c_int) -> c_int;
}

#[cfg(not(target_arch = "x86_64"))]
impl Flags {
    fn now() -> Self {
        let mut flags = 0;
        // SAFETY: no system's `fexcept_t` is larger than 64 bits.
        unsafe { fegetexceptflag(&raw mut flags, ALL_FLAGS) };
        Self(flags)
    }

    fn restore(&self) {
        // SAFETY: these flags were read by `fegetexceptflag`.
        unsafe { fesetexceptflag(&raw const self.0, ALL_FLAGS) };
    }
}

/// Raises the flag that NumPy reports as "invalid value encountered".
fn raise_invalid() {
    black_box(black_box(f64::INFINITY) - black_box(f64::INFINITY));
}
