//! The amplitude and the phase of an oscillator without drive as functions of the time.

use super::super::check::{CheckedEquation, DerivationError};
use super::super::document::DerivationStep;
use super::super::formula::{
    Formula, Name, Statement, call, derivative, letter, ln, number, sqrt, sum, tenths,
};
use super::super::trials::Trials;
use super::subject::SlowFlowSubject;
use libration::algebra::{Function, Rational};
use libration::perturbation::{AmplitudeInTime, PhaseInTime};

pub(super) fn step(subject: &SlowFlowSubject) -> Result<Option<DerivationStep>, DerivationError> {
    let Some(motion) = &subject.steps.in_time else { return Ok(None) };
    let step = DerivationStep::new("in-time", "Amplitude and phase in time");
    if motion.growth.is_none() && motion.constant.is_none() {
        return constant(subject, step).map(Some);
    }
    subject
        .where_real(|trials| {
            let trials = moving(subject, trials)?;
            let step = amplitude(subject, &trials, motion, step.clone())?;
            match &motion.phase {
                Some(phase) => integrated(subject, &trials, phase, step),
                None => Ok(step.say("The phase follows by integrating its rate along this amplitude.", [])),
            }
        })
        .map(Some)
}

/// The choices with an amplitude that changes at its rate.
fn moving(subject: &SlowFlowSubject, mut trials: Trials) -> Result<Trials, DerivationError> {
    trials.let_move(&subject.amplitude());
    // An early time and a small amplitude, for which all powers are positive.
    trials.define(&Name::new("t"), tenths(1))?;
    for name in [subject.amplitude(), start(&subject.amplitude())] {
        trials.define(&name, tenths(3))?;
    }
    let [growth, _] = subject.rates()?;
    trials.with(&subject.amplitude().prime(), growth)
}

/// The value at t = 0.
fn start(name: &Name) -> Name {
    name.clone().word("start")
}

/// The frequency at an amplitude that does not change.
fn constant(subject: &SlowFlowSubject, step: DerivationStep) -> Result<DerivationStep, DerivationError> {
    let [_, turning] = subject.rates()?;
    let (a, phi, psi) = (subject.amplitude(), subject.phase(), Name::new("ψ").prime());
    let frequency = subject.omega0()? + turning.clone();
    let trials = subject.trials.with(&psi, subject.omega0()? + Formula::from(phi.clone().prime()))?;
    Ok(step
        .say("The amplitude {} stays as it is, and the phase grows in proportion to the time:", [(&a).into()])
        .show(CheckedEquation::definition(Statement::equal(
            &phi,
            Formula::from(start(&phi)) + times(&turning, letter("t")),
        )))
        .say("So the frequency of the oscillation depends on its amplitude,", [])
        .show(trials.compare_choices(Statement::equal(psi, frequency))?))
}

