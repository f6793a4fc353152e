//! The same motion in another gauge: different series in ε, equal series in the amplitude.

use super::super::check::{CheckedEquation, DerivationError, failed};
use super::super::document::DerivationStep;
use super::super::formula::{Name, Statement, letter};
use super::amplitude::{of_amplitude, relations};
use super::motion::{motion, series};
use super::names::coefficient_name;
use super::question::LindstedtQuestion;
use super::solution::Solution;
use super::substitution::solves;
use libration::algebra::Rational;
use libration::internals::progress::Watch;
use libration::perturbation::Gauge;
use libration::progress::Quiet;

/// A₁ = 1, and −1 for the next coefficient; the first harmonic itself if that was the requested gauge.
fn other(question: &LindstedtQuestion) -> Gauge {
    let next = if question.is_odd() { vec![1, 0, -1] } else { vec![1, -1] };
    let other = Gauge::Coefficients(next.into_iter().map(Rational::from).collect());
    if question.solution.gauge == other { Gauge::Fundamental } else { other }
}

pub(super) fn comparison(question: &LindstedtQuestion) -> Result<DerivationStep, DerivationError> {
    let watch = &Watch::new(&Quiet);
    let (oscillator, reduced) = (question.oscillator.as_ref(), &question.reduced);
    let other = Solution::new(oscillator, reduced, question.order, &other(question), watch)?;
    let mut step = DerivationStep::new("second-gauge", "A second gauge")
        .say("That the choice is free is best seen by making another one. With", []);
    for n in question.powers() {
        let name = Name::from(&coefficient_name(1, n));
        step = step.show(CheckedEquation::definition(Statement::defined(name, &other.coefficient(1, n))));
    }
    step = step.say("the series in {} are others:", [letter("ε")]);
    step = series(question, &other).into_iter().fold(step, DerivationStep::show);
    step = step.show(solves(question, &motion(question, &other))?);
    let (here, there) = (of_amplitude(question, &question.solution)?, of_amplitude(question, &other)?);
    let same = here.frequency_ratio == there.frequency_ratio
        && here.period_ratio == there.period_ratio
        && here.harmonics == there.harmonics;
    if !same {
        let statement = Statement::from(letter("Δ"));
        return Err(failed(&statement, "two gauges give different frequencies or harmonics".to_owned()));
    }
    step = step.say("But put the series of {} in the amplitude into them, which is another one too, and the same comes out:", [letter("ε")]);
    Ok(relations(question, &other)?.into_iter().fold(step, DerivationStep::show))
}
