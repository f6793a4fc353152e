//! The amplitude as a function of time from the first term alone: for a force
//! with one power of the velocity, or with two as in Van der Pol's equation.

use super::super::check::{CheckedEquation, DerivationError};
use super::super::document::DerivationStep;
use super::super::formula::{
    Formula, Name, Statement, apply, call, derivative, double_factorial, integral, letter, ln, number,
    scaled, sin, sqrt, tenths,
};
use super::super::phase::{self, PiNumber};
use super::super::trials::Trials;
use super::flow::Flow;
use super::names::growth_name;
use super::question::AveragingQuestion;
use libration::algebra::{Function, Rational};

/// The symbol of slow time.
const SLOW: &str = "τ";

pub(super) fn step(
    question: &AveragingQuestion,
    flow: &Flow,
) -> Result<Option<DerivationStep>, DerivationError> {
    if let Some((n, _)) = question.power_law() {
        let Some(rate) = flow.growth.get(&(n, 1)) else { return Ok(None) };
        return power_law(question, n, &rate.negated()).map(Some);
    }
    self_excitation(question, flow)
}

fn slow_time(question: &AveragingQuestion) -> CheckedEquation {
    CheckedEquation::definition(Statement::defined(letter(SLOW), question.small() * letter("t")))
}

fn a() -> Formula {
    apply("A", [letter(SLOW)])
}

fn start() -> Name {
    Name::new("A").index(0)
}

/// dA/dτ = −βAⁿ.
fn power_law(
    question: &AveragingQuestion,
    n: usize,
    beta: &PiNumber,
) -> Result<DerivationStep, DerivationError> {
    let (name, power) = (Name::new("β"), i64::try_from(n).unwrap_or(i64::MAX));
    let mut trials = Trials::new(None)?.with(&start(), tenths(3))?.with(&Name::new(SLOW), tenths(4))?;
    let value = trials.define(&name, mean(question, n))?;
    let to = |formula: Formula, power: i64| match power {
        0 => number(1),
        1 => formula,
        _ => formula.pow(power),
    };
    let (a0, b, tau) = (|| Formula::from(start()), || letter("β"), || letter(SLOW));
    let motion = match n {
        0 => a0() - b() * tau(),
        1 => a0() * call(Function::Exp, -(b() * tau())),
        2 => a0() / (number(1) + b() * a0() * tau()),
        3 => a0() / sqrt(number(1) + 2 * b() * a0().squared() * tau()),
        _ => {
            let below = number(1) + number(power - 1) * b() * to(a0(), power - 1) * tau();
            a0() / below.pow(Rational::new(1, power - 1).unwrap_or_else(|| Rational::from(1)))
        }
    };
    let motion = trials.define_function("A", &[SLOW], motion);
    let law = if n == 0 { -b() } else { -(b() * to(a(), power)) };
    let law = Statement::equal(derivative(a(), SLOW), law);
    let half = match n {
        0 => a0() / (2 * b()),
        1 => ln(2) / b(),
        2 => number(1) / (b() * a0()),
        _ => {
            let below = number(power - 1) * b() * to(a0(), power - 1);
            number((1 << (power - 1)) - 1) / below
        }
    };
    let halved = Statement::equal(apply("A", [half]), a0() / 2);
    let step = DerivationStep::new("amplitude-law", "The decay of small swings")
        .say(
            "The first term alone says how small swings decay. With slow time and its coefficient, the first harmonic of a power of the sine,",
            [],
        )
        .show(slow_time(question))
        .show(value);
    let step = coefficient(question, n, beta, step, &trials)?;
    Ok(step
        .say("The amplitude that begins at {} is then", [a0()])
        .show(motion)
        .say("because", [])
        .show(trials.compare_once(law)?)
        .say(kind(n), [])
        .say("It has fallen to one half after the slow time in the brackets:", [])
        .show(trials.compare_once(halved)?))
}

fn kind(n: usize) -> &'static str {
    match n {
        0 => {
            "Dry friction takes the same from the amplitude in each swing, so that it falls on a straight line, and the motion ends."
        }
        1 => {
            "Viscous damping takes the same part of the amplitude in each swing: the only power for which the decay is exponential, with a \
             logarithmic decrement that does not depend on the amplitude."
        }
        2 => {
            "The reciprocal of the amplitude grows on a straight line. Large swings decay fast and small ones slowly, and after a long time the \
             amplitude no longer depends on how it began."
        }
        _ => {
            "A power of the amplitude’s reciprocal grows on a straight line, and small swings decay slower than any exponential."
        }
    }
}

/// factor·ω0ⁿ⁻¹ times a formula.
fn times_strength(question: &AveragingQuestion, n: usize, formula: Formula) -> Formula {
    let factor = question.power_law().map_or_else(|| Rational::from(1), |(_, factor)| factor);
    let exponent = isize::try_from(n).unwrap_or(isize::MAX) - 1;
    let power = question.omega0().integer_power(exponent).unwrap_or_else(|| Rational::from(1));
    scaled(&(factor * power), formula)
}

