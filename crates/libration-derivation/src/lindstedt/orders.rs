//! The conditions order by order, with an open gauge.

use super::super::check::{Check, CheckedEquation, DerivationError, OpenCondition};
use super::super::document::DerivationStep;
use super::super::formula::{Formula, Name, Statement, cos, derivative, letter, number, sin, tenths};
use super::super::trials::Trials;
use super::contributions::{Contributions, vanishes};
use super::names::{coefficient_name, cosine};
use super::question::LindstedtQuestion;
use super::solution::PolynomialSeries;
use super::substitution::{Motion, has_harmonics};
use libration::algebra::{Polynomial, Rational, Variable};
use libration::perturbation::Condition;

/// Number of choices of fractions for the symbols with which a condition is checked.
pub(super) const CHOICES: usize = 3;

pub(super) fn secular_terms(question: &LindstedtQuestion) -> Result<DerivationStep, DerivationError> {
    let tau = || letter("τ");
    let trials = Trials::new(None)?.with(&Name::new("τ"), tenths(7))?;
    let growing = tau() * sin(tau()) / 2;
    let velocity = (sin(tau()) + tau() * cos(tau())) / 2;
    let first = Statement::equal(derivative(growing.clone(), "τ"), velocity.clone());
    let second = Statement::equal(derivative(velocity, "τ") + growing, cos(tau()));
    let step = DerivationStep::new("secular-terms", "The role of each condition")
        .say(
            "At the power {} the new coefficient of {} enters through {} alone, with the factor {}. For every harmonic but the first \
             this is not zero, and the condition fixes that coefficient.",
            [
                letter("ε").pow(letter("n")),
                cos(letter("k") * tau()),
                letter("y").clone() + Formula::from(Name::new("y").prime().prime()),
                number(1) - letter("k").squared(),
            ],
        )
        .say(
            "For the first harmonic it is zero: the oscillator is driven at its own frequency. If something were left over \
             there, the solution would grow with time, for instance",
            [],
        )
        .show(trials.compare_once(first)?)
        .show(trials.compare_once(second)?)
        .say(
            "and a motion that is periodic would be written as one that is not. Such secular terms are avoided by the frequency: its \
             correction has the factor {} in this very condition, and is chosen so that nothing is left over. The coefficient of the \
             first harmonic itself is not fixed by anything.",
            [Formula::from(-2) * Formula::from(Name::new("A").index(1))],
        )
        .say(
            "The tables of the next sections show the products that a condition comes from: those of {} have the parts of {} before them, \
             those of a power of {} the number of orderings of the coefficients, and the factor of {} in the product of their cosines.",
            [
                Formula::from(question.displacement.clone().prime().prime()),
                letter("Δ").squared(),
                question.u(),
                cos(letter("k") * tau()),
            ],
        );
    Ok(match question.has_velocity() {
        true => step.say(
            "With a velocity the coefficients of {} come with the factors {} of their sines, and the parts of the power of {} stand before them.",
            [
                question.displacement.clone().prime().into(),
                -letter("k"),
                letter("Δ"),
            ],
        ),
        false => step,
    })
}

/// Highest order whose derivation is shown unfolded; those of higher orders, which grow fast, are folded.
fn open_to_read(question: &LindstedtQuestion) -> usize {
    if question.is_odd() { 5 } else { 3 }
}

pub(super) fn conditions(question: &LindstedtQuestion) -> Result<Vec<DerivationStep>, DerivationError> {
    let contributions = Contributions::new(question);
    let step = |order| {
        check_order(question, order)?;
        check_contributions(question, &contributions, order)?;
        Ok(one_order(question, &contributions, order))
    };
    question.powers().into_iter().map(step).collect()
}

