//! Legendre's incomplete integrals from Carlson's symmetric ones (DLMF 19.25.5, 19.25.9).

use super::{Modulus, carlson};
use crate::double_double::{DoubleDouble, two_prod, two_sum};
use crate::elementary::two_word;

/// φ = `half_turns`·π + rest, |rest| ≤ π/2, with the sine of the rest and its cosine, which is at least zero.
struct Reduced {
    half_turns: DoubleDouble,
    sine: DoubleDouble,
    cosine: DoubleDouble,
}

/// From here on an integral is its mean growth: what it is beyond, at most its value at π/2, is below a hundredth
/// of an ulp.
const LARGEST_REDUCED: f64 = 1e18;

/// π/2 less its two words.
const FRAC_PI_2_THIRD: f64 = 0.5 * DoubleDouble::PI_TAIL.lo;

/// By the nearest quarter turn, from which sine and cosine are both relatively accurate: on which side of an odd
/// quarter φ lies is then the sign of the rest, and not a rounded quotient.
fn reduce(phi: f64) -> Reduced {
    let (first, rest) = nearest_quarter(DoubleDouble::from(phi));
    // The first quotient may be wrong by its last bit, which is many quarters beyond 2⁵³ of them.
    let (second, rest) = nearest_quarter(rest);
    let quarters = two_sum(first, second);
    let (sine, cosine) = two_word::sin_cos(rest);
    let odd = (first.rem_euclid(2.0) - second.rem_euclid(2.0)).abs() > 0.5;
    match (odd, rest.hi > 0.0) {
        (false, _) => Reduced { half_turns: quarters.scaled(0.5), sine, cosine },
        (true, false) => Reduced { half_turns: (quarters - 1.0).scaled(0.5), sine: cosine, cosine: -sine },
        (true, true) => Reduced { half_turns: (quarters + 1.0).scaled(0.5), sine: -cosine, cosine: sine },
    }
}

/// The nearest number of quarter turns, and what is left of the angle.
fn nearest_quarter(angle: DoubleDouble) -> (f64, DoubleDouble) {
    let quarters = (angle.hi * std::f64::consts::FRAC_2_PI).round_ties_even();
    let rest = angle
        - two_prod(DoubleDouble::FRAC_PI_2.hi, quarters)
        - two_prod(DoubleDouble::FRAC_PI_2.lo, quarters)
        - FRAC_PI_2_THIRD * quarters;
    (quarters, rest)
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
    if modulus.complementary.hi == 0.0 && phi.abs() > std::f64::consts::FRAC_PI_2 && phi.is_finite() {
        return f64::INFINITY.copysign(phi);
    }
    from_quarter(phi, modulus.integrals.first, |sine, cosine| {
        first_of_point(sine, cosine, delta(sine, cosine, modulus.complementary))
    })
}

pub(super) fn second(modulus: &Modulus, phi: f64) -> f64 {
    from_quarter(phi, modulus.integrals.second, |sine, cosine| {
        if modulus.complementary.hi == 0.0 {
            return sine;
        }
        let delta = delta(sine, cosine, modulus.complementary);
        let parameter = modulus.modulus.square() * sine.square() / 3.0;
        first_of_point(sine, cosine, delta)
            - sine * parameter * carlson::second_kind(cosine, delta, DoubleDouble::ONE)
    })
}

/// The integral to φ from its value at π/2 and as a function of the sine and cosine of what is left of φ.
fn from_quarter(
    phi: f64,
    quarter: DoubleDouble,
    partial: impl Fn(DoubleDouble, DoubleDouble) -> DoubleDouble,
) -> f64 {
    if phi == 0.0 || !phi.is_finite() {
        return if phi == 0.0 { phi } else { f64::NAN };
    }
    if phi.abs() > LARGEST_REDUCED {
        return mean_growth(quarter, phi);
    }
    let Reduced { half_turns, sine, cosine } = reduce(phi);
    let partial = partial(sine, cosine);
    // Infinite quarters would not vanish with no turns.
    if half_turns.hi == 0.0 {
        partial.to_f64()
    } else {
        (quarter * half_turns.scaled(2.0) + partial).to_f64()
    }
}

/// quarter·2φ/π, which may overflow.
fn mean_growth(quarter: DoubleDouble, phi: f64) -> f64 {
    let (fraction, exponent) = libm::frexp(phi);
    libm::scalbn((quarter * DoubleDouble::FRAC_2_PI * fraction).to_f64(), exponent)
}
