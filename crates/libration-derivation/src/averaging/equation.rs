//! The equation of motion, its form while the displacement falls, and the force as a series.

use super::super::check::{CheckedEquation, DerivationError, Given, same_series_where};
use super::super::document::DerivationStep;
use super::super::formula::{Formula, Name, Statement, number, order, polynomial, tenths};
use super::super::trials::Trials;
use super::question::AveragingQuestion;
use libration::algebra::Rational;

pub(super) fn step(question: &AveragingQuestion) -> Result<DerivationStep, DerivationError> {
    let second = Formula::from(question.variable.clone().prime().prime());
    let whole = second + question.acceleration().negated();
    let step = DerivationStep::new("equation-of-motion", "The equation of motion")
        .say(
            "An oscillator is given, and on it acts a weak force that takes energy from it or gives energy to it. How weak it is says \
             the small number {}; a prime is a derivative with respect to the time:",
            [question.small()],
        )
        .show(CheckedEquation::premise(Statement::equal(whole, number(0))));
    let step = about(question, step);
    let step = match question.flow.kinked {
        true => falling(question, step)?,
        false => step,
    };
    let step = frequency(question, step);
    if question.is_whole && question.variable == question.displacement {
        return Ok(step);
    }
    taylor(question, step)
}

/// States the origin of the displacement.
fn about(question: &AveragingQuestion, step: DerivationStep) -> DerivationStep {
    let variable = Formula::from(&question.variable);
    if question.variable == question.displacement {
        return step;
    }
    let equilibrium = Formula::from(question.equilibrium.clone());
    step.say(
        "It can stay at rest at {} = {}, and the displacement is counted from there:",
        [variable.clone(), equilibrium.clone()],
    )
    .show(CheckedEquation::definition(Statement::defined(question.u(), variable - equilibrium)))
}

/// States the force for negative velocities.
fn falling(question: &AveragingQuestion, step: DerivationStep) -> Result<DerivationStep, DerivationError> {
    let velocity = question.variable.clone().prime();
    let trials = Trials::new(None)?
        .with(&question.variable, tenths(4))?
        .with(&velocity, tenths(-7))?
        .with(&question.parameter, tenths(1))?;
    let acceleration = Formula::from(&question.force.acceleration);
    let statement = Statement::equal(question.acceleration(), acceleration);
    Ok(step
        .say(
            "The force has a kink where the velocity changes its sign. But a swing is made of two halves that are each other’s opposites: \
             with {} and {} also {} and {} satisfy the equation. So one half is enough, and while {} falls from its turning point on the \
             right to that on the left the velocity is negative, and the force is without kinks:",
            [
                question.u(),
                (&velocity).into(),
                -question.u(),
                -Formula::from(&velocity),
                question.u(),
            ],
        )
        .show(trials.compare_once(statement)?))
}

fn frequency(question: &AveragingQuestion, step: DerivationStep) -> DerivationStep {
    let omega = || Formula::from(Name::new("ω").index(0));
    let statement = Statement::equal(omega(), question.omega0().clone());
    step.say("Very small swings without the weak force have the frequency", [])
        .show(CheckedEquation::definition(statement))
}

/// The force without the weak terms, as a series.
fn taylor(question: &AveragingQuestion, step: DerivationStep) -> Result<DerivationStep, DerivationError> {
    let mut coefficients = vec![Rational::from(0); question.order + 1];
    if let Some(first) = coefficients.get_mut(1) {
        *first = question.omega0().clone() * question.omega0().clone();
    }
    for term in question.restoring_terms() {
        if let Some(coefficient) = coefficients.get_mut(term.position) {
            *coefficient = coefficient.clone() + term.factor.clone();
        }
    }
    let next = i64::try_from(coefficients.len()).unwrap_or(i64::MAX);
    let series = polynomial(&coefficients, &question.u());
    let (series, told) = match question.is_whole {
        true => (series, "From there the restoring force is"),
        false => (
            series + order(question.u().pow(next)),
            "The swings are small enough for a power series of the restoring force, which is needed to the power asked for:",
        ),
    };
    let mut given = Vec::new();
    if question.variable != question.displacement {
        let position = Formula::from(question.equilibrium.clone()) + question.u();
        given.push(Given::Value(question.variable.clone(), position));
    }
    let force = Formula::from(question.force.oscillator.acceleration()).negated();
    let length = coefficients.len();
    let statement = Statement::equal(force, series);
    let equation = same_series_where(&question.displacement, length, &given, statement)?;
    Ok(step.say(told, []).show(equation))
}