fn one_order(question: &LindstedtQuestion, contributions: &Contributions, order: usize) -> DerivationStep {
    let step = DerivationStep::new(&format!("order-{order}"), &format!("Order {order}, with the gauge open"));
    let shown = question.open.conditions().iter().filter(|condition| is_shown(condition, order));
    shown.fold(vanishing(question, order, step), |step, condition| {
        let way = |step: DerivationStep| way_to(question, step, contributions, condition);
        match solved(question, condition) {
            None => way(step),
            Some(solution) if order <= open_to_read(question) => way(step).say("so that", []).show(solution),
            Some(solution) => {
                let step = step.say("The factor of {} in the power {} leads to", factor_of(condition));
                step.show(solution).fold("Derivation", way)
            }
        }
    })
}

/// cos kτ and εⁿ.
fn factor_of(condition: &Condition) -> [Formula; 2] {
    let k = usize::try_from(condition.harmonic).unwrap_or(usize::MAX);
    [cosine(k), letter("ε").pow(i64::from(condition.order))]
}

/// The derivation of a condition.
fn way_to(
    question: &LindstedtQuestion,
    step: DerivationStep,
    contributions: &Contributions,
    condition: &Condition,
) -> DerivationStep {
    let with_products = usize::try_from(condition.order).is_ok_and(|order| order <= open_to_read(question));
    let step = step
        .say("The factor of {} in the power {} has the parts", factor_of(condition))
        .table(contributions.table(condition, with_products));
    let inserted = contributions.sum(condition.order, condition.harmonic) != condition.polynomial;
    let step = match inserted {
        true => step.say("With what lower orders have found, their sum becomes the condition", []),
        false => step.say("Their sum is the condition", []),
    };
    step.show(substituted(question, condition, Statement::equal(&condition.polynomial, 0)))
}

fn substituted(question: &LindstedtQuestion, condition: &Condition, statement: Statement) -> CheckedEquation {
    let condition = Some(Box::new(open_condition(question, condition)));
    CheckedEquation::new(statement, Check::Substituted { choices: CHOICES, condition })
}

fn open_condition(question: &LindstedtQuestion, condition: &Condition) -> OpenCondition {
    let index = |n: u32| usize::try_from(n).unwrap_or(usize::MAX);
    let powers = question.powers();
    let harmonics = question.harmonics().into_iter().flat_map(|k| {
        powers.iter().map(move |n| (*n, k, Name::from(&coefficient_name(k, *n)))).collect::<Vec<_>>()
    });
    let corrections = powers.iter().filter(|n| **n > 1).map(|n| (n - 1, Name::from(&correction_name(n - 1))));
    let before = question.open.conditions().iter().filter(|other| other.order < condition.order);
    let lower = before.filter_map(|other| {
        let unknown = fixed_by(other)?;
        Some((Name::from(&unknown), question.open.solution().get(&unknown)?.into()))
    });
    OpenCondition {
        force: question.terms().cloned().collect(),
        symbols: question.symbols().map(Name::from).collect(),
        harmonics: harmonics.collect(),
        frequency: corrections.collect(),
        lower: lower.collect(),
        fixes: fixed_by(condition).map(|unknown| Name::from(&unknown)),
        order: index(condition.order),
        harmonic: index(condition.harmonic),
    }
}

/// dₙ.
fn correction_name(n: usize) -> Variable {
    Variable::indexed("d", u32::try_from(n).unwrap_or(u32::MAX))
}

/// The coefficient that a condition fixes.
fn fixed_by(condition: &Condition) -> Option<Variable> {
    let n = usize::try_from(condition.order).ok()?;
    match usize::try_from(condition.harmonic).ok()? {
        1 => n.checked_sub(1).filter(|n| *n > 0).map(correction_name),
        k => Some(coefficient_name(k, n)),
    }
}

