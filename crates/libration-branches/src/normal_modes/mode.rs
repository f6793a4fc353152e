//! One normal mode.

use super::no_shift::ShiftError;
use libration_numbers::algebra::{Complex, Surd};

/// A motion in which all coordinates change in time as e^{st}.
#[derive(Clone, Debug, PartialEq)]
pub struct Mode {
    /// s, with an imaginary part that is not negative: the frequency, with the rate of growth.
    pub exponent: Complex,
    /// −s² exactly, where it is known: the square of the frequency.
    pub frequency_squared: Option<Surd>,
    /// Behaviour of the mode in time.
    pub behaviour: Behaviour,
    /// The parts of the coordinates, the largest being 1: x(t) = xₑ + a·Re(shape·e^{st}). So a is the amplitude of the
    /// coordinate with the part 1, which is [`leading`](Self::leading).
    pub shape: Vec<Complex>,
    /// The shape exactly, where it is known.
    pub exact_shape: Option<Vec<Surd>>,
    /// Number of modes with this frequency: any mixture of them is a mode as well.
    pub multiplicity: usize,
    /// Other modes whose frequency is a small multiple of this one's, or of which this one's is.
    pub resonances: Vec<Resonance>,
    /// Change of the frequency with the amplitude.
    pub shift: Result<Shift, ShiftError>,
}

/// Behaviour of a mode in time.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Behaviour {
    /// Oscillation with a constant amplitude.
    Oscillating,
    /// Nothing drives it back and nothing drives it away: it drifts.
    Free,
    /// Exponential growth, oscillating or not.
    Unstable,
    /// Exponential decay, oscillating or not.
    Damped,
}

/// Ω = ω + κa², where a is the coefficient of cos Ωt in the leading coordinate.
#[derive(Clone, Debug, PartialEq)]
pub struct Shift {
    /// κ.
    pub coefficient: f64,
    /// κ/ω exactly, where it is known: −1/16 for a pendulum.
    pub relative: Option<Surd>,
}

impl Mode {
    /// ω, the imaginary part of the exponent.
    #[must_use]
    pub fn frequency(&self) -> f64 {
        self.exponent.im
    }

    /// The number of the coordinate whose part is 1.
    #[must_use]
    pub fn leading(&self) -> usize {
        let one = Complex::from(1.0);
        self.shape.iter().position(|part| *part == one).unwrap_or(0)
    }
}

/// Another mode with which this one can exchange energy at small amplitudes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Resonance {
    /// The number of the other mode.
    pub other: usize,
    /// Ratio of the faster frequency to the slower one: 1, 2 or 3.
    pub multiple: u32,
    /// `true` if the other one is the faster.
    pub other_is_faster: bool,
    /// The faster frequency over the multiple of the slower one, less one.
    pub detuning: f64,
    /// `true` if the detuning is zero: proved, or up to rounding errors.
    pub exact: bool,
}
