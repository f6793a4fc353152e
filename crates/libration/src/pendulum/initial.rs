//! From an initial state to the energy, without cancellation next to the separatrix.
//!
//! The motion is a libration, a separatrix or a rotation as 4g·cos²(θ/2) − l·θ′² is positive, zero or
//! negative. The difference divided by 4g is 1 − e, with e = E/(2mgl), and it is needed relatively accurate:
//! next to the separatrix the period is its logarithm.

use crate::algebra::BigFloat;
use crate::double_double::{DoubleDouble, two_prod};
use crate::quantity::Angle;

/// Where the difference of the two words has lost more than this many bits it is recomputed.
const LOST: f64 = 1.0 / 1048576.0;

/// Bits of the recomputation. Two f64 inputs on the separatrix to more than this would have to be found by
/// design; equality is possible at θ = 0 only and is exact.
const BITS: usize = 640;

/// 1 − e, relatively accurate; `cosine` is cos(θ/2).
pub(super) fn energy_deficit(
    angle: &Angle,
    cosine: DoubleDouble,
    velocity: f64,
    (gravity, length): (DoubleDouble, f64),
) -> DoubleDouble {
    let top = cosine.square();
    let kinetic = two_prod(velocity, velocity) * length / gravity.scaled(4.0);
    let difference = top - kinetic;
    if difference.hi.abs() > LOST * top.hi {
        difference
    } else {
        cancelling_deficit(angle, velocity, (gravity, length))
    }
}

#[cold]
fn cancelling_deficit(angle: &Angle, velocity: f64, (gravity, length): (DoubleDouble, f64)) -> DoubleDouble {
    let big = |words| BigFloat::from_words(words, BITS);
    let four_gravity = big(gravity.scaled(4.0));
    let velocity = big(DoubleDouble::from(velocity));
    let kinetic = velocity.clone() * velocity * big(DoubleDouble::from(length));
    // An angle given in radians is exact, one given by its complement has that exact.
    let in_turn = angle.in_turn_words();
    let cosine = if in_turn.lo != 0.0 && angle.complement() < 1.0 {
        big(angle.complement_words()).halved().sin()
    } else {
        big(in_turn).halved().cos()
    };
    let difference = (cosine.clone() * cosine * four_gravity.clone() - kinetic) / four_gravity;
    let hi = difference.to_f64();
    let lo = (difference - big(DoubleDouble::from(hi))).to_f64();
    DoubleDouble::new(hi, lo)
}