/// The coefficients of harmonics that do not occur yet.
fn vanishing(question: &LindstedtQuestion, order: usize, step: DerivationStep) -> DerivationStep {
    let conditions = question.open.conditions().iter();
    let alone: Vec<&Condition> =
        conditions.filter(|condition| is_of(condition, order) && is_alone(condition)).collect();
    let step = if order == 1 {
        step.say(
            "In the power {} of the equation of motion stand the coefficients of this power alone. In the factor of {} they cancel, since \
             a very small swing has the frequency {}.",
            [letter("ε"), cosine(1), Formula::from(Name::new("ω").index(0))],
        )
    } else {
        step
    };
    if alone.is_empty() {
        return step;
    }
    let step = match alone.len() {
        1 => step.say("In the factor of one harmonic a coefficient stands alone, so that it vanishes: nothing of lower orders makes this \
                       harmonic.", []),
        _ => step.say("In the factors of some harmonics a coefficient stands alone, so that it vanishes: nothing of lower orders makes \
                       these harmonics.", []),
    };
    alone.into_iter().fold(step, |step, condition| {
        let left = product_alone(condition).unwrap_or_else(|| (&condition.polynomial).into());
        step.show(substituted(question, condition, Statement::equal(left, 0)))
    })
}

/// (1 − k²) times the coefficient, for a condition that is this product.
fn product_alone(condition: &Condition) -> Option<Formula> {
    let unknown = fixed_by(condition)?;
    let k = i64::from(condition.harmonic);
    let product = Polynomial::variable(unknown.clone()).scaled(&Rational::from(1 - k * k));
    let factor = number(1) - number(k).squared();
    (k > 1 && product == condition.polynomial).then(|| factor * Formula::Name(Name::from(&unknown)))
}

fn is_of(condition: &Condition, order: usize) -> bool {
    usize::try_from(condition.order) == Ok(order) && !condition.polynomial.is_zero()
}

/// Returns `true` if the condition is a single coefficient; for the first harmonic, times the factor A₁.
fn is_alone(condition: &Condition) -> bool {
    condition.harmonic != 1 && condition.polynomial.terms().count() == 1
}

/// Returns `true` unless the condition reads 0 = 0, or only excludes a harmonic that does not occur yet.
fn is_shown(condition: &Condition, order: usize) -> bool {
    is_of(condition, order) && !is_alone(condition)
}

/// The coefficients that the conditions of an order fix, with their values, and folded the products that the conditions come from.
pub(super) fn solutions(
    question: &LindstedtQuestion,
    order: usize,
    step: DerivationStep,
) -> Result<DerivationStep, DerivationError> {
    let contributions = Contributions::new(question);
    check_order(question, order)?;
    check_contributions(question, &contributions, order)?;
    let conditions = question.open.conditions().iter().filter(|condition| is_of(condition, order));
    Ok(conditions.fold(step, |step, condition| {
        let Some(solution) = solved(question, condition) else { return step };
        step.show(solution).fold("Derivation", |step| match product_alone(condition) {
            Some(product) => step.show(substituted(question, condition, Statement::equal(product, 0))),
            None => way_to(question, step, &contributions, condition),
        })
    }))
}

/// The coefficient that a condition fixes, with its value.
fn solved(question: &LindstedtQuestion, condition: &Condition) -> Option<CheckedEquation> {
    let unknown = fixed_by(condition)?;
    let value = question.open.solution().get(&unknown)?;
    Some(substituted(question, condition, Statement::equal(Name::from(&unknown), value)))
}

/// Substitutes fractions for all symbols in the ansatz, with the results of lower orders, and compares the resulting equation of motion with the
/// conditions; then substitutes the solution, for which it must be zero.
fn check_order(question: &LindstedtQuestion, order: usize) -> Result<(), DerivationError> {
    for choice in 0..CHOICES {
        let any = |variable: &Variable| fraction_for(variable, choice);
        let expected: Vec<(usize, Polynomial)> = (question.open.conditions().iter())
            .filter(|condition| usize::try_from(condition.order) == Ok(order))
            .filter_map(|condition| {
                let value = at(question, &condition.polynomial, &any);
                Some((usize::try_from(condition.harmonic).ok()?, value))
            })
            .collect();
        has_harmonics(question, &motion(question, order, &any, Newest::Open), order, &expected)?;
        has_harmonics(question, &motion(question, order, &any, Newest::Solved), order, &[])?;
    }
    Ok(())
}

