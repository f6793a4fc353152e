//! Padé approximants of series that go by steps of several powers.

use crate::perturbation::{Pade, Pole};

/// A Padé approximant in a power of the amplitude, times another power.
#[derive(Clone, Debug, PartialEq)]
pub struct Approximant {
    pub(super) pade: Pade,
    pub(super) first: f64,
    pub(super) stride: f64,
}

impl Approximant {
    /// The value; infinite or NaN at a pole.
    #[must_use]
    pub fn value_at(&self, amplitude: f64) -> f64 {
        libm::pow(amplitude, self.first) * self.pade.value_at(libm::pow(amplitude, self.stride))
    }

    /// The quotient itself.
    #[must_use]
    pub const fn pade(&self) -> &Pade {
        &self.pade
    }

    /// The least amplitude at which it has a pole.
    #[must_use]
    pub fn first_pole(&self) -> Option<f64> {
        let positive = |pole: &Pole| pole.position.re > 0.0 && pole.position.im == 0.0;
        let first = self.pade.poles().into_iter().find(positive)?;
        Some(libm::pow(first.position.re, 1.0 / self.stride))
    }
}
