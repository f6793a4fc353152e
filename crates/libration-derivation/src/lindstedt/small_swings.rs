//! The equation of motion and its Taylor series about the equilibrium.

use super::super::check::{CheckedEquation, DerivationError, Given, same_series_where};
use super::super::document::DerivationStep;
use super::super::formula::{Formula, Name, Statement, cos, letter, number, order, polynomial};
use super::question::Question;
use libration::algebra::Rational;

pub(super) fn equation_of_motion(question: &Question) -> Result<DerivationStep, DerivationError> {
    let variable = Formula::from(&question.variable);
    let acceleration = Formula::from(question.variable.clone().prime().prime());
    let mut step = DerivationStep::new("equation-of-motion", "The equation of motion")
        .say(
            "The oscillator is given by its equation of motion, with a prime for a derivative with respect to the time {}:",
            [letter("t")],
        )
        .show(CheckedEquation::premise(Statement::equal(acceleration, question.acceleration())));
    if question.variable == question.displacement {
        step = step.say(
            "It can stay at rest at {} = {}, and is driven back from both sides.",
            [variable, number(0)],
        );
    } else {
        let place = Formula::from(question.equilibrium.clone());
        step = step
            .say(
                "It can stay at rest at {} = {}, and is driven back from both sides. From here on the displacement \
                 is counted from there:",
                [variable.clone(), place.clone()],
            )
            .show(CheckedEquation::definition(Statement::defined(question.u(), variable - place)));
    }
    let omega = || Formula::from(Name::new("ω").index(0));
    let square = Statement::defined(omega().squared(), question.omega0_squared.clone());
    Ok(step
        .say(
            "Close to this place the force is proportional to the displacement, with a factor that is the square of the \
             frequency of very small swings,",
            [],
        )
        .show(CheckedEquation::definition(square))
        .say(
            "and a very small swing of amplitude {}, begun at a turning point, is {}. For larger ones neither the frequency \
             nor the form stays the same.",
            [letter("ε"), letter("ε") * cos(omega() * letter("t"))],
        ))
}

pub(super) fn taylor(question: &Question) -> Result<DerivationStep, DerivationError> {
    let with_linear: Vec<Rational> = [Rational::from(0)].iter().chain(&question.force).cloned().collect();
    let next = i64::try_from(with_linear.len()).unwrap_or(i64::MAX);
    let series = polynomial(&with_linear, &question.u()) + order(question.u().pow(next));
    let mut given = Vec::new();
    if question.variable != question.displacement {
        let place = Formula::from(question.equilibrium.clone()) + question.u();
        given.push(Given::Value(question.variable.clone(), place));
    }
    let statement = Statement::equal(question.restoring_force(), series);
    let equation = same_series_where(&question.displacement, with_linear.len(), &given, statement)?;
    let mut step = DerivationStep::new("taylor", "The Taylor step")
        .say(
            "Perturbation theory needs the force as a power series. Up to the order at which the derivation stops, the restoring \
             force over the square of {} is",
            [Formula::from(Name::new("ω").index(0))],
        )
        .show(equation);
    if question.is_odd() {
        step = step.say(
            "Only odd powers occur: the force at the opposite displacement is the opposite force. So the motion to the \
             left is that to the right, half a period later.",
            [],
        );
    }
    Ok(step)
}
