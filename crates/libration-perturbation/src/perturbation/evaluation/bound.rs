//! The proven remainder of the pendulum's period series.

use libration_kernels::elementary::count;
use std::f64::consts::PI;

/// A bound of what is missing from T/T0 = Σ tₙθ0²ⁿ when it is cut off after θ0^(2·corrections); the true remainder is
/// positive, and rarely less than three quarters of the bound. Infinite from θ0 = π on.
///
/// All tₙ are positive and at most (11π⁴/1536)·π^(−2n)/n, with equality at n = 2. The recurrence that Legendre's
/// equation for T/T0 = P₋½(cos θ0) gives for n·tₙ·π²ⁿ makes it nearly the mean of its predecessors; interval arithmetic to
/// n = 400 and this inheritance bound all of them.
///
/// # Accuracy
/// The bound includes the rounding of its own evaluation.
#[must_use]
pub fn pendulum_period_remainder(amplitude: f64, corrections: usize) -> f64 {
    /// 11π⁴/1536, rounded up.
    const LARGEST: f64 = 0.697_591_146_728_6;
    const TERMS_SUMMED: usize = 64;
    let x = (amplitude / PI) * (amplitude / PI);
    if x.is_nan() || x >= 1.0 {
        return if x.is_nan() { x } else { f64::INFINITY };
    }
    let n = count(corrections);
    // Σ xⁿ/n beyond the corrections: some terms, and for the rest a geometric series.
    let first = libm::pow(x, n + 1.0);
    let (mut power, mut sum) = (first, 0.0);
    for j in 1..=TERMS_SUMMED {
        sum += power / (n + count(j));
        power *= x;
    }
    let rest = power / ((n + count(TERMS_SUMMED + 1)) * (1.0 - x));
    // x is right to four roundings, which its powers multiply.
    let rounding = 1.0 + (n + 2.0 * count(TERMS_SUMMED)) * 4.0 * f64::EPSILON / (1.0 - x);
    LARGEST * (sum + rest) * rounding
}
