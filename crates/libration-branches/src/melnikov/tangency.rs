//! Tangencies of the manifolds of the upright position, to all orders of the perturbation; Melnikov's threshold is the first order.

use std::f64::consts::TAU;

use super::function::{Melnikov, Threshold, with_value};
use super::manifolds::{Delays, Manifolds};
use super::{MelnikovError, PerturbedPendulum, TangencyError};
use libration_kernels::elementary::count;
use libration_numbers::expression::Equation;
use libration_numbers::internals::progress::Watch;
use libration_numbers::progress::Progress;

/// The value of a parameter at which the stable and the unstable manifold of the saddle orbit touch; the saddle orbit is the upright position as
/// the perturbation moves it. The manifolds themselves are followed, to all orders of the perturbation.
///
/// # Examples
/// ```
/// # extern crate libration_branches as libration;
/// use libration::melnikov::thresholds;
/// use libration::progress::Quiet;
/// let equation = "x'' + 0.1 x' + sin(x) = A cos(t)".parse()?;
/// let [upper, _] = thresholds(&equation, "A", [0.0, 1.0], &Quiet)?[..] else { panic!() };
/// let touching = upper.tangency(&equation, "A", &Quiet)?;
/// assert!((upper.value - 0.319_478_526).abs() < 1e-9 && (touching.value - 0.319_869_600).abs() < 1e-9);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tangency {
    /// The value of the parameter.
    pub value: f64,
    /// The error of the value: the last corrections of the value and of the separation,
    /// the change with starts at twice the distance from the saddle, and rounding.
    pub error: f64,
    /// The phase Ωt of the drive at which the common motion of both manifolds passes the bottom.
    pub phase: f64,
    /// The velocity of the common motion at the bottom, in rad/s.
    pub velocity: f64,
    /// Bound on the errors of phase and velocity: the last correction of the phase, and rounding.
    pub place_error: f64,
}

/// Distance of the starts from the saddle, in radians: its square times the strength of the perturbation is below the last digit.
const DISTANCE: f64 = 1e-6;

/// Relative error of the energy at the bottom from the integration.
const ROUNDING: f64 = 2e-15;

impl Threshold {
    /// The tangency of the manifolds next to this threshold.
    ///
    /// # Errors
    /// No saddle orbit near the upright position, or manifolds that do not pass the
    /// bottom or do not touch nearby: the perturbation is no longer weak. Cancellation.
    pub fn tangency(
        &self,
        equation: &Equation,
        parameter: &str,
        progress: &dyn Progress,
    ) -> Result<Tangency, TangencyError> {
        let watch = &Watch::new(progress);
        let approach = Approach { equation, parameter, direction: self.direction, watch };
        approach.tangency(self.value)
    }
}

/// The search for a tangency.
struct Approach<'a> {
    equation: &'a Equation,
    parameter: &'a str,
    direction: f64,
    watch: &'a Watch<'a>,
}

/// An extreme of the separation of the manifolds at the bottom.
#[derive(Clone, Copy)]
struct Nearest {
    time: f64,
    separation: f64,
    velocity: f64,
    /// The last correction of the separation, and rounding.
    separation_error: f64,
    /// Rounding error of the time.
    time_rounding: f64,
}

/// Intervals between the times that are compared, relative to the period of the drive: for
/// the search of an extreme, next to a known one, and to measure the effect of the interval.
const FAR: &[f64] = &[1.0 / 32.0, 1.0 / 256.0, 1.0 / 1024.0];
const NEXT: &[f64] = &[1.0 / 1024.0];
const SHORTER: &[f64] = &[1.0 / 2048.0];

