//! The ansatz with its symbols, and the terms of the equation of motion for it, power by power of ε.

use std::collections::BTreeMap;

use super::{Condition, EpsilonPowers, RestoringTerm};
use crate::perturbation::cosines::{COSINES, Cosines, cosines};
use libration_numbers::{
    algebra::{Polynomial, Polynomials, Rational, Ring, Variable},
    internals::algebra::{HarmonicPair, PhaseRing},
};

/// The harmonics of x, and the powers of ε they have.
#[derive(Clone, Debug)]
pub(super) struct Ansatz {
    pub(super) harmonics: Vec<u32>,
    pub(super) orders: Vec<u32>,
}

impl Ansatz {
    pub(super) fn new(order: u32, powers: EpsilonPowers, asymmetric: bool) -> Self {
        let odd = || (1..=order).step_by(2).collect();
        Self {
            harmonics: if asymmetric { (0..=order).collect() } else { odd() },
            orders: if powers == EpsilonPowers::All { (1..=order).collect() } else { odd() },
        }
    }
}

/// A, B, C, … for the odd harmonics 1, 3, 5, …; P, Q, R, … for the even ones 0, 2, 4, ….
pub(super) fn coefficient(harmonic: u32, order: u32) -> Variable {
    let first = if harmonic.is_multiple_of(2) { 'P' } else { 'A' };
    let letter = char::from_u32(u32::from(first) + harmonic / 2).unwrap_or('?');
    Variable::indexed(&letter.to_string(), order)
}

/// d₁, d₂, d₃, ….
pub(super) fn frequency_correction(order: u32) -> Variable {
    Variable::indexed("d", order)
}

/// x, Δx′, their products and Δ as power series in ε, as far as they are known.
pub(super) struct OpenExpansion<'a> {
    ansatz: &'a Ansatz,
    force: &'a [RestoringTerm],
    /// The coefficients of εⁿ in x, and in Δx′.
    displacement: Vec<Cosines>,
    velocity: Vec<Cosines>,
    /// The coefficients of εⁿ in xᵖ·(Δx′)^q, by the exponents.
    products: BTreeMap<(u32, u32), Vec<Cosines>>,
    /// The coefficients of Δ.
    frequency: Vec<Polynomial>,
}

impl<'a> OpenExpansion<'a> {
    pub(super) fn new(ansatz: &'a Ansatz, force: &'a [RestoringTerm]) -> Self {
        let one = Polynomial::constant(Rational::from(1));
        let zero = || vec![COSINES.zero()];
        let mut products = BTreeMap::new();
        for term in force {
            // From the velocity's power on, the displacement's are built up one by one.
            let of_velocity = (2..=term.velocity).map(|velocity| (0, velocity));
            let of_both = (1..=term.position).map(|position| (position, term.velocity));
            products.extend(of_velocity.chain(of_both).filter(|(p, q)| p + q > 1).map(|key| (key, zero())));
        }
        Self { ansatz, force, displacement: zero(), velocity: zero(), products, frequency: vec![one] }
    }

    /// The conditions of an order, whose coefficients enter as symbols.
    pub(super) fn conditions(&mut self, order: u32) -> Vec<Condition> {
        self.fill_products(order as usize);
        self.insert(order, &BTreeMap::new());
        let equation = self.equation_of_motion(order as usize);
        let polynomial = |harmonic: u32| COSINES.harmonic(&equation, harmonic as usize).cosine;
        let condition =
            |harmonic: &u32| Condition { order, harmonic: *harmonic, polynomial: polynomial(*harmonic) };
        self.ansatz.harmonics.iter().map(condition).collect()
    }

