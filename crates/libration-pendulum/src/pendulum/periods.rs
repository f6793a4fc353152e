//! The period in seconds where amplitude, length and gravity are plain numbers, for one pendulum or many.

use super::period::{
    Nearer, amplitude_above, excess_below, log_inverse_nome, nearer_of_amplitude, ratio_above, within_pi,
};
use super::period_stages::Stages;
use super::{LengthMismatch, Pendulum};
use libration_kernels::dispatch::{Kernel, dispatch, dispatch_slices};
use libration_kernels::double_double::block::{BLOCK, Words};
use libration_kernels::double_double::{DoubleDouble, fast_two_sum, pick};

/// The period in seconds of the libration with this amplitude in radians, for a pendulum of this length in metres under this gravity in m/s².
///
/// # Domain
/// Amplitudes as [`period_ratio`](super::period_ratio), length and gravity as [`Pendulum::new`]; NaN outside.
/// # Accuracy
/// 0.56 ulp: T/T0 and T0 are in two words, and their product is rounded once.
/// # Examples
/// ```
/// # extern crate libration_pendulum as libration;
/// use libration::pendulum::{Pendulum, period};
/// assert_eq!(period(0.0, 1.0, 9.81), Pendulum::new(1.0, 9.81)?.small_angle_period());
/// assert!((period(60f64.to_radians(), 1.0, 9.80665) - 2.1532423517838).abs() < 1e-13);
/// # Ok::<(), libration::pendulum::PendulumError>(())
/// ```
#[must_use]
pub fn period(amplitude: f64, length: f64, gravity: f64) -> f64 {
    dispatch(One { amplitude, small_angle_period: small_angle_period(length, gravity) })
}

/// [`period`] of each amplitude, length and gravity, bit for bit.
///
/// # Errors
/// The slices have different lengths.
pub fn periods(
    amplitudes: &[f64],
    lengths: &[f64],
    gravities: &[f64],
    periods: &mut [f64],
) -> Result<(), LengthMismatch> {
    for slice in [lengths, gravities, periods] {
        LengthMismatch::check(amplitudes, slice)?;
    }
    dispatch_slices(Each { amplitudes, lengths, gravities, periods });
    Ok(())
}

/// T0 in two words; NaN if such a pendulum does not exist.
fn small_angle_period(length: f64, gravity: f64) -> DoubleDouble {
    Pendulum::new(length, gravity).map_or(DoubleDouble::from(f64::NAN), |pendulum| {
        DoubleDouble::PI.scaled(2.0) / pendulum.angular_frequency_words()
    })
}

/// T from the two forms of T/T0.
#[inline(always)]
fn in_seconds(
    amplitude: f64,
    excess: DoubleDouble,
    log: DoubleDouble,
    small_angle_period: DoubleDouble,
) -> f64 {
    let (below, above) = (fast_two_sum(1.0, excess.hi), ratio_above(excess, log));
    let below = DoubleDouble::new(below.hi, below.lo + excess.lo);
    let ratio = pick(amplitude_above(amplitude), above, below);
    let period = (small_angle_period * ratio).to_f64();
    if within_pi(amplitude) { period } else { f64::NAN }
}

struct One {
    amplitude: f64,
    small_angle_period: DoubleDouble,
}

impl Kernel for One {
    type Output = f64;
    #[inline(always)]
    fn run(self) -> f64 {
        let Nearer { s, u } = nearer_of_amplitude(self.amplitude);
        in_seconds(self.amplitude, excess_below(u), log_inverse_nome(s, u), self.small_angle_period)
    }
}

struct Each<'a> {
    amplitudes: &'a [f64],
    lengths: &'a [f64],
    gravities: &'a [f64],
    periods: &'a mut [f64],
}

impl Kernel for Each<'_> {
    type Output = ();
    #[inline(always)]
    fn run(self) {
        let (mut stages, mut scale) = (Stages::ZERO, Scale::new());
        let sizes = self.lengths.chunks(BLOCK).zip(self.gravities.chunks(BLOCK));
        let blocks = self.amplitudes.chunks(BLOCK).zip(sizes).zip(self.periods.chunks_mut(BLOCK));
        for ((amplitudes, (lengths, gravities)), periods) in blocks {
            let mut block = [0.0; BLOCK];
            block[..amplitudes.len()].copy_from_slice(amplitudes);
            scale.block(lengths, gravities);
            stages.load(&block);
            for (i, period) in periods.iter_mut().enumerate() {
                *period = in_seconds(block[i], stages.excess.get(i), stages.log.get(i), scale.periods.get(i));
            }
        }
    }
}

/// T0 of a block, recomputed only where the pendulum changes.
struct Scale {
    length: f64,
    gravity: f64,
    period: DoubleDouble,
    periods: Words,
}

impl Scale {
    fn new() -> Self {
        let nothing = DoubleDouble::from(f64::NAN);
        Self { length: 0.0, gravity: 0.0, period: nothing, periods: Words::ZERO }
    }

    fn block(&mut self, lengths: &[f64], gravities: &[f64]) {
        for (i, (length, gravity)) in lengths.iter().zip(gravities).enumerate() {
            if length.to_bits() != self.length.to_bits() || gravity.to_bits() != self.gravity.to_bits() {
                self.period = small_angle_period(*length, *gravity);
                (self.length, self.gravity) = (*length, *gravity);
            }
            self.periods.set(i, self.period);
        }
    }
}
