//! Arithmetic progressions of exact numbers.

use dashu_base::{Abs, Signed};
use dashu_ratio::RBig;

use super::excerpt::excerpt;
use super::pi_combination::PiCombination;
use super::range_error::{MOST_ELEMENTS, RangeError};

/// An exact arithmetic progression.
#[derive(Clone, Debug)]
pub(super) struct Progression {
    start: PiCombination,
    step: PiCombination,
    pub(super) count: usize,
}

impl Progression {
    pub(super) fn new(
        text: &str,
        start: PiCombination,
        stop: &PiCombination,
        step: PiCombination,
    ) -> Result<Self, RangeError> {
        let (distance, stride) =
            (stop.value().to_rational() - start.value().to_rational(), step.value().to_rational());
        if stride.is_zero() {
            return Err(RangeError::ZeroStep(excerpt(text)));
        }
        if !distance.is_zero() && distance.is_negative() != stride.is_negative() {
            return Err(RangeError::WrongSign(excerpt(text)));
        }
        let tolerance = RBig::from_parts(5.into(), 10_000_000_000u64.into());
        let steps = (distance / stride).abs() + tolerance;
        let too_many = || RangeError::TooMany(excerpt(text));
        let steps = u64::try_from(steps.floor()).map_err(|_| too_many())?;
        if steps >= MOST_ELEMENTS {
            return Err(too_many());
        }
        let count = usize::try_from(steps + 1).map_err(|_| too_many())?;
        Ok(Self { start, step, count })
    }

    pub(super) fn get(&self, k: usize) -> Option<PiCombination> {
        (k < self.count).then(|| self.element(k))
    }

    pub(super) fn element(&self, k: usize) -> PiCombination {
        let k = RBig::from(k);
        PiCombination {
            pi_multiple: &self.start.pi_multiple + &self.step.pi_multiple * &k,
            rest: &self.start.rest + &self.step.rest * &k,
        }
    }
}
