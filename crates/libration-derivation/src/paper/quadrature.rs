//! Integrals over a quarter period of functions that are smooth and periodic beyond it, for which the midpoint rule converges faster than any
//! power. Like the rest of the evidence it does not use the library's quadrature.

use std::f64::consts::FRAC_PI_2;

const POINTS: u32 = 60;

/// ∫ f(φ) dφ from 0 to π/2, for f even about both ends.
pub(super) fn quarter(f: &dyn Fn(f64) -> Option<f64>) -> Option<f64> {
    let step = FRAC_PI_2 / f64::from(POINTS);
    let values = (0..POINTS).map(|index| f(step * (f64::from(index) + 0.5)));
    Some(step * values.sum::<Option<f64>>()?)
}

/// ∫ f(θ) dθ from 0 to the amplitude, where f has an inverse-root singularity at the amplitude: with θ = θ0·sin φ.
pub(super) fn to_amplitude(amplitude: f64, f: &dyn Fn(f64) -> Option<f64>) -> Option<f64> {
    quarter(&|phi| {
        let (sine, cosine) = libm::sincos(phi);
        Some(f(amplitude * sine)? * amplitude * cosine)
    })
}
