//! Straight-line arithmetic on double-precision numbers, as machine code for several lanes side by side.
//!
//! An integrator repeats the same few thousand multiplications and additions in every step. A [`StraightLine`] is a list of these without loops
//! and branches. It is interpreted, or compiled on processors for which there is machine code. Both give the same bits: every operation is
//! rounded as IEEE 754 requires, in the order of the list.
//!
//! ```
//! use libration_jit::{Arithmetic, Compiled, StraightLine};
//!
//! // c = a·b + a, in two lanes.
//! let steps = vec![
//!     Arithmetic::Place(0),
//!     Arithmetic::Place(1),
//!     Arithmetic::MultiplyAdd(0, 1, 0),
//!     Arithmetic::Keep { value: 2, slot: 2 },
//! ];
//! let line = StraightLine::new(steps, 3, 0)?;
//! let mut places = [1.0, 2.0, 10.0, 20.0, 0.0, 0.0];
//! line.interpret(&mut places, &[], 2);
//! assert_eq!(places[4..], [11.0, 42.0]);
//! # Ok::<(), libration_jit::OutOfOrder>(())
//! ```
//!
//! Lines are compiled for x86-64 with fused multiply-add on Unix: with 4 or 8 lanes in a vector register, or with one lane, where up to four
//! inner products (eight with AVX-512) share a vector register.
//!
//! # Method
//! A value stays in its register until another value needs the register sooner. With one lane, sums of products of the same length are formed up
//! to four at a time, with AVX-512 up to eight (`groups.rs`, `assembly/packing.rs`). Their factors are packed next to each other as they become
//! known, once for all orders of the series, so that the code is half as long or less and fits the first-level instruction cache. The order of
//! operations within each sum does not change.

mod aligned;
mod inner_product;
mod interpreter;
mod straight_line;

#[cfg(all(target_arch = "x86_64", unix))]
mod assembly;
#[cfg(all(target_arch = "x86_64", unix))]
mod call;
#[cfg(all(target_arch = "x86_64", unix))]
mod groups;
#[cfg(all(target_arch = "x86_64", unix))]
mod instruction_set;
#[cfg(all(target_arch = "x86_64", unix))]
mod registers;
#[cfg(all(target_arch = "x86_64", unix))]
mod uses;
#[cfg(all(target_arch = "x86_64", unix))]
mod windows;
#[cfg(all(target_arch = "x86_64", unix))]
mod written_out;
mod compiled;

pub use aligned::Aligned;
pub use compiled::Compiled;
pub use inner_product::{MultiplyAdd, inner_product};
pub use straight_line::{Arithmetic, OutOfOrder, StraightLine};
