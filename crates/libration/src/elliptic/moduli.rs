//! Moduli of a batch, and slices whose lengths differ.

/// The modulus of each element, in one of the ways in which a [`Modulus`](super::Modulus) is made: each is exactly the
/// `f64` given, from 0 to 1; elements outside give NaN.
#[derive(Clone, Copy, Debug)]
pub enum Moduli<'a> {
    /// m = k², as [`Modulus::from_parameter`](super::Modulus::from_parameter).
    Parameters(&'a [f64]),
    /// 1 − m, as [`Modulus::from_complementary_parameter`](super::Modulus::from_complementary_parameter).
    ComplementaryParameters(&'a [f64]),
    /// k, as [`Modulus::from_modulus`](super::Modulus::from_modulus).
    Moduli(&'a [f64]),
    /// k′, as [`Modulus::from_complementary_modulus`](super::Modulus::from_complementary_modulus).
    ComplementaryModuli(&'a [f64]),
}

impl<'a> Moduli<'a> {
    pub(super) fn values(&self) -> &'a [f64] {
        match self {
            Self::Parameters(values)
            | Self::ComplementaryParameters(values)
            | Self::Moduli(values)
            | Self::ComplementaryModuli(values) => values,
        }
    }
}

/// Slices of a batch whose lengths differ.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("slices of {expected} and {found} elements were given: give slices of one length")]
pub struct LengthMismatch {
    /// The length of the first slice.
    pub expected: usize,
    /// The length that differs from it.
    pub found: usize,
}

impl LengthMismatch {
    pub(crate) fn check(input: &[f64], output: &[f64]) -> Result<(), Self> {
        Self::check_lengths(input.len(), output.len())
    }

    pub(crate) fn check_lengths(expected: usize, found: usize) -> Result<(), Self> {
        if expected == found { Ok(()) } else { Err(Self { expected, found }) }
    }
}