impl Approach<'_> {
    /// Finds the tangency by the secant method, beginning at the threshold. If a
    /// step is so short that rounding affects its slope, the previous slope is kept.
    fn tangency(&self, threshold: f64) -> Result<Tangency, TangencyError> {
        /// First step relative to the threshold: its difference of separations has many digits.
        const FIRST_STEP: f64 = 1e-3;
        /// Shortest step, relative to the value, of which a slope is taken.
        const SHORTEST_OF_SLOPE: f64 = 1e-7;
        const STEPS: usize = 20;
        /// Relative change below which a change that no longer decreases is the rounding of the separation.
        const SMALL: f64 = 1e-9;
        let first = self.nearest(threshold, DISTANCE, self.first_time(threshold)?, FAR)?;
        let (mut time, mut slope) = (first.time, f64::NAN);
        let mut last = (threshold, first.separation);
        let mut value = threshold * (1.0 + FIRST_STEP);
        let mut change = f64::INFINITY;
        for _ in 0..STEPS {
            let nearest = self.nearest(value, DISTANCE, time, NEXT)?;
            time = nearest.time;
            if (value - last.0).abs() > SHORTEST_OF_SLOPE * value.abs() {
                slope = (nearest.separation - last.1) / (value - last.0);
            }
            let next = value - nearest.separation / slope;
            let before = std::mem::replace(&mut change, (next - value).abs());
            if !change.is_finite() || (next - threshold).abs() > 0.5 * threshold.abs() {
                return Err(TangencyError::NoConvergence);
            }
            if change <= 2.0 * f64::EPSILON * value.abs()
                || (change >= before && before < SMALL * value.abs())
            {
                return self.with_errors(value, change, &nearest, slope);
            }
            last = (value, nearest.separation);
            value = next;
        }
        Err(TangencyError::NoConvergence)
    }

    /// The tangency with its errors. The component of a start off the manifold grows with the square of the distance from the saddle, so that
    /// starts at twice the distance change the result by three times its error.
    fn with_errors(
        &self,
        value: f64,
        change: f64,
        nearest: &Nearest,
        slope: f64,
    ) -> Result<Tangency, TangencyError> {
        let farther = self.nearest(value, 2.0 * DISTANCE, nearest.time, NEXT)?;
        let start = (farther.separation - nearest.separation).abs();
        let error = change + (start + nearest.separation_error) / slope.abs();
        let shorter = self.nearest(value, DISTANCE, nearest.time, SHORTER)?;
        let pendulum = PerturbedPendulum::new(&with_value(self.equation, self.parameter, value)?)?;
        let frequency = pendulum.frequency().ok_or(TangencyError::NoSaddle)?;
        let time_error = (shorter.time - nearest.time).abs() + shorter.time_rounding;
        Ok(Tangency {
            value,
            error,
            phase: (frequency * shorter.time).rem_euclid(TAU),
            velocity: shorter.velocity,
            place_error: frequency * time_error + error,
        })
    }

    /// The time at which the Melnikov function touches zero at its threshold.
    fn first_time(&self, threshold: f64) -> Result<f64, TangencyError> {
        const PLACES: usize = 64;
        let melnikov = self.melnikov(threshold)?;
        let intervals = PLACES * melnikov.harmonics.len().max(1);
        let phases = (0..intervals).map(|j| TAU * count(j) / count(intervals));
        let nearest =
            phases.min_by(|a, b| melnikov.at_phase(*a).abs().total_cmp(&melnikov.at_phase(*b).abs()));
        Ok(nearest.unwrap_or(0.0) / melnikov.frequency)
    }

    fn melnikov(&self, value: f64) -> Result<Melnikov, TangencyError> {
        let pendulum = PerturbedPendulum::new(&with_value(self.equation, self.parameter, value)?)?;
        let [upper, lower] = Melnikov::both(&pendulum, self.watch).map_err(MelnikovError::from)?;
        Ok(if self.direction > 0.0 { upper } else { lower })
    }

    /// The extreme of the separation near a time, from differences of five times, whose error is the fourth power of the interval: interval
    /// after interval, and with the last one until its correction of the separation is rounding.
    fn nearest(
        &self,
        value: f64,
        distance: f64,
        time: f64,
        intervals: &[f64],
    ) -> Result<Nearest, TangencyError> {
        const MOST: usize = 10;
        let equation = with_value(self.equation, self.parameter, value)?;
        let pendulum = PerturbedPendulum::new(&equation)?;
        let frequency = pendulum.frequency().ok_or(TangencyError::NoSaddle)?;
        let kind = [self.direction, pendulum.omega0(), frequency];
        let equation = pendulum.hanging_at_zero(&equation)?;
        let manifolds = Manifolds::new(&equation, kind, distance, self.watch)?;
        let mut delays: Delays = manifolds.delays();
        let mut time = time;
        for round in 1..=MOST {
            let interval = intervals[round.min(intervals.len()) - 1] * TAU / frequency;
            let next = extreme(&manifolds, time, interval, &mut delays)?;
            time = next.time;
            let is_settled = next.separation_error <= 2.0 * ROUNDING * next.velocity * next.velocity;
            if round >= intervals.len() && is_settled {
                return Ok(next);
            }
        }
        Err(TangencyError::NoConvergence)
    }
}

/// One correction towards the extreme of the separation, from five times.
fn extreme(
    manifolds: &Manifolds<'_>,
    time: f64,
    interval: f64,
    delays: &mut Delays,
) -> Result<Nearest, TangencyError> {
    /// Largest correction, in intervals.
    const FARTHEST: f64 = 8.0;
    let mut at = |side: f64| manifolds.separation(time + side * interval, delays);
    let [[a, _], [b, _], [middle, velocity], [c, _], [d, _]] =
        [at(-2.0)?, at(-1.0)?, at(0.0)?, at(1.0)?, at(2.0)?];
    let slope = (8.0 * (c - b) - (d - a)) / 12.0;
    let bend = (16.0 * (b + c) - 30.0 * middle - (a + d)) / 12.0;
    let shift = -slope / bend;
    if shift.is_nan() || shift.abs() > FARTHEST {
        return Err(TangencyError::NoConvergence);
    }
    let (correction, rounding) = (0.5 * slope * shift, ROUNDING * velocity * velocity);
    Ok(Nearest {
        time: time + shift * interval,
        separation: middle + correction,
        velocity,
        separation_error: correction.abs() + rounding,
        time_rounding: rounding / bend.abs() * interval,
    })
}