    /// Sets the coefficients of an order to their solutions, the others to their symbols.
    pub(super) fn insert(&mut self, order: u32, solutions: &BTreeMap<Variable, Polynomial>) {
        let value = |symbol: Variable| {
            solutions.get(&symbol).cloned().unwrap_or_else(|| Polynomial::variable(symbol))
        };
        let terms = self.ansatz.harmonics.iter().map(|k| (*k, value(coefficient(*k, order))));
        self.displacement[order as usize] = cosines(terms);
        if let Some(before @ 1..) = order.checked_sub(1) {
            self.frequency[before as usize] = value(frequency_correction(before));
        }
    }

    /// The products up to εⁿ, which need x and Δx′ only up to εⁿ⁻¹; zero for the orders that the ansatz passes over.
    fn fill_products(&mut self, n: usize) {
        self.frequency.resize(n, Polynomial::zero());
        for n in self.displacement.len()..=n {
            self.displacement.push(COSINES.zero());
            if n > 1 {
                self.velocity.push(self.velocity_at(n - 1));
            }
            // Ascending keys: each product has its shorter one before it.
            let keys: Vec<(u32, u32)> = self.products.keys().copied().collect();
            let by_velocity = keys.iter().filter(|(p, _)| *p == 0);
            for key in by_velocity.chain(keys.iter().filter(|(p, _)| *p > 0)) {
                let (by, rest) = match key {
                    (0, q) => (&self.velocity, self.power(0, q - 1)),
                    (p, q) => (&self.displacement, self.power(p - 1, *q)),
                };
                let next = COSINES.convolution(&by[1..n], &rest[1..n]);
                if let Some(product) = self.products.get_mut(key) {
                    product.push(next);
                }
            }
        }
    }

    /// xᵖ·(Δx′)^q, as far as it is known.
    fn power(&self, position: u32, velocity: u32) -> &[Cosines] {
        match (position, velocity) {
            (1, 0) => &self.displacement,
            (0, 1) => &self.velocity,
            key => self.products.get(&key).map_or(&[], Vec::as_slice),
        }
    }

    /// The coefficient of εⁿ in Δx′.
    fn velocity_at(&self, n: usize) -> Cosines {
        let term = |m: usize| COSINES.times_number(&self.slope(n - m), &self.frequency[m]);
        (0..n).map(term).fold(COSINES.zero(), |sum, term| COSINES.add(&sum, &term))
    }

    /// The coefficient of εⁿ in Δ²x″ + x + Σ factor·xᵖ·(Δx′)^q.
    fn equation_of_motion(&self, n: usize) -> Cosines {
        let acceleration = (0..n).map(|m| {
            let square = Polynomials.convolution(&self.frequency[..=m], &self.frequency[..=m]);
            COSINES.times_number(&self.second_derivative(n - m), &square)
        });
        let force = self.force.iter().filter_map(|term| {
            let product = self.power(term.position, term.velocity).get(n)?;
            Some(COSINES.times_number(product, &term.factor))
        });
        let parts = acceleration.chain(force);
        parts.fold(self.displacement[n].clone(), |sum, term| COSINES.add(&sum, &term))
    }

    /// The coefficient of εⁿ in the derivative of x with respect to Ωt.
    fn slope(&self, n: usize) -> Cosines {
        let term = |k: &u32| {
            let amplitude = COSINES.harmonic(&self.displacement[n], *k as usize).cosine;
            let sine = amplitude.scaled(&-Rational::from(i64::from(*k)));
            (*k as usize, HarmonicPair { cosine: Polynomial::zero(), sine })
        };
        COSINES.sum_of_harmonics(&self.ansatz.harmonics.iter().map(term).collect::<Vec<_>>())
    }

    /// The coefficient of εⁿ in the second derivative of x with respect to Ωt.
    fn second_derivative(&self, n: usize) -> Cosines {
        let term = |k: &u32| {
            let amplitude = COSINES.harmonic(&self.displacement[n], *k as usize).cosine;
            (*k, amplitude.scaled(&-Rational::from(i64::from(k * k))))
        };
        cosines(self.ansatz.harmonics.iter().map(term))
    }
}
