//! Reliability of β and of the fitted motion, on which several warnings and pieces of advice depend.

use super::SwingsFit;
use crate::fit::angle_unit::MistakenUnit;
use crate::fit::beta::Beta;
use crate::fit::cycles;

impl SwingsFit {
    /// The unit of the angles, where it is not the stated one.
    pub(super) fn mistaken_unit(&self) -> Option<MistakenUnit> {
        let cycles = self.all_cycles().map(|(_, cycle)| cycle);
        self.beta.as_ref().ok().and_then(|beta| cycles::mistaken_unit(beta.factor.value, cycles))
    }

    /// Relative fall of the amplitude in a cycle, where it is so large that the period of single cycles, for which the exact law
    /// assumes a constant amplitude, means little.
    pub(super) fn strong_damping(&self) -> Option<f64> {
        /// R − 1, which goes with the square of the amplitude, then changes by a fifth within a cycle.
        const STRONG: f64 = 0.1;
        self.fall_in_a_cycle().filter(|&fall| fall > STRONG)
    }

    /// A β that is not explained by the exact law, strong damping, a fitted scale or a mistaken
    /// unit.
    pub(super) fn doubtful_beta(&self) -> Option<&Beta> {
        let beta = self.beta.as_ref().ok().filter(|beta| beta.differs_from_one())?;
        let explained =
            self.scale_is_fitted() || self.strong_damping().is_some() || self.mistaken_unit().is_some();
        (!explained).then_some(beta)
    }

    /// Returns `true` if the residuals of the motion are so large that its parameters mean little.
    pub(super) fn is_poor(&self) -> bool {
        /// Residuals relative to the swing, in root mean squares; errors of reading are a hundredth of it or so.
        const POOR: f64 = 0.1;
        self.fit.unexplained.sqrt() > POOR
    }
}
