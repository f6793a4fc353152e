//! Formulas evaluated as power series with rational coefficients.

use libration::algebra::{Function, Rational, Rationals, Ring};
use libration::series::PowerSeries;

use crate::evaluate::{Analysis, EvaluationError};

/// The coefficients that are certain, constant term first.
pub(crate) type Coefficients = Vec<Rational>;

impl Analysis for PowerSeries<Rationals> {
    fn is_negligible(&self, term: &Coefficients, _sum: &Coefficients) -> bool {
        self.is_zero(term)
    }

    fn most_terms(&self) -> usize {
        self.terms
    }

    fn integral(
        &self,
        _from: &Coefficients,
        _to: &Coefficients,
        _integrand: &mut dyn FnMut(Coefficients) -> Result<Coefficients, EvaluationError>,
    ) -> Result<Coefficients, EvaluationError> {
        Err(EvaluationError::NotInRing("an integral of series"))
    }

    fn slope(
        &self,
        _function: &mut dyn FnMut(Coefficients) -> Result<Coefficients, EvaluationError>,
    ) -> Result<Coefficients, EvaluationError> {
        Err(EvaluationError::NotInRing("a derivative of series"))
    }

    /// Each step doubles the number of coefficients that agree.
    fn agm(&self, a: &Coefficients, b: &Coefficients) -> Option<Coefficients> {
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
    fn left_out(&self, order: &Coefficients) -> Result<Coefficients, EvaluationError> {
        let begins = order.iter().position(|c| !c.is_zero()).unwrap_or(order.len());
        Ok(vec![Rational::from(0); begins])
    }
}