/// Substitutes arbitrary fractions for all symbols in the ansatz, and compares the equation of motion with the sums of the contributions.
pub fn check_contributions(
    question: &LindstedtQuestion,
    contributions: &Contributions,
    order: usize,
) -> Result<(), DerivationError> {
    for choice in 0..CHOICES {
        let any = |variable: &Variable| match vanishes(question, variable) {
            true => Rational::from(0),
            false => fraction_for(variable, choice),
        };
        let of_order = question
            .open
            .conditions()
            .iter()
            .filter(|condition| usize::try_from(condition.order) == Ok(order));
        let expected = of_order.filter_map(|condition| {
            let sum = contributions.sum(condition.order, condition.harmonic);
            Some((usize::try_from(condition.harmonic).ok()?, at(question, &sum, &any)))
        });
        let expected: Vec<(usize, Polynomial)> = expected.collect();
        has_harmonics(question, &motion(question, order, &any, Newest::AllOpen), order, &expected)?;
    }
    Ok(())
}

/// The kind of the coefficients of the highest order.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Newest {
    /// Arbitrary fractions, also for lower orders.
    AllOpen,
    /// Arbitrary fractions.
    Open,
    /// The solution.
    Solved,
}

/// The ansatz up to an order, with fractions for the free symbols.
fn motion(
    question: &LindstedtQuestion,
    order: usize,
    any: &dyn Fn(&Variable) -> Rational,
    newest: Newest,
) -> Motion {
    let value = |variable: Variable, n: usize| {
        let coefficient = question.open.solution().get(&variable);
        let solved = coefficient.filter(|_| match newest {
            Newest::AllOpen => false,
            Newest::Open => n < order,
            Newest::Solved => true,
        });
        solved.map_or_else(|| Polynomial::constant(any(&variable)), |value| at(question, value, any))
    };
    let zero = Polynomial::zero;
    let powers = question.powers();
    let series = |k: usize| -> PolynomialSeries {
        let present = |n: usize| n <= order && powers.contains(&n);
        (0..=order).map(|n| if present(n) { value(coefficient_name(k, n), n) } else { zero() }).collect()
    };
    let correction = |n: usize| match n {
        0 => Polynomial::constant(Rational::from(1)),
        n if powers.contains(&(n + 1)) => value(correction_name(n), n + 1),
        _ => zero(),
    };
    Motion {
        harmonics: question.harmonics().into_iter().map(|k| (k, series(k))).collect(),
        frequency: (0..order).map(correction).collect(),
    }
}

/// The polynomial with fractions for all variables but the symbols of the force.
fn at(
    question: &LindstedtQuestion,
    polynomial: &Polynomial,
    any: &dyn Fn(&Variable) -> Rational,
) -> Polynomial {
    let is_of_force = |variable: &Variable| question.symbols().any(|symbol| symbol == variable);
    let others = polynomial.variables().into_iter().filter(|variable| !is_of_force(variable));
    others.fold(polynomial.clone(), |value, variable| {
        value.substitute(&variable, &Polynomial::constant(any(&variable)))
    })
}

/// A small nonzero fraction that differs from symbol to symbol.
pub(super) fn fraction_for(variable: &Variable, choice: usize) -> Rational {
    let seed = variable.letters().bytes().map(i64::from).sum::<i64>() * 31
        + variable.index().map_or(0, i64::from) * 17;
    let mixed = (seed + i64::try_from(choice).unwrap_or(0) * 7919) % 1009;
    Rational::new(mixed % 13 + 1, mixed % 5 + 2).unwrap_or_else(|| Rational::from(1))
}
