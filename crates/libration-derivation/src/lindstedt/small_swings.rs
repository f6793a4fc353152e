//! The equation of motion and its Taylor series about the equilibrium.

use super::super::check::{
    CheckedEquation, DerivationError, Given, chosen, same_series_for_choices, same_series_where,
};
use super::super::document::DerivationStep;
use super::super::formula::{Formula, Name, Statement, cos, letter, number, order, polynomial};
use super::orders::CHOICES;
use super::question::LindstedtQuestion;
use super::reduced::omega0;
use libration::algebra::Rational;

pub(super) fn equation_of_motion(question: &LindstedtQuestion) -> Result<DerivationStep, DerivationError> {
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
        let equilibrium = question.equilibrium.clone();
        step = step
            .say(
                "It can stay at rest at {} = {}, and is driven back from both sides. From here on the displacement \
                 is counted from there:",
                [variable.clone(), equilibrium.clone()],
            )
            .show(CheckedEquation::definition(Statement::defined(question.u(), variable - equilibrium)));
    }
    let omega = omega0;
    let square = Statement::defined(omega().squared(), question.omega0_squared.clone());
    let step = match question.omega0_squared == omega().squared() {
        true => step.say(
            "Close to this place the force is proportional to the displacement, with the factor {}: the square of the frequency of very small \
             swings.",
            [omega().squared()],
        ),
        false => step
            .say(
                "Close to this place the force is proportional to the displacement, with a factor that is the square of the \
                 frequency of very small swings,",
                [],
            )
            .show(CheckedEquation::definition(square)),
    };
    let begin = if question.omega0_squared == omega().squared() { "A" } else { "and a" };
    Ok(step
        .say(
            &format!("{begin} very small swing of amplitude {{}}, begun at a turning point, is {{}}. For larger ones neither the frequency \
             nor the form stays the same."),
            [letter("ε"), letter("ε") * cos(omega() * letter("t"))],
        ))
}

pub(super) fn taylor(question: &LindstedtQuestion) -> Result<DerivationStep, DerivationError> {
    let step = DerivationStep::new("taylor", "The Taylor step").say(
        "Perturbation theory needs the force as a power series. Up to the order at which the derivation stops, the restoring \
         force over the square of {} is",
        [omega0()],
    );
    let step = match question.is_reduced() {
        true => by_powers(question, step)?,
        false => step.show(whole_series(question)?),
    };
    let velocities = if question.has_velocity() { ", with any velocity," } else { "" };
    Ok(match question.is_odd() {
        true => step.say(
            &format!(
                "Only odd powers occur: the force at the opposite displacement{velocities} is the opposite force. So the motion to the left is \
                 that to the right, half a period later."
            ),
            [],
        ),
        false => step,
    })
}

/// The series of a force whose numbers are fractions.
fn whole_series(question: &LindstedtQuestion) -> Result<CheckedEquation, DerivationError> {
    let with_linear: Vec<Rational> = [Rational::from(0)].iter().chain(&question.force).cloned().collect();
    let next = i64::try_from(with_linear.len()).unwrap_or(i64::MAX);
    let series = polynomial(&with_linear, &question.u()) + order(question.u().pow(next));
    let mut given = Vec::new();
    if question.variable != question.displacement {
        given.push(Given::Value(question.variable.clone(), question.equilibrium.clone() + question.u()));
    }
    let statement = Statement::equal(question.whole_force(), series);
    same_series_where(&question.displacement, with_linear.len(), &given, statement)
}

/// The series of a force with symbols in its factors, or with a velocity.
fn by_powers(question: &LindstedtQuestion, step: DerivationStep) -> Result<DerivationStep, DerivationError> {
    let (u, epsilon) = (|| question.u(), Name::new("ε"));
    let slope = Formula::from(question.displacement.clone().prime());
    let is_one = question.omega0_squared == Formula::from(1);
    let velocity = if is_one { slope } else { slope / omega0() };
    let size = if question.has_velocity() { Formula::from(&epsilon) } else { u() };
    let next = i64::try_from(question.order + 1).unwrap_or(i64::MAX);
    let series = question.reduced.with_velocity(&question.displacement, &velocity) + order(size.pow(next));
    let statement = Statement::equal(question.whole_force(), series);
    // At any ratio of velocity and displacement both are the same series in a common factor.
    let given = |choice: usize| -> Vec<Given<'static>> {
        let mut given = question.values_of_symbols(choice);
        let slope = Formula::from(chosen(1, choice)) * Formula::from(&epsilon);
        if question.has_velocity() {
            given.push(Given::Value(question.displacement.clone(), (&epsilon).into()));
            given.push(Given::Value(question.displacement.clone().prime(), slope.clone()));
        }
        if question.variable != question.displacement {
            given.push(Given::Value(question.variable.clone(), question.equilibrium.clone() + u()));
            if question.has_velocity() {
                given.push(Given::Value(question.variable.clone().prime(), slope));
            }
        }
        given
    };
    let variable = if question.has_velocity() { epsilon.clone() } else { question.displacement.clone() };
    let step = step.show(same_series_for_choices(&variable, question.order + 1, CHOICES, &given, statement)?);
    let step = match question.has_velocity() {
        true => step.say("for a displacement and a velocity of the size of {}.", [(&epsilon).into()]),
        false => step,
    };
    let defined = question.reduced.symbols.iter().map(|(symbol, value)| {
        CheckedEquation::definition(Statement::defined(Name::from(symbol), value.clone()))
    });
    let defined: Vec<CheckedEquation> = defined.collect();
    if defined.is_empty() {
        return Ok(step);
    }
    let said = match question.has_velocity() {
        true => {
            "A symbol stands for what is before a product of powers. Below it are their exponents, first that of the displacement:"
        }
        false => "A symbol stands for what is before a power:",
    };
    Ok(step.say(said, []).show_all(defined))
}
