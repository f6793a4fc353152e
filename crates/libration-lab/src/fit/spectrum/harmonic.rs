//! A harmonic that was measured, beside that of theory.

use crate::fit::Uncertain;

/// A harmonic of a measured swing: in-phase·cos nφ + quadrature·sin nφ, where the first harmonic has its maxima at φ = 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Harmonic {
    /// Its number; zero for the constant.
    pub n: usize,
    /// Beside cos nφ, in rad or rad/s; of an undamped pendulum all there is.
    pub in_phase: Uncertain,
    /// Beside sin nφ; none for n = 0, and for n = 1, which has none by the meaning of φ.
    pub quadrature: Option<Uncertain>,
    /// What `in_phase` is for an undamped pendulum whose first harmonic is the measured one: zero for even n.
    pub theory: f64,
    /// `in_phase` less `theory`, with the uncertainty of both; none for n = 1, by which the amplitude is known.
    pub difference: Option<Uncertain>,
    /// Of the noise about this harmonic, by which its uncertainties are known.
    pub degrees_of_freedom: usize,
}

impl Harmonic {
    /// √(in-phase² + quadrature²), which noise makes larger: by half of the uncertainty squared over itself.
    #[must_use]
    pub fn amplitude(&self) -> Uncertain {
        let [c, s] = [self.in_phase, self.quadrature.unwrap_or_default()];
        let value = libm::hypot(c.value, s.value);
        let along = libm::hypot(c.value * c.uncertainty, s.value * s.uncertainty) / value;
        let uncertainty = if value > 0.0 { along } else { c.uncertainty.max(s.uncertainty) };
        Uncertain { value, uncertainty }
    }

    /// By which it lags behind cos nφ, in rad from −π to π; none where the amplitude is below two of its uncertainties, and for
    /// the constant.
    #[must_use]
    pub fn lag(&self) -> Option<Uncertain> {
        let amplitude = self.amplitude();
        if self.n == 0 || amplitude.value < 2.0 * amplitude.uncertainty {
            return None;
        }
        let [c, s] = [self.in_phase, self.quadrature.unwrap_or_default()];
        let across = libm::hypot(c.value * s.uncertainty, s.value * c.uncertainty);
        let uncertainty = across / (amplitude.value * amplitude.value);
        Some(Uncertain { value: libm::atan2(s.value, c.value), uncertainty })
    }

    /// The difference over its uncertainty.
    #[must_use]
    pub fn deviation(&self) -> Option<f64> {
        self.difference.map(|it| it.value / it.uncertainty)
    }

    /// The quadrature over its uncertainty.
    #[must_use]
    pub fn quadrature_deviation(&self) -> Option<f64> {
        self.quadrature.map(|it| it.value / it.uncertainty)
    }
}

/// Some swings of a trace.
#[derive(Clone, Debug, PartialEq)]
pub struct SpectrumWindow {
    /// Of its middle, in s.
    pub time: f64,
    /// Rows that count.
    pub rows: usize,
    /// Of the first harmonic in the middle, in Hz.
    pub frequency: Uncertain,
    /// Of the undamped swing with this first harmonic, in rad.
    pub amplitude: Uncertain,
    /// From n = 0, in the middle.
    pub harmonics: Vec<Harmonic>,
}
