//! Special cases that are known independently: the linear spring with viscous
//! damping, and the pendulum with two kinds of damping at any amplitude.

use super::super::check::{DerivationError, Given, same_series, same_series_where};
use super::super::document::DerivationStep;
use super::super::formula::{
    Formula, Name, Statement, agm, apply, call, cos, derivative, integral, letter, number, order, polynomial,
    scaled, sin, sqrt, tenths,
};
use super::super::phase::PiNumber;
use super::super::trials::Trials;
use super::flow::Flow;
use super::question::AveragingQuestion;
use libration::algebra::{Function, Rational, Rationals};
use libration::expression::{Expression, Symbol};

/// Viscous damping: the smallest swings are those of a linear spring.
pub(super) fn linear_spring(
    question: &AveragingQuestion,
    flow: &Flow,
) -> Result<Option<DerivationStep>, DerivationError> {
    let Some((1, factor)) = question.power_law() else { return Ok(None) };
    let c = || question.small();
    let length = question.parameter_order + 1;
    let coefficient = |j: usize| flow.frequency.get(&(0, j)).and_then(PiNumber::to_rational);
    let coefficients: Vec<Rational> =
        (0..length).map(|j| coefficient(j).unwrap_or_else(|| 0.into())).collect();
    let next = i64::try_from(length).unwrap_or(i64::MAX);
    let series = polynomial(&coefficients, &c()) + order(c().pow(next));
    let half = factor.checked_div(&Rational::from(2)).unwrap_or_else(|| 0.into());
    let quarter = half.clone() * half.clone();
    let square = question.omega0().clone() * question.omega0().clone();
    let root = sqrt(Formula::from(square.clone()) - scaled(&quarter, c().squared()));
    let frequency = same_series(&question.parameter, length, Statement::equal(root, series))?;
    let mut trials =
        Trials::new(None)?.with(&question.parameter, tenths(2))?.with(&Name::new("t"), tenths(7))?;
    trials = trials.with(&Name::new("s"), tenths(7))?;
    let [delta, omega] = [Name::new("δ"), Name::new("ω").word("d")];
    let decay_rate = trials.define(&delta, scaled(&half, c()))?;
    let damped =
        trials.define(&omega, sqrt(Formula::from(square.clone()) - Formula::from(&delta).squared()))?;
    let (d, w, s) = (|| Formula::from(&delta), || Formula::from(&omega), || letter("s"));
    let decay = || call(Function::Exp, -(d() * s()));
    let motion = trials.define_function("y", &["s"], decay() * (cos(w() * s()) + d() / w() * sin(w() * s())));
    let fall = -(scaled(&square, decay() * sin(w() * s())) / w());
    let velocity = trials.define_function("z", &["s"], fall);
    let [y, z] = ["y", "z"].map(|name| apply(name, [s()]));
    let first = Statement::equal(derivative(y.clone(), "s"), z.clone());
    let force = -(scaled(&factor, c()) * z.clone()) - scaled(&square, y);
    let second = Statement::equal(derivative(z, "s"), force);
    Ok(Some(
        DerivationStep::new("linear-spring", "The linear spring, known exactly")
            .say(
                "Very small swings are those of a linear spring, whose motion under viscous damping is known. With",
                [],
            )
            .show(decay_rate)
            .show(damped)
            .say("displacement and velocity at the time {} after a turning point are, up to a factor,", [s()])
            .show(motion)
            .show(velocity)
            .say("for they begin with one and zero, and", [])
            .show(trials.compare_once(first)?)
            .show(trials.compare_once(second)?)
            .say(
                "The turning points follow one another in equal times and fall with {}, so that {} is {} exactly. And the frequency, as a series,",
                [call(Function::Exp, -(d() * s())), Name::new("A").prime().into(), -(d() * question.amplitude())],
            )
            .show(frequency)
            .say("has the terms that stand without {} in the law of the phase.", [question.amplitude()]),
    ))
}

