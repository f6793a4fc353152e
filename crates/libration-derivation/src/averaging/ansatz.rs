//! The ansatz for the motion, its change with time, and the definition of the amplitude.

use std::collections::BTreeMap;

use super::super::check::{AveragedClaim, AveragedFormula, Check, CheckedEquation, DerivationError};
use super::super::document::DerivationStep;
use super::super::formula::{Formula, Name, Statement, cos, letter, number, sum};
use super::super::phase::{PhaseFunction, PiNumber, Wave};
use super::super::prose::Prose;
use super::flow::{Flow, FlowOrder, PowerPair};
use super::names::{below, frequency_name, growth_name, motion_name, phase, power};
use super::put_back::{Along, PhaseSeries};
use super::question::AveragingQuestion;
use libration::algebra::Rational;

pub(super) fn step(question: &AveragingQuestion, flow: &Flow) -> DerivationStep {
    let (u, psi) = (|| question.u(), Name::new("ψ"));
    let (amplitude, c) = (|| question.amplitude(), || question.small());
    let rate = |name: &Name| Formula::from(name.clone().prime());
    let unknown = |name: &dyn Fn(PowerPair) -> Name, pairs: &[PowerPair]| {
        let terms = pairs.iter().map(|powers| power(question, *powers) * Formula::from(name(*powers)));
        terms.collect::<Vec<Formula>>()
    };
    let [motions, growths, frequencies] = places(question, flow);
    let motion = [amplitude() * cos(phase())]
        .into_iter()
        .chain(unknown(&|powers| motion_name(question, powers), &motions));
    let growth = unknown(&growth_name, &growths);
    let frequency =
        [Formula::from(Name::new("ω").index(0))].into_iter().chain(unknown(&frequency_name, &frequencies));
    let dots = |mut terms: Vec<Formula>| {
        terms.push(letter("…"));
        sum(terms)
    };
    DerivationStep::new("ansatz", "The ansatz")
        .say(
            "Without the weak force the motion is periodic, and its frequency and form depend on its amplitude {} alone. With the force the \
             amplitude changes, but slowly, and the form is a little different. So the motion is looked for as a function of the amplitude \
             and of a phase {}, both of which go with time in a way that depends on the amplitude alone: {} and {} are functions of {}. All \
             three are power series in {} and {}:",
            [
                amplitude(),
                phase(),
                rate(&Name::new("A")),
                rate(&psi),
                amplitude(),
                amplitude(),
                c(),
            ],
        )
        .show(CheckedEquation::definition(Statement::equal(u(), dots(motion.collect()))))
        .show(CheckedEquation::definition(Statement::equal(rate(&Name::new("A")), dots(growth))))
        .show(CheckedEquation::definition(Statement::equal(rate(&psi), dots(frequency.collect()))))
        .say(
            "The first number below a letter is the power of {}, the second that of {}. The functions {} depend on the phase alone, and primes at \
             them are derivatives with respect to it; {} and {} are numbers.",
            [
                amplitude(),
                c(),
                Formula::from(below(question.displacement.clone(), &["n", "j"])),
                Formula::from(below(Name::new("a"), &["n", "j"])),
                Formula::from(below(Name::new("w"), &["n", "j"])),
            ],
        )
        .say(why_these(question), [])
        .paragraph(backwards(question))
        .paragraph(counted(question, flow, [&motions, &growths, &frequencies]))
}

/// States which powers of the parameter occur.
fn backwards(question: &AveragingQuestion) -> Prose {
    if !question.is_reversed_by_its_parameter() {
        return Prose::text("All powers of the small parameter are there.");
    }
    Prose::new(
        "Read backwards in time the motion is one with the other sign of {}. So {} has odd powers of it alone, and {} even ones.",
        [question.small(), Name::new("A").prime().into(), Name::new("ψ").prime().into()],
    )
}

