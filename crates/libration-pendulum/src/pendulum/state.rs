//! The state of a pendulum at one time.

use libration_kernels::double_double::{DoubleDouble, pick, two_sum};
use libration_kernels::elementary::ReducedArctangent;
use libration_kernels::fused::FusedMultiplyAdd;

/// A state of a pendulum. Next to the top the angle alone would lose the complement; in rotation the angle grows with the turns.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct State {
    /// Whole turns: angle = 2π·turns + angle in the turn. The count is not exact beyond 2⁵³, and limited to the range of `i64`.
    pub turns: i64,
    /// The angle in the turn, within [−π, π] radians.
    pub angle_in_turn: f64,
    /// π − |angle in the turn|, relatively accurate however small.
    pub complement: f64,
    /// The unwrapped angle in radians.
    pub angle: f64,
    /// The angular velocity in rad/s.
    pub velocity: f64,
}

impl State {
    /// A state of NaN, for a time that is not finite.
    pub(super) const NAN: Self =
        Self { turns: 0, angle_in_turn: f64::NAN, complement: f64::NAN, angle: f64::NAN, velocity: f64::NAN };
}

/// An angle within [0, π] and its complement, as twice the arctangent of a ratio.
#[derive(Clone, Copy)]
pub(super) struct DoubledArctangent {
    pub(super) angle: DoubleDouble,
    pub(super) complement: DoubleDouble,
}

/// A ratio reduced for its doubled arctangent.
#[derive(Clone, Copy)]
pub(super) struct ReducedRatio {
    /// The arctangent of the ratio, or of its inverse if the ratio is above one.
    pub(super) arctangent: ReducedArctangent,
    pub(super) steep: bool,
}

impl ReducedRatio {
    /// The reduction of a ratio of positive numbers.
    #[inline(always)]
    pub(super) fn from_quotient(numerator: DoubleDouble, denominator: DoubleDouble) -> Self {
        let steep = numerator.hi > denominator.hi;
        let (small, large) = (pick(steep, denominator, numerator), pick(steep, numerator, denominator));
        Self { arctangent: ReducedArctangent::from_quotient(small, large), steep }
    }
}

impl DoubledArctangent {
    /// 2 atan(numerator/denominator) for a ratio of positive numbers.
    #[inline(always)]
    pub(super) fn from_quotient(numerator: DoubleDouble, denominator: DoubleDouble) -> Self {
        Self::from_reduced(ReducedRatio::from_quotient(numerator, denominator))
    }

    #[inline(always)]
    pub(super) fn from_reduced(ratio: ReducedRatio) -> Self {
        let near = ratio.arctangent.angle().scaled(2.0);
        let far = two_sum(DoubleDouble::PI.hi, -near.hi);
        let far = DoubleDouble::new(far.hi, far.lo + (DoubleDouble::PI.lo - near.lo));
        Self { angle: pick(ratio.steep, far, near), complement: pick(ratio.steep, near, far) }
    }
}

/// base + sign·angle, rounded once.
#[inline(always)]
pub(super) fn unwrapped(base: DoubleDouble, sign: f64, angle: DoubleDouble) -> f64 {
    let sum = two_sum(base.hi, sign * angle.hi);
    sum.hi + (sum.lo + sign.fma(angle.lo, base.lo))
}

/// A number of turns in an `f64` as an integer.
#[expect(
    clippy::cast_possible_truncation,
    reason = "float-to-integer casts saturate, and beyond 2⁵³ turns the count is not known anyway"
)]
pub(super) fn whole_turns(turns: f64) -> i64 {
    turns as i64
}
