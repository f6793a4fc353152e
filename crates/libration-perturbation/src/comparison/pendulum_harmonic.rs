//! The pendulum's harmonics as power series whose coefficients have one sign.
//!
//! With u = θ0², τ = iK′/K and the nome q = exp(iπτ), aₖ = ±(8/k)·q^(k/2)/(1 + qᵏ) = ±(4/k)/cos(kπτ/2) for odd k, and with G = T/T0 all
//! coefficients of ln(|aₖ|/θ0ᵏ) and of ln G by powers of u are positive beyond the first, so that those of |aₖ| and G are, and those
//! of 1/G = exp(−ln G) are no larger than those of G.
//!
//! For as a function of u these logarithms are analytic but for u ≥ π²: in the upper half plane of θ0 the parameter sin²(θ0/2) is neither
//! 0 nor 1. The first quadrant of θ0, which is the upper half plane of u, is mapped into the strip 0 < Re τ < 1: the interval 0 to π
//! on Re τ = 0, the imaginary axis on Re τ = 1. There cos(kπτ/2) is not zero, and its argument falls from 0 to −kπ/2 as Re τ grows. So
//! Im ln(|aₖ|/θ0ᵏ) = −arg cos(kπτ/2) − k·arg θ0 is zero on both of these, not negative on the real axis beyond π, and bounded: it is not negative in the
//! whole quadrant. Such a function (Pick's, or Nevanlinna's) is a constant plus ∫ (1/(s − u) − s/(1 + s²)) dρ(s) over s ≥ π² with a measure dρ ≥ 0,
//! and the coefficient of uⁿ is ∫ dρ/s^(n+1). For ln G the argument of K(m) grows by quarter turns each time θ0
//! passes above a multiple of π, as K becomes K + 2iK′, −3K + 2iK′, −3K − 4iK′, …

use std::f64::consts::PI;

use super::SeriesQuantity;
use super::exact::of_pendulum;
use crate::perturbation::PositiveSeries;
use libration_numbers::algebra::Rational;
use libration_numbers::quantity::Displacement;

/// The sizes of the coefficients of aₖ, by powers of the amplitude from zero.
pub(super) fn series_of_size(series: &[Rational], k: usize) -> PositiveSeries {
    PositiveSeries::new(series.iter().map(|coefficient| coefficient.to_f64().abs()).collect(), k, 2)
}

/// |aₖ| at an amplitude, or a little more; infinite from π on.
pub(super) fn size(amplitude: f64, k: usize) -> f64 {
    let exact = Displacement::from_f64(amplitude)
        .and_then(|displacement| of_pendulum(SeriesQuantity::Cosine(k), &displacement).ok())
        .filter(|_| amplitude < PI);
    exact.map_or(f64::INFINITY, |exact| exact.value.abs() + exact.uncertainty)
}