/// States the number of coefficients, and which of them vanish.
fn counted(
    question: &AveragingQuestion,
    flow: &Flow,
    [motions, growths, frequencies]: [&[PowerPair]; 3],
) -> Prose {
    let count = |n: usize| number(i64::try_from(n).unwrap_or(i64::MAX));
    let zero =
        |pairs: &[PowerPair], is_known: &dyn Fn(&PowerPair) -> bool, name: &dyn Fn(PowerPair) -> Name| {
            let missing = pairs.iter().filter(|powers| !is_known(powers));
            missing.map(|powers| Formula::from(name(*powers))).collect::<Vec<Formula>>()
        };
    let mut vanishing =
        zero(motions, &|powers| flow.motion.contains_key(powers), &|powers| motion_name(question, powers));
    vanishing.extend(zero(growths, &|powers| flow.growth.contains_key(powers), &growth_name));
    vanishing.extend(zero(frequencies, &|powers| flow.frequency.contains_key(powers), &frequency_name));
    let template = match (motions.len(), growths.len() + frequencies.len()) {
        (1, _) => "To the requested orders this leaves {} function and {} numbers to be found",
        _ => "To the requested orders this leaves {} functions and {} numbers to be found",
    };
    let numbers = growths.len() + frequencies.len();
    let prose = Prose::new(template, [count(motions.len()), count(numbers)]);
    let Some((last, before)) = vanishing.split_last() else {
        return prose.and(Prose::text(", none of which will be zero."));
    };
    let prose = prose.and(Prose::text("; of these, as will be seen, nothing forces "));
    let listed = before.iter().enumerate().fold(prose, |prose, (index, formula)| {
        let comma = if index > 0 { ", " } else { "" };
        prose.and(Prose::text(comma)).and(Prose::formula(formula.clone()))
    });
    let and = if before.is_empty() { "" } else { " and " };
    listed.and(Prose::text(and)).and(Prose::formula(last.clone())).and(Prose::text("."))
}

/// The powers of the ansatz at which a coefficient may be nonzero.
fn places(question: &AveragingQuestion, flow: &Flow) -> [Vec<PowerPair>; 3] {
    let shown = |powers: &PowerPair| question.asks_for(*powers);
    let orders = || flow.orders.iter().filter(|order| shown(&order.powers) && can_be(question, order.powers));
    let at = |order: &FlowOrder| order.powers;
    let motions = orders().map(at).collect();
    let is_reversed = question.is_reversed_by_its_parameter();
    let growths = orders().map(at).filter(|(_, j)| *j > 0 && !(is_reversed && j % 2 == 0)).collect();
    let frequencies = orders().filter_map(|order| Some((order.powers.0.checked_sub(1)?, order.powers.1)));
    let frequencies = frequencies.filter(|(_, j)| !(is_reversed && j % 2 == 1));
    [motions, growths, frequencies.filter(|powers| *powers != (0, 0)).collect()]
}

/// Returns `true` if the symmetries of the equation allow a coefficient at these powers.
fn can_be(question: &AveragingQuestion, (n, j): PowerPair) -> bool {
    match symmetry(question) {
        Some(Symmetry::Amplitude) => n % 2 == 1,
        Some(Symmetry::AmplitudeAndParameter) => (n + j) % 2 == 1,
        None => true,
    }
}

/// A change of signs that leaves the equation of the half swing invariant.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Symmetry {
    /// Symmetry in displacement and velocity.
    Amplitude,
    /// Symmetry in displacement, velocity and the small parameter.
    AmplitudeAndParameter,
}

fn symmetry(question: &AveragingQuestion) -> Option<Symmetry> {
    let all = |is: fn(usize, usize) -> bool| {
        question.flow.terms.iter().all(|term| is(term.position + term.velocity, term.parameter))
    };
    if all(|degree, _| degree % 2 == 1) {
        return Some(Symmetry::Amplitude);
    }
    all(|degree, parameter| (degree + parameter) % 2 == 1).then_some(Symmetry::AmplitudeAndParameter)
}

