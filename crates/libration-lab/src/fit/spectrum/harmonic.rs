//! A measured harmonic, with that of theory.

use crate::fit::uncertain::Uncertain;

/// A harmonic of a measured swing: in-phase·cos nφ + quadrature·sin nφ, where the first harmonic has its maxima at φ = 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Harmonic {
    /// The order; zero for the constant.
    pub n: usize,
    /// Coefficient of cos nφ, in rad or rad/s; the only one of an undamped pendulum.
    pub in_phase: Uncertain,
    /// Coefficient of sin nφ; `None` for n = 0, and for n = 1, where it vanishes by the definition of φ.
    pub quadrature: Option<Uncertain>,
    /// Value of `in_phase` for an undamped pendulum whose first harmonic is the measured one: zero for even n.
    pub theory: f64,
    /// `in_phase` less `theory`, with the uncertainty of both; `None` for n = 1, from which the amplitude is derived.
    pub difference: Option<Uncertain>,
    /// Degrees of freedom of the noise about this harmonic, from which its uncertainties are derived.
    pub degrees_of_freedom: usize,
}

impl Harmonic {
    /// √(in-phase² + quadrature²), which noise increases: by half of the uncertainty squared over itself.
    #[must_use]
    pub fn amplitude(&self) -> Uncertain {
        let [c, s] = [self.in_phase, self.quadrature.unwrap_or_default()];
        let value = libm::hypot(c.value, s.value);
        let along = libm::hypot(c.value * c.uncertainty, s.value * s.uncertainty) / value;
        let uncertainty = if value > 0.0 { along } else { c.uncertainty.max(s.uncertainty) };
        Uncertain { value, uncertainty }
    }

    /// Phase lag behind cos nφ, in rad from −π to π; `None` where the amplitude is below two of its uncertainties, and for
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
        self.difference.map(|difference| difference.value / difference.uncertainty)
    }

    /// The quadrature over its uncertainty.
    #[must_use]
    pub fn quadrature_deviation(&self) -> Option<f64> {
        self.quadrature.map(|quadrature| quadrature.value / quadrature.uncertainty)
    }
}

/// Results of a window of some swings of a trace.
#[derive(Clone, Debug, PartialEq)]
pub struct SpectrumWindow {
    /// Time of its middle, in s.
    pub time: f64,
    /// Number of rows that count.
    pub rows: usize,
    /// Frequency of the first harmonic in the middle, in Hz.
    pub frequency: Uncertain,
    /// Amplitude of the undamped swing with this first harmonic, in rad.
    pub amplitude: Uncertain,
    /// Harmonics from n = 0, in the middle.
    pub harmonics: Vec<Harmonic>,
}
