//! Formulas evaluated as power series.

use libration::algebra::{Function, Ring};
use libration::series::PowerSeries;

use crate::evaluate::{Analysis, EvaluationError};

impl<R: Ring> Analysis for PowerSeries<R> {
    fn is_negligible(&self, term: &Self::Element, _sum: &Self::Element) -> bool {
        self.is_zero(term)
    }

    fn most_terms(&self) -> usize {
        self.terms
    }

    fn integral(
        &self,
        _from: &Self::Element,
        _to: &Self::Element,
        _integrand: &mut dyn FnMut(Self::Element) -> Result<Self::Element, EvaluationError>,
    ) -> Result<Self::Element, EvaluationError> {
        Err(EvaluationError::NotInRing("an integral of series"))
    }

    fn slope(
        &self,
        _function: &mut dyn FnMut(Self::Element) -> Result<Self::Element, EvaluationError>,
    ) -> Result<Self::Element, EvaluationError> {
        Err(EvaluationError::NotInRing("a derivative of series"))
    }

    /// Each step doubles the number of coefficients that agree.
    fn agm(&self, a: &Self::Element, b: &Self::Element) -> Option<Self::Element> {
        let (mut a, mut b) = (a.clone(), b.clone());
        for _ in 0..=self.terms {
            if self.is_zero(&self.subtract(&a, &b)) {
                return Some(a);
            }
            let mean = self.over_integer(&self.add(&a, &b), 2)?;
            b = self.value(Function::Sqrt, &self.multiply(&a, &b))?;
            a = mean;
        }
        None
    }

    /// The omitted part; zero if its order lies beyond the coefficients that are compared.
    fn left_out(&self, order: &Self::Element) -> Result<Self::Element, EvaluationError> {
        let begins = order.iter().position(|c| !self.coefficients.is_zero(c)).unwrap_or(order.len());
        Ok(vec![self.coefficients.zero(); begins])
    }
}
