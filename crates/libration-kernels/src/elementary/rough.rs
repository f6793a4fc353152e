//! Powers of two and their logarithms to a few digits, where an approximate value suffices.

use super::{nearest_integer, polynomial, power_of_two};

/// log₂ m for 1 ≤ m ≤ 2 at Chebyshev's points, absolute error 1.0e-4.
const LOGARITHM: [f64; 5] = [-2.50561466, 4.04961689, -2.09940228, 0.63551112, -0.08001088];
/// 2ˣ for |x| ≤ 1/2 at Chebyshev's points, absolute error 2.7e-6.
const POWER: [f64; 5] = [1.00000008, 0.69312103, 0.24022107, 0.05592204, 0.00967604];

/// log₂ x for x ≥ 0 within 2e-4; −∞ for zero. Subnormal numbers count as about 2⁻¹⁰²³.
#[inline(always)]
pub fn log2(x: f64) -> f64 {
    /// The bits of the mantissa.
    const MANTISSA: u64 = (1 << 52) - 1;
    /// 2⁵²: the next numbers differ by 1.
    const TWO_TO_52: f64 = 4503599627370496.0;
    let bits = x.to_bits();
    let mantissa = f64::from_bits((bits & MANTISSA) | 1.0_f64.to_bits());
    // 2⁵² + n has the integer n in its last bits.
    let exponent = f64::from_bits((bits >> 52) | TWO_TO_52.to_bits()) - (TWO_TO_52 + 1023.0);
    let logarithm = exponent + polynomial(mantissa, &LOGARITHM);
    if x == 0.0 { f64::NEG_INFINITY } else { logarithm }
}

/// 2ˣ with a relative error of 1e-5 for |x| ≤ 1000, and 2^±1000 beyond.
#[inline(always)]
pub fn exp2(x: f64) -> f64 {
    let x = x.clamp(-1000.0, 1000.0);
    let whole = nearest_integer(x);
    polynomial(x - whole, &POWER) * power_of_two(whole)
}
