//! States of pendulums released from rest with an individual amplitude each: the period kernel gives the period and the nome, the theta
//! quotients of libration give the state.
//!
//! Amplitudes up to π/2 use the circular expansion in the nome, those above use the hyperbolic one in the complementary nome. A batch sorts its
//! elements by side, so that each loop does one kind of work.
//!
//! # Method
//! If each element of a batch has its own amplitude, nothing can be prepared. A batch therefore sorts its elements into one queue for each side
//! of π/2 and empties a full queue stage by stage, 64 elements together (`varying_stages.rs`). The velocity has four roundings, the angle one.

use super::period::{
    FRAC_1_PI, Nearer, amplitude_above, excess_below, log_inverse_nome, nearer_of_amplitude, root_of_nome,
    within_pi,
};
use super::state::{DoubledArctangent, State};
use libration_kernels::dispatch::{Kernel, dispatch};
use libration_kernels::double_double::{DoubleDouble, fast_two_sum, magnitude, pick, two_prod, two_sum};
use libration_kernels::fused::FusedMultiplyAdd;
use libration_kernels::internals::elliptic::{
    CircularSide, HyperbolicSide, Phase, Side, ThetaSeries, ThetaValues, scaled_by,
};

const FRAC_1_TAU: DoubleDouble = DoubleDouble::new(0.15915494309189535, -9.839338337591243e-18);

/// The state at `time` (s) of a pendulum of angular frequency ω0 (rad/s) released at rest from `amplitude`
/// (rad) at t = 0.
///
/// # Domain
/// |amplitude| up to the largest `f64` below π, ω0·t finite; NaN outside. NaN from 2⁴⁹ periods on, where the error bound is a quarter of the
/// period or more: [`Motion::state_at`](super::Motion::state_at) resolves the phase up to 2⁹⁷ periods.
/// # Accuracy
/// 2.2 ulp of the angle and 4·2⁻⁵³·|θ′t|; likewise the velocity (ledger in `tests/suite/promises.rs`).
#[must_use]
pub fn state(amplitude: f64, angular_frequency: f64, time: f64) -> State {
    dispatch(One { amplitude, angular_frequency, time })
}

/// Differences between the two expansions. The factors are those of `Libration`, left as quotients.
pub(super) trait ReleaseSide: Side {
    /// `true` if the amplitudes are above π/2.
    const ABOVE: bool;
    /// T/T0 from the period ratio of the nearer side and the log of its inverse nome.
    fn ratio(gauss: DoubleDouble, log: DoubleDouble) -> DoubleDouble;
    /// The factors of the numerator and of the denominator of tan(θ/2).
    fn tangent_factors(odd: bool, factors: &Factors) -> (DoubleDouble, DoubleDouble);
    /// The factor of θ′/2ω0 that multiplies θ₄(0)/θ₃(0)².
    fn speed_factor(odd: bool, factors: &Factors) -> DoubleDouble;
}

/// The factors of `Libration` that depend on the amplitude, left unmultiplied.
#[derive(Clone, Copy)]
pub(super) struct Factors {
    /// 4√q·θ₂(0)/2q^¼.
    pub(super) small_second: DoubleDouble,
    /// θ₂(0)/2q^¼.
    pub(super) second: DoubleDouble,
    /// θ₄(0).
    pub(super) fourth: DoubleDouble,
}

impl Factors {
    #[inline(always)]
    pub(super) fn from_nome_root(root: DoubleDouble) -> Self {
        let series = ThetaSeries::new(root.hi * root.hi);
        let second = series.second_at_zero();
        Self { small_second: scaled_by(root.scaled(4.0), second), second, fourth: series.fourth_at_zero() }
    }
}

impl ReleaseSide for CircularSide {
    const ABOVE: bool = false;
    #[inline(always)]
    fn ratio(gauss: DoubleDouble, _: DoubleDouble) -> DoubleDouble {
        gauss
    }
    #[inline(always)]
    fn tangent_factors(_: bool, factors: &Factors) -> (DoubleDouble, DoubleDouble) {
        (factors.small_second, factors.fourth)
    }
    #[inline(always)]
    fn speed_factor(_: bool, factors: &Factors) -> DoubleDouble {
        factors.small_second
    }
}

impl ReleaseSide for HyperbolicSide {
    const ABOVE: bool = true;
    #[inline(always)]
    fn ratio(gauss: DoubleDouble, log: DoubleDouble) -> DoubleDouble {
        gauss * (log * FRAC_1_PI)
    }
    #[inline(always)]
    fn tangent_factors(odd: bool, factors: &Factors) -> (DoubleDouble, DoubleDouble) {
        (factors.fourth, pick(odd, factors.small_second, factors.second))
    }
    #[inline(always)]
    fn speed_factor(odd: bool, factors: &Factors) -> DoubleDouble {
        pick(odd, factors.small_second, factors.second)
    }
}

