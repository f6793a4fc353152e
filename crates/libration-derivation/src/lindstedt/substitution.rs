//! Substitution of a motion into the equation of motion: the proof that it is a solution.
//!
//! At each order the equation is a polynomial in cos τ whose degree is at most the order. It
//! is therefore decided by one more value of cos τ than the order; rational values suffice.

use super::super::check::{
    Check, CheckedEquation, DerivationError, Given, Letters, failed, same_series_where, series_value,
};
use super::super::formula::{Formula, Name, Statement, letter, monomial, number, order, polynomial, sum};
use super::names::{cosine, harmonic_name};
use super::question::Question;
use libration::algebra::Rational;

/// A motion as the harmonics k with their series in ε, and its frequency ratio Ω/ω0.
#[derive(Debug)]
pub struct Motion {
    pub harmonics: Vec<(usize, Vec<Rational>)>,
    pub frequency: Vec<Rational>,
}

/// Checks that a motion solves Δ²u″ = f/ω0² up to the requested order.
pub fn solves(question: &Question, motion: &Motion) -> Result<CheckedEquation, DerivationError> {
    let next = i64::try_from(question.order + 1).unwrap_or(i64::MAX);
    let statement = Statement::equal(left_side(question), order(letter("ε").pow(next)));
    let phases = question.order + 1;
    for cosine in cosines(phases) {
        same_series_where(&epsilon(), phases, &given(question, motion, &cosine), statement.clone())?;
    }
    let check = Check::Phases { variable: epsilon(), order: question.order, phases };
    Ok(CheckedEquation::new(statement, check).with_letters(letters(question, motion)))
}

/// The values of the names in the equation of motion at a phase τ.
fn letters(question: &Question, motion: &Motion) -> Letters {
    let series = |(k, series): &(usize, Vec<Rational>)| (harmonic_name(*k), polynomial(series, &letter("ε")));
    let total = |weight: &dyn Fn(usize) -> i64| {
        let term = |(k, _): &(usize, Vec<Rational>)| {
            number(weight(*k)) * Formula::from(harmonic_name(*k)) * cosine(*k)
        };
        sum(motion.harmonics.iter().map(term).collect())
    };
    let square = |k: usize| -i64::try_from(k * k).unwrap_or(i64::MAX);
    let mut values: Vec<(Name, Formula)> = motion.harmonics.iter().map(series).collect();
    values.push((Name::new("Δ"), polynomial(&motion.frequency, &letter("ε"))));
    values.push((question.displacement.clone(), total(&|_| 1)));
    values.push((second_derivative(question), total(&square)));
    if question.variable != question.displacement {
        let place = Formula::from(question.equilibrium.clone()) + question.u();
        values.push((question.variable.clone(), place));
    }
    Letters { values, functions: vec![] }
}

/// Checks that the coefficient of εⁿ in the equation of motion is Σ pₖ cos kτ.
pub fn has_harmonics(
    question: &Question,
    motion: &Motion,
    n: usize,
    expected: &[(usize, Rational)],
) -> Result<(), DerivationError> {
    for cosine in cosines(question.order + 1) {
        let values = given(question, motion, &cosine);
        let residual = series_value(&epsilon(), question.order + 1, &values, &left_side(question))?;
        let chebyshev = chebyshev(&cosine, question.order);
        let sum =
            expected.iter().fold(Rational::from(0), |sum, (k, p)| sum + p.clone() * chebyshev[*k].clone());
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

fn second_derivative(question: &Question) -> Name {
    question.displacement.clone().prime().prime()
}

/// Δ²u″ + g, with g the restoring force divided by ω0².
pub(super) fn left_side(question: &Question) -> Formula {
    letter("Δ").squared() * Formula::Name(second_derivative(question)) + question.restoring_force()
}

/// 0, 1/n, 2/n, …: `count` different values of cos τ.
fn cosines(count: usize) -> impl Iterator<Item = Rational> {
    let count = i64::try_from(count).unwrap_or(i64::MAX);
    (0..count).filter_map(move |n| Rational::new(n, count))
}

/// cos kτ for k = 0, 1, … from cos τ.
fn chebyshev(cosine: &Rational, highest: usize) -> Vec<Rational> {
    let mut values = vec![Rational::from(1), cosine.clone()];
    for k in 2..=highest {
        let next = Rational::from(2) * cosine.clone() * values[k - 1].clone() - values[k - 2].clone();
        values.push(next);
    }
    values
}

/// Δ, u, u″ and the variable at one phase.
fn given<'a>(question: &Question, motion: &Motion, cosine: &Rational) -> Vec<Given<'a>> {
    let chebyshev = chebyshev(cosine, question.order);
    let sum = |weight: &dyn Fn(usize) -> i64| {
        let mut sums = vec![Rational::from(0); question.order + 1];
        for (k, series) in &motion.harmonics {
            let factor = chebyshev[*k].clone() * Rational::from(weight(*k));
            for (sum, coefficient) in sums.iter_mut().zip(series) {
                *sum = sum.clone() + factor.clone() * coefficient.clone();
            }
        }
        polynomial(&sums, &letter("ε"))
    };
    let square = |k: usize| -i64::try_from(k * k).unwrap_or(i64::MAX);
    let displacement = sum(&|_| 1);
    let mut given = vec![
        Given::Value(Name::new("Δ"), polynomial(&motion.frequency, &letter("ε"))),
        Given::Value(question.displacement.clone(), displacement),
        Given::Value(second_derivative(question), sum(&square)),
    ];
    if question.variable != question.displacement {
        let place = Formula::from(question.equilibrium.clone()) + question.u();
        given.push(Given::Value(question.variable.clone(), place));
    }
    given
}

/// Σ cₙεⁿ + O(…), with the powers that occur.
pub(super) fn in_epsilon(coefficients: &[Rational], next: usize) -> Formula {
    let powers = coefficients.iter().enumerate().take(next).filter(|(_, c)| !c.is_zero());
    let mut terms: Vec<Formula> = powers.map(|(n, c)| monomial(c, &letter("ε"), n)).collect();
    if terms.is_empty() {
        terms.push(number(0));
    }
    terms.push(order(letter("ε").pow(i64::try_from(next).unwrap_or(i64::MAX))));
    Formula::Sum(terms)
}
