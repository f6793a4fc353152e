//! The derivation by powers of the amplitude and of the small parameter.

use super::super::check::{AveragedClaim, AveragedFormula, Check, CheckedEquation, DerivationError};
use super::super::document::{Cells, DerivationStep, DerivationTable};
use super::super::formula::{Formula, Name, Statement, cos, integral, monomial, number, scaled, sin, sum};
use super::super::phase::{self, PhaseFunction, PiNumber, Wave};
use super::super::prose::Prose;
use super::super::trials::Trials;
use super::ansatz::second_derivative;
use super::flow::{Contribution, EquationPart, Flow, FlowOrder};
use super::names::{
    frequency_name, growth_name, motion_name, of_products, phase, times_omega0, velocity_name,
};
use super::question::AveragingQuestion;
use super::tables::in_terms;
use libration::algebra::Rational;

/// Highest power of the amplitude whose derivation is shown unfolded; those of higher powers are folded.
const OPEN_TO_READ: usize = 3;
/// Largest number of terms from lower powers that is shown under an integral.
const SHORT: usize = 2;

pub(super) fn steps(
    question: &AveragingQuestion,
    flow: &Flow,
) -> Result<Vec<DerivationStep>, DerivationError> {
    let first = beginning(question, flow);
    let orders =
        flow.orders.iter().filter(|order| question.asks_for(order.powers) && !Flow::is_trivial(order));
    let rest = orders.map(|order| one_power(question, flow, order));
    std::iter::once(Ok(first)).chain(rest).collect()
}

/// The power A without the small parameter.
fn beginning(question: &AveragingQuestion, flow: &Flow) -> DerivationStep {
    let powers = (1, 0);
    let velocity = flow.velocity.get(&powers).cloned().unwrap_or_default();
    DerivationStep::new("order-1-0", "The beginning")
        .say(
            "In the power {} without {} there is the small swing alone, which turns at {}:",
            [question.amplitude(), question.small(), question.amplitude()],
        )
        .show(CheckedEquation::definition(Statement::equal(motion_name(question, powers), cos(phase()))))
        .show(CheckedEquation::definition(Statement::equal(
            velocity_name(powers),
            phase::series(&velocity, "ψ"),
        )))
}

fn one_power(
    question: &AveragingQuestion,
    flow: &Flow,
    order: &FlowOrder,
) -> Result<DerivationStep, DerivationError> {
    let (n, j) = order.powers;
    let heading = format!("The power {}", heading(question, order.powers));
    let step = DerivationStep::new(&format!("order-{n}-{j}"), &heading);
    let way = |step: DerivationStep| {
        step.say("The parts of the equation of motion bring to the right side", [])
            .table(table(question, order))
            .say("so that the equation in this power is", [])
            .show(forcing(question, order))
    };
    let step = match n <= OPEN_TO_READ && j <= 1 {
        true => way(step),
        false => step.fold("Contributions of lower powers, and the equation", way),
    };
    let step = conditions(question, order, step)?;
    let step = step.say("With that the solution that turns at the beginning is", []);
    Ok(with_velocity(question, flow, order, step.show(motion(question, order))))
}

/// Aⁿcʲ as plain text.
fn heading(question: &AveragingQuestion, (n, j): (usize, usize)) -> String {
    let raised = |letter: &str, n: usize| match n {
        0 => String::new(),
        1 => letter.to_owned(),
        n => format!("{letter}{}", superscript(n)),
    };
    let text = format!("{}{}", raised(&question.parameter.letter, j), raised("A", n));
    if j == 0 { format!("{text}, without the weak force") } else { text }
}

fn superscript(n: usize) -> String {
    let digit = |digit: char| {
        digit.to_digit(10).and_then(|index| "⁰¹²³⁴⁵⁶⁷⁸⁹".chars().nth(usize::try_from(index).ok()?))
    };
    n.to_string().chars().filter_map(digit).collect()
}

