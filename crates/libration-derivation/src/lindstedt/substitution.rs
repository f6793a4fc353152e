//! Substitution of a motion into the equation of motion: the proof that it is a solution.
//!
//! At each order the equation is a polynomial in cos τ whose degree is at most the order. It
//! is therefore decided by one more value of cos τ than the order; rational values suffice.

use super::super::check::{
    Check, CheckedEquation, DerivationError, Given, Letters, failed, letters_of, same_series_where,
    series_value,
};
use super::super::formula::{
    Formula, Name, Statement, letter, monomial, number, order, polynomial, sin, sum,
};
use super::names::{cosine, harmonic_name};
use super::question::LindstedtQuestion;
use super::solution::PolynomialSeries;
use libration::algebra::{Polynomial, Rational};

/// A motion as the harmonics k with their series in ε, and its frequency ratio Ω/ω0.
#[derive(Debug)]
pub struct Motion {
    pub harmonics: Vec<(usize, Vec<Polynomial>)>,
    pub frequency: Vec<Polynomial>,
}

/// Checks that a motion solves Δ²u″ = f/ω0² up to the requested order.
pub fn solves(question: &LindstedtQuestion, motion: &Motion) -> Result<CheckedEquation, DerivationError> {
    let next = i64::try_from(question.order + 1).unwrap_or(i64::MAX);
    let statement = Statement::equal(left_side(question), order(letter("ε").pow(next)));
    let phases = question.order + 1;
    for phase in phases_of(question, phases) {
        same_series_where(&epsilon(), phases, &given(question, motion, &phase), statement.clone())?;
    }
    let check = Check::Phases { variable: epsilon(), order: question.order, phases };
    Ok(CheckedEquation::new(statement, check).with_letters(letters(question, motion)))
}

/// The values of the names in the equation of motion at a phase τ.
fn letters(question: &LindstedtQuestion, motion: &Motion) -> Letters {
    let series =
        |(k, series): &(usize, PolynomialSeries)| (harmonic_name(*k), polynomial(series, &letter("ε")));
    let total = |weight: &dyn Fn(usize) -> i64| {
        let term = |(k, _): &(usize, PolynomialSeries)| {
            number(weight(*k)) * Formula::from(harmonic_name(*k)) * cosine(*k)
        };
        sum(motion.harmonics.iter().map(term).collect())
    };
    let square = |k: usize| -i64::try_from(k * k).unwrap_or(i64::MAX);
    let mut values = letters_of(&question.free_symbols()).values;
    values.extend(motion.harmonics.iter().map(series));
    values.push((Name::new("Δ"), polynomial(&motion.frequency, &letter("ε"))));
    values.push((question.displacement.clone(), total(&|_| 1)));
    values.push((second_derivative(question), total(&square)));
    if question.has_velocity() {
        let term = |(k, _): &(usize, PolynomialSeries)| {
            let k_number = i64::try_from(*k).unwrap_or(i64::MAX);
            number(-k_number) * Formula::from(harmonic_name(*k)) * sin(number(k_number) * letter("τ"))
        };
        let slope = sum(motion.harmonics.iter().map(term).collect());
        values.push((question.displacement.clone().prime(), slope));
    }
    if question.variable != question.displacement && !question.is_reduced() {
        let position = question.equilibrium.clone() + question.u();
        values.push((question.variable.clone(), position));
    }
    Letters { values, functions: vec![] }
}

/// Checks that the coefficient of εⁿ in the equation of motion is Σ pₖ cos kτ.
pub fn has_harmonics(
    question: &LindstedtQuestion,
    motion: &Motion,
    n: usize,
    expected: &[(usize, Polynomial)],
) -> Result<(), DerivationError> {
    for phase in phases_of(question, question.order + 1) {
        let values = given(question, motion, &phase);
        let residual = series_value(&epsilon(), question.order + 1, &values, &left_side(question))?;
        let chebyshev = chebyshev(&phase[0], question.order);
        let sum = expected.iter().fold(Polynomial::zero(), |sum, (k, p)| sum + p.scaled(&chebyshev[*k]));
        if residual.get(n) != Some(&sum) {
            let statement = Statement::from(left_side(question));
            return Err(failed(&statement, format!("its part of order {n} is not what the conditions say")));
        }
    }
    Ok(())
}

