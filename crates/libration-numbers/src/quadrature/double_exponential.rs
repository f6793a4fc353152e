//! The double exponential rule, which maps both ends to infinity.

use std::f64::consts::PI;

use super::{Integral, equal_steps};

/// Number of points in a unit of the variable before the substitution.
const STEPS_PER_UNIT: f64 = 16.0;
/// Number of points on each side: at the last ones x is 2e-22 from an end.
const STEPS: i32 = 56;

/// ∫₀¹ f(x) dx of a function that is analytic between the ends, and at them bounded by a power above −1 of the distance.
///
/// # Accuracy
/// A few ε for functions that do not oscillate. For a power between −1 and 0, the integral from 0 to 2e-22 is missing, and if the singular end
/// is one, the rounding of x adds an error of `f`. `error` is estimated from other step lengths and the outermost terms.
///
/// # Examples
/// ```
/// # extern crate libration_numbers as libration;
/// use libration::quadrature::double_exponential;
/// let root = double_exponential(|x| x.powf(0.3));
/// assert!((root.value - 1.0 / 1.3).abs() < 1e-15 && root.error < 1e-14);
/// ```
///
/// # References
/// H. Takahasi and M. Mori, Publ. RIMS 9, 721 (1974), doi:10.2977/prims/1195192451.
pub fn double_exponential(f: impl Fn(f64) -> f64) -> Integral {
    let term = |step: i32| {
        let s = f64::from(step) / STEPS_PER_UNIT;
        // x/(1 − x) = e^(π sinh s), so that small x are as accurate as others.
        let ratio = libm::exp(PI * libm::sinh(s));
        let (x, rest) = (ratio / (1.0 + ratio), 1.0 / (1.0 + ratio));
        PI * libm::cosh(s) * x * rest * f(x)
    };
    let within = equal_steps(STEPS_PER_UNIT, -STEPS..=STEPS, term);
    // Beyond the last step each term is less than half of the one before.
    let beyond = (term(-STEPS).abs() + term(STEPS).abs()) / STEPS_PER_UNIT;
    Integral { error: within.error + beyond, ..within }
}
