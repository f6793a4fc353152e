//! The ansatz for the motion, and the conclusion from a vanishing sum of cosines.

use super::super::check::{CheckedEquation, DerivationError};
use super::super::document::DerivationStep;
use super::super::formula::{
    Formula, Name, Statement, cos, integral, letter, number, order, sin, sum, tenths,
};
use super::super::trials::Trials;
use super::names::{coefficient_name, cosine, harmonic_name};
use super::question::LindstedtQuestion;
use super::substitution::left_side;

fn power_of_epsilon(n: usize) -> Formula {
    if n == 1 { letter("ε") } else { letter("ε").pow(i64::try_from(n).unwrap_or(i64::MAX)) }
}

fn left_out(question: &LindstedtQuestion) -> Formula {
    order(power_of_epsilon(question.order + 1))
}

/// The step that writes the motion as a fundamental with harmonics.
pub fn fundamental_and_harmonics(question: &LindstedtQuestion) -> DerivationStep {
    let omega = || letter("Ω");
    let phase = Statement::defined(letter("τ"), omega() * letter("t"));
    let ratio = Statement::defined(letter("Δ"), omega() / Formula::from(Name::new("ω").index(0)));
    let motion = Statement::equal(left_side(question), 0);
    let cosines = question.harmonics().into_iter().map(|k| match k {
        0 => harmonic_name(0).into(),
        k => Formula::from(harmonic_name(k)) * cosine(k),
    });
    let ansatz = Statement::equal(question.u(), sum(cosines.collect()));
    let step = DerivationStep::new("ansatz", "The ansatz")
        .say(
            "The motion is periodic with a frequency {} that is not known yet. So time is counted in such a way that the period \
             becomes a fixed number,",
            [omega()],
        )
        .show(CheckedEquation::definition(phase))
        .show(CheckedEquation::definition(ratio))
        .say("and with primes now for derivatives with respect to {} the equation of motion is", [letter("τ")])
        .show(CheckedEquation::premise(motion))
        .say("A motion that begins at a turning point is even in {} and a sum of cosines:", [letter("τ")])
        .show(CheckedEquation::definition(ansatz));
    let step = if question.is_odd() {
        step.say("Sines and even multiples are missing, for reasons given below.", [])
    } else {
        step.say("The force is not odd, so that the motion has a constant part and all multiples.", [])
    };
    let step = step.say(
        "The coefficients are power series in a small number {}, which is a measure of the size of the swing and has no \
         other meaning yet. Nothing is known of them but that they vanish with it:",
        [letter("ε")],
    );
    let step = question.harmonics().into_iter().fold(step, |step, k| step.show(harmonic_series(question, k)));
    step.show(frequency_series(question))
}

fn harmonic_series(question: &LindstedtQuestion, k: usize) -> CheckedEquation {
    let terms = question
        .powers()
        .into_iter()
        .map(|n| Formula::from(Name::from(&coefficient_name(k, n))) * power_of_epsilon(n));
    let terms = terms.chain([left_out(question)]).collect();
    CheckedEquation::definition(Statement::equal(harmonic_name(k), sum(terms)))
}

fn frequency_series(question: &LindstedtQuestion) -> CheckedEquation {
    let powers = question.powers().into_iter().filter(|n| *n > 1).map(|n| n - 1);
    let term = |n: usize| {
        let name = Name::new("d").index(i64::try_from(n).unwrap_or(i64::MAX));
        Formula::from(name) * power_of_epsilon(n)
    };
    let next = order(power_of_epsilon(question.order));
    let terms = [number(1)].into_iter().chain(powers.map(term)).chain([next]).collect();
    CheckedEquation::definition(Statement::equal(letter("Δ"), sum(terms)))
}

pub(super) fn projection(question: &LindstedtQuestion) -> Result<DerivationStep, DerivationError> {
    let (j, k, tau) = (|| letter("j"), || letter("k"), || letter("τ"));
    let trials = Trials::new(None)?.with(&Name::new("τ"), tenths(7))?.with(&Name::new("j"), number(3))?;
    let product = Statement::equal(
        cos(j() * tau()) * cos(k() * tau()),
        (cos((j() - k()) * tau()) + cos((j() + k()) * tau())) / 2,
    );
    let sines = Statement::equal(
        sin(j() * tau()) * sin(k() * tau()),
        (cos((j() - k()) * tau()) - cos((j() + k()) * tau())) / 2,
    );
    let whole = |integrand| number(1) / Formula::Pi * integral("τ", 0, 2 * Formula::Pi, integrand);
    let same = Statement::equal(whole(cos(k() * tau()).squared()), 1);
    let cube = Statement::equal(cos(tau()).pow(3), (3 * cos(tau()) + cos(3 * tau())) / 4);
    let step = DerivationStep::new("projection", "Projection on the harmonics")
        .say("Powers of the sum are sums of cosines again, because a product of two is half the sum of two others:", [])
        .show(trials.compare_cases("k", 1..=5, product)?)
        .say("for example", [])
        .show(trials.compare_once(cube)?);
    let step = match question.has_velocity() {
        true => step
            .say(
                "The derivative of {} is {}, so that {} is a sum of sines. Its even powers are sums of cosines too, because",
                [cos(k() * tau()), -(k() * sin(k() * tau())), question.displacement.clone().prime().into()],
            )
            .show(trials.compare_cases("k", 1..=5, sines)?),
        false => step,
    };
    Ok(step
        .say(
            "A sum of cosines vanishes at all times only if the factor of each cosine does. That factor is found by projection: the \
             integral over a period of the sum times {} is zero for all other cosines, and for this one",
            [cos(k() * tau())],
        )
        .show(trials.compare_cases("k", 1..=5, same)?)
        .say(
            "The same holds for the powers of {}. So the equation of motion becomes one condition for each harmonic and each \
             power.",
            [letter("ε")],
        ))
}
