//! Numerical derivatives of functions of the inputs.

/// Step relative to the distance to the next point where the function ends, or to the value itself: the five-point rule then errs by the fourth
/// power of this, and rounding by 1e-16 over it.
const PART: f64 = 1e-3;

/// f′(x) by five points, at a distance from x of at most twice a thousandth of `reach`.
pub fn derivative(x: f64, reach: f64, f: impl Fn(f64) -> f64) -> f64 {
    let step = PART * reach;
    let difference = |steps: f64| f(x + steps * step) - f(x - steps * step);
    (8.0 * difference(1.0) - difference(2.0)) / (12.0 * step)
}

/// f″(x), by the same points.
pub fn second_derivative(x: f64, reach: f64, f: impl Fn(f64) -> f64) -> f64 {
    let step = PART * reach;
    let bend = |steps: f64| f(x + steps * step) - 2.0 * f(x) + f(x - steps * step);
    (16.0 * bend(1.0) - bend(2.0)) / (12.0 * step * step)
}
