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

    /// Relative decrease of the amplitude in a cycle, if it is so large that the periods of single cycles, for which the exact
    /// law assumes a constant amplitude, mean little.
    pub(super) fn strong_damping(&self) -> Option<f64> {
        /// Relative decrease of the amplitude in a cycle above which damping is strong: R − 1, proportional to the square of the amplitude, then
        /// changes by a fifth within the cycle.
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
        /// Root mean square of the residuals relative to the swing above which a fit is poor; reading errors are about a hundredth.
        const POOR: f64 = 0.1;
        self.fit.unexplained.sqrt() > POOR
    }
}
