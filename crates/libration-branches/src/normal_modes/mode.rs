//! One normal mode.

use super::no_shift::ShiftError;
use libration_numbers::algebra::{Complex, Surd};

/// A motion in which all coordinates are proportional to e^{st}.
#[derive(Clone, Debug, PartialEq)]
pub struct Mode {
    /// s, with a nonnegative imaginary part (the frequency); the real part is the growth rate.
    pub exponent: Complex,
    /// −s² exactly, if it is known: the square of the frequency.
    pub frequency_squared: Option<Surd>,
    /// Behaviour of the mode in time.
    pub behaviour: Behaviour,
    /// The components of the mode, the largest being 1: x(t) = xₑ + a·Re(shape·e^{st}). Thus a is
    /// the amplitude of the coordinate with the component 1, the [`leading`](Self::leading) one.
    pub shape: Vec<Complex>,
    /// The shape exactly, if it is known.
    pub exact_shape: Option<Vec<Surd>>,
    /// Number of modes with this frequency: any linear combination of them is a mode as well.
    pub multiplicity: usize,
    /// Number of further motions with this exponent that are not modes: they contain the factor t or powers of it, as t·e^{−t} at critical damping.
    pub with_powers_of_time: usize,
    /// Other modes whose frequency is a small multiple or a simple fraction of this one's.
    pub resonances: Vec<Resonance>,
    /// Change of the frequency with the amplitude.
    pub shift: Result<Shift, ShiftError>,
}

/// Behaviour of a mode in time.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Behaviour {
    /// Oscillation with a constant amplitude.
    Oscillating,
    /// Motion without a restoring or repelling force: drift.
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
    /// κ/ω exactly, if it is known: −1/16 for a pendulum.
    pub relative: Option<Surd>,
}

impl Mode {
    /// ω, the imaginary part of the exponent.
    #[must_use]
    pub fn frequency(&self) -> f64 {
        self.exponent.im
    }

    /// The index of the coordinate whose component is 1.
    #[must_use]
    pub fn leading(&self) -> usize {
        let one = Complex::from(1.0);
        self.shape.iter().position(|part| *part == one).unwrap_or(0)
    }
}

/// Another mode with which this one can exchange energy at small amplitudes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Resonance {
    /// The index of the other mode.
    pub other: usize,
    /// Ratio of the faster frequency to the slower one: 1, 2 or 3.
    pub multiple: u32,
    /// `true` if the other mode is the faster one.
    pub other_is_faster: bool,
    /// The faster frequency over the multiple of the slower one, minus one.
    pub detuning: f64,
    /// `true` if the detuning is zero, proved or up to rounding errors.
    pub exact: bool,
}