/// The contribution of each part of the equation of motion, as products of lower results and evaluated.
fn table(question: &AveragingQuestion, order: &FlowOrder) -> DerivationTable {
    let row = |contribution: &Contribution| {
        vec![
            Prose::formula(part(question, contribution.part)),
            in_terms(&of_products(question, &contribution.products)),
            in_terms(&phase::series(&contribution.value, "ψ")),
        ]
    };
    let head =
        vec![Prose::text("part"), Prose::text("as products of what is known"), Prose::text("worked out")];
    DerivationTable {
        cells: Cells::Formulas,
        head,
        rows: order.parts.iter().map(row).collect(),
        note: Prose::text("the signs are those on the right side; checked with their sum"),
    }
}

/// A part of the equation of motion as a formula.
fn part(question: &AveragingQuestion, part: EquationPart) -> Formula {
    let [fast, mixed, slow, detuning, drift] = second_derivative(question);
    match part {
        EquationPart::Fast => fast,
        EquationPart::Mixed => mixed,
        EquationPart::Slow => slow,
        EquationPart::Detuning => detuning,
        EquationPart::Drift => drift,
        EquationPart::Force(number) => force(question, number),
    }
}

/// A term of the force, with the velocity as a symbol.
fn force(question: &AveragingQuestion, number: usize) -> Formula {
    let Some(term) = question.flow.terms.get(number) else { return Formula::from(0) };
    let velocity = Formula::from(question.displacement.clone().prime());
    let raised = |base: Formula, n: usize| monomial(&Rational::from(1), &base, n);
    let factors =
        [(question.small(), term.parameter), (question.u(), term.position), (velocity, term.velocity)];
    let product = factors.into_iter().filter(|(_, n)| *n > 0).map(|(base, n)| raised(base, n));
    match product.reduce(|product, factor| product * factor) {
        None => Formula::Number(term.factor.clone()),
        Some(product) => scaled(&term.factor, product),
    }
}

/// The equation at this power.
fn forcing(question: &AveragingQuestion, order: &FlowOrder) -> CheckedEquation {
    let (n, j) = order.powers;
    let x = |primes: usize| {
        let name = motion_name(question, order.powers);
        Formula::from((0..primes).fold(name, |name, _| name.prime()))
    };
    let forcing = phase::series(&order.forcing, "ψ");
    let left = times_omega0(question, 2, x(2)) + times_omega0(question, 2, x(0));
    let twice = |name: Name, wave: Formula| {
        let factor = Rational::from(2) * question.omega0().clone();
        scaled(&factor, Formula::from(name)) * wave
    };
    let mut right = if order.forcing.is_zero() { vec![] } else { summands(forcing.clone()) };
    if let Some(below) = n.checked_sub(1) {
        right.push(twice(frequency_name((below, j)), cos(phase())));
    }
    if j > 0 {
        right.push(twice(growth_name(order.powers), sin(phase())));
    }
    let statement = Statement::equal(left, sum(right));
    averaged(question, statement, AveragedClaim::Forcing { power: n, parameter: j, value: forcing })
}

fn summands(formula: Formula) -> Vec<Formula> {
    match formula {
        Formula::Sum(terms) => terms,
        term => vec![term],
    }
}

pub(super) fn averaged(
    question: &AveragingQuestion,
    statement: Statement,
    claim: AveragedClaim,
) -> CheckedEquation {
    let formula = AveragedFormula { flow: question.flow.clone(), claim };
    CheckedEquation::new(statement, Check::Averaged(Box::new(formula)))
}

