//! The small terms along the motion, their resonant parts, and the slow flow.

use super::super::check::{DerivationError, chosen};
use super::super::document::DerivationStep;
use super::super::formula::{
    Formula, Name, Statement, apply, cos, integral, letter, number, scaled, sin, sum,
};
use super::super::trials::Trials;
use super::subject::{SlowFlowSubject, cosine};
use libration::expression::{Expression, Symbol};
use libration::perturbation::SmallTerm;

fn sine() -> Formula {
    sin(Name::new("ψ"))
}

/// A term with the motion in place of displacement and velocity, in W·t or with its phase.
fn along(subject: &SlowFlowSubject, term: &SmallTerm, at_phase: usize) -> Result<Formula, DerivationError> {
    let variable = Symbol::plain(&subject.equation.variables()[0]);
    let [position, velocity] = &subject.steps.motion[at_phase];
    let mut motion = vec![(variable.clone().with_primes(1), velocity), (variable, position)];
    if let Some(before) = &subject.steps.before {
        let names = before.names.each_ref().map(|name| Symbol::plain(name));
        motion.extend(names.into_iter().zip(&before.motion[at_phase]));
    }
    let mut force = subject.read(&term.force[at_phase])?;
    for (symbol, text) in motion {
        let value = if text.is_empty() { "0" } else { text.as_str() };
        force = force.substitute(&symbol, &subject.read(value)?);
    }
    Ok(subject.written(&force))
}

/// c·cos ψ + s·sin ψ, with brackets around sums.
fn wave(
    subject: &SlowFlowSubject,
    [cosine_part, sine_part]: &[String; 2],
) -> Result<Formula, DerivationError> {
    let mut terms = vec![];
    for (text, wave) in [(cosine_part, cosine()), (sine_part, sine())] {
        let factor = subject.read(text)?;
        if !factor.vanishes() {
            terms.push(factored(subject, &factor, wave));
        }
    }
    Ok(if terms.is_empty() { number(0) } else { sum(terms) })
}

/// A product with its sign in front.
fn factored(subject: &SlowFlowSubject, factor: &Expression, wave: Formula) -> Formula {
    match factor {
        Expression::Negate(size) => -(subject.written(size) * wave),
        _ => subject.written(factor) * wave,
    }
}

/// The terms of the lowest order.
pub(super) fn step(
    subject: &SlowFlowSubject,
    terms: &[SmallTerm],
) -> Result<DerivationStep, DerivationError> {
    let mut trials = Trials::choices()?;
    for (index, name) in ["α", "β"].into_iter().enumerate() {
        trials.choose(&Name::new(name), &|choice| Formula::Number(chosen(index, choice)))?;
    }
    let [a, b] = ["α", "β"].map(Name::new);
    let difference = || Formula::from(&a) - Formula::from(&b);
    let both = || Formula::from(&a) + Formula::from(&b);
    let half = |sum: Formula| sum / 2;
    let products = [
        Statement::equal(cos(&a) * cos(&b), half(cos(difference()) + cos(both()))),
        Statement::equal(sin(&a) * sin(&b), half(cos(difference()) - cos(both()))),
        Statement::equal(sin(&a) * cos(&b), half(sin(both()) + sin(difference()))),
    ];
    let products = products.map(|statement| trials.compare_choices(statement));
    let mut step = DerivationStep::new("small-terms", "The small terms along the motion")
        .say("The motion is put into each small term. Products become sums of waves by", []);
    for product in products {
        step = step.show(product?);
    }
    step = step.say(
        "used once for each further factor. Only waves with the frequency of the oscillation drive it in resonance; the others force small waves of their own frequencies, which matter in the next order \
         alone.",
        [],
    );
    for term in terms {
        step = one_term(subject, step, term)?;
    }
    Ok(step)
}

pub(super) fn one_term(
    subject: &SlowFlowSubject,
    step: DerivationStep,
    term: &SmallTerm,
) -> Result<DerivationStep, DerivationError> {
    let force = subject.formula(&term.force[0])?;
    let Some(waves) = &term.waves else { return kinked(subject, step, term, force) };
    let waves = subject.formula(waves)?;
    let inserted = along(subject, term, 0)?;
    let mut statement = Statement::equal(force.clone(), inserted.clone());
    if waves != inserted {
        statement = statement.and_equal(waves.clone());
    }
    if inserted == force {
        statement = Statement::equal(force, waves.clone());
    }
    let is_plain = waves == inserted && statement.rest.len() == 1 && statement.first == waves;
    let step = match is_plain {
        true => step,
        false => step.show(subject.trials.compare_choices(statement)?),
    };
    if term.turning.is_empty() {
        return Ok(step);
    }
    let turning = subject.formula(&term.turning)?;
    let drive = subject.drive()?.unwrap_or_else(|| number(1)) * letter("t");
    let since = scaled(&subject.resonance(), bracketed(subject));
    let resonant = wave(subject, &term.turned)?;
    Ok(step
        .say(
            "With {} in place of {} the waves of the drive with the frequency of the oscillation are here",
            [since, drive],
        )
        .show(subject.trials.compare_choices(Statement::equal(turning, resonant))?))
}

fn bracketed(subject: &SlowFlowSubject) -> Formula {
    Formula::Sum(vec![letter("ψ"), -Formula::from(subject.phase())])
}

