//! The amplitude as a function of time, by a law for its rate of decrease.

use std::f64::consts::TAU;

use super::cycle::{Cycle, small_cycle_integral};
use super::{Decay, LEAST_AMPLITUDE};
use libration_numbers::quadrature::gauss;
use libration_pendulum::pendulum::Amplitude;

/// The law by which the amplitude decreases.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum EnvelopeLaw {
    /// dE/dt is replaced by the mean of dE/dt over an undamped cycle, with exact integrals at any amplitude.
    Averaged,
    /// The same law for small amplitudes: dA/dt = −Σ cₙβₙω0ⁿ⁻¹Aⁿ/π.
    SmallAmplitude,
}

/// An amplitude that decreases by an [`EnvelopeLaw`].
///
/// The law gives the time as an integral in the variable ln tan(A/2), in which the integrand is analytic from the bottom to the top.
#[derive(Clone, Copy, Debug)]
pub struct DecayEnvelope<'a> {
    decay: &'a Decay,
    law: EnvelopeLaw,
    /// tan(A/2) at the start.
    tangent: f64,
}

/// The decrease of ln tan(A/2) over one panel of the quadrature. Singularities are π/2 away in the imaginary direction.
const PANEL: f64 = 1.5;

impl<'a> DecayEnvelope<'a> {
    pub(super) fn new(decay: &'a Decay, law: EnvelopeLaw) -> Self {
        let modulus = decay.start.modulus();
        Self { decay, law, tangent: modulus.modulus() / modulus.complementary_modulus() }
    }

    /// The amplitude in radians at a time in seconds after the release; zero below 1e-100 rad.
    ///
    /// # Accuracy
    /// Relative error 1e-13 for the given law, as long as the amplitude decreases by less than nine orders of magnitude.
    #[must_use]
    pub fn amplitude_at(&self, time: f64) -> f64 {
        let mut left = time * self.decay.pendulum.angular_frequency();
        if left <= 0.0 {
            return self.decay.start.radians();
        }
        let mut fall = 0.0;
        while self.tangent_after(fall) > 0.5 * LEAST_AMPLITUDE {
            let panel = self.duration(fall, PANEL);
            if panel > left {
                let tangent = self.tangent_after(fall + self.part(fall, left, panel));
                return 2.0 * libm::atan(tangent);
            }
            left -= panel;
            fall += PANEL;
        }
        if left.is_nan() { f64::NAN } else { 0.0 }
    }

    /// The time in seconds at which the amplitude has decreased to this one; zero
    /// if it is not below the start. Amplitudes below 1e-100 rad count as 1e-100.
    #[must_use]
    pub fn time_of(&self, amplitude: &Amplitude) -> f64 {
        let modulus = amplitude.modulus();
        let tangent = modulus.modulus() / modulus.complementary_modulus();
        let whole = libm::log(self.tangent / tangent.max(0.5 * LEAST_AMPLITUDE));
        let (mut fall, mut time) = (0.0, 0.0);
        while fall < whole {
            let panel = PANEL.min(whole - fall);
            time += self.duration(fall, panel);
            fall += panel;
        }
        time / self.decay.pendulum.angular_frequency()
    }

    /// The further decrease in a panel during `time`, by Newton's method; `whole` is the time of the panel.
    fn part(&self, fall: f64, time: f64, whole: f64) -> f64 {
        /// Iteration limit; four are usual, as the error is squared, and more if a step was clamped to the panel.
        const MOST: usize = 40;
        if whole.is_infinite() {
            return 0.0;
        }
        let mut further = PANEL * (time / whole);
        for _ in 0..MOST {
            let missing = time - self.duration(fall, further);
            let step = missing / self.slowness(fall + further);
            further = (further + step).clamp(0.0, PANEL);
            // The error is squared in each iteration.
            if step.abs() <= 1e-9 {
                break;
            }
        }
        further
    }

    /// The time for a further decrease, in units of 1/ω0.
    fn duration(&self, fall: f64, further: f64) -> f64 {
        further * gauss(|part| self.slowness(fall + further * part)).value
    }

    /// The time per unit decrease of ln tan(A/2), with dA = sin A d(ln tan(A/2)) and dE = sin A dA.
    fn slowness(&self, fall: f64) -> f64 {
        let tangent = self.tangent_after(fall);
        let damping = &self.decay.scaled;
        match self.law {
            EnvelopeLaw::Averaged => {
                let cycle = Cycle::of_tangent(tangent);
                cycle.period() * cycle.sine() / (cycle.loss(damping) / cycle.sine())
            }
            EnvelopeLaw::SmallAmplitude => {
                let angle = 2.0 * libm::atan(tangent);
                let losses = damping
                    .terms()
                    .iter()
                    .map(|term| term.coefficient * small_cycle_integral(term.exponent, angle));
                TAU * libm::sin(angle) / (losses.sum::<f64>() / angle)
            }
        }
    }

    fn tangent_after(&self, fall: f64) -> f64 {
        self.tangent * libm::exp(-fall)
    }
}