/// The conditions for the rates of amplitude and phase.
fn conditions(
    question: &AveragingQuestion,
    order: &FlowOrder,
    step: DerivationStep,
) -> Result<DerivationStep, DerivationError> {
    let rates = rates(order);
    let both = order.powers.1 > 0;
    let step = match rates.as_slice() {
        [] if both => step.say(
            "Neither {} nor {} has a part in its right side: amplitude and phase need no correction in this power.",
            [cos(phase()), sin(phase())],
        ),
        [] => step.say("{} has no part in its right side: the phase needs no correction in this power.", [cos(phase())]),
        [(_, _, _, Wave::Sine)] if order.powers.0 > 0 => {
            step.say("The part of {} in its right side is zero by itself, that of {} for", [cos(phase()), sin(phase())])
        }
        [_] if both && order.powers.0 > 0 => {
            step.say("The part of {} in its right side is zero by itself, that of {} for", [sin(phase()), cos(phase())])
        }
        [(_, _, _, Wave::Sine)] => step.say("The part of {} in its right side is zero for", [sin(phase())]),
        [_] => step.say("The part of {} in its right side is zero for", [cos(phase())]),
        _ => step.say("The parts of {} and {} in its right side are zero for", [sin(phase()), cos(phase())]),
    };
    rates_with_integrals(question, order, rates).map(|equations| step.show_all(equations))
}

/// The nonzero coefficients.
fn rates(order: &FlowOrder) -> Vec<(Name, PiNumber, AveragedClaim, Wave)> {
    let (n, j) = order.powers;
    let growth = (!order.growth.is_zero()).then(|| {
        let claim = AveragedClaim::Growth { power: n, parameter: j };
        (growth_name(order.powers), order.growth.clone(), claim, Wave::Sine)
    });
    let frequency = n.checked_sub(1).filter(|_| !order.frequency.is_zero()).map(|below| {
        let claim = AveragedClaim::Frequency { power: below, parameter: j };
        (frequency_name((below, j)), order.frequency.clone(), claim, Wave::Cosine)
    });
    growth.into_iter().chain(frequency).collect()
}

/// The coefficients, with the integral for each if the motion is given by half swings or the integral is short.
fn rates_with_integrals(
    question: &AveragingQuestion,
    order: &FlowOrder,
    rates: Vec<(Name, PiNumber, AveragedClaim, Wave)>,
) -> Result<Vec<CheckedEquation>, DerivationError> {
    let is_short = question.flow.kinked && order.forcing.terms().count() <= SHORT;
    let with_integral = |(name, value, claim, wave): (Name, PiNumber, AveragedClaim, Wave)| {
        let value = phase::number(&value);
        if !is_short {
            return Ok(averaged(question, Statement::equal(name, value), claim));
        }
        let wave = if wave == Wave::Sine { sin(phase()) } else { cos(phase()) };
        let under = times_omega0(question, 1, Formula::Pi);
        let whole =
            -(number(1) / under * integral("ψ", 0, Formula::Pi, phase::series(&order.forcing, "ψ") * wave));
        Trials::new(None)?.compare_once(Statement::equal(whole.clone(), value.clone()))?;
        Ok(averaged(question, Statement::equal(name, whole).and_equal(value), claim))
    };
    rates.into_iter().map(with_integral).collect()
}

/// The motion at this power.
fn motion(question: &AveragingQuestion, order: &FlowOrder) -> CheckedEquation {
    let (power, parameter) = order.powers;
    let statement = Statement::equal(motion_name(question, order.powers), phase::series(&order.motion, "ψ"));
    averaged(question, statement, AveragedClaim::Motion { power, parameter })
}

fn with_velocity(
    question: &AveragingQuestion,
    flow: &Flow,
    order: &FlowOrder,
    step: DerivationStep,
) -> DerivationStep {
    let velocity = flow.velocity.get(&order.powers).cloned().unwrap_or_default();
    let is_needed = question.flow.terms.iter().any(|term| term.velocity > 0);
    if !is_needed || velocity == PhaseFunction::default() {
        return step;
    }
    let (power, parameter) = order.powers;
    let statement = Statement::equal(velocity_name(order.powers), phase::series(&velocity, "ψ"));
    step.say("with the velocity", []).show(averaged(
        question,
        statement,
        AveragedClaim::Velocity { power, parameter },
    ))
}
