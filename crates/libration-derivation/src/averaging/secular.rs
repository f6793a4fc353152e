//! Conditions at each power of the equation of motion.

use super::super::check::{Check, CheckedEquation, DerivationError};
use super::super::document::DerivationStep;
use super::super::formula::{
    Formula, Name, Statement, apply, cos, derivative, integral, letter, number, sin, tenths,
};
use super::super::trials::Trials;
use super::names::{below, phase, times_omega0};
use super::question::AveragingQuestion;

pub(super) fn step(question: &AveragingQuestion) -> Result<DerivationStep, DerivationError> {
    let step = DerivationStep::new("conditions", "The condition in each power");
    let step = equation_of_a_power(question, step);
    let trials = Trials::new(None)?.with(&Name::new("ψ"), tenths(7))?;
    let growing = || -(phase() * cos(phase()) / 2);
    let slope = || (phase() * sin(phase()) - cos(phase())) / 2;
    let first = Statement::equal(derivative(growing(), "ψ"), slope());
    let second = Statement::equal(derivative(slope(), "ψ") + growing(), sin(phase()));
    let step = step
        .say(
            "It is the equation of an oscillator that is driven at its own frequency by the last two terms and whatever of these harmonics is in {}. \
             For such a force the response grows without bound, for instance with",
            [forcing()],
        )
        .show(trials.compare_once(first)?)
        .show(trials.compare_once(second)?);
    let step = step.say(
        "The two coefficients of amplitude and phase are there to prevent this: they are chosen so that nothing is left over.",
        [],
    );
    match question.flow.kinked {
        true => half_swing(question, step, &trials),
        false => whole_swing(step, &trials),
    }
}

/// The contributions of lower powers.
fn forcing() -> Formula {
    below(Name::new("R"), &["n", "j"]).into()
}

fn equation_of_a_power(question: &AveragingQuestion, step: DerivationStep) -> DerivationStep {
    let x = |primes: usize| {
        let name = below(question.displacement.clone(), &["n", "j"]);
        Formula::from((0..primes).fold(name, |name, _| name.prime()))
    };
    let rate = |name: &str, power: &str| Formula::from(below(Name::new(name), &[power, "j"]));
    let left = times_omega0(question, 2, x(2)) + times_omega0(question, 2, x(0));
    let secular = [
        times_omega0(question, 1, number(2) * rate("w", "m") * cos(phase())),
        times_omega0(question, 1, number(2) * rate("a", "n") * sin(phase())),
    ];
    let [cosine, sine] = secular;
    step.say(
        "All is put into the equation of motion. In the power {} stand the newest coefficients, with the factors that {} gives them, and \
         products of those of lower powers, whose sum, moved to the right side, is called {}. With {} = {} this is",
        [
            question.small().pow(letter("j")) * question.amplitude().pow(letter("n")),
            question.amplitude() * cos(phase()),
            forcing(),
            letter("m"),
            letter("n") - 1,
        ],
    )
    .show(CheckedEquation::new(Statement::equal(left, forcing() + cosine + sine), Check::Below))
}

/// The conditions for a periodic motion: the first harmonic vanishes.
fn whole_swing(step: DerivationStep, trials: &Trials) -> Result<DerivationStep, DerivationError> {
    let mean = |integrand| number(1) / Formula::Pi * integral("ψ", 0, 2 * Formula::Pi, integrand);
    let same = Statement::equal(mean(sin(phase()).squared()), number(1));
    let other = Statement::equal(sin(phase()) * sin(3 * phase()), (cos(2 * phase()) - cos(4 * phase())) / 2);
    let step = step
        .say(
            "Here {} is a sum of harmonics, and nothing is left over where its part of {} and the term with {} cancel, and its part of {} and the term \
             with {}. Parts of harmonics are found by projection:",
            [
                forcing(),
                sin(phase()),
                below(Name::new("a"), &["n", "j"]).into(),
                cos(phase()),
                below(Name::new("w"), &["m", "j"]).into(),
            ],
        )
        .show(trials.compare_once(same)?)
        .say("while products of different harmonics are sums of waves without a mean, as", [])
        .show(trials.compare_once(other)?);
    solution(step, trials)
}

