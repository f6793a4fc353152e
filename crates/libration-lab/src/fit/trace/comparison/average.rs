//! Numbers averaged over the models that the data leave.

use super::{Comparison, Standing};
use crate::fit::Uncertain;
use crate::fit::trace::TraceFit;

/// A number averaged over the models that the data leave.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Averaged {
    /// The mean, each model with its weight.
    pub value: f64,
    /// The standard uncertainty, the spread between the models included.
    pub uncertainty: f64,
    /// The spread between the models alone, as a standard deviation.
    pub spread: f64,
}

impl From<Averaged> for Uncertain {
    fn from(Averaged { value, uncertainty, .. }: Averaged) -> Self {
        Self { value, uncertainty }
    }
}

impl Comparison {
    /// How much the data speak for each model (Akaike's weights, ibidem, section 2.9): the sum is 1, and those that are
    /// excluded have none.
    #[must_use]
    pub fn weights(&self) -> Vec<f64> {
        let least = (0..self.fits.len()).map(|place| self.evidence(place)).fold(f64::INFINITY, f64::min);
        let weight = |place: usize| match self.standing(place) {
            Standing::Preferred | Standing::Tied | Standing::Possible => {
                libm::exp(-0.5 * (self.evidence(place) - least).min(2.0 * Self::DECISIVE))
            }
            Standing::Negative | Standing::FeedsEnergy | Standing::Excluded => 0.0,
        };
        let weights: Vec<f64> = (0..self.fits.len()).map(weight).collect();
        let sum: f64 = weights.iter().sum();
        weights.into_iter().map(|weight| weight / sum).collect()
    }

    /// 2π/ω0, averaged over the models, in s.
    #[must_use]
    pub fn small_angle_period(&self) -> Averaged {
        self.averaged(|fit| {
            let period = fit.small_angle_period();
            Some((period.value, period.uncertainty))
        })
    }

    /// A shared parameter, averaged over the models that have it; none if no model has.
    #[must_use]
    pub fn parameter(&self, name: &str) -> Option<Averaged> {
        let value = |fit: &TraceFit| fit.parameter(name).map(|it| (it.value, it.uncertainty));
        self.fits.iter().any(|fit| value(fit).is_some()).then(|| self.averaged(value))
    }

    /// With the unconditional variance of Burnham and Anderson's equation 4.9, as variances.
    fn averaged(&self, of: impl Fn(&TraceFit) -> Option<(f64, f64)>) -> Averaged {
        let weights = self.weights();
        let known = self.fits.iter().zip(&weights).filter_map(|(fit, weight)| Some((of(fit)?, *weight)));
        let known: Vec<((f64, f64), f64)> = known.collect();
        let total: f64 = known.iter().map(|(_, weight)| weight).sum();
        let mean = |value: &dyn Fn((f64, f64)) -> f64| {
            known.iter().map(|(pair, weight)| weight * value(*pair)).sum::<f64>() / total
        };
        let value = mean(&|(value, _)| value);
        let between = mean(&|(one, _)| (one - value) * (one - value));
        let within = mean(&|(_, uncertainty)| uncertainty * uncertainty);
        Averaged { value, uncertainty: (within + between).sqrt(), spread: between.sqrt() }
    }
}
