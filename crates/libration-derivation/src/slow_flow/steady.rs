//! Steady states of the slow flow: limit cycles, the elimination of the phase of a drive, stability.

use super::super::check::{CheckedEquation, DerivationError};
use super::super::document::DerivationStep;
use super::super::formula::{Formula, Name, Statement, apply, cos, derivative, number, scaled, sin};
use super::super::trials::Trials;
use super::subject::SlowFlowSubject;
use libration::algebra::Rational;

/// The names of A′ and φ′ as functions of amplitude and phase.
pub(super) fn functions(subject: &SlowFlowSubject) -> [&'static str; 2] {
    [subject.function(["G", "U", "M"]), subject.function(["H", "V", "N"])]
}

/// Defines A′ and φ′ as functions, of the amplitude alone without drive.
pub(super) fn with_functions(
    subject: &SlowFlowSubject,
    mut trials: Trials,
    parameters: &[&str],
) -> Result<Trials, DerivationError> {
    let rates = subject.rates()?;
    for (name, rate) in functions(subject).into_iter().zip(rates) {
        trials.define_function(name, parameters, rate);
    }
    Ok(trials)
}

/// The limit cycle of an oscillator without drive.
pub(super) fn free(subject: &SlowFlowSubject) -> Result<Option<DerivationStep>, DerivationError> {
    let state = &subject.flow().steady_state;
    let Some(amplitude) = &state.cycle_amplitude else { return Ok(None) };
    let [p, q] = functions(subject);
    let a = subject.amplitude();
    let limit = a.clone().index(number(0));
    let value = subject.formula(amplitude)?;
    let rate = || derivative(apply(p, [Formula::from(&a)]), &a.letter);
    let at_limit = |name: &str| apply(name, [Formula::from(&limit)]);
    let step = DerivationStep::new("limit-cycle", "The limit cycle")
        .say(
            "With {} and {} for the right sides of the two equations, which depend on {} alone, the amplitude stays where {} is zero,",
            [apply(p, [Formula::from(&a)]), apply(q, [Formula::from(&a)]), (&a).into(), apply(p, [Formula::from(&a)])],
        );
    let omega = subject.omega0()?;
    let rates = subject.rates()?;
    let is_turning = !subject.read(&subject.flow().phase_rate)?.vanishes();
    subject
        .where_real(|trials| {
            let trials = with_functions(subject, trials, &[&a.letter])?;
            let mut trials = trials.with(&a, value.clone())?;
            let definition = trials.define(&limit, value.clone())?;
            let zero = trials.compare_choices(Statement::equal(rates[0].clone(), 0))?;
            let mut step = step.clone().show(zero).say("This is solved by", []).show(definition);
            if let Some(frequency) = state.cycle_frequency.as_ref().filter(|_| is_turning) {
                let statement = Statement::equal(omega.clone() + at_limit(q), subject.formula(frequency)?);
                step = step.say("The frequency of the cycle is", []).show(trials.compare_choices(statement)?);
            }
            let Some(exponent) = &subject.steps.cycle_exponent else { return Ok(step) };
            let slope = Statement::equal(rate(), subject.formula(&subject.steps.partials[0][0])?)
                .and_equal(subject.formula(exponent)?);
            Ok(step
                .say("A small distance from the cycle grows at the rate that is the derivative there,", [])
                .show(trials.compare_choices(slope)?)
                .say("Where it is negative the cycle attracts its neighbours.", []))
        })
        .map(Some)
}

