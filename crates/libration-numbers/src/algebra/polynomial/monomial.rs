//! Products of powers of variables, and the order in which they are written.

use std::cmp::Ordering;

use super::Variable;

/// A product of positive powers of different variables; the empty product is 1.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Monomial<V = Variable> {
    /// Factors in the order of the variables.
    factors: Vec<(V, u32)>,
}

impl<V> Default for Monomial<V> {
    fn default() -> Self {
        Self { factors: vec![] }
    }
}

impl<V: Ord + Clone> Monomial<V> {
    /// The variables with their exponents, in the order of the variables.
    #[must_use]
    pub fn factors(&self) -> &[(V, u32)] {
        &self.factors
    }

    /// The sum of the exponents.
    #[must_use]
    pub fn degree(&self) -> u32 {
        self.degree_in(|_| true)
    }

    /// The sum of the exponents of the variables of a kind, at most the largest `u32`.
    pub(crate) fn degree_in(&self, kind: impl Fn(&V) -> bool) -> u32 {
        let exponents = self.factors.iter().filter(|(variable, _)| kind(variable));
        exponents.fold(0, |sum, (_, exponent)| sum.saturating_add(*exponent))
    }

    /// The exponent of a variable, 0 if it does not occur.
    #[must_use]
    pub fn exponent(&self, of: &V) -> u32 {
        self.factors.iter().find(|(variable, _)| variable == of).map_or(0, |(_, exponent)| *exponent)
    }

    pub(super) fn variable(variable: V) -> Self {
        Self { factors: vec![(variable, 1)] }
    }

    /// The product; `None` for exponents beyond `u32`.
    pub(super) fn times(&self, other: &Self) -> Option<Self> {
        let mut factors = Vec::with_capacity(self.factors.len() + other.factors.len());
        let (mut ours, mut theirs) = (&self.factors[..], &other.factors[..]);
        while let ([(x, i), our_rest @ ..], [(y, j), their_rest @ ..]) = (ours, theirs) {
            let order = x.cmp(y);
            factors.push(match order {
                Ordering::Less => (x.clone(), *i),
                Ordering::Greater => (y.clone(), *j),
                Ordering::Equal => (x.clone(), i.checked_add(*j)?),
            });
            ours = if order.is_le() { our_rest } else { ours };
            theirs = if order.is_ge() { their_rest } else { theirs };
        }
        factors.extend(ours.iter().chain(theirs).cloned());
        Some(Self { factors })
    }

    /// The power; `None` for exponents beyond `u32`.
    pub(super) fn power(&self, times: u32) -> Option<Self> {
        let factors = self.factors.iter().filter(|_| times > 0);
        let factors =
            factors.map(|(variable, exponent)| Some((variable.clone(), exponent.checked_mul(times)?)));
        Some(Self { factors: factors.collect::<Option<_>>()? })
    }

    /// The quotient, if no exponent of the divisor is larger.
    pub(super) fn divided_by(&self, divisor: &Self) -> Option<Self> {
        let divides = divisor.factors.iter().all(|(variable, exponent)| self.exponent(variable) >= *exponent);
        let quotient = self.factors.iter().map(|(variable, exponent)| {
            // Not negative if `divides` holds; otherwise the result is discarded.
            (variable.clone(), exponent.saturating_sub(divisor.exponent(variable)))
        });
        divides.then(|| Self { factors: quotient.filter(|(_, exponent)| *exponent > 0).collect() })
    }

    /// The monomial without one of its variables.
    pub(super) fn without(&self, variable: &V) -> Self {
        Self { factors: self.factors.iter().filter(|(other, _)| other != variable).cloned().collect() }
    }
}

/// Lower degrees come first; among equal degrees, the larger power of the first variable. This is an admissible order: multiplication preserves
/// it, and 1 comes first.
impl<V: Ord> Ord for Monomial<V> {
    fn cmp(&self, other: &Self) -> Ordering {
        let degree =
            |monomial: &Self| monomial.factors.iter().map(|(_, exponent)| u64::from(*exponent)).sum::<u64>();
        let by_power = |((x, i), (y, j)): (&(V, u32), &(V, u32))| x.cmp(y).then_with(|| j.cmp(i));
        let pairs = || self.factors.iter().zip(&other.factors).map(by_power);
        let by_degree = degree(self).cmp(&degree(other));
        by_degree
            .then_with(|| pairs().find(|order| order.is_ne()).unwrap_or(Ordering::Equal))
            .then_with(|| self.factors.len().cmp(&other.factors.len()))
    }
}

impl<V: Ord> PartialOrd for Monomial<V> {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}
