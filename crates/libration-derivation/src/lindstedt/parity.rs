//! Reasons why the ansatz for an odd force has no sines, no even harmonics and no even powers
//! of the expansion parameter: the first two do not occur, the last are excluded by choice.

use super::super::check::{CheckedEquation, DerivationError, Given, same_series_where};
use super::super::document::DerivationStep;
use super::super::formula::{
    Coefficient, Formula, Name, Statement, cos, integral, letter, number, order, tenths,
};
use super::super::trials::Trials;
use super::names::coefficient_name;
use super::orders::solutions;
use super::question::LindstedtQuestion;
use libration::algebra::{Polynomial, Rational, Variable};
use libration::internals::progress::Watch;
use libration::perturbation::Gauge;

/// The step; `None` if the ansatz has all powers anyway.
pub(super) fn step(
    question: &LindstedtQuestion,
    watch: &Watch<'_>,
) -> Result<Option<DerivationStep>, DerivationError> {
    if question.powers().contains(&2) {
        return Ok(None);
    }
    // Every gauge with A₂ leads to the open gauge with all powers.
    let gauge = Gauge::Coefficients(vec![Rational::from(1), Rational::from(1)]);
    let open = question.again(4, &gauge, watch)?;
    let (epsilon, tau) = (|| letter("ε"), || letter("τ"));
    let step = DerivationStep::new("parity", "Terms that are missing")
        .say(
            "Sines are missing, because the equation of motion is the same for {} and {}, and so is a start at rest: the motion before the \
             turning point mirrors that after it.",
            [tau(), -tau()],
        )
        .say("Even multiples are missing, because half a period later", [])
        .show_all(half_a_period_later()?)
        .say(
            "while the displacement of a symmetric oscillator is then the opposite one: the factor of an even multiple is its own opposite, \
             and zero.",
            [],
        )
        .say(
            "Even powers of {} are another case. If they were in the ansatz, the factor of {} in {} would be found by projection as",
            [epsilon(), cos(tau()), epsilon().squared()],
        )
        .show(first_correction()?)
        .say("which must vanish. With that the conditions of the even powers give", []);
    let step = solutions(&open, 4, solutions(&open, 2, step)?)?;
    renamed(&open, step).map(Some)
}

/// Shows that A₂ only renames ε.
fn renamed(open: &LindstedtQuestion, step: DerivationStep) -> Result<DerivationStep, DerivationError> {
    let epsilon = || letter("ε");
    let [first, second] = [1, 2].map(|n| Formula::from(Name::from(&coefficient_name(1, n))));
    let d2 = open.open.solution().get(&Variable::indexed("d", 2));
    let factor = d2.map_or_else(Polynomial::zero, |d2| d2.coefficient(&coefficient_name(1, 1), 2));
    let other = epsilon() + epsilon().squared() * second.clone() / first.clone();
    let squared = factor.times(first.clone().squared());
    let product = factor.scaled(&Rational::from(2)).times(first.clone() * second.clone());
    let expanded =
        squared.clone() * epsilon().squared() + product * epsilon().pow(3) + order(epsilon().pow(4));
    let names = [1, 2].map(|n| Name::from(&coefficient_name(1, n)));
    let given = names.into_iter().zip([13, 7]).map(|(name, value)| Given::Value(name, tenths(value)));
    let given = open.free_symbols().into_iter().chain(given);
    let statement = Statement::equal(squared * other.clone().squared(), expanded);
    Ok(step
        .say(
            "All of them vanish with {}, which no condition fixes, and nothing else is in them than a change of the parameter: with {} in \
             the place of {} the first correction of the frequency gives the second,",
            [second.clone(), other, epsilon()],
        )
        .show(same_series_where(&Name::new("ε"), 4, &given.collect::<Vec<_>>(), statement)?)
        .say(
            "So {} and all even ones after it are chosen to be zero. This is a part of the gauge and not a law: keeping them gives other series \
             in {} and the same motion.",
            [second, epsilon()],
        ))
}

fn half_a_period_later() -> Result<Vec<CheckedEquation>, DerivationError> {
    let trials = Trials::new(None)?.with(&Name::new("τ"), tenths(7))?;
    let (tau, k) = (|| letter("τ"), || letter("k"));
    let even = Statement::equal(cos(2 * k() * (tau() + Formula::Pi)), cos(2 * k() * tau()));
    let odd = || 2 * k() + 1;
    let odd = Statement::equal(cos(odd() * (tau() + Formula::Pi)), -cos(odd() * tau()));
    Ok(vec![trials.compare_cases("k", 1..=5, even)?, trials.compare_cases("k", 0..=4, odd)?])
}

fn first_correction() -> Result<CheckedEquation, DerivationError> {
    let name = |letter: &str| Name::new(letter).index(1);
    let product = || Formula::from(-2) * Formula::from(name("A")) * Formula::from(name("d"));
    let trials = Trials::new(None)?.with(&name("A"), tenths(13))?.with(&name("d"), tenths(7))?;
    let projected = integral("τ", 0, 2 * Formula::Pi, product() * cos(letter("τ")).squared());
    trials.compare_once(Statement::equal(number(1) / Formula::Pi * projected, product()))
}
