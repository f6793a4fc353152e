//! The energy of an initial state, without cancellation next to the separatrix.
//!
//! The motion is a libration, a separatrix or a rotation as 4g·cos²(θ/2) − l·θ′² is positive, zero or negative. With w = θ′/2ω0 the difference
//! divided by 4g is 1 − e = cos²(θ/2) − w², e = E/(2mgl). Its relative accuracy matters: next to the separatrix the period is a logarithm of it.
//!
//! # Method
//! The comparison of w = |θ′|/2ω0 with cos(θ/2) distinguishes libration from rotation, and |cos²(θ/2) − w²| is k′² next to the separatrix. Both
//! numbers have two words, and the difference is formed from their ratio, which neither overflows nor underflows. A relative difference below
//! 1e-6 is recomputed from the given numbers in `BigFloat`s of 640 bits, and in 2600 bits if these cancel too (below 1e-150).

use std::cmp::Ordering;

use super::Size;
use libration_kernels::double_double::DoubleDouble;
use libration_numbers::algebra::BigFloat;
use libration_numbers::quantity::Angle;

/// The energy compared with that of the separatrix, and √|1 − e|.
pub(super) struct Separation {
    /// Less in libration, greater in rotation.
    pub(super) energy: Ordering,
    /// √|1 − e|, relatively accurate.
    pub(super) root: DoubleDouble,
}

/// Relative differences below which too many bits have cancelled: in two words, and in the first recomputation.
const LOST: [f64; 2] = [1e-6, 1e-150];

/// Bits of the first and the second recomputation. The second resolves a complement of 1e-300, whose relative difference is δ²; equality is
/// possible only at θ = 0 and is exact.
const BITS: [usize; 2] = [640, 2600];

/// The energy of the state compared with that of the separatrix; `None` if the difference is not zero but below the range of `f64`. `cosine` is
/// cos(θ/2) ≥ 0, `speed` is |w| > 0.
pub(super) fn separation(
    angle: &Angle,
    cosine: DoubleDouble,
    velocity: f64,
    speed: DoubleDouble,
    size: Size,
) -> Option<Separation> {
    let rotates = speed.hi > cosine.hi;
    let (larger, smaller) = if rotates { (speed, cosine) } else { (cosine, speed) };
    let ratio = smaller / larger;
    let difference = (DoubleDouble::ONE - ratio) * (DoubleDouble::ONE + ratio);
    if difference.hi > LOST[0] {
        let energy = if rotates { Ordering::Greater } else { Ordering::Less };
        return Some(Separation { energy, root: larger * difference.sqrt() });
    }
    let mut difference = relative_difference(angle, velocity, size, BITS[0]);
    if difference.hi.abs() < LOST[1] {
        difference = relative_difference(angle, velocity, size, BITS[1]);
    }
    if difference.hi == 0.0 && angle.in_turn() != 0.0 {
        return None;
    }
    let energy = 0f64.partial_cmp(&difference.hi)?;
    Some(Separation { energy, root: cosine * difference.abs().sqrt() })
}

/// Computes 1 − l·θ′²/(4g·cos²(θ/2)) in `bits` bits.
#[cold]
fn relative_difference(angle: &Angle, velocity: f64, size: Size, bits: usize) -> DoubleDouble {
    let big = |words| BigFloat::from_words(words, bits);
    let word = |x: f64| big(DoubleDouble::from(x));
    let (gravity, length) = match size {
        Size::LengthAndGravity { length, gravity } => (word(gravity), word(length)),
        Size::AngularFrequency(omega) => (word(omega) * word(omega), word(1.0)),
    };
    // An angle given in radians is exact; an angle given by its complement has an exact complement.
    let in_turn = angle.in_turn_words();
    let cosine = if in_turn.lo != 0.0 && angle.complement() < 1.0 {
        big(angle.complement_words()).halved().sin()
    } else {
        big(in_turn).halved().cos()
    };
    let top = word(4.0) * gravity * cosine.clone() * cosine;
    let difference = (top.clone() - word(velocity) * word(velocity) * length) / top;
    let hi = difference.to_f64();
    let lo = (difference - word(hi)).to_f64();
    DoubleDouble::new(hi, lo)
}
