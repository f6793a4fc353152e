//! States released from rest where the amplitude varies from one to the next: the period kernel gives period
//! and nome of each, the theta quotients of libration the state.

use super::LengthMismatch;
use super::period::{
    Nearer, amplitude_above, excess_below, log_inverse_nome, nearer_of_amplitude, ratio_above, root_of_nome,
    within_pi,
};
use super::state::{DoubledArctangent, State};
use crate::dispatch::{Kernel, dispatch};
use crate::double_double::{DoubleDouble, fast_two_sum, two_prod, two_sum};
use crate::elliptic::{Phase, ThetaSeries, ThetaValues, ThetaZero};

const FRAC_1_TAU: DoubleDouble = DoubleDouble::new(0.15915494309189535, -9.839338337591243e-18);

/// The state at `time` (s) of a pendulum of angular frequency ω0 (rad/s) released at rest from `amplitude`
/// (rad) at t = 0.
///
/// # Domain
/// |amplitude| up to the last `f64` below π, ω0·t finite; NaN outside.
/// # Accuracy
/// 4 ulp of the angle and 4·2⁻⁵³·|θ′t|; likewise the velocity (ledger in `tests/suite/accuracy.rs`).
#[must_use]
pub fn state(amplitude: f64, angular_frequency: f64, time: f64) -> State {
    dispatch(One { amplitude, angular_frequency, time })
}

/// The angle and velocity of [`state`] for each pair of amplitude and time, bit for bit.
///
/// # Errors
/// The slices have different lengths.
pub fn states(
    amplitudes: &[f64],
    angular_frequency: f64,
    times: &[f64],
    angles: &mut [f64],
    velocities: &mut [f64],
) -> Result<(), LengthMismatch> {
    for slice in [times, angles, velocities] {
        LengthMismatch::check(amplitudes, slice)?;
    }
    dispatch(Each { amplitudes, angular_frequency, times, angles, velocities });
    Ok(())
}

/// |θ| as a doubled arctangent, its sign, and θ′.
struct Released {
    half: DoubledArctangent,
    sign: f64,
    velocity: f64,
}

/// ω0t/2πR turns, for a period ratio R in two words.
#[inline(always)]
fn turns(ratio: DoubleDouble, angular_frequency: f64, time: f64) -> DoubleDouble {
    let angle = two_prod(angular_frequency, time);
    let small = angle.hi * FRAC_1_TAU.hi;
    let small_lo =
        angle.hi.mul_add(FRAC_1_TAU.hi, -small) + angle.hi.mul_add(FRAC_1_TAU.lo, angle.lo * FRAC_1_TAU.hi);
    let inverse = 1.0 / ratio.hi;
    let quotient = small * inverse;
    let residual = (-quotient).mul_add(ratio.hi, small) + quotient.mul_add(-ratio.lo, small_lo);
    // Released at the turning point, a quarter turn after the bottom.
    let sum = two_sum(quotient, 0.25);
    DoubleDouble::new(sum.hi, sum.lo + residual * inverse)
}

/// Where in its orbit the pendulum is, and the nome and scale of its theta functions.
struct Place {
    phase: Phase,
    above: bool,
    root: f64,
    log: DoubleDouble,
}

#[inline(always)]
fn place(amplitude: f64, angular_frequency: f64, time: f64) -> Place {
    let above = amplitude_above(amplitude);
    let Nearer { s, u } = nearer_of_amplitude(amplitude);
    let excess = excess_below(u);
    let log = log_inverse_nome(s, u);
    let log = fast_two_sum(log.hi, log.lo);
    let high = ratio_above(excess, log);
    let high = fast_two_sum(high.hi, high.lo);
    let low = fast_two_sum(1.0, excess.hi);
    let low = fast_two_sum(low.hi, low.lo + excess.lo);
    let ratio = DoubleDouble::new(if above { high.hi } else { low.hi }, if above { high.lo } else { low.lo });
    let phase = Phase::of(turns(ratio, angular_frequency, time));
    Place { phase, above, root: root_of_nome(s.hi, u.hi), log }
}

/// The theta values of either expansion: z = 2πy, or 2y·ln(1/q′) since 2πK/K′ = 2 ln(1/q′).
#[inline(always)]
fn values(place: &Place, series: &ThetaSeries) -> ThetaValues {
    let circular = series.circular(place.phase.rest);
    let hyperbolic = series.hyperbolic(place.phase.rest * place.log.scaled(2.0));
    let pick = |circular, hyperbolic| if place.above { hyperbolic } else { circular };
    ThetaValues {
        first: pick(circular.first, hyperbolic.first),
        second: pick(circular.second, hyperbolic.second),
        third: pick(circular.third, hyperbolic.third),
        fourth: pick(circular.fourth, hyperbolic.fourth),
    }
}

/// The quotients of `Libration`, with their factors left as quotients too.
#[inline(always)]
fn released(amplitude: f64, angular_frequency: f64, time: f64) -> Released {
    let place = place(amplitude, angular_frequency, time);
    let series = ThetaSeries::new(place.root * place.root);
    let ThetaZero { second: zero_second, third: zero_third, fourth: zero_fourth } = series.zero;
    let ThetaValues { first, second, third, fourth } = values(&place, &series);
    let small = 4.0 * place.root;
    let odd = place.phase.is_odd();
    let (beside, below) = if place.above { (fourth, second) } else { (second, fourth) };
    let (numerator, denominator) = if odd { (beside, below) } else { (first, third) };
    let (rising, falling) = if odd { (-first, third) } else { (beside, below) };
    let slow = !place.above || odd;
    let raising = if place.above { zero_fourth } else { small * zero_second };
    let lowering = if place.above { zero_second * if odd { small } else { 1.0 } } else { zero_fourth };
    let numerator = raising * numerator;
    let inside = within_pi(amplitude);
    let scale = if slow { small } else { 1.0 } * (zero_second * zero_fourth) * rising;
    let sign = place.phase.sign() * 1f64.copysign(amplitude);
    let velocity = sign * (2.0 * angular_frequency) * (scale / ((zero_third * zero_third) * falling));
    Released {
        half: DoubledArctangent::of(numerator.abs(), if inside { lowering * denominator } else { f64::NAN }),
        sign: 1f64.copysign(sign * numerator),
        velocity: if inside { velocity } else { f64::NAN },
    }
}

struct One {
    amplitude: f64,
    angular_frequency: f64,
    time: f64,
}

impl Kernel for One {
    type Output = State;
    #[inline(always)]
    fn run(self) -> State {
        let Released { half, sign, velocity } = released(self.amplitude, self.angular_frequency, self.time);
        let angle = sign * half.angle.to_f64();
        State { turns: 0, angle_in_turn: angle, complement: half.complement.to_f64(), angle, velocity }
    }
}

struct Each<'a> {
    amplitudes: &'a [f64],
    angular_frequency: f64,
    times: &'a [f64],
    angles: &'a mut [f64],
    velocities: &'a mut [f64],
}

impl Kernel for Each<'_> {
    type Output = ();
    #[inline(always)]
    fn run(self) {
        let outputs = self.angles.iter_mut().zip(self.velocities);
        for ((amplitude, time), (angle, velocity)) in self.amplitudes.iter().zip(self.times).zip(outputs) {
            let released = released(*amplitude, self.angular_frequency, *time);
            *angle = released.sign * released.half.angle.to_f64();
            *velocity = released.velocity;
        }
    }
}
