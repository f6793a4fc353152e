//! The choice of the gauge, and the motion in it.

use super::super::check::{Check, CheckedEquation, DerivationError, failed};
use super::super::document::DerivationStep;
use super::super::formula::{Formula, Name, Statement, letter};
use super::names::{coefficient_name, harmonic_name};
use super::question::LindstedtQuestion;
use super::solution::Solution;
use super::substitution::{Motion, in_epsilon, solves};
use libration::algebra::{Polynomial, Variable};
use libration::perturbation::Gauge;

pub(super) fn gauge(question: &LindstedtQuestion) -> Result<DerivationStep, DerivationError> {
    let unknowns = question.open.unknowns().len();
    let free = question.open.free_constants();
    let count = |number: usize| crate::formula::number(i64::try_from(number).unwrap_or(i64::MAX));
    let vanishing = question.open.solution().values().filter(|value| value.is_zero()).count();
    let mut step = DerivationStep::new("gauge", "The gauge")
        .say(
            "The ansatz has {} coefficients. The conditions fix {} of them, of which {} vanish. Free are those of the first harmonic, {} \
             in number: they say what {} means, since any other measure of the size of the swing would do as well. To choose them is \
             to choose the gauge. It changes every series in {}, and no relation between quantities that can be measured.",
            [count(unknowns), count(unknowns - free.len()), count(vanishing), count(free.len()), letter("ε"), letter("ε")],
        )
        .say(meaning(&question.solution.gauge), []);
    for n in question.powers() {
        let value = Formula::from(&question.solution.coefficient(1, n));
        let name = Name::from(&coefficient_name(1, n));
        step = step.show(CheckedEquation::definition(Statement::defined(name, value)));
    }
    Ok(step)
}

fn meaning(gauge: &Gauge) -> &'static str {
    match gauge {
        Gauge::Fundamental => {
            "Here the expansion parameter shall be the coefficient of the first harmonic itself:"
        }
        Gauge::XMax => "Here the expansion parameter shall be the largest displacement, which takes",
        Gauge::HalfSwing => {
            "Here the expansion parameter shall be half the distance between the turning points, which takes"
        }
        Gauge::Energy => {
            "Here the square of the expansion parameter shall be twice the energy over the square of the frequency of small \
             swings, which takes"
        }
        Gauge::Nome => {
            "Here the expansion parameter shall be eight times the root of Jacobi’s nome, which takes"
        }
        _ => "Here they are chosen as asked for:",
    }
}

pub(super) fn solution(question: &LindstedtQuestion) -> Result<DerivationStep, DerivationError> {
    agrees_with_open_gauge(question, &question.solution)?;
    let step = DerivationStep::new("solution", "The solution")
        .say("With these the coefficients are known, and the motion is", []);
    let step = (series(question, &question.solution).into_iter()).fold(step, DerivationStep::show);
    Ok(step
        .say(
            match question.is_reduced() {
                true => {
                    "These series were found by another algorithm, which goes to any order. That they are a solution is seen by putting them \
                     back into the equation of motion:"
                }
                false => {
                    "These series were found by another algorithm, which goes to any order. That they are a solution is seen by putting them \
                     back into the equation of motion, with the whole force and not its Taylor series:"
                }
            },
            [],
        )
        .show(solves(question, &motion(question, &question.solution))?))
}

/// The harmonics and the frequency, each with the check shown below it.
pub(super) fn series(question: &LindstedtQuestion, solution: &Solution) -> Vec<CheckedEquation> {
    let mut equations = Vec::new();
    for k in question.harmonics() {
        let statement =
            Statement::equal(harmonic_name(k), in_epsilon(&solution.harmonic(k), question.order + 1));
        equations.push(CheckedEquation::new(statement, Check::Below));
    }
    let frequency = in_epsilon(&solution.frequency_ratio, question.order);
    equations.push(CheckedEquation::new(Statement::equal(letter("Δ"), frequency), Check::Below));
    equations
}

/// The motion of a solution, in numbers.
pub fn motion(question: &LindstedtQuestion, solution: &Solution) -> Motion {
    Motion {
        harmonics: question.harmonics().into_iter().map(|k| (k, solution.harmonic(k))).collect(),
        frequency: solution.frequency_ratio.clone(),
    }
}

/// Checks that the general solution, with the symbols of this gauge inserted, is the solution in this gauge.
fn agrees_with_open_gauge(question: &LindstedtQuestion, solution: &Solution) -> Result<(), DerivationError> {
    let free = question.open.free_constants();
    let in_gauge = |polynomial: &Polynomial| {
        free.iter().fold(polynomial.clone(), |value, variable| {
            let chosen = coefficient_of(question, solution, variable).unwrap_or_else(Polynomial::zero);
            value.substitute(variable, &chosen)
        })
    };
    for (variable, polynomial) in question.open.solution() {
        let value = in_gauge(polynomial);
        let there = coefficient_of(question, solution, variable);
        if there.is_some_and(|there| there != value) {
            let statement = Statement::equal(Name::from(variable), Formula::from(&value));
            return Err(failed(&statement, "the engine finds another value".to_owned()));
        }
    }
    Ok(())
}

/// The value of a symbol from the library's expansion.
fn coefficient_of(
    question: &LindstedtQuestion,
    solution: &Solution,
    variable: &Variable,
) -> Option<Polynomial> {
    let n = usize::try_from(variable.index()?).ok()?;
    if variable.letters() == "d" {
        return solution.frequency_ratio.get(n).cloned();
    }
    let k = question.harmonics().into_iter().find(|k| coefficient_name(*k, n) == *variable)?;
    Some(solution.coefficient(k, n))
}
