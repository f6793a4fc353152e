//! The ansatz with its symbols, and the terms of the equation of motion for it, power by power of ε.

use std::collections::BTreeMap;

use super::{Condition, EpsilonPowers};
use crate::perturbation::cosines::{COSINES, Cosines, cosines};
use libration_numbers::{
    algebra::{Polynomial, Polynomials, Rational, Ring, Variable},
    internals::algebra::PhaseRing,
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

/// x, its powers and Δ as power series in ε, as far as they are known.
pub(super) struct Expansion<'a> {
    ansatz: &'a Ansatz,
    /// The factors of x, x², x³, ….
    force: &'a [Rational],
    /// `powers[p][n]` is the coefficient of εⁿ in x^(p+1).
    powers: Vec<Vec<Cosines>>,
    /// The coefficients of Δ.
    frequency: Vec<Polynomial>,
}

impl<'a> Expansion<'a> {
    pub(super) fn new(ansatz: &'a Ansatz, force: &'a [Rational]) -> Self {
        let one = Polynomial::constant(Rational::from(1));
        Self { ansatz, force, powers: vec![vec![COSINES.zero()]; force.len()], frequency: vec![one] }
    }

    /// The conditions of an order, whose coefficients enter as symbols.
    pub(super) fn conditions(&mut self, order: u32) -> Vec<Condition> {
        self.fill_powers(order as usize);
        self.insert(order, &BTreeMap::new());
        let equation = self.equation_of_motion(order as usize);
        let polynomial = |harmonic: u32| COSINES.harmonic(&equation, harmonic as usize).cosine;
        let condition =
            |harmonic: &u32| Condition { order, harmonic: *harmonic, polynomial: polynomial(*harmonic) };
        self.ansatz.harmonics.iter().map(condition).collect()
    }

    /// Sets the coefficients of an order to their solutions, the others to their symbols.
    pub(super) fn insert(&mut self, order: u32, found: &BTreeMap<Variable, Polynomial>) {
        let value =
            |symbol: Variable| found.get(&symbol).cloned().unwrap_or_else(|| Polynomial::variable(symbol));
        let terms = self.ansatz.harmonics.iter().map(|k| (*k, value(coefficient(*k, order))));
        self.powers[0][order as usize] = cosines(terms);
        if let Some(before @ 1..) = order.checked_sub(1) {
            self.frequency[before as usize] = value(frequency_correction(before));
        }
    }

    /// The powers of x up to εⁿ, which need x only up to εⁿ⁻¹; zero for the orders that the ansatz passes over.
    fn fill_powers(&mut self, n: usize) {
        self.frequency.resize(n, Polynomial::zero());
        for n in self.powers[0].len()..=n {
            self.powers[0].push(COSINES.zero());
            for p in 1..self.force.len() {
                let next = COSINES.convolution(&self.powers[0][1..n], &self.powers[p - 1][1..n]);
                self.powers[p].push(next);
            }
        }
    }

    /// The coefficient of εⁿ in Δ²x″ + x + g₂x² + g₃x³ + ….
    fn equation_of_motion(&self, n: usize) -> Cosines {
        let acceleration = (0..n).map(|m| {
            let square = Polynomials.convolution(&self.frequency[..=m], &self.frequency[..=m]);
            COSINES.times_number(&self.second_derivative(n - m), &square)
        });
        let force =
            self.force.iter().zip(&self.powers).map(|(factor, power)| {
                COSINES.times_number(&power[n], &Polynomial::constant(factor.clone()))
            });
        acceleration.chain(force).fold(COSINES.zero(), |sum, term| COSINES.add(&sum, &term))
    }

    /// The coefficient of εⁿ in the second derivative of x with respect to Ωt.
    fn second_derivative(&self, n: usize) -> Cosines {
        let term = |k: &u32| {
            let amplitude = COSINES.harmonic(&self.powers[0][n], *k as usize).cosine;
            (*k, amplitude.scaled(&-Rational::from(i64::from(k * k))))
        };
        cosines(self.ansatz.harmonics.iter().map(term))
    }
}
