//! Products of powers of variables, and the order in which they are written.

use std::cmp::{Ordering, Reverse};

use super::Variable;

/// A product of positive powers of different variables; 1 without any.
#[derive(Clone, Debug, Default, PartialEq, Eq, Hash)]
pub struct Monomial {
    /// In the order of the variables.
    factors: Vec<(Variable, u32)>,
}

impl Monomial {
    /// The variables with their exponents, in the order of the variables.
    #[must_use]
    pub fn factors(&self) -> &[(Variable, u32)] {
        &self.factors
    }

    /// The sum of the exponents.
    #[must_use]
    pub fn degree(&self) -> u32 {
        self.factors.iter().map(|(_, exponent)| exponent).sum()
    }

    /// The exponent of a variable, 0 where it is missing.
    #[must_use]
    pub fn exponent(&self, of: &Variable) -> u32 {
        self.factors.iter().find(|(variable, _)| variable == of).map_or(0, |(_, exponent)| *exponent)
    }

    pub(super) fn variable(variable: Variable) -> Self {
        Self { factors: vec![(variable, 1)] }
    }

    pub(super) fn times(&self, other: &Self) -> Self {
        let mut factors = Vec::with_capacity(self.factors.len() + other.factors.len());
        let (mut ours, mut theirs) = (self.factors.iter().peekable(), other.factors.iter().peekable());
        while let (Some((x, i)), Some((y, j))) = (ours.peek(), theirs.peek()) {
            let order = x.cmp(y);
            factors.push(match order {
                Ordering::Less => (x.clone(), *i),
                Ordering::Greater => (y.clone(), *j),
                Ordering::Equal => (x.clone(), i + j),
            });
            let _ = if order.is_le() { ours.next() } else { None };
            let _ = if order.is_ge() { theirs.next() } else { None };
        }
        factors.extend(ours.chain(theirs).cloned());
        Self { factors }
    }

    /// The quotient, when the divisor's exponents are nowhere larger.
    pub(super) fn divided_by(&self, divisor: &Self) -> Option<Self> {
        let divides = divisor.factors.iter().all(|(variable, exponent)| self.exponent(variable) >= *exponent);
        let quotient = self.factors.iter().map(|(variable, exponent)| {
            // Not below zero when `divides` holds; otherwise thrown away.
            (variable.clone(), exponent.saturating_sub(divisor.exponent(variable)))
        });
        divides.then(|| Self { factors: quotient.filter(|(_, exponent)| *exponent > 0).collect() })
    }

    /// The monomial without one of its variables.
    pub(super) fn without(&self, variable: &Variable) -> Self {
        Self { factors: self.factors.iter().filter(|(other, _)| other != variable).cloned().collect() }
    }
}

/// Lower degrees first; among equal degrees the one with the larger power of the first variable. This is an
/// admissible order: it is kept by multiplication, and 1 comes first.
impl Ord for Monomial {
    fn cmp(&self, other: &Self) -> Ordering {
        let key = |(variable, exponent): &(Variable, u32)| (variable.clone(), Reverse(*exponent));
        let by_degree = self.degree().cmp(&other.degree());
        by_degree.then_with(|| self.factors.iter().map(key).cmp(other.factors.iter().map(key)))
    }
}

impl PartialOrd for Monomial {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}