fn why_these(question: &AveragingQuestion) -> &'static str {
    match symmetry(question) {
        Some(Symmetry::Amplitude) => {
            "Even powers of the amplitude are missing: the equation remains the same when displacement and velocity change their signs, which \
             an amplitude of the other sign does too."
        }
        Some(Symmetry::AmplitudeAndParameter) => {
            "Those powers are missing whose sum is even: the equation of the half swing remains the same when displacement, velocity and the \
             small parameter all change their signs, which an amplitude and a parameter of the other sign do too."
        }
        None if question.flow.kinked => {
            "All powers are there: the equation of the half swing has no symmetry that would leave any out."
        }
        None => "All powers are there: the equation has no symmetry that would leave any out.",
    }
}

/// A partial derivative of a function.
fn partial(name: Name, by: &[&str]) -> Formula {
    below(name, by).into()
}

/// The parts of the second time derivative, in the form used in tables.
pub(super) fn second_derivative(question: &AveragingQuestion) -> [Formula; 5] {
    let x = |by: &[&str]| partial(question.displacement.clone(), by);
    let (growth, turn) = (Name::new("A").prime(), Name::new("ψ").prime());
    let [a, w] = [&growth, &turn].map(Formula::from);
    [
        w.clone().squared() * x(&["ψ", "ψ"]),
        number(2) * a.clone() * w * x(&["A", "ψ"]),
        a.clone().squared() * x(&["A", "A"]),
        a.clone() * partial(turn, &["A"]) * x(&["ψ"]),
        a * partial(growth, &["A"]) * x(&["A"]),
    ]
}

pub(super) fn chain_rule(question: &AveragingQuestion) -> Result<DerivationStep, DerivationError> {
    let x = |by: &[&str]| partial(question.displacement.clone(), by);
    let (growth, turn) = (Name::new("A").prime(), Name::new("ψ").prime());
    let velocity = Formula::from(&turn) * x(&["ψ"]) + Formula::from(&growth) * x(&["A"]);
    let second = sum(second_derivative(question).to_vec());
    let first = Statement::equal(question.displacement.clone().prime(), velocity);
    let second = Statement::equal(question.displacement.clone().prime().prime(), second);
    let [first, second] = [checked_rate(question, first, 1)?, checked_rate(question, second, 2)?];
    let names = [("ψ", &turn), ("A", &growth)].map(|(letter, name)| (letter, name.clone()));
    let [(_, turn), (_, growth)] = names;
    Ok(DerivationStep::new("chain-rule", "The derivative with respect to time")
        .say(
            "Time enters through phase and amplitude alone. With {} and {} for the partial derivatives of the motion the chain rule gives the velocity",
            [x(&["ψ"]), x(&["A"])],
        )
        .show(first)
        .say(
            "and once more, with {} and {}, which depend on {} alone, the acceleration",
            [partial(turn, &["A"]), partial(growth, &["A"]), question.amplitude()],
        )
        .show(second)
        .say(
            "In a power series each derivative with respect to {} takes down one power.",
            [question.amplitude()],
        ))
}

/// Checks the chain rule with example functions.
fn checked_rate(
    question: &AveragingQuestion,
    statement: Statement,
    times: usize,
) -> Result<CheckedEquation, DerivationError> {
    let holds = (1..=3).all(|choice| example_holds(choice, times));
    let formula = AveragedFormula { flow: question.flow.clone(), claim: AveragedClaim::ChainRule };
    match holds {
        true => Ok(CheckedEquation::new(statement, Check::Averaged(Box::new(formula)))),
        false => {
            Err(DerivationError::Disagreement { what: "the chain rule and the derivative along the motion" })
        }
    }
}

