//! Complete integrals in two words.
//!
//! # Method
//! K(√p), the nome q and its logarithm come from the series of `descent.rs`. The integral of the second kind on the far side follows by
//! Legendre's relation (DLMF 19.7.1), the far nome from ln q·ln q′ = π². The sum of the later squared differences of the arithmetic–geometric
//! mean is kept divided by p, so that E − k′²K = k²·K·(½ − sum) keeps its digits, and with it the action of the smallest swings.

use super::descent::Descent;
use super::nearer::Nearer;
use crate::dispatch::{Kernel, dispatch};
use crate::double_double::DoubleDouble;

/// The complete integrals of one modulus.
#[derive(Clone, Copy, Debug)]
pub struct Complete {
    /// K, infinite for k′ = 0.
    pub first: DoubleDouble,
    /// E.
    pub second: DoubleDouble,
    /// (E − k′²K)/k², from π/4 to 1: the integral of cos²φ/Δ.
    pub cosine_part: DoubleDouble,
    /// E − k′²K, relatively accurate however small k is.
    pub second_less_scaled_first: DoubleDouble,
}

/// The complete integrals of the modulus k with its complement k′.
pub fn complete(modulus: DoubleDouble, complementary: DoubleDouble) -> Complete {
    dispatch(CompleteOfWords(modulus, complementary))
}

struct CompleteOfWords(DoubleDouble, DoubleDouble);

impl Kernel for CompleteOfWords {
    type Output = Complete;
    #[inline(always)]
    fn run(self) -> Complete {
        let nearer = Nearer::from_words(self.0, self.1);
        let descent = Descent::new(&nearer);
        Complete::new(&nearer, &descent, descent.log_inverse_nome(nearer.raised))
    }
}

impl Complete {
    /// Computes the integrals of a modulus, given ln(1/q).
    #[inline(always)]
    pub(crate) fn new(nearer: &Nearer, descent: &Descent, log: DoubleDouble) -> Self {
        let (near, later) = (descent.near_quarter(), descent.later_differences(nearer));
        if nearer.above {
            return Self::far(nearer, near, later, log);
        }
        let cosine_part = cosine_part_near(near, later);
        let parameter = nearer.plain_smaller();
        Self {
            first: near,
            second: second_near(nearer, near, later),
            cosine_part,
            second_less_scaled_first: cosine_part * parameter,
        }
    }

    /// Computes the integrals by Legendre's relation (DLMF 19.7.1), E = π/2K′ + (1 − E′/K′)·K.
    #[inline(always)]
    fn far(nearer: &Nearer, near: DoubleDouble, later: DoubleDouble, log: DoubleDouble) -> Self {
        if nearer.smaller.hi == 0.0 {
            let (first, one) = (DoubleDouble::from(f64::INFINITY), DoubleDouble::ONE);
            return Self { first, second: one, cosine_part: one, second_less_scaled_first: one };
        }
        let first = Descent::far_quarter(near, log);
        let less = second_less_scaled_first_far(nearer, near, later, first);
        Self {
            first,
            second: second_far(nearer, near, later, log),
            cosine_part: less.over(nearer.root.square()),
            second_less_scaled_first: less,
        }
    }
}

/// (E − k′²K)/k² of the modulus √p.
#[inline(always)]
pub(super) fn cosine_part_near(near: DoubleDouble, later: DoubleDouble) -> DoubleDouble {
    near * (DoubleDouble::from(0.5) - later)
}

/// E − k′²K of the modulus c, given K(c).
#[inline(always)]
pub(super) fn second_less_scaled_first_far(
    nearer: &Nearer,
    near: DoubleDouble,
    later: DoubleDouble,
    first: DoubleDouble,
) -> DoubleDouble {
    let product = DoubleDouble::FRAC_PI_2.over(near);
    let scaled = nearer.plain_smaller() * first;
    product - scaled * (DoubleDouble::from(0.5) - later)
}

/// E(√p) = K(√p)·(1 − p·(½ + later differences)).
#[inline(always)]
pub(crate) fn second_near(nearer: &Nearer, near: DoubleDouble, later: DoubleDouble) -> DoubleDouble {
    near * (DoubleDouble::ONE - nearer.plain_smaller() * (later + 0.5))
}

/// E(c) = π/2K(√p) + p·(½ + later differences)·K(c).
#[inline(always)]
pub(crate) fn second_far(
    nearer: &Nearer,
    near: DoubleDouble,
    later: DoubleDouble,
    log: DoubleDouble,
) -> DoubleDouble {
    let first = Descent::far_quarter(near, log);
    let small = nearer.plain_smaller() * (later + 0.5) * first;
    let sum = DoubleDouble::FRAC_PI_2.over(near).plus_smaller(small);
    // Avoids 0·∞.
    if nearer.smaller.hi == 0.0 { DoubleDouble::ONE } else { sum }
}
