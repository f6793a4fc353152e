//! Formulas of a limit cycle by Lindstedt's method, power by power.

use super::super::formula::{Formula, Name};
use super::FlowTerms;

/// A formula of a limit cycle, and the equation it belongs to.
#[derive(Clone, Debug, PartialEq)]
pub struct CycleFormula {
    /// The equation.
    pub flow: FlowTerms,
    /// The power of the excitation.
    pub order: usize,
    /// Statement of the formula.
    pub claim: CycleClaim,
}

/// The statement of a formula of a limit cycle.
#[derive(Clone, Debug, PartialEq)]
pub enum CycleClaim {
    /// The contribution of lower powers to the right side, with the amplitude one power below open.
    Forcing {
        /// The amplitude that is open.
        open: Name,
        /// Its known value.
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
        /// The amplitude that is open.
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
