//! Legendre's incomplete integrals from Carlson's symmetric ones (DLMF 19.25.5, 19.25.9).

use super::{Modulus, carlson};
use crate::double_double::DoubleDouble;
use crate::elementary::two_word;

/// φ = `half_turns`·π + rest, |rest| ≤ π/2, with the sine and cosine of the rest.
struct Reduced {
    half_turns: f64,
    sine: DoubleDouble,
    cosine: DoubleDouble,
}

/// Beyond this many half turns an `f64` says little of the fraction.
const MOST_HALF_TURNS: f64 = 4503599627370496.0;

fn reduce(phi: f64) -> Reduced {
    let half_turns = (phi * std::f64::consts::FRAC_1_PI).round_ties_even();
    if half_turns.abs() > MOST_HALF_TURNS {
        return Reduced { half_turns, sine: DoubleDouble::ZERO, cosine: DoubleDouble::ONE };
    }
    let third_word = DoubleDouble::PI_TAIL.lo * half_turns;
    let rest = DoubleDouble::from(phi)
        - crate::double_double::two_prod(DoubleDouble::PI.hi, half_turns)
        - crate::double_double::two_prod(DoubleDouble::PI.lo, half_turns)
        - DoubleDouble::from(third_word);
    let (sine, cosine) = two_word::sin_cos(rest);
    Reduced { half_turns, sine, cosine: cosine.abs() }
}

/// √(1 − k² sin²φ) as √(cos²φ + k′² sin²φ), scaled so that the squares do not underflow.
fn delta(sine: DoubleDouble, cosine: DoubleDouble, complementary: DoubleDouble) -> DoubleDouble {
    let other = (complementary * sine).abs();
    let (large, small) = if cosine.hi > other.hi { (cosine, other) } else { (other, cosine) };
    if large.hi == 0.0 {
        return DoubleDouble::ZERO;
    }
    large * (DoubleDouble::ONE + (small / large).square()).sqrt()
}

/// F at the point with this sine, cosine ≥ 0 and delta = dn.
pub(crate) fn first_of_point(sine: DoubleDouble, cosine: DoubleDouble, delta: DoubleDouble) -> DoubleDouble {
    sine * carlson::first_kind(cosine, delta, DoubleDouble::ONE)
}

pub(super) fn first(modulus: &Modulus, phi: f64) -> f64 {
    if phi == 0.0 || !phi.is_finite() {
        return if phi == 0.0 { phi } else { f64::NAN };
    }
    let Reduced { half_turns, sine, cosine } = reduce(phi);
    if modulus.complementary.hi == 0.0 && half_turns != 0.0 {
        return f64::INFINITY.copysign(phi);
    }
    let delta = delta(sine, cosine, modulus.complementary);
    let partial = first_of_point(sine, cosine, delta);
    if half_turns == 0.0 {
        partial.to_f64()
    } else {
        (modulus.integrals.first * (2.0 * half_turns) + partial).to_f64()
    }
}

pub(super) fn second(modulus: &Modulus, phi: f64) -> f64 {
    if phi == 0.0 || !phi.is_finite() {
        return if phi == 0.0 { phi } else { f64::NAN };
    }
    let Reduced { half_turns, sine, cosine } = reduce(phi);
    let partial = if modulus.complementary.hi == 0.0 {
        sine
    } else {
        let delta = delta(sine, cosine, modulus.complementary);
        let parameter = modulus.modulus.square() * sine.square() / 3.0;
        first_of_point(sine, cosine, delta)
            - sine * parameter * carlson::second_kind(cosine, delta, DoubleDouble::ONE)
    };
    (modulus.integrals.second * (2.0 * half_turns) + partial).to_f64()
}
