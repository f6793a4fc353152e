//! The result in the symbols and constants of the equation.

use super::super::check::{CheckedEquation, DerivationError, Given, same_series_for_choices};
use super::super::document::DerivationStep;
use super::super::formula::{Formula, Name, Statement, letter, order, polynomial, sum};
use super::amplitude::of_amplitude;
use super::names::harmonic_name;
use super::orders::CHOICES;
use super::question::LindstedtQuestion;
use super::reduced::{in_symbols, omega0};
use libration::algebra::{LaurentPolynomial, LaurentPolynomials, Rational, Ring};
use libration::internals::progress::Watch;
use libration::perturbation::{Gauge, SymbolicExpansion, expand_symbolically};

/// The step; `None` if all numbers of the equation are fractions.
pub(super) fn step(
    question: &LindstedtQuestion,
    watch: &Watch<'_>,
) -> Result<Option<DerivationStep>, DerivationError> {
    if question.oscillator.is_some() {
        return Ok(None);
    }
    let outcome = expand_symbolically(&question.symbolic, question.order, &Gauge::XMax, watch);
    let expansion = outcome.map_err(|_| DerivationError::NoFractions)?;
    let Some(of) = &expansion.series.of_amplitude else { return Ok(None) };
    let (ratio, reduced) = (&of.frequency_ratio, of_amplitude(question, &question.solution)?);
    let step = DerivationStep::new("in-symbols", "The result in the symbols of the equation")
        .say("With what the symbols stand for, the frequency and the harmonics are", []);
    let frequency = frequency(question, &expansion, ratio);
    let statement = Statement::equal(letter("Ω"), omega0() * letter("Δ")).and_equal(frequency);
    let mut step = step.show(checked(question, question.order, statement)?);
    for (k, _) in reduced.harmonics.iter().filter(|(k, _)| *k <= question.order) {
        let Some((_, series)) = of.harmonics.iter().find(|(other, _)| other == k) else { continue };
        let series = series_formula(question, series, question.order + 1);
        let statement = Statement::equal(harmonic_name(*k), series);
        step = step.show(checked(question, question.order + 1, statement)?);
    }
    Ok(Some(step))
}

/// Ω by powers of the amplitude.
fn frequency(
    question: &LindstedtQuestion,
    expansion: &SymbolicExpansion,
    ratio: &[LaurentPolynomial],
) -> Formula {
    match &expansion.omega0 {
        Some(root) => {
            let ring = LaurentPolynomials::new(root.letters().to_vec());
            let products: Vec<LaurentPolynomial> =
                ratio.iter().map(|term| ring.multiply(root, term)).collect();
            series_formula(question, &products, question.order)
        }
        None => omega0() * series_formula(question, ratio, question.order),
    }
}

/// Σ cₙAⁿ + O(…), with the powers that occur.
fn series_formula(question: &LindstedtQuestion, coefficients: &[LaurentPolynomial], next: usize) -> Formula {
    let amplitude = Formula::from(question.amplitude());
    let power = |n: usize| match n {
        1 => amplitude.clone(),
        n => amplitude.clone().pow(i64::try_from(n).unwrap_or(i64::MAX)),
    };
    let term = |(n, coefficient): (usize, &LaurentPolynomial)| {
        let formula = in_symbols(&question.symbolic, coefficient);
        match (n, formula) {
            (0, formula) => formula,
            (n, Formula::Number(one)) if one == Rational::from(1) => power(n),
            (n, Formula::Negate(inner)) => -(*inner * power(n)),
            (n, formula) => formula * power(n),
        }
    };
    let present =
        coefficients.iter().enumerate().take(next).filter(|(_, coefficient)| !coefficient.is_zero());
    sum(present.map(term).chain([order(power(next))]).collect())
}

/// Compares a series in the amplitude with what the derivation found, with fractions for the symbols of the equation.
fn checked(
    question: &LindstedtQuestion,
    coefficients: usize,
    statement: Statement,
) -> Result<CheckedEquation, DerivationError> {
    let of = of_amplitude(question, &question.solution)?;
    let amplitude = Formula::from(question.amplitude());
    let given = |choice: usize| -> Vec<Given<'static>> {
        let mut given = question.values_of_symbols(choice);
        let ratio = polynomial(&of.frequency_ratio, &amplitude);
        given.push(Given::Value(Name::new("Δ"), ratio));
        let harmonics = of.harmonics.iter();
        given.extend(
            harmonics.map(|(k, series)| Given::Value(harmonic_name(*k), polynomial(series, &amplitude))),
        );
        given.push(Given::Value(Name::new("Ω"), omega0() * letter("Δ")));
        given
    };
    same_series_for_choices(&question.amplitude(), coefficients, CHOICES, &given, statement)
}
