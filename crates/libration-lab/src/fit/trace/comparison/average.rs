//! Averages over the models that are not ruled out.

use super::{Comparison, Standing};
use crate::fit::trace::{ParameterKind, TraceFit};
use crate::fit::uncertain::Uncertain;

/// A number averaged over the models that are not ruled out.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ModelAverage {
    /// The mean, each model with its weight; its uncertainty includes the spread between the models.
    pub mean: Uncertain,
    /// The spread between the models alone, as a standard deviation.
    pub spread: f64,
}

impl Comparison {
    /// Akaike weights of the models (Burnham and Anderson 2002, section 2.9): the sum is 1, and those that are
    /// excluded have none.
    #[must_use]
    pub fn weights(&self) -> Vec<f64> {
        let least = (0..self.fits.len()).map(|index| self.evidence(index)).fold(f64::INFINITY, f64::min);
        let weight = |index: usize| match self.standing(index) {
            Standing::Preferred | Standing::Tied | Standing::Possible => {
                libm::exp(-0.5 * (self.evidence(index) - least).min(2.0 * Self::DECISIVE))
            }
            Standing::Negative | Standing::FeedsEnergy | Standing::Excluded => 0.0,
        };
        let weights: Vec<f64> = (0..self.fits.len()).map(weight).collect();
        let sum: f64 = weights.iter().sum();
        weights.into_iter().map(|weight| weight / sum).collect()
    }

    /// 2π/ω0, averaged over the models, in s.
    #[must_use]
    pub fn small_angle_period(&self) -> ModelAverage {
        self.averaged(|fit| Some(fit.small_angle_period()))
    }

    /// A shared parameter, averaged over the models that have it; `None` if no model has it.
    #[must_use]
    pub fn parameter(&self, kind: ParameterKind) -> Option<ModelAverage> {
        let estimate = |fit: &TraceFit| fit.parameter(kind).map(|parameter| parameter.estimate);
        self.fits.iter().any(|fit| estimate(fit).is_some()).then(|| self.averaged(estimate))
    }

    /// The difference of Q at an amplitude, in radians, between a model and the others with their weights, as a standard deviation.
    pub(crate) fn spread_of_quality(&self, of: &TraceFit, amplitude: f64) -> f64 {
        let Some(quality) = of.quality(amplitude) else { return 0.0 };
        let pairs = self.fits.iter().zip(self.weights());
        let qualities =
            pairs.filter_map(|(fit, weight)| Some((fit.quality(amplitude)?.factor.value, weight)));
        let (sum, weights) = qualities.fold((0.0, 0.0), |(sum, weights), (value, weight)| {
            let difference = value - quality.factor.value;
            (sum + weight * difference * difference, weights + weight)
        });
        (sum / weights).sqrt()
    }

    /// Averages with the unconditional variance of Burnham and Anderson's equation 4.9, as variances.
    fn averaged(&self, estimate: impl Fn(&TraceFit) -> Option<Uncertain>) -> ModelAverage {
        let weights = self.weights();
        let pairs =
            self.fits.iter().zip(&weights).filter_map(|(fit, weight)| Some((estimate(fit)?, *weight)));
        let estimates: Vec<(Uncertain, f64)> = pairs.collect();
        let total: f64 = estimates.iter().map(|(_, weight)| weight).sum();
        let mean = |number: &dyn Fn(&Uncertain) -> f64| {
            estimates.iter().map(|(one, weight)| weight * number(one)).sum::<f64>() / total
        };
        let value = mean(&|one| one.value);
        let between = mean(&|one| (one.value - value) * (one.value - value));
        let within = mean(&|one| one.uncertainty * one.uncertainty);
        let uncertainty = (within + between).sqrt();
        ModelAverage { mean: Uncertain { value, uncertainty }, spread: between.sqrt() }
    }
}