/// The solution for the amplitude.
fn amplitude(
    subject: &SlowFlowSubject,
    trials: &Trials,
    motion: &AmplitudeInTime,
    step: DerivationStep,
) -> Result<DerivationStep, DerivationError> {
    let a = subject.amplitude();
    let raised = |name: &Name| match motion.power {
        1 => Formula::from(name),
        power => Formula::from(name).pow(power),
    };
    let [growth, constant, ratio] = [&motion.growth, &motion.constant, &motion.ratio]
        .map(|text| text.as_ref().map(|text| subject.formula(text)).transpose());
    let (growth, constant, ratio) = (growth?, constant?, ratio?);
    let time = letter("t");
    let rate = |of: Formula| {
        sum(growth.iter().map(|factor| times(factor, of.clone())).chain(constant.clone()).collect())
    };
    let first = raised(&start(&a));
    let solution = match (&growth, &constant, ratio) {
        (Some(growth), Some(constant), ratio) => {
            let ratio = ratio.unwrap_or_else(|| constant.clone() / growth.clone());
            (first + ratio.clone()) * exp(times(growth, time)) + opposite(ratio)
        }
        (Some(growth), None, _) => first * exp(times(growth, time)),
        (None, constant, _) => sum([first]
            .into_iter()
            .chain(constant.iter().map(|factor| times(factor, time.clone())))
            .collect()),
    };
    let linear = Statement::equal(derivative(raised(&a), "t"), rate(raised(&a)));
    let formula = if motion.power == 1 { solution.clone() } else { root(solution.clone(), motion.power) };
    let [amplitude_rate, _] = subject.rates()?;
    let solved = trials.with(&a, formula.clone())?;
    let solved =
        solved.compare_choices(Statement::equal(derivative(formula.clone(), "t"), amplitude_rate))?;
    let begin = "at the beginning it is solved by";
    let mut step = match motion.power {
        1 => step.say(
            &format!("The equation for {{}} is linear. With {{}} {begin}"),
            [(&a).into(), start(&a).into()],
        ),
        _ => step
            .say("The equation for {} is linear in {},", [(&a).into(), raised(&a)])
            .show(trials.compare_choices(linear)?)
            .say(&format!("With {{}} {begin}"), [start(&a).into()]),
    };
    step = step.show(CheckedEquation::definition(Statement::equal(raised(&a), solution)));
    if motion.power != 1 {
        let formula = CheckedEquation::definition(Statement::equal(&a, formula));
        step = step.say("so that the amplitude is", []).show(formula);
    }
    if constant.is_some() {
        step = step.say("as long as this is positive.", []);
    }
    Ok(step.say("Put into the equation:", []).show(solved))
}

/// The amplitude from its power.
fn root(of: Formula, power: i64) -> Formula {
    match power {
        -1 => number(1) / of,
        -2 => number(1) / sqrt(of),
        _ => of.pow(Formula::Number(Rational::new(1, power).unwrap_or_else(|| 1.into()))),
    }
}

/// The product, with the sign of the first factor before it.
fn times(factor: &Formula, of: Formula) -> Formula {
    match (factor, &of) {
        (Formula::Negate(factor), _) => -times(factor, of),
        (Formula::Fraction(over, under), Formula::Name(_) | Formula::Power(..)) => {
            Formula::Fraction(Box::new(times(over, of)), under.clone())
        }
        _ => factor.clone() * of,
    }
}

fn opposite(of: Formula) -> Formula {
    match of {
        Formula::Negate(of) => *of,
        of => -of,
    }
}

fn exp(of: Formula) -> Formula {
    call(Function::Exp, of)
}

/// The phase, whose derivative is the second rate.
fn integrated(
    subject: &SlowFlowSubject,
    trials: &Trials,
    phase: &PhaseInTime,
    step: DerivationStep,
) -> Result<DerivationStep, DerivationError> {
    let (a, phi) = (subject.amplitude(), subject.phase());
    let [_, turning] = subject.rates()?;
    let mut integral = vec![];
    let mut differences = vec![Formula::from(start(&phi))];
    for (power, factor) in &phase.powers {
        let factor = subject.formula(factor)?;
        let raised = |name: &Name| Formula::from(name).pow(*power);
        integral.push(times(&factor, raised(&a)));
        differences.push(times(&factor, raised(&a) - raised(&start(&a))));
    }
    if let Some(factor) = &phase.logarithm {
        let factor = subject.formula(factor)?;
        integral.push(times(&factor, ln(&a)));
        differences.push(times(&factor, ln(Formula::from(&a) / Formula::from(start(&a)))));
    }
    if let Some(factor) = &phase.time {
        let linear = times(&subject.formula(factor)?, letter("t"));
        integral.push(linear.clone());
        differences.push(linear);
    }
    if integral.is_empty() {
        return Ok(step.say("The phase {} stays as it is.", [phi.into()]));
    }
    let slope = Statement::equal(derivative(sum(integral), "t"), turning);
    Ok(step
        .say("The phase follows by integration over the time, with the rate of {} in", [(&a).into()])
        .show(trials.compare_choices(slope)?)
        .say("which is the rate of the phase. So", [])
        .show(CheckedEquation::definition(Statement::equal(&phi, sum(differences)))))
}