/// 1 + excess = θ₃(0)².
#[inline(always)]
pub(super) fn gauss(excess: DoubleDouble) -> DoubleDouble {
    let sum = fast_two_sum(1.0, excess.hi);
    fast_two_sum(sum.hi, sum.lo + excess.lo)
}

/// 2⁴⁹: from here on the error bound, 2⁻⁵¹ of the time, is a quarter of the period or more.
const MOST_PERIODS: f64 = 562949953421312.0;

/// The phase at ω0t of a pendulum with period ratio R: ω0t/2πR turns after the turning point.
#[inline(always)]
pub(super) fn phase(ratio: DoubleDouble, angular_frequency: f64, time: f64) -> Phase {
    let angle = two_prod(angular_frequency, time);
    let turns = angle.hi * FRAC_1_TAU.hi;
    let turns_lo =
        angle.hi.fma(FRAC_1_TAU.hi, -turns) + angle.hi.fma(FRAC_1_TAU.lo, angle.lo * FRAC_1_TAU.hi);
    let inverse = 1.0 / ratio.hi;
    let quotient = turns * inverse;
    let residual = (-quotient).fma(ratio.hi, turns) + quotient.fma(-ratio.lo, turns_lo);
    let sum = two_sum(quotient, 0.25);
    Phase::from_turns(DoubleDouble::new(sum.hi, sum.lo + residual * inverse), MOST_PERIODS)
}

/// tan(|θ|/2) as a quotient, and the sign of θ.
pub(super) struct Tangent {
    pub(super) above: DoubleDouble,
    pub(super) below: DoubleDouble,
    pub(super) sign: f64,
}

#[inline(always)]
pub(super) fn tangent<S: ReleaseSide>(
    amplitude: f64,
    phase: &Phase,
    factors: &Factors,
    values: &ThetaValues,
) -> Tangent {
    let odd = phase.is_odd();
    let (beside, other) = S::beside(values);
    let (raising, lowering) = S::tangent_factors(odd, factors);
    let tangent = scaled_by(raising, pick(odd, beside, values.first));
    let below = scaled_by(lowering, pick(odd, other, values.third));
    let inside = if within_pi(amplitude) { 1.0 } else { f64::NAN };
    Tangent {
        above: magnitude(tangent).scaled(inside),
        below: fast_two_sum(below.hi, below.lo),
        sign: 1f64.copysign(phase.sign() * 1f64.copysign(amplitude) * tangent.hi),
    }
}

/// θ′, with four roundings; `gauss` is θ₃(0)².
#[inline(always)]
pub(super) fn velocity<S: ReleaseSide>(
    amplitude: f64,
    angular_frequency: f64,
    phase: &Phase,
    (factors, gauss): (&Factors, DoubleDouble),
    values: &ThetaValues,
) -> f64 {
    let odd = phase.is_odd();
    let (beside, other) = S::beside(values);
    let inside = if within_pi(amplitude) { 2.0 * angular_frequency } else { f64::NAN };
    let factor = scaled_by(S::speed_factor(odd, factors), factors.fourth);
    let above = scaled_by(factor, pick(odd, -values.first, beside)).to_f64();
    let below = scaled_by(gauss, pick(odd, values.third, other)).to_f64();
    phase.sign() * 1f64.copysign(amplitude) * inside * (above / below)
}

/// A single element.
pub(super) struct One {
    pub(super) amplitude: f64,
    pub(super) angular_frequency: f64,
    pub(super) time: f64,
}

impl Kernel for One {
    type Output = State;
    #[inline(always)]
    fn run(self) -> State {
        if amplitude_above(self.amplitude) {
            self.state::<HyperbolicSide>()
        } else {
            self.state::<CircularSide>()
        }
    }
}

impl One {
    #[inline(always)]
    fn state<S: ReleaseSide>(&self) -> State {
        let Nearer { s, u } = nearer_of_amplitude(self.amplitude);
        let excess = excess_below(u);
        let log = log_inverse_nome(s, u);
        let log = fast_two_sum(log.hi, log.lo);
        let gauss = gauss(excess);
        let phase = phase(S::ratio(gauss, log), self.angular_frequency, self.time);
        let root = root_of_nome(s, u.hi);
        // 2πK/K′ = 2 ln(1/q′), q′ the complementary nome.
        let values = S::values(&ThetaSeries::new(root.hi * root.hi), phase.rest, log.scaled(2.0));
        let factors = Factors::from_nome_root(root);
        let Tangent { above, below, sign } = tangent::<S>(self.amplitude, &phase, &factors, &values);
        let half = DoubledArctangent::from_quotient(above, below);
        let velocity =
            velocity::<S>(self.amplitude, self.angular_frequency, &phase, (&factors, gauss), &values);
        let angle = sign * half.angle.to_f64();
        State { turns: 0, angle_in_turn: angle, complement: half.complement.to_f64(), angle, velocity }
    }
}
