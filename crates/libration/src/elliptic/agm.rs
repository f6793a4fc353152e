//! Complete integrals from the arithmetic–geometric mean, in two words.
//!
//! With a₀ = 1, b₀ = k′ and cₙ₊₁ = (aₙ − bₙ)/2: K = π/(2 agm(1, k′)) and E = K·(1 − k²/2 − Σₙ≥₁ 2ⁿ⁻¹cₙ²)
//! (DLMF 19.8.5, 19.8.6). The cₙ are kept divided by k, so that no square of a small k is formed.

use crate::double_double::DoubleDouble;

const TWO_TO_500: f64 = 3.273390607896142e150;

/// The complete integrals of one modulus.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Complete {
    /// K, infinite for k′ = 0.
    pub(crate) first: DoubleDouble,
    /// E.
    pub(crate) second: DoubleDouble,
    /// (E − k′²K)/k², from π/4 to 1: the integral of cos²φ/Δ.
    pub(crate) cosine_part: DoubleDouble,
    /// E − k′²K, relatively accurate however small k is.
    pub(crate) second_less_scaled_first: DoubleDouble,
}

/// The complete integrals of the modulus k with its complement k′.
pub(crate) fn complete(modulus: DoubleDouble, complementary: DoubleDouble) -> Complete {
    if complementary.hi == 0.0 {
        let first = DoubleDouble::from(f64::INFINITY);
        let one = DoubleDouble::ONE;
        return Complete { first, second: one, cosine_part: one, second_less_scaled_first: one };
    }
    // A small k′ is scaled with the rest, or the rounding errors of its products would underflow.
    let scale = if complementary.hi < 1e-150 { TWO_TO_500 } else { 1.0 };
    let (mut a, mut b) = (DoubleDouble::from(scale), complementary.scaled(scale));
    // cₙ = k·ratio.
    let k = modulus.scaled(scale);
    let mut ratio = DoubleDouble::ONE;
    let mut sum = DoubleDouble::ZERO;
    let mut weight = 0.5;
    // Below 2⁻⁵⁵ the next step, c²/4a, is beyond the second word; k′ = 1e-300 takes 15 steps.
    while k.hi * ratio.hi > 2.8e-17 * a.hi {
        let mean = (a + b).scaled(0.5);
        // c²/4 relatively accurate where (a − b)/2 would cancel.
        ratio = ratio.square() * (k / mean.scaled(4.0));
        b = (a * b).sqrt();
        a = mean;
        weight *= 2.0;
        sum = sum + ratio.square() * weight;
    }
    let first = DoubleDouble::FRAC_PI_2 / a.scaled(1.0 / scale);
    let parameter = modulus.square();
    let cosine_part = first * (DoubleDouble::from(0.5) - sum);
    let second = first * (DoubleDouble::ONE - parameter * (sum + 0.5));
    Complete { first, second, cosine_part, second_less_scaled_first: cosine_part * parameter }
}
