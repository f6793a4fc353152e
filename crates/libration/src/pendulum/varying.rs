//! States released from rest where the amplitude varies from one to the next: the period kernel gives period
//! and nome of each, the theta quotients of libration the state.

use super::LengthMismatch;
use super::period::{
    Nearer, amplitude_above, excess_below, log_inverse_nome, nearer_of_amplitude, ratio_above, root_of_nome,
    within_pi,
};
use super::state::{DoubledArctangent, State, magnitude, pick};
use crate::dispatch::{Kernel, dispatch};
use crate::double_double::{DoubleDouble, fast_two_sum, two_prod, two_sum};
use crate::elliptic::{Phase, ThetaSeries, ThetaValues, quotient, scaled_by};

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
    root: DoubleDouble,
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
    Place { phase, above, root: root_of_nome(s, u.hi), log }
}

/// The theta values of either expansion: z = 2πy, or 2y·ln(1/q′) since 2πK/K′ = 2 ln(1/q′).
#[inline(always)]
fn values(place: &Place, series: &ThetaSeries) -> ThetaValues {
    let circular = series.circular(place.phase.rest);
    let hyperbolic = series.hyperbolic(place.phase.rest * place.log.scaled(2.0));
    ThetaValues {
        first: pick(place.above, hyperbolic.first, circular.first),
        second: pick(place.above, hyperbolic.second, circular.second),
        third: pick(place.above, hyperbolic.third, circular.third),
        fourth: pick(place.above, hyperbolic.fourth, circular.fourth),
    }
}

/// The factors of the quotients: 4√q, θ₂(0)/2q^¼, θ₃(0), θ₄(0).
struct Factors {
    small: DoubleDouble,
    second: DoubleDouble,
    third: DoubleDouble,
    fourth: DoubleDouble,
}

/// The quotients of `Libration`, with their factors left as quotients too.
#[inline(always)]
fn released(amplitude: f64, angular_frequency: f64, time: f64) -> Released {
    let place = place(amplitude, angular_frequency, time);
    let series = ThetaSeries::new(place.root.hi * place.root.hi);
    let values = values(&place, &series);
    let factors = Factors {
        small: place.root.scaled(4.0),
        second: series.second_at_zero(),
        third: series.third_at_zero(),
        fourth: series.fourth_at_zero(),
    };
    let sign = place.phase.sign() * 1f64.copysign(amplitude);
    let inside = if within_pi(amplitude) { 1.0 } else { f64::NAN };
    let (tangent, below) = tangent(&place, &factors, &values);
    Released {
        half: DoubledArctangent::of(magnitude(tangent).scaled(inside), below),
        sign: 1f64.copysign(sign * tangent.hi),
        velocity: sign * inside * (2.0 * angular_frequency) * speed(&place, &factors, &values),
    }
}

/// tan(θ/2) as a quotient.
#[inline(always)]
fn tangent(place: &Place, factors: &Factors, values: &ThetaValues) -> (DoubleDouble, DoubleDouble) {
    let odd = place.phase.is_odd();
    let above = pick(odd, pick(place.above, values.fourth, values.second), values.first);
    let below = pick(odd, pick(place.above, values.second, values.fourth), values.third);
    let factor_above = pick(place.above, factors.fourth, scaled_by(factors.small, factors.second));
    let small = pick(odd, factors.small, DoubleDouble::ONE);
    let factor_below = pick(place.above, scaled_by(small, factors.second), factors.fourth);
    let below = scaled_by(factor_below, below);
    (scaled_by(factor_above, above), fast_two_sum(below.hi, below.lo))
}

/// θ′/2ω0 in size.
#[inline(always)]
fn speed(place: &Place, factors: &Factors, values: &ThetaValues) -> f64 {
    let odd = place.phase.is_odd();
    let above = pick(odd, -values.first, pick(place.above, values.fourth, values.second));
    let below = pick(odd, values.third, pick(place.above, values.second, values.fourth));
    let small = pick(place.above && !odd, DoubleDouble::ONE, factors.small);
    let factor = scaled_by(small, scaled_by(factors.second, factors.fourth));
    let below = scaled_by(scaled_by(factors.third, factors.third), below);
    quotient(factor, above, fast_two_sum(below.hi, below.lo))
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
