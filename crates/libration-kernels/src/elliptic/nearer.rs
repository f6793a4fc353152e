//! The nearer side of a modulus: the smaller of m and 1 − m, with the square root of the larger.
//!
//! All quantities of a modulus follow from its nearer side: those of the same side by series that converge in a few terms, those of the other
//! side by the logarithm of the nome.

use super::{Expansion, leg};
use crate::double_double::{DoubleDouble, fast_two_sum, pick};

/// The smaller of m and 1 − m, and the square root of the larger.
#[derive(Clone, Copy, Debug)]
pub struct Nearer {
    /// `true` if m is the larger, above one half.
    pub above: bool,
    /// The smaller parameter, times `RAISE`² if it is `raised`.
    pub(crate) smaller: DoubleDouble,
    /// `true` if the smaller parameter is below 1e-200, where its second word and quotients with it would underflow.
    pub raised: bool,
    /// √(1 − smaller), the square root of the larger parameter.
    pub(crate) root: DoubleDouble,
}

/// 2⁶⁰⁰.
const RAISE: f64 = 4.149515568880993e180;
/// Threshold below which a parameter is raised, and the modulus whose square is this threshold.
const SMALL: f64 = 1e-200;
const SMALL_MODULUS: f64 = 1e-100;

impl Nearer {
    /// The nearer side of the parameter m, 0 ≤ m ≤ 1.
    #[inline(always)]
    pub fn from_parameter(m: f64) -> Self {
        let above = m > 0.5;
        // Above one half the difference is exact.
        Self::from_smaller(above, if above { 1.0 - m } else { m })
    }

    /// The nearer side of the complementary parameter 1 − m.
    #[inline(always)]
    pub fn from_complementary_parameter(complementary: f64) -> Self {
        let above = complementary < 0.5;
        Self::from_smaller(above, if above { complementary } else { 1.0 - complementary })
    }

    #[inline(always)]
    pub(crate) fn from_modulus(modulus: f64) -> Self {
        let modulus = DoubleDouble::from(modulus);
        Self::from_words(modulus, leg(modulus))
    }

    #[inline(always)]
    pub(crate) fn from_complementary_modulus(complementary: f64) -> Self {
        let complementary = DoubleDouble::from(complementary);
        Self::from_words(leg(complementary), complementary)
    }

    #[inline(always)]
    fn from_smaller(above: bool, smaller: f64) -> Self {
        let raised = smaller < SMALL;
        let raise = if raised { RAISE } else { 1.0 };
        let root = fast_two_sum(1.0, -smaller).sqrt();
        Self { above, smaller: DoubleDouble::from(smaller * raise * raise), raised, root }
    }

    /// The nearer side of the modulus k with its complement k′.
    #[inline(always)]
    pub fn from_words(modulus: DoubleDouble, complementary: DoubleDouble) -> Self {
        let above = modulus.hi > complementary.hi;
        let (small, root) = if above { (complementary, modulus) } else { (modulus, complementary) };
        let raised = small.hi < SMALL_MODULUS;
        let smaller = small.scaled(if raised { RAISE } else { 1.0 }).square();
        Self { above, smaller, raised, root }
    }

    pub(crate) fn expansion(&self) -> Expansion {
        if self.above { Expansion::Hyperbolic } else { Expansion::Circular }
    }

    /// 1/`RAISE` if the smaller parameter is raised, otherwise 1.
    #[inline(always)]
    pub fn lowering(&self) -> f64 {
        if self.raised { 1.0 / RAISE } else { 1.0 }
    }

    /// m and 1 − m.
    #[inline(always)]
    pub(crate) fn parameters(&self) -> [DoubleDouble; 2] {
        let smaller = self.plain_smaller();
        let larger = DoubleDouble::ONE - smaller;
        [pick(self.above, larger, smaller), pick(self.above, smaller, larger)]
    }

    /// The smaller parameter without raising.
    #[inline(always)]
    pub(crate) fn plain_smaller(&self) -> DoubleDouble {
        self.smaller.scaled(self.lowering()).scaled(self.lowering())
    }
}