/// The first harmonic of a power of the sine.
fn mean(question: &AveragingQuestion, n: usize) -> Formula {
    let power = i64::try_from(n + 1).unwrap_or(i64::MAX);
    let raised = if n == 0 { sin(letter("ψ")) } else { sin(letter("ψ")).pow(power) };
    times_strength(question, n, number(1) / Formula::Pi) * integral("ψ", 0, Formula::Pi, raised)
}

/// The value of the first harmonic of a power of the sine, which is the number in the law.
fn coefficient(
    question: &AveragingQuestion,
    n: usize,
    beta: &PiNumber,
    step: DerivationStep,
    trials: &Trials,
) -> Result<DerivationStep, DerivationError> {
    let power = i64::try_from(n).unwrap_or(i64::MAX);
    let quotient = double_factorial(power) / double_factorial(power + 1);
    let wallis = match n % 2 {
        0 => times_strength(question, n, number(2) / Formula::Pi) * quotient,
        _ => times_strength(question, n, quotient),
    };
    let chain = Statement::equal(letter("β"), wallis).and_equal(phase::number(beta));
    let step = step.say("In each step by parts the integral goes down by two powers, so that", []);
    let step = step.show(trials.compare_once(chain)?);
    harmonics(n, step, trials)
}

/// The harmonics of |sin|ⁿ⁻¹ sin.
fn harmonics(n: usize, step: DerivationStep, trials: &Trials) -> Result<DerivationStep, DerivationError> {
    let (psi, m) = (|| letter("ψ"), || letter("m"));
    let odd = || 2 * m() + 1;
    let harmonic = |power: Option<Formula>| {
        let wave = sin(odd() * psi());
        let integrand = power.map_or_else(|| wave.clone(), |power| power * wave.clone());
        number(2) / Formula::Pi * integral("ψ", 0, Formula::Pi, integrand)
    };
    match n {
        0 => {
            let statement = Statement::equal(harmonic(None), number(4) / (Formula::Pi * odd()));
            let step = step.say("The sign of the velocity is a square wave; its harmonics, of which the first one counts here, are", []);
            Ok(step.show(trials.compare_cases("m", 0..=4, statement)?))
        }
        2 => {
            let under = Formula::Pi * odd() * (odd().squared() - 4);
            let statement = Statement::equal(harmonic(Some(sin(psi()).squared())), -(number(8) / under));
            let step = step.say(
                "A square with the sign of the sine has all odd harmonics, of which the first one counts here and the others change the form of the swing:",
                [],
            );
            Ok(step.show(trials.compare_cases("m", 0..=4, statement)?))
        }
        3 => {
            let trials = trials.with(&Name::new("ψ"), tenths(7))?;
            let cube = Statement::equal(sin(psi()).pow(3), (3 * sin(psi()) - sin(3 * psi())) / 4);
            let step =
                step.say("The cube of a sine has two harmonics, of which the first one counts here:", []);
            Ok(step.show(trials.compare_once(cube)?))
        }
        _ => Ok(step),
    }
}

/// dA/dτ = αA − βA³, which has a limit cycle.
fn self_excitation(
    question: &AveragingQuestion,
    flow: &Flow,
) -> Result<Option<DerivationStep>, DerivationError> {
    let first: Vec<(usize, Option<Rational>)> = (flow.growth.iter())
        .filter(|((_, j), _)| *j == 1)
        .map(|((n, _), value)| (*n, value.to_rational()))
        .collect();
    let [(1, Some(alpha)), (3, Some(beta))] = first.as_slice() else { return Ok(None) };
    let beta = -beta.clone();
    if alpha.is_negative() || beta.is_negative() {
        return Ok(None);
    }
    let (a0, tau) = (|| Formula::from(start()), || letter(SLOW));
    let mut trials = Trials::new(None)?.with(&start(), tenths(3))?.with(&Name::new(SLOW), tenths(4))?;
    let [first, third] = [(1, 1), (3, 1)].map(growth_name);
    trials = trials.with(&first, alpha.clone().into())?.with(&third, (-beta).into())?;
    let alpha = trials.define(&Name::new("α"), first.into())?;
    let beta = trials.define(&Name::new("β"), -Formula::from(third))?;
    let decaying = call(Function::Exp, -(2 * letter("α") * tau()));
    let begun = || letter("β") * a0().squared();
    let below = begun() + (letter("α") - begun()) * decaying;
    let motion = trials.define_function("A", &[SLOW], a0() * sqrt(letter("α") / below));
    let law = Statement::equal(derivative(a(), SLOW), letter("α") * a() - letter("β") * a().pow(3));
    let step = DerivationStep::new("amplitude-law", "Growth and saturation of the swings")
        .say("To first order the amplitude changes, in slow time, by two terms, one that feeds it and one that limits it:", [])
        .show(slow_time(question))
        .show(alpha)
        .show(beta)
        .say("The square of the amplitude obeys a logistic equation, so that from {}", [a0()])
        .show(motion)
        .say("because", [])
        .show(trials.compare_once(law)?)
        .say("Whatever it begins with, the amplitude tends to {}, the limit cycle.", [sqrt(letter("α") / letter("β"))]);
    Ok(Some(step))
}
