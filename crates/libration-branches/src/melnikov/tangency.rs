//! Where the manifolds of the upright position touch, which Melnikov's threshold says to the first order of the perturbation.

use std::f64::consts::TAU;

use super::function::{Melnikov, Threshold, with_value};
use super::manifolds::{Delays, Manifolds};
use super::{NoTangency, PerturbedPendulum};
use libration_kernels::elementary::count;
use libration_numbers::expression::Equation;
use libration_numbers::watch::Watch;

/// The value of a parameter at which the stable and the unstable manifold of the saddle orbit, which is the upright position as the perturbation
/// moves it, touch: the manifolds themselves are followed, to all orders of the perturbation.
///
/// # Examples
/// ```
/// # extern crate libration_branches as libration;
/// use libration::melnikov::thresholds;
/// let equation = "x'' + 0.1 x' + sin(x) = A cos(t)".parse()?;
/// let [upper, _] = thresholds(&equation, "A", [0.0, 1.0])?[..] else { panic!() };
/// let touching = upper.tangency(&equation, "A")?;
/// assert!((upper.value - 0.319_478_526).abs() < 1e-9 && (touching.value - 0.319_869_600).abs() < 1e-9);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tangency {
    /// The value of the parameter.
    pub value: f64,
    /// Its error: the last correction, what starts at twice the distance from the saddle change, and rounding.
    pub error: f64,
    /// The phase Ωt of the drive at which the motion that they share passes the bottom.
    pub phase: f64,
    /// The velocity of that motion there, in rad/s.
    pub velocity: f64,
    /// The phase may be wrong by so much, and the velocity likewise: what the last correction of the phase and rounding change.
    pub place_error: f64,
}

/// Of the starts from the saddle, in radians: its square times the strength of the perturbation is below the last digit.
const DISTANCE: f64 = 1e-6;

/// What integration leaves of the energy at the bottom, in parts of it.
const ROUNDING: f64 = 2e-15;

impl Threshold {
    /// The tangency of the manifolds next to this threshold.
    ///
    /// # Errors
    /// No saddle orbit near the upright position, manifolds that do not pass the bottom or do not touch nearby: the perturbation is no longer weak.
    pub fn tangency(&self, equation: &Equation, parameter: &str) -> Result<Tangency, NoTangency> {
        self.tangency_watched(equation, parameter, &Watch::none())
    }

    /// The same, asking at each step of the integrations whether to go on.
    ///
    /// # Errors
    /// As [`Self::tangency`], and being told not to.
    pub fn tangency_watched(
        &self,
        equation: &Equation,
        parameter: &str,
        watch: &Watch<'_>,
    ) -> Result<Tangency, NoTangency> {
        let approach = Approach { equation, parameter, direction: self.direction, watch };
        approach.tangency(self.value)
    }
}

/// The way to a tangency.
struct Approach<'a> {
    equation: &'a Equation,
    parameter: &'a str,
    direction: f64,
    watch: &'a Watch<'a>,
}

/// Where the manifolds are nearest: when they pass the bottom, how far apart, with what velocity.
#[derive(Clone, Copy)]
struct Nearest {
    time: f64,
    separation: f64,
    velocity: f64,
}

/// A passage of the bottom by both manifolds.
struct Place {
    time: f64,
    velocity: f64,
    /// Of the time.
    error: f64,
}

