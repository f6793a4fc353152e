//! Functions of a phase: polynomials in it times harmonics, with fractions and powers of π, as they arise from weak forces on an oscillation.

pub(crate) mod function;
pub(crate) mod pi_number;
pub(crate) mod written;

pub(super) use function::{PhaseFunction, Wave};
pub(super) use pi_number::PiNumber;
pub(super) use written::{number, series, term_with};
