//! Moduli of a batch, and slices whose lengths differ.

use super::Modulus;
use super::nearer::Nearer;

/// The modulus of each element, given in one of the ways in which a [`Modulus`](super::Modulus) is made. Each `f64` is taken as exact, from 0 to
/// 1; elements outside give NaN.
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

    /// Computes few moduli one by one by a function of the index and the modulus; NaN where there is no modulus.
    pub(super) fn one_by_one<const M: usize>(
        &self,
        mut results: [&mut [f64]; M],
        function: impl Fn(usize, &Modulus) -> [f64; M],
    ) {
        for i in 0..self.values().len() {
            let values = self.modulus(i).map_or([f64::NAN; M], |modulus| function(i, &modulus));
            for (result, value) in results.iter_mut().zip(values) {
                result[i] = value;
            }
        }
    }

    /// The nearer side of a modulus given by the quantity of this variant; an arbitrary side for a value outside [0, 1].
    #[inline(always)]
    pub(super) fn nearer(&self, value: f64) -> Nearer {
        match self {
            Self::Parameters(_) => Nearer::from_parameter(value),
            Self::ComplementaryParameters(_) => Nearer::from_complementary_parameter(value),
            Self::Moduli(_) => Nearer::from_modulus(value),
            Self::ComplementaryModuli(_) => Nearer::from_complementary_modulus(value),
        }
    }

    /// The nearer side of element `i`, if the element is a modulus.
    pub(super) fn inside(&self, i: usize) -> Option<Nearer> {
        let value = self.values()[i];
        (0.0..=1.0).contains(&value).then(|| self.nearer(value))
    }

    pub(super) fn modulus(&self, i: usize) -> Option<Modulus> {
        let value = self.values()[i];
        let modulus = match self {
            Self::Parameters(_) => Modulus::from_parameter(value),
            Self::ComplementaryParameters(_) => Modulus::from_complementary_parameter(value),
            Self::Moduli(_) => Modulus::from_modulus(value),
            Self::ComplementaryModuli(_) => Modulus::from_complementary_modulus(value),
        };
        modulus.ok()
    }
}

/// Largest number of elements that take less time one by one than in a block.
pub(super) const FEW: usize = 6;

/// Slices of a batch whose lengths differ.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("slices of {expected} and {found} elements were given: give slices of one length")]
pub struct LengthMismatch {
    /// The length of the first slice.
    pub expected: usize,
    /// The length that differs from that of the first slice.
    pub found: usize,
}

impl LengthMismatch {
    #[doc(hidden)]
    pub fn check(input: &[f64], output: &[f64]) -> Result<(), Self> {
        Self::check_lengths(input.len(), output.len())
    }

    #[doc(hidden)]
    pub fn check_lengths(expected: usize, actual: usize) -> Result<(), Self> {
        if expected == actual { Ok(()) } else { Err(Self { expected, found: actual }) }
    }
}
