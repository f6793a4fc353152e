//! The shape of a swing without damping, which a measured one has locally: the angle, or the angular velocity, between
//! two of its zeros.
//!
//! Only the shape is taken from the exact law; the duration and the height of a swing are fitted to the data.

use super::even::Even;
use crate::measurement::Observable;
use libration::elliptic::Modulus;

/// Largest amplitude, in radians, with a shape of its own; larger ones have the shape of this one. For recordings from 3.1, 3.125 and 3.135 rad β
/// was less certain by up to a quarter with 3.0; with 3.14, where the shape consists of steps, nothing changed.
pub(super) const LARGEST_AMPLITUDE: f64 = 3.13;
/// Smallest amplitude with a shape of its own; smaller ones have the shape of this one, which is that of a harmonic oscillator to A²/192 = 5e-9:
/// with 1e-2 and 1e-5 nothing changed in 25 recordings.
const SMALLEST_AMPLITUDE: f64 = 1e-3;

/// Fraction of the extreme up to which the time is a smooth function of the value.
const STEEP: f64 = 0.9;

/// The shape of swings of one amplitude.
#[derive(Clone, Copy, Debug)]
pub struct Shape {
    observable: Observable,
    modulus: Modulus,
    amplitude: f64,
}

impl Shape {
    /// The shape of this quantity at this amplitude in radians.
    pub fn new(observable: Observable, amplitude: f64) -> Self {
        let amplitude = amplitude.clamp(SMALLEST_AMPLITUDE, LARGEST_AMPLITUDE);
        let modulus = Modulus::from_modulus(libm::sin(0.5 * amplitude)).expect("a sine lies in [0, 1]");
        Self { observable, modulus, amplitude }
    }

    /// The value at `part` of a quarter period from the extreme, where it is 1; zero at ±1.
    pub fn near_extreme(&self, part: f64) -> f64 {
        let quarter = self.modulus.first();
        match self.observable {
            Observable::Angle => {
                let sine = self.modulus.jacobi(quarter * (1.0 - part.abs())).sn;
                2.0 * libm::asin(self.modulus.modulus() * sine) / self.amplitude
            }
            Observable::AngularVelocity => self.modulus.jacobi(quarter * part).cn,
        }
    }

    /// Distance from a zero, in quarter periods, at which the value is this fraction of the extreme, within (−1, 1).
    pub fn time_since_zero(&self, value: f64) -> f64 {
        let (size, quarter) = (value.abs().min(1.0), self.modulus.first());
        let part = match self.observable {
            Observable::Angle => {
                let sine = libm::sin(0.5 * size * self.amplitude) / self.modulus.modulus();
                self.modulus.incomplete_first(libm::asin(sine.min(1.0))) / quarter
            }
            Observable::AngularVelocity => 1.0 - self.modulus.incomplete_first(libm::acos(size)) / quarter,
        };
        part.copysign(value)
    }

    /// The slope of [`Shape::time_since_zero`]: quarter periods per value.
    pub fn slope_of_time(&self, value: f64) -> f64 {
        let (k, complementary) = (self.modulus.modulus(), self.modulus.complementary_modulus());
        let size = value.abs().min(1.0);
        // θ′/2ω0 = √(k² − sin²(θ/2)), and v′ of cn = sn·dn.
        let speed = match self.observable {
            Observable::Angle => {
                let sine = libm::sin(0.5 * size * self.amplitude);
                2.0 * ((k - sine) * (k + sine)).max(0.0).sqrt() / self.amplitude
            }
            Observable::AngularVelocity => {
                ((1.0 - size * size) * (complementary * complementary + k * k * size * size)).sqrt()
            }
        };
        1.0 / (speed * self.modulus.first())
    }

    /// [`Self::near_extreme`] for this number of evaluations, up to some part of a quarter period.
    pub fn near_extreme_for(&self, times: usize, largest: f64) -> impl Fn(f64) -> f64 {
        let shape = *self;
        let even = often(times, largest, |part| shape.near_extreme(part));
        move |part| even.as_ref().and_then(|even| even.at(part)).unwrap_or_else(|| shape.near_extreme(part))
    }

    /// [`Self::time_since_zero`] for this number of evaluations.
    pub fn time_since_zero_for(&self, times: usize) -> impl Fn(f64) -> f64 {
        let shape = *self;
        let even = often(times, STEEP, |value| shape.time_since_zero(value) / value);
        move |value| {
            let sum = even.as_ref().and_then(|even| even.at(value));
            sum.map_or_else(|| shape.time_since_zero(value), |sum| sum * value)
        }
    }

    /// A function for [`Self::slope_of_time`] at a distance from a zero in quarter periods, no nearer to the extreme than `nearest`;
    /// prepared for the given number of evaluations.
    pub fn slope_near_zero_for(&self, times: usize, nearest: f64) -> impl Fn(f64) -> f64 {
        let shape = *self;
        let slope = move |part: f64| shape.slope_of_time(shape.near_extreme((1.0 - part.abs()).max(nearest)));
        let even = often(times, 1.0 - nearest, slope);
        move |part| even.as_ref().and_then(|even| even.at(part)).unwrap_or_else(|| slope(part))
    }

    /// The second derivative at the extreme, per quarter period squared, as a positive number.
    pub fn curvature(&self) -> f64 {
        let quarter = self.modulus.first();
        let force = match self.observable {
            Observable::Angle => libm::sin(self.amplitude) / self.amplitude,
            Observable::AngularVelocity => 1.0,
        };
        quarter * quarter * force.max(f64::EPSILON)
    }
}

/// Returns a sum for an even function with this number of evaluations; `None` if it is not worthwhile.
pub fn often(times: usize, largest: f64, function: impl Fn(f64) -> f64) -> Option<Even> {
    if times >= Even::WORTH { Even::new(largest, function) } else { None }
}

/// The amplitude of a swing with this largest velocity, in radians; `None` when it goes over the top.
pub fn amplitude_of_velocity(velocity: f64, omega0: f64) -> Option<f64> {
    let sine = 0.5 * velocity / omega0;
    (sine < 1.0).then(|| 2.0 * libm::asin(sine))
}

/// The derivative of that amplitude with respect to the velocity, in seconds.
pub fn slope_of_amplitude(amplitude: f64, omega0: f64) -> f64 {
    1.0 / (omega0 * libm::cos(0.5 * amplitude))
}