/// The elimination of the phase.
pub(super) fn driven(
    subject: &SlowFlowSubject,
    trials: &Trials,
) -> Result<Option<DerivationStep>, DerivationError> {
    let state = &subject.flow().steady_state;
    let Some(relation) = &state.relation else { return Ok(None) };
    let (a, phi) = (subject.amplitude(), subject.phase());
    let mut step = DerivationStep::new("steady-states", "Steady states").say(
        "Where an amplitude that is not zero and its phase stay as they are, {} and {} are zero. The motion then has the period of the drive, or a multiple of it.",
        [a.clone().prime().into(), phi.clone().prime().into()],
    );
    match &state.phase {
        Some((m, parts)) => {
            let angle = || scaled(&Rational::from(i64::try_from(*m).unwrap_or(1)), Formula::from(&phi));
            let [cosine, sine] = parts;
            let cosine = Statement::equal(cos(angle()), subject.formula(cosine)?);
            let sine = Statement::equal(sin(angle()), subject.formula(sine)?);
            step = step
                .say("Both equations are linear in sine and cosine of the phase, and give", [])
                .show(trials.compare_choices(cosine)?)
                .show(trials.compare_choices(sine)?)
                .say(
                    "The sum of their squares is one. Without common factors this is the relation of amplitude and detuning, on which all steady states are:",
                    [],
                );
        }
        None => {
            step = step.say(
                "Sines and cosines of several multiples of the phase occur. Both equations become polynomials in {}, and their resultant, which vanishes where they have a common zero, is the relation of \
                 amplitude and detuning:",
                [super::super::formula::call(
                    libration::algebra::Function::Exp,
                    Formula::from(Name::new("i")) * Formula::from(&phi),
                )],
            );
        }
    }
    let zero = Statement::equal(subject.formula(relation)?, 0);
    Ok(Some(
        step.show(trials.compare_choices(zero)?)
            .say("Its left side is called {} below.", [relation_at(subject, relation_name(subject))]),
    ))
}

/// The name of the relation.
pub(super) fn relation_name(subject: &SlowFlowSubject) -> &'static str {
    subject.function(["R", "S", "K"])
}

pub(super) fn define_relation(
    subject: &SlowFlowSubject,
    trials: &mut Trials,
    relation: &str,
) -> Result<CheckedEquation, DerivationError> {
    let letters = [subject.amplitude().letter, subject.detuning().letter];
    let parameters = letters.each_ref().map(String::as_str);
    Ok(trials.define_function(relation_name(subject), &parameters, subject.formula(relation)?))
}

/// R(A, σ).
pub(super) fn relation_at(subject: &SlowFlowSubject, r: &str) -> Formula {
    apply(r, [subject.amplitude().into(), subject.detuning().into()])
}

/// Trace and determinant of the Jacobian.
pub(super) fn stability(
    subject: &SlowFlowSubject,
    trials: &Trials,
) -> Result<Option<DerivationStep>, DerivationError> {
    let state = &subject.flow().steady_state;
    let (Some(trace), Some(determinant)) = (&state.trace, &state.determinant) else { return Ok(None) };
    // A linear equation is steady at every amplitude.
    if determinant == "0" {
        return Ok(None);
    }
    let (a, phi) = (subject.amplitude(), subject.phase());
    let parameters = [&*a.letter, &*phi.letter];
    let [anywhere, trials] = [
        with_functions(subject, subject.trials.clone(), &parameters)?,
        with_functions(subject, trials.clone(), &parameters)?,
    ];
    let at = |name: &str| apply(name, [Formula::from(&a), Formula::from(&phi)]);
    let [p, q] = functions(subject);
    let partial = |name: &str, by: &Name| derivative(at(name), &by.letter);
    let mut step = DerivationStep::new("stability", "Stability").say(
        "Close to a steady state the deviations of {} and {} obey linear equations, whose coefficients are the derivatives of the right sides of the slow flow, here called {} and {}:",
        [(&a).into(), (&phi).into(), at(p), at(q)],
    );
    for (name, row) in [p, q].into_iter().zip(&subject.steps.partials) {
        for (by, text) in [&a, &phi].into_iter().zip(row) {
            let statement = Statement::equal(partial(name, by), subject.formula(text)?);
            step = step.show(anywhere.compare_choices(statement)?);
        }
    }
    let sum = Statement::equal(partial(p, &a) + partial(q, &phi), subject.formula(trace)?);
    let minor = partial(p, &a) * partial(q, &phi) - partial(p, &phi) * partial(q, &a);
    let minor = Statement::equal(minor, subject.formula(determinant)?);
    let step = step
        .say(
            "Deviations decay if the trace of these coefficients is negative and their determinant positive. In steady states sine and cosine of the phase have the values found above, so that the trace is",
            [],
        )
        .show(trials.compare_choices(sum)?)
        .say("and the determinant", [])
        .show(trials.compare_choices(minor)?);
    Ok(Some(match subject.steps.curve {
        Some(_) => step.say("It changes its sign at the folds of the response curve.", []),
        None => step,
    }))
}