/// Compares the rates of A and ψ applied `times` times in succession with the sum of the chain rule, for one choice of functions.
fn example_holds(choice: i64, times: usize) -> bool {
    let number =
        |over: i64, under: i64| PiNumber::from(Rational::new(over, under).unwrap_or_else(|| 1.into()));
    let growth = BTreeMap::from([((0, 1), number(choice, 2)), ((2, 1), number(-1, 3))]);
    let frequency =
        BTreeMap::from([((0, 0), number(choice + 1, 1)), ((2, 0), number(2, 5)), ((1, 1), number(1, 7))]);
    let term = |power, k, wave| PhaseFunction::term(power, k, wave, number(choice, 3));
    let x = PhaseSeries::from([
        ((1, 0), term(0, 1, Wave::Cosine)),
        ((3, 1), term(2, 2, Wave::Sine)),
        ((2, 0), term(1, 0, Wave::Cosine)),
    ]);
    let along = Along { growth: &growth, frequency: &frequency, level: 20, parameter_order: 9, lift: 0 };
    let by_phase = |series: &PhaseSeries| {
        series.iter().map(|(powers, part)| (*powers, part.slope())).collect::<PhaseSeries>()
    };
    let by_amplitude = |series: &PhaseSeries| {
        let degree = |n: usize| number(i64::try_from(n).unwrap_or(0), 1);
        let parts = series.iter().filter(|((n, _), _)| *n > 0);
        parts.map(|((n, j), part)| ((n - 1, *j), part.scaled(&degree(*n)))).collect::<PhaseSeries>()
    };
    let series = |coefficients: &BTreeMap<PowerPair, PiNumber>| {
        coefficients
            .iter()
            .map(|(powers, value)| (*powers, PhaseFunction::constant(value.clone())))
            .collect::<PhaseSeries>()
    };
    let (a, w) = (series(&growth), series(&frequency));
    let product = |factors: &[&PhaseSeries]| {
        let one = PhaseSeries::from([((0, 0), PhaseFunction::constant(number(1, 1)))]);
        factors.iter().fold(one, |product, factor| along.times(&product, factor))
    };
    let (x_a, x_p) = (by_amplitude(&x), by_phase(&x));
    let once = [product(&[&w, &x_p]), product(&[&a, &x_a])];
    let two = PhaseSeries::from([((0, 0), PhaseFunction::constant(number(2, 1)))]);
    let twice = [
        product(&[&w, &w, &by_phase(&x_p)]),
        product(&[&two, &a, &w, &by_amplitude(&x_p)]),
        product(&[&a, &a, &by_amplitude(&x_a)]),
        product(&[&a, &by_amplitude(&w), &x_p]),
        product(&[&a, &by_amplitude(&a), &x_a]),
    ];
    let parts: &[PhaseSeries] = if times == 1 { &once } else { &twice };
    let mut rest = if times == 1 { along.rate(&x) } else { along.rate(&along.rate(&x)) };
    for (powers, part) in parts.iter().flatten() {
        let entry = rest.entry(*powers).or_default();
        *entry = entry.minus(part);
    }
    rest.values().all(PhaseFunction::is_zero)
}

/// The step that defines the amplitude.
pub(super) fn gauge(question: &AveragingQuestion) -> DerivationStep {
    let at_start = |name: Name| Formula::Apply(name, vec![number(0)]);
    let (motion, velocity) =
        (below(question.displacement.clone(), &["n", "j"]), below(Name::new("v"), &["n", "j"]));
    DerivationStep::new("gauge", "The definition of the amplitude")
        .say(
            "As it stands the ansatz says the same motion in many ways: another measure of its size in the place of {} would do as well, and so \
             would a phase that is counted from elsewhere. One of them is chosen here, that which is seen and measured: at {} = {} the motion \
             turns, and {} is the displacement there. Then all that is added to {} has neither a value nor a velocity at the turning point. With \
             {} for what stands beside a power in the velocity:",
            [
                question.amplitude(),
                phase(),
                number(0),
                question.amplitude(),
                question.amplitude() * cos(phase()),
                Formula::from(&velocity),
            ],
        )
        .show(CheckedEquation::premise(Statement::equal(at_start(motion), number(0))))
        .show(CheckedEquation::premise(Statement::equal(at_start(velocity), number(0))))
        .say(
            "In another gauge, such as that in which the first harmonic is {} alone, the series are others; what they say of the motion is the \
             same.",
            [question.amplitude() * cos(phase())],
        )
}