/// The pendulum at any amplitude, to first power of the damping, if the loss per cycle is elementary.
pub(super) fn pendulum(
    question: &AveragingQuestion,
    flow: &Flow,
) -> Result<Option<DerivationStep>, DerivationError> {
    let is_pendulum = is_sine(question);
    let power = question.power_law().filter(|(_, factor)| is_pendulum && *factor == Rational::from(1));
    let Some((n @ (0 | 2), _)) = power else { return Ok(None) };
    let (a, theta) = (|| question.amplitude(), || question.u());
    // The rational part of the rate: A′ = −(4c/π)·q for n = 2, and −(2c/π)·q for dry friction.
    let per_unit = Rational::from(if n == 2 { -4 } else { -2 });
    let quotient = |k: usize| {
        let value = flow.growth.get(&(k, 1)).cloned().unwrap_or_default().times_power_of_pi(1);
        value
            .to_rational()
            .and_then(|ratio| ratio.checked_div(&per_unit))
            .unwrap_or_else(|| Rational::from(0))
    };
    let length = question.order + 1 - question.flow.lift;
    let coefficients: Vec<Rational> = (0..length).map(quotient).collect();
    let next = i64::try_from(length).unwrap_or(i64::MAX);
    let series = polynomial(&coefficients, &a()) + order(a().pow(next));
    let mean = agm(number(1), cos(a() / 2));
    let loss = match n {
        2 => sin(a()) - a() * cos(a()),
        _ => a(),
    };
    let statement = Statement::equal(mean * loss.clone() / sin(a()), series);
    let given: [Given; 0] = [];
    let check = same_series_where(&Name::new("A"), length, &given, statement)?;
    let swing = match n {
        2 => Statement::equal(
            integral(&question.displacement.letter, -a(), a(), 2 * (cos(theta()) - cos(a()))),
            4 * loss.clone(),
        ),
        _ => {
            Statement::equal(integral(&question.displacement.letter, -a(), a(), number(1)), 2 * loss.clone())
        }
    };
    let trials = Trials::new(None)?.with(&Name::new("A"), tenths(12))?;
    let law = match n {
        2 => -(number(4) * question.small() / Formula::Pi),
        _ => -(number(2) * question.small() / Formula::Pi),
    };
    let step = DerivationStep::new("any-amplitude", "The pendulum at any amplitude");
    let step = match n {
        2 => step.say(
            "To first order in {} the loss is found at any amplitude. The undamped pendulum’s velocity has the square {}, so that in a half swing the drag takes, \
             for each unit of {},",
            [question.small(), 2 * (cos(theta()) - cos(a())), question.small()],
        ),
        _ => step.say(
            "To first order in {} the loss is found at any amplitude. Friction is the same everywhere and takes in a half swing, for each unit of {},",
            [question.small(), question.small()],
        ),
    };
    Ok(Some(
        step.show(trials.compare_once(swing)?)
            .say(
                "A half swing takes the time {}, and the energy at the turning point changes by {} with the amplitude. So without any series {} is {} times",
                [
                    Formula::Pi / agm(number(1), cos(a() / 2)),
                    sin(a()),
                    Name::new("A").prime().into(),
                    law,
                ],
            )
            .show(check)
            .say("the same coefficients again; the first is that of the decay of small swings.", []),
    ))
}

/// Returns `true` if the restoring force is the sine.
fn is_sine(question: &AveragingQuestion) -> bool {
    let x = Symbol::plain(question.force.oscillator.variable());
    let acceleration = question.force.oscillator.acceleration();
    let sine = Expression::Call(Function::Sin, Box::new(Expression::Symbol(x.clone())));
    let series = |expression: &Expression| expression.taylor_series(&Rationals, &x, &0.into(), 20);
    let negative = Expression::Negate(Box::new(sine));
    series(acceleration).is_some_and(|of_force| Some(of_force) == series(&negative))
}

