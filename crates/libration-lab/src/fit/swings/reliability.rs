//! How far β and the fitted motion can be relied on, which several warnings and pieces of advice need to know.

use super::SwingsFit;
use crate::fit::cycles;
use crate::fit::{Beta, MistakenUnit};

impl SwingsFit {
    /// The unit of the angles, where it is not the one that was said.
    pub(super) fn mistaken_unit(&self) -> Option<MistakenUnit> {
        let cycles = self.all_cycles().map(|(_, cycle)| cycle);
        self.beta.as_ref().ok().and_then(|beta| cycles::mistaken_unit(beta.factor.value, cycles))
    }

    /// By which part the amplitude falls in a cycle, where that is so much that the period of single cycles, which the exact law
    /// gives for a constant amplitude, says little.
    pub(super) fn strong_damping(&self) -> Option<f64> {
        /// R − 1, which goes with the square of the amplitude, then changes by a fifth within a cycle.
        const STRONG: f64 = 0.1;
        self.fall_in_a_cycle().filter(|&fall| fall > STRONG)
    }

    /// A β that the exact law does not explain, and neither strong damping, nor a scale that is fitted, nor a mistaken
    /// unit.
    pub(super) fn doubtful_beta(&self) -> Option<&Beta> {
        let beta = self.beta.as_ref().ok().filter(|beta| beta.differs_from_one())?;
        let explained =
            self.scale_is_fitted() || self.strong_damping().is_some() || self.mistaken_unit().is_some();
        (!explained).then_some(beta)
    }

    /// Whether what the motion leaves is so large that its numbers mean little.
    pub(super) fn is_poor(&self) -> bool {
        /// As a part of the swing, in root mean squares; errors of reading are a hundredth of it or so.
        const POOR: f64 = 0.1;
        self.fit.unexplained.sqrt() > POOR
    }
}
