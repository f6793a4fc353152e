//! Standing of models relative to the preferred one.

use super::Comparison;
use crate::fit::trace::{DampingKind, DampingModel, TraceFit};

/// Standing of a model relative to the preferred one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Standing {
    /// The preferred model.
    Preferred,
    /// The data cannot distinguish it from the preferred one.
    Tied,
    /// Worse, but the data do not exclude it.
    Possible,
    /// The model explains the data as well or better, but by too little to accept a negative coefficient.
    Negative,
    /// The model feeds energy to the pendulum at some speed, which no friction does.
    FeedsEnergy,
    /// The data exclude it.
    Excluded,
}

impl Standing {
    /// A stable name.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Preferred => "preferred",
            Self::Tied => "tied",
            Self::Possible => "possible",
            Self::Negative => "negative",
            Self::FeedsEnergy => "feeds_energy",
            Self::Excluded => "excluded",
        }
    }
}

impl Comparison {
    /// The standing of the model at this index.
    #[must_use]
    pub fn standing(&self, index: usize) -> Standing {
        let fit = &self.fits[index];
        let beyond = self.evidence(index) - self.evidence(self.preferred);
        match () {
            () if index == self.preferred => Standing::Preferred,
            () if !fit.dissipates() => Standing::FeedsEnergy,
            () if beyond < Self::INDISTINGUISHABLE => Standing::Tied,
            () if beyond < Self::UNSUPPORTED => Standing::Possible,
            () if fit.dissipates() && self.excess_over_preferred(index) < Self::UNSUPPORTED => {
                Standing::Negative
            }
            () => Standing::Excluded,
        }
    }

    /// The other models that the data do not exclude.
    #[must_use]
    pub fn rivals(&self) -> Vec<DampingModel> {
        let left = |index: &usize| matches!(self.standing(*index), Standing::Tied | Standing::Possible);
        (0..self.fits.len()).filter(left).map(|index| self.fits[index].damping).collect()
    }

    /// The rivals that contradict the preferred model: they lack a kind of damping that it has, or their additional terms change
    /// a coefficient of the damping by more than [`Self::MOVED`] of its stated uncertainties. A model that contains the
    /// preferred one, with a further coefficient that is zero within two of its uncertainties, contradicts nothing.
    #[must_use]
    pub fn contradicting(&self) -> Vec<DampingModel> {
        let preferred = self.best();
        let moves = |rival: &TraceFit| {
            preferred.damping.iter().any(|term| {
                let [reference, other] = [preferred, rival].map(|fit| fit.damping_coefficient(term));
                reference.zip(other).is_none_or(|(coefficient, other)| {
                    (other.estimate.value - coefficient.estimate.value).abs()
                        > Self::MOVED * coefficient.estimate.uncertainty
                })
            })
        };
        let adds_nothing = |rival: &TraceFit| {
            let contains = preferred.damping.iter().all(|term| rival.damping_coefficient(term).is_some());
            let has = |term: &DampingKind| preferred.damping_coefficient(*term).is_some();
            let mut added = rival.damping.iter().filter(|term| !has(term));
            let is_zero = |term: DampingKind| {
                let added = rival.damping_coefficient(term).map(|coefficient| coefficient.estimate);
                added.is_none_or(|added| added.deviation_from(0.0) <= Self::ZERO)
            };
            contains && added.all(is_zero)
        };
        let named = |terms: DampingModel| self.fits.iter().find(|fit| fit.damping == terms);
        self.rivals()
            .into_iter()
            .filter(|&rival| named(rival).is_some_and(|rival| !adds_nothing(rival) && moves(rival)))
            .collect()
    }

    /// The models that explain the data better than the preferred one and are not accepted, each with the difference of the criterion: one
    /// that is lower by less than [`Self::SUBSTANTIAL`] is not evidence.
    pub fn better(&self) -> impl Iterator<Item = (&TraceFit, f64)> {
        let doubtful = self
            .fits
            .iter()
            .enumerate()
            .filter(|(_, fit)| !(fit.dissipates() && fit.dissipates_by_each_term()));
        let with_evidence = doubtful.map(|(index, fit)| (fit, -self.excess_over_preferred(index)));
        with_evidence.filter(|(_, evidence)| *evidence > Self::SUBSTANTIAL)
    }

    /// Difference of the criterion from that of the preferred model.
    fn excess_over_preferred(&self, index: usize) -> f64 {
        self.aicc_differences[index] - self.aicc_differences[self.preferred]
    }
}
