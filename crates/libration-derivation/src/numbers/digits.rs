//! Sums, integrals and derivatives in real numbers to a given number of binary digits.

use super::precision::PRECISION;
use super::quadrature;
use crate::evaluate::{Analysis, EvaluationError};
use libration::algebra::{BigFloat, Floats, Ring};

/// Maximum number of terms of an infinite sum.
const MOST_TERMS: usize = 4000;

/// The numbers in which formulas are compared.
pub const DIGITS: Floats = Floats { precision: PRECISION };

impl Analysis for Floats {
    fn is_negligible(&self, term: &BigFloat, sum: &BigFloat) -> bool {
        let bits = isize::try_from(self.precision).unwrap_or(isize::MAX);
        match (term.exponent(), sum.exponent()) {
            (None, _) => true,
            (Some(term), Some(sum)) => sum - term > bits,
            (Some(_), None) => false,
        }
    }

    fn most_terms(&self) -> usize {
        MOST_TERMS
    }

    fn integral(
        &self,
        from: &BigFloat,
        to: &BigFloat,
        integrand: &mut dyn FnMut(BigFloat) -> Result<BigFloat, EvaluationError>,
    ) -> Result<BigFloat, EvaluationError> {
        quadrature::integral(from, to, integrand)
    }

    /// The central difference, whose error is of the order of the square of the step.
    /// With a step of 2 to minus a third of the bits, two thirds of the bits are correct.
    fn slope(
        &self,
        function: &mut dyn FnMut(BigFloat) -> Result<BigFloat, EvaluationError>,
    ) -> Result<BigFloat, EvaluationError> {
        let one = BigFloat::from_integer(1, self.precision);
        let step = (0..self.precision / 3).fold(one, |step, _| step.halved());
        let difference = function(step.clone())? - function(-step.clone())?;
        Ok((difference / step).halved())
    }

    fn agm(&self, a: &BigFloat, b: &BigFloat) -> Option<BigFloat> {
        let zero = self.zero();
        (*a > zero && *b > zero).then(|| a.agm(b))
    }

    fn left_out(&self, _order: &BigFloat) -> Result<BigFloat, EvaluationError> {
        Err(EvaluationError::NotInRing("the sum of the terms left out"))
    }
}
