//! From an initial state to the energy, without cancellation next to the separatrix.
//!
//! The motion is a libration, a separatrix or a rotation as 4g·cos²(θ/2) − l·θ′² is positive, zero or
//! negative. The difference divided by 4g is 1 − e, with e = E/(2mgl), and it is needed relatively accurate:
//! next to the separatrix the period is its logarithm.

use std::cmp::Ordering;

use crate::algebra::BigFloat;
use crate::double_double::{DoubleDouble, two_prod};
use crate::quantity::Angle;

/// How the energy lies to that of the separatrix, with √|1 − e|.
pub(super) struct Separation {
    /// Less in libration, greater in rotation.
    pub(super) energy: Ordering,
    /// √|1 − e|, relatively accurate.
    pub(super) root: DoubleDouble,
}

/// Where the difference of the two words has lost more than this it is recomputed.
const LOST: f64 = 1.0 / 1048576.0;

/// Bits of the first and the second recomputation. The second tells apart what a complement of 1e-300 allows,
/// a relative difference of δ²; equality is possible at θ = 0 only and is exact.
const BITS: [usize; 2] = [640, 2600];

/// Below this the squares are formed after scaling by its inverse square root.
const SMALL: f64 = 1e-150;
/// 2⁵⁰⁰.
const SCALE: f64 = 3.273390607896142e150;

/// The energy of the state against that of the separatrix, `None` where the difference is not zero but below
/// the range of `f64`; `cosine` is cos(θ/2) ≥ 0, `scaled_velocity` θ′/2ω0.
pub(super) fn separation(
    angle: &Angle,
    cosine: DoubleDouble,
    velocity: f64,
    scaled_velocity: DoubleDouble,
    (gravity, length): (DoubleDouble, f64),
) -> Option<Separation> {
    if velocity == 0.0 {
        return Some(Separation { energy: Ordering::Less, root: cosine });
    }
    let small = cosine.hi.max(scaled_velocity.hi.abs()) < SMALL;
    let scale = if small { SCALE } else { 1.0 };
    let top = cosine.scaled(scale).square();
    let kinetic = two_prod(velocity * scale, velocity * scale) * length / gravity.scaled(4.0);
    let mut difference = top - kinetic;
    for bits in BITS {
        if difference.hi.abs() > LOST * top.hi {
            break;
        }
        difference = cancelling_difference(angle, velocity * scale, scale, (gravity, length), bits);
    }
    if difference.hi == 0.0 && angle.in_turn() != 0.0 {
        return None;
    }
    let energy = 0f64.partial_cmp(&difference.hi).unwrap_or(Ordering::Greater);
    Some(Separation { energy, root: difference.abs().sqrt().scaled(1.0 / scale) })
}

/// The difference in so many bits.
#[cold]
fn cancelling_difference(
    angle: &Angle,
    velocity: f64,
    scale: f64,
    (gravity, length): (DoubleDouble, f64),
    bits: usize,
) -> DoubleDouble {
    let big = |words| BigFloat::from_words(words, bits);
    let word = |x: f64| big(DoubleDouble::from(x));
    let kinetic = word(velocity) * word(velocity) * word(length);
    // An angle given in radians is exact, one given by its complement has that exact.
    let in_turn = angle.in_turn_words();
    let cosine = if in_turn.lo != 0.0 && angle.complement() < 1.0 {
        big(angle.complement_words()).halved().sin()
    } else {
        big(in_turn).halved().cos()
    };
    let cosine = cosine * word(scale);
    let four_gravity = big(gravity.scaled(4.0));
    let difference = (cosine.clone() * cosine * four_gravity.clone() - kinetic) / four_gravity;
    let hi = difference.to_f64();
    let lo = (difference - word(hi)).to_f64();
    DoubleDouble::new(hi, lo)
}
