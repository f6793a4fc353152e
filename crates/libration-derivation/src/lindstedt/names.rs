//! The names of the coefficients in the ansatz, and their cosines.

use super::super::formula::{Formula, Name, cos, letter, number};
use libration::algebra::Variable;
use libration::perturbation::OpenGauge;

/// aₖ.
pub(super) fn harmonic_name(k: usize) -> Name {
    Name::new("a").index(i64::try_from(k).unwrap_or(i64::MAX))
}

/// The symbol of the coefficient of εⁿ in aₖ.
pub(super) fn coefficient_name(k: usize, n: usize) -> Variable {
    let small = |n: usize| u32::try_from(n).unwrap_or(u32::MAX);
    OpenGauge::coefficient_name(small(k), small(n))
}

/// cos kτ, and 1 for k = 0.
pub(super) fn cosine(k: usize) -> Formula {
    match k {
        0 => number(1),
        1 => cos(letter("τ")),
        k => cos(Formula::from(i64::try_from(k).unwrap_or(i64::MAX)) * letter("τ")),
    }
}