/// A force with kinks: its resonant part by an integral over a quarter of a period.
fn kinked(
    subject: &SlowFlowSubject,
    step: DerivationStep,
    term: &SmallTerm,
    force: Formula,
) -> Result<DerivationStep, DerivationError> {
    let inserted = along(subject, term, 1)?;
    let mut step = step
        .say(
            "The term {} has infinitely many harmonics. Its part with the frequency of the oscillation follows by projection, to which each quarter of a period contributes the same, the first one with {} positive and {} negative. In front of {} and {} stand, where they are not zero,",
            [
                force,
                subject.variable().into(),
                subject.variable().prime().into(),
                cosine(),
                sine(),
            ],
        );
    for (text, wave) in term.resonant.iter().zip([cosine(), sine()]) {
        let value = subject.read(text)?;
        if value.vanishes() {
            continue;
        }
        let part = integral("ψ", 0, Formula::Pi / 2, inserted.clone() * wave);
        let statement = Statement::equal(number(4) / Formula::Pi * part, subject.written(&value));
        step = step.show(subject.trials.compare_choices(statement)?);
    }
    Ok(step)
}

/// The slow flow by the terms that act in it.
pub(super) fn averaged(
    subject: &SlowFlowSubject,
    terms: &[&SmallTerm],
) -> Result<DerivationStep, DerivationError> {
    let excess = subject.excess(Formula::from(subject.phase().prime()))?;
    let step = DerivationStep::new("slow-flow", "The slow flow of amplitude and phase").say(
        "By the definition of {} the difference {} is {}. What stands before {} in the derivatives must be what stands before it in the small terms, and the same holds for {}:",
        [
            letter("ψ"),
            Formula::from(Name::new("ψ").prime()) - subject.omega0()?,
            excess,
            cosine(),
            sine(),
        ],
    );
    let step = solved(subject, step, left_sides(subject)?, terms)?;
    if terms.iter().any(|term| term.waves.is_none()) {
        return Ok(step);
    }
    means(subject, step, terms)
}

/// The coefficients of cos ψ and sin ψ on the left side of the equation of motion, to the first order in the rates.
pub(super) fn left_sides(subject: &SlowFlowSubject) -> Result<[Formula; 2], DerivationError> {
    let a = subject.amplitude();
    let excess = subject.excess(Formula::from(subject.phase().prime()))?;
    let before_cosine = -subject.times_omega0(2, 1, Formula::from(&a) * excess)?;
    let before_sine = -subject.times_omega0(2, 1, Formula::from(a.prime()))?;
    Ok([before_cosine, before_sine])
}

/// The equations of these left sides and the resonant parts of the terms, and the rates that solve them.
pub(super) fn solved(
    subject: &SlowFlowSubject,
    mut step: DerivationStep,
    left_sides: [Formula; 2],
    terms: &[&SmallTerm],
) -> Result<DerivationStep, DerivationError> {
    let compare = |statement: Statement| subject.trials.compare_choices(statement);
    for (wave, left_side) in left_sides.into_iter().enumerate() {
        let mut factors = vec![];
        for term in terms {
            if !subject.read(&term.resonant[wave])?.vanishes() {
                match subject.formula(&term.resonant[wave])? {
                    Formula::Sum(terms) => factors.extend(terms),
                    one => factors.push(one),
                }
            }
        }
        let factor = if factors.is_empty() { number(0) } else { sum(factors) };
        step = step.show(compare(Statement::equal(left_side, factor))?);
    }
    let [rate, turning] = subject.rates()?;
    let (growth, turn) = (subject.amplitude().prime(), subject.phase().prime());
    Ok(step
        .say("Solved for the two rates this is the slow flow,", [])
        .show(compare(Statement::equal(&growth, rate))?)
        .show(compare(Statement::equal(&turn, turning))?))
}

/// The rates as means of the whole force.
fn means(
    subject: &SlowFlowSubject,
    step: DerivationStep,
    terms: &[&SmallTerm],
) -> Result<DerivationStep, DerivationError> {
    let (a, phi) = (subject.amplitude(), subject.phase());
    let f = subject.function(["f", "h", "k"]);
    let mut trials = subject.trials.clone();
    let mut forces = vec![];
    for term in terms {
        forces.push(along(subject, term, 1)?);
    }
    let definition = trials.define_function(f, &["ψ"], sum(forces));
    let (_, q) = subject.flow().resonance.unwrap_or((1, 1));
    let turns = 2 * i64::from(q);
    let mean = |wave: Formula| integral("ψ", 0, number(turns) * Formula::Pi, apply(f, [letter("ψ")]) * wave);
    let below = subject.turns(i64::from(q))?;
    let growth = -(number(1) / below.clone() * mean(sine()));
    let turning = -(number(1) / (below * Formula::from(&a)) * mean(cosine()));
    let turning = match subject.turning()? {
        Some(detuned) => detuned.negated() + turning,
        None => turning,
    };
    let mut equations = vec![];
    for (wave, name, mean) in [(1, a.clone().prime(), growth), (0, phi.prime(), turning)] {
        // An integral that is zero cannot be compared with its size.
        let acts =
            |term: &&SmallTerm| subject.read(&term.resonant[wave]).is_ok_and(|value| !value.vanishes());
        if terms.iter().any(acts) {
            equations.push(trials.compare_choices(Statement::equal(name, mean))?);
        }
    }
    Ok(step
        .say(
            "The same in one formula: a wave is in resonance where its product with {} or {} has a mean. With the sum of all small terms along the motion,",
            [cosine(), sine()],
        )
        .show(definition)
        .say("the rates are", [])
        .show_all(equations))
}
