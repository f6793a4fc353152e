//! What Lindstedt's method says of a limit cycle, power by power.

use super::super::formula::{Formula, Name};
use super::FlowTerms;

/// A formula of a limit cycle, and the equation it belongs to.
#[derive(Clone, Debug, PartialEq)]
pub struct CycleFormula {
    /// The equation.
    pub flow: FlowTerms,
    /// The power of the excitation.
    pub order: usize,
    /// What the formula says.
    pub claim: CycleClaim,
}

/// What a formula of a limit cycle says.
#[derive(Clone, Debug, PartialEq)]
pub enum CycleClaim {
    /// What lower powers bring to the right side, with the amplitude one power below open.
    Forcing {
        /// That amplitude.
        open: Name,
        /// It.
        known: Formula,
    },
    /// The factor of the sine on the right side, which must vanish.
    Sine {
        /// The amplitude that is open.
        open: Name,
    },
    /// The amplitude one power below.
    Amplitude,
    /// The correction of the frequency.
    Frequency,
    /// The motion, its own amplitude open.
    Motion {
        /// That amplitude.
        open: Name,
    },
    /// The amplitude of the first harmonic as a series.
    AmplitudeSeries {
        /// The strength of the excitation.
        parameter: Name,
    },
    /// The frequency as a series.
    FrequencySeries {
        /// The strength of the excitation.
        parameter: Name,
    },
}
