//! Formulas of a limit cycle by Lindstedt's method, power by power.

use super::super::formula::{Formula, Name};
use super::FlowTerms;

/// A formula of a limit cycle, and its equation of motion.
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
    /// The contribution of lower powers to the right side, as a function of the undetermined amplitude one power below.
    Forcing {
        /// The undetermined amplitude.
        open: Name,
        /// The known value of the amplitude.
        value: Formula,
    },
    /// The factor of the sine on the right side, which must vanish.
    Sine {
        /// The undetermined amplitude.
        open: Name,
    },
    /// The amplitude one power below.
    Amplitude,
    /// The correction of the frequency.
    Frequency,
    /// The motion, as a function of its undetermined amplitude.
    Motion {
        /// The undetermined amplitude.
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