/// The consequences of the published equation, with the power of the velocity itself instead of |θ′|ⁿ⁻¹θ′.
pub(super) fn published(question: &AveragingQuestion) -> Result<Option<DerivationStep>, DerivationError> {
    let power_law = question.power_law().filter(|(n, _)| *n > 0 && is_sine(question));
    let Some((n, _)) = power_law else { return Ok(None) };
    let power = i64::try_from(n).unwrap_or(i64::MAX);
    let psi = || letter("ψ");
    let trials = Trials::new(None)?.with(&Name::new("ψ"), tenths(7))?;
    let raised = |phase: Formula| sin(phase).pow(power + 1);
    let step = DerivationStep::new("published-form", "The published form of the damping");
    let velocity = Formula::from(question.variable.clone().prime());
    let raised_to = |power: i64| if power == 1 { velocity.clone() } else { velocity.clone().pow(power) };
    let step = step.say(
        "B. Black and V. Vel (Am. J. Phys. 91, 776, 2023) propose in their equation (54) to go on to a damped pendulum, and write the damping as {}, a power of the velocity \
         itself. What it takes in a unit of time is the product with the velocity, {}.",
        [question.small() * raised_to(power), question.small() * raised_to(power + 1)],
    );
    if n % 2 == 1 {
        return Ok(Some(step.say(
            "That is never negative for an odd power such as this: the published form is right, and is the one above. For an even power it has the sign of the velocity, \
             and takes in one half swing what it gives in the other; there the damping is {}.",
            [question.small() * velocity.clone() * call(Function::Abs, velocity.clone()).pow(letter("n") - 1)],
        )));
    }
    let statement = Statement::equal(raised(psi() + Formula::Pi), -raised(psi()));
    let step = step
        .say("For an even power such as this it has the sign of the velocity, and half a swing later it is the opposite,", [])
        .show(trials.compare_once(statement)?)
        .say(
            "so that the published form takes in one half swing what it gives back in the other, and no amplitude falls. Damping is {}, which is what is derived here.",
            [match n {
                2 => question.small() * velocity.clone() * call(Function::Abs, velocity.clone()),
                _ => question.small() * velocity.clone() * call(Function::Abs, velocity.clone()).pow(power - 1),
            }],
        );
    if n != 2 {
        return Ok(Some(step));
    }
    conserved(question, step).map(Some)
}

/// The quantity that the published equation conserves for the square of the velocity.
fn conserved(question: &AveragingQuestion, step: DerivationStep) -> Result<DerivationStep, DerivationError> {
    let (c, theta, y) = (|| question.small(), || question.u(), || letter("y"));
    let velocity = Formula::from(question.variable.clone().prime());
    let mut trials = Trials::new(None)?
        .with(&question.variable, tenths(4))?
        .with(&Name::new("y"), tenths(9))?
        .with(&question.parameter, tenths(2))?;
    let growing = call(Function::Exp, 2 * c() * theta());
    let shape = 2 * (2 * c() * sin(theta()) - cos(theta())) / (4 * c().squared() + 1);
    let letters = [question.displacement.letter.as_str(), "y"];
    let quantity = trials.define_function("H", &letters, growing * (y() + shape));
    let h = || apply("H", [theta(), y()]);
    let rate = -2 * c() * y() - 2 * sin(theta());
    let along = Statement::equal(derivative(h(), letters[0]), rate.clone().negated() * derivative(h(), "y"));
    Ok(step
        .say(
            "With the square of the velocity it even conserves a quantity. For {}, the square, the published equation says that it changes with the angle by {}; so",
            [y(), rate],
        )
        .show(quantity)
        .say("does not change:", [])
        .show(trials.compare_once(along)?)
        .say("A motion with {} constant comes back to where it was: it is periodic, and not damped at all. (Here {} is {}.)", [
            h(),
            y(),
            velocity.squared(),
        ]))
}