fn epsilon() -> Name {
    Name::new("ε")
}

fn second_derivative(question: &LindstedtQuestion) -> Name {
    question.displacement.clone().prime().prime()
}

/// Δ²u″ + g, with g the restoring force divided by ω0².
pub(super) fn left_side(question: &LindstedtQuestion) -> Formula {
    letter("Δ").squared() * Formula::Name(second_derivative(question)) + question.restoring_force()
}

/// cos τ and sin τ at `count` phases with different cosines. The cosines are 0, 1/n, 2/n, …, and the sines are not needed; with a velocity in
/// the force both are fractions, by the tangent of half the phase.
fn phases_of(question: &LindstedtQuestion, count: usize) -> impl Iterator<Item = [Rational; 2]> {
    let has_velocity = question.has_velocity();
    let count = i64::try_from(count).unwrap_or(i64::MAX);
    (0..count).filter_map(move |n| match has_velocity {
        false => Some([Rational::new(n, count)?, Rational::from(0)]),
        true => {
            let under = count * count + n * n;
            Some([Rational::new(count * count - n * n, under)?, Rational::new(2 * n * count, under)?])
        }
    })
}

/// cos kτ for k = 0, 1, … from cos τ.
fn chebyshev(cosine: &Rational, highest: usize) -> Vec<Rational> {
    waves([Rational::from(1), cosine.clone()], cosine, highest)
}

/// cos kτ or sin kτ for k = 0, 1, … from the first two.
fn waves(first: [Rational; 2], cosine: &Rational, highest: usize) -> Vec<Rational> {
    let mut values = first.to_vec();
    for k in 2..=highest {
        let next = Rational::from(2) * cosine.clone() * values[k - 1].clone() - values[k - 2].clone();
        values.push(next);
    }
    values
}

/// The symbols, Δ, u, its derivatives and the variable at one phase.
fn given<'a>(
    question: &LindstedtQuestion,
    motion: &Motion,
    [cosine, sine]: &[Rational; 2],
) -> Vec<Given<'a>> {
    let (cosines, sines) =
        (chebyshev(cosine, question.order), waves([Rational::from(0), sine.clone()], cosine, question.order));
    let sum = |waves: &[Rational], weight: &dyn Fn(i64) -> i64| {
        let mut sums = vec![Polynomial::zero(); question.order + 1];
        for (k, series) in &motion.harmonics {
            let factor = waves[*k].clone() * Rational::from(weight(i64::try_from(*k).unwrap_or(i64::MAX)));
            for (sum, coefficient) in sums.iter_mut().zip(series) {
                *sum = std::mem::replace(sum, Polynomial::zero()) + coefficient.scaled(&factor);
            }
        }
        polynomial(&sums, &letter("ε"))
    };
    let mut given = question.free_symbols();
    given.push(Given::Value(Name::new("Δ"), polynomial(&motion.frequency, &letter("ε"))));
    given.push(Given::Value(question.displacement.clone(), sum(&cosines, &|_| 1)));
    given.push(Given::Value(question.displacement.clone().prime(), sum(&sines, &|k| -k)));
    given.push(Given::Value(second_derivative(question), sum(&cosines, &|k| -k * k)));
    if question.variable != question.displacement && !question.is_reduced() {
        let position = question.equilibrium.clone() + question.u();
        given.push(Given::Value(question.variable.clone(), position));
    }
    given
}

/// Σ cₙεⁿ + O(…), with the powers that occur.
pub(super) fn in_epsilon(coefficients: &[Polynomial], next: usize) -> Formula {
    let powers = coefficients.iter().enumerate().take(next).filter(|(_, c)| !c.is_zero());
    let mut terms: Vec<Formula> = powers.map(|(n, c)| monomial(c, &letter("ε"), n)).collect();
    if terms.is_empty() {
        terms.push(number(0));
    }
    terms.push(order(letter("ε").pow(i64::try_from(next).unwrap_or(i64::MAX))));
    Formula::Sum(terms)
}