impl Approach<'_> {
    /// By the secant through the last two values, from the threshold on.
    fn tangency(&self, threshold: f64) -> Result<Tangency, NoTangency> {
        const FIRST_STEP: f64 = 1e-3;
        const STEPS: usize = 20;
        const SMALL: f64 = 1e-9;
        let mut time = self.first_time(threshold)?;
        let mut nearest_at = |value: f64, distance: f64| {
            let nearest = self.nearest(value, distance, time)?;
            time = nearest.time;
            Ok::<_, NoTangency>(nearest)
        };
        let mut last = (threshold, nearest_at(threshold, DISTANCE)?.separation);
        let mut value = threshold * (1.0 + FIRST_STEP);
        let mut change = f64::INFINITY;
        for _ in 0..STEPS {
            let nearest = nearest_at(value, DISTANCE)?;
            let slope = (nearest.separation - last.1) / (value - last.0);
            let next = value - nearest.separation / slope;
            let before = std::mem::replace(&mut change, (next - value).abs());
            if !change.is_finite() || (next - threshold).abs() > 0.5 * threshold.abs() {
                return Err(NoTangency::NoConvergence);
            }
            if change <= 2.0 * f64::EPSILON * value.abs()
                || (change >= before && before < SMALL * value.abs())
            {
                let farther = nearest_at(value, 2.0 * DISTANCE)?.separation;
                let rounding = ROUNDING * nearest.velocity * nearest.velocity;
                let error =
                    change.min(before) + ((farther - nearest.separation).abs() + rounding) / slope.abs();
                let frequency = self.frequency(value)?;
                let place = self.place(value, frequency, nearest.time)?;
                let phase = frequency * place.time;
                return Ok(Tangency {
                    value,
                    error,
                    phase: phase.rem_euclid(TAU),
                    velocity: place.velocity,
                    place_error: frequency * place.error + error,
                });
            }
            last = (value, nearest.separation);
            value = next;
        }
        Err(NoTangency::NoConvergence)
    }

    /// The time at which the Melnikov function touches zero at its threshold.
    fn first_time(&self, threshold: f64) -> Result<f64, NoTangency> {
        const PLACES: usize = 64;
        let melnikov = self.melnikov(threshold)?;
        let places = PLACES * melnikov.harmonics.len().max(1);
        let phases = (0..places).map(|j| TAU * count(j) / count(places));
        let nearest =
            phases.min_by(|a, b| melnikov.at_phase(*a).abs().total_cmp(&melnikov.at_phase(*b).abs()));
        Ok(nearest.unwrap_or(0.0) / melnikov.frequency)
    }

    fn melnikov(&self, value: f64) -> Result<Melnikov, NoTangency> {
        let pendulum = PerturbedPendulum::new(&with_value(self.equation, self.parameter, value)?)?;
        let [upper, lower] = Melnikov::both(&pendulum);
        Ok(if self.direction > 0.0 { upper } else { lower })
    }

    fn frequency(&self, value: f64) -> Result<f64, NoTangency> {
        Ok(self.melnikov(value)?.frequency)
    }

    /// The time of the extreme to more digits, by differences of five times: these leave the fourth power of the interval, and rounding over it,
    /// some 1e-11 each. The last correction is what the longer interval has left.
    fn place(&self, value: f64, frequency: f64, time: f64) -> Result<Place, NoTangency> {
        const INTERVALS: [f64; 2] = [1.0 / 1024.0, 1.0 / 2048.0];
        let equation = with_value(self.equation, self.parameter, value)?;
        let omega0 = PerturbedPendulum::new(&equation)?.omega0();
        let manifolds = Manifolds::new(&equation, [self.direction, omega0, frequency], DISTANCE, self.watch)?;
        let mut delays: Delays = manifolds.delays();
        let mut place = Place { time, velocity: 0.0, error: f64::INFINITY };
        for part in INTERVALS {
            let interval = part * TAU / frequency;
            let mut at = |side: f64| manifolds.separation(place.time + side * interval, &mut delays);
            let [[a, _], [b, _], [middle, velocity], [c, _], [d, _]] =
                [at(-2.0)?, at(-1.0)?, at(0.0)?, at(1.0)?, at(2.0)?];
            let slope = (8.0 * (c - b) - (d - a)) / 12.0;
            let bend = (16.0 * (b + c) - 30.0 * middle - (a + d)) / 12.0;
            let shift = -slope / bend;
            if shift.is_nan() || shift.abs() > 1.0 {
                return Err(NoTangency::NoConvergence);
            }
            let error = (shift.abs() + ROUNDING * velocity * velocity / bend.abs()) * interval;
            place = Place { time: place.time + shift * interval, velocity, error };
        }
        Ok(place)
    }

    /// The extreme of the separation near a time, by parabolas through three times that draw together.
    fn nearest(&self, value: f64, distance: f64, time: f64) -> Result<Nearest, NoTangency> {
        const INTERVALS: [f64; 4] = [1.0 / 32.0, 1.0 / 256.0, 1.0 / 1024.0, 1.0 / 4096.0];
        let equation = with_value(self.equation, self.parameter, value)?;
        let pendulum = PerturbedPendulum::new(&equation)?;
        let frequency = pendulum.frequency().ok_or(NoTangency::NoSaddle)?;
        let kind = [self.direction, pendulum.omega0(), frequency];
        let manifolds = Manifolds::new(&equation, kind, distance, self.watch)?;
        let mut delays: Delays = manifolds.delays();
        let mut nearest = Nearest { time, separation: 0.0, velocity: 0.0 };
        for part in INTERVALS {
            let interval = part * TAU / frequency;
            let mut at = |side: f64| manifolds.separation(nearest.time + side * interval, &mut delays);
            let [[before, _], [middle, velocity], [after, _]] = [at(-1.0)?, at(0.0)?, at(1.0)?];
            let (slope, bend) = (0.5 * (after - before), after - 2.0 * middle + before);
            let shift = -slope / bend;
            if shift.is_nan() || shift.abs() > 8.0 {
                return Err(NoTangency::NoConvergence);
            }
            let separation = middle + 0.5 * slope * shift;
            nearest = Nearest { time: nearest.time + shift * interval, separation, velocity };
        }
        Ok(nearest)
    }
}
