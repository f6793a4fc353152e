//! Probability that chance gives a coefficient as far from zero as this.

use std::f64::consts::FRAC_2_PI;

use libration::roots::{Tolerance, bisect};

/// The probability that |t| of Student's distribution is at least this large; whole degrees of freedom, one or more.
///
/// The finite sums 26.7.3 and 26.7.4 of Abramowitz and Stegun.
///
/// # Accuracy
/// 1e-14 absolute.
pub fn probability_beyond(t: f64, dof: usize) -> f64 {
    let angle = libm::atan(t.abs() / super::count(dof).sqrt());
    let (sine, cosine) = (libm::sin(angle), libm::cos(angle));
    let odd = dof % 2 == 1;
    let mut term = if odd { cosine } else { 1.0 };
    let mut sum = 0.0;
    for k in (if odd { 2 } else { 1 }..dof).step_by(2) {
        sum += term;
        let k = super::count(k);
        term *= cosine * cosine * k / (k + 1.0);
    }
    let inside = if odd { FRAC_2_PI * (angle + sine * sum) } else { sine * sum };
    (1.0 - inside).clamp(0.0, 1.0)
}

/// The probability for any degrees of freedom, truncated to a whole number of at least one; infinite ones are allowed.
pub(crate) fn probability_beyond_any(t: f64, dof: f64) -> f64 {
    match whole(dof) {
        whole if whole < MANY => probability_beyond(t, to_count(whole)),
        _ => libm::erfc(t.abs() / std::f64::consts::SQRT_2),
    }
}

/// Degrees of freedom truncated to a whole number of at least one: 10 minus rounding errors is 10.
fn whole(dof: f64) -> f64 {
    /// Far above rounding, far below the effect of a degree of freedom.
    const ROUNDING: f64 = 1e-9;
    (dof * (1.0 + ROUNDING)).floor().max(1.0)
}

/// Degrees of freedom above which the quantile is the normal one with its first correction: the next is below 1e-8.
const MANY: f64 = 1e4;

/// The t that |t| exceeds with this probability. Degrees of freedom are truncated to a whole number (Guide to the Expression
/// of Uncertainty in Measurement, G.4.1) of at least one; infinite ones are allowed.
///
/// # Accuracy
/// 1e-8 relative for probabilities from 1e-3 to one half.
pub fn quantile(probability: f64, dof: f64) -> f64 {
    let whole = whole(dof);
    if whole < MANY {
        return root(|t| probability_beyond(t, to_count(whole)) > probability);
    }
    let normal = root(|z| libm::erfc(z / std::f64::consts::SQRT_2) > probability);
    // Abramowitz and Stegun 26.7.5.
    normal + 0.25 * normal * (normal * normal + 1.0) / whole
}

/// The point at which a condition that holds at zero ceases to hold.
fn root(holds: impl Fn(f64) -> bool) -> f64 {
    let [root, _] = bisect([0.0, 1e6], Tolerance::relative(1e-10), holds);
    root
}

#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a whole number from 1 to 1e4")]
fn to_count(whole: f64) -> usize {
    whole as usize
}