/// The conditions if the next half swing is the opposite of this one.
fn half_swing(
    question: &AveragingQuestion,
    step: DerivationStep,
    trials: &Trials,
) -> Result<DerivationStep, DerivationError> {
    let y = |primes: usize| {
        let name = (0..primes).fold(Name::new("y"), |name, _| name.prime());
        move |at: Formula| Formula::Apply(name.clone(), vec![at])
    };
    let example = example(trials);
    let ends = |primes: usize| y(primes)(Formula::Pi) + y(primes)(number(0));
    let forced = || y(2)(phase()) + y(0)(phase());
    let by_sine = Statement::equal(integral("ψ", 0, Formula::Pi, forced() * sin(phase())), ends(0));
    let by_cosine = Statement::equal(integral("ψ", 0, Formula::Pi, forced() * cos(phase())), -ends(1));
    let step = step
        .say(
            "Only the half swing from {} = 0 to {} is known, and the condition is that the next one begins as the opposite of this one, with the \
             opposite displacement and the opposite velocity. For any function {} of the phase, integrated twice by parts,",
            [phase(), Formula::Pi, letter("y")],
        )
        .show(example.compare_once(by_sine)?)
        .show(example.compare_once(by_cosine)?)
        .say(
            "For the check an example stands in the place of {}. Where the next half swing begins at the opposite, the right sides vanish; so the left sides must, and \
             the right side of the equation has no part of {} and {} on the half swing. Since",
            [letter("y"), sin(phase()), cos(phase())],
        )
        .show(trials.compare_once(Statement::equal(
            integral("ψ", 0, Formula::Pi, sin(phase()).squared()),
            Formula::Pi / 2,
        ))?)
.say("and", [])
        .show(trials.compare_once(Statement::equal(sin(phase()) * cos(phase()), sin(2 * phase()) / 2))?)
        .say("has no integral over the half swing, the coefficients are", []);
    let condition = |name: Name, wave: Formula| {
        let whole = integral("ψ", 0, Formula::Pi, forcing() * wave);
        let under = times_omega0(question, 1, Formula::Pi);
        CheckedEquation::new(Statement::equal(name, -(number(1) / under * whole)), Check::Below)
    };
    let step = step
        .show(condition(below(Name::new("a"), &["n", "j"]), sin(phase())))
        .show(condition(below(Name::new("w"), &["m", "j"]), cos(phase())));
    solution(step, trials)
}

/// Examples of y with its derivatives.
fn example(trials: &Trials) -> Trials {
    let name = |primes: usize| (0..primes).fold(Name::new("y"), |name, _| name.prime());
    let p = phase;
    trials
        .with_function(&name(0), "ψ", p().squared() + cos(2 * p()) + p() * sin(p()))
        .with_function(&name(1), "ψ", 2 * p() - 2 * sin(2 * p()) + sin(p()) + p() * cos(p()))
        .with_function(&name(2), "ψ", number(2) - 4 * cos(2 * p()) + 2 * cos(p()) - p() * sin(p()))
}

/// The solution of the equation under these conditions.
fn solution(step: DerivationStep, trials: &Trials) -> Result<DerivationStep, DerivationError> {
    let r = |at: &str| apply("r", [letter(at)]);
    let mut trials =
        trials.with_function(&Name::new("r"), "s", letter("s") * cos(2 * letter("s")) + sin(letter("s")));
    let part = |wave: fn(Formula) -> Formula| integral("s", 0, phase(), r("s") * wave(letter("s")));
    let y = sin(phase()) * part(cos) - cos(phase()) * part(sin);
    let slope = || cos(phase()) * part(cos) + sin(phase()) * part(sin);
    let definition = trials.define_function("y", &["ψ"], y);
    let y = || apply("y", [phase()]);
    let first = Statement::equal(derivative(y(), "ψ"), slope());
    let second = Statement::equal(derivative(slope(), "ψ") + y(), r("ψ"));
    Ok(step
        .say(
            "What is then left on the right side, {} once the factor of the left side is divided out, forces a motion that begins with neither value nor slope,",
            [r("ψ")],
        )
        .show(definition)
        .say("for", [])
        .show(trials.compare_once(first)?)
        .show(trials.compare_once(second)?)
        .say(
            "For the check an example stands in the place of {}. A multiple of {} is added so that the velocity at the turning point vanishes, slow parts such as that with {} \
             included. Or one guesses the form and compares.",
            [letter("r"), sin(phase()), below(Name::new("a"), &["n", "j"]).into()],
        ))
}
