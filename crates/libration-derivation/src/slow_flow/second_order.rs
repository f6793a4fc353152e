//! The order after the first: the waves that the small terms force, the products of the rates, and the changes of the small terms.

use super::super::check::{CheckedEquation, DerivationError};
use super::super::document::DerivationStep;
use super::super::formula::{Formula, Name, Statement, apply, cos, derivative, number, sin, sum};
use super::super::prose::Prose;
use super::small_terms::one_term;
use super::steady::{functions, with_functions};
use super::subject::{SlowFlowSubject, cosine};
use libration::perturbation::EarlierOrder;

/// The waves of other frequencies that the small terms force; `None` if there are none.
pub(super) fn forced_waves(
    subject: &SlowFlowSubject,
    before: &EarlierOrder,
) -> Result<Option<DerivationStep>, DerivationError> {
    let [waves, _] = &before.motion[1];
    if waves.is_empty() {
        return Ok(None);
    }
    let [displacement, change] = before.names.each_ref().map(|name| subject.name(name));
    let slope = subject.formula(&before.wave_velocity[1])?;
    let turned = |of: Formula| subject.times_omega0(1, 1, derivative(of, "ψ"));
    let derived = turned(subject.formula(waves)?)?;
    let is_velocity = before.products.is_none() && changes_velocity(before);
    let velocity = match is_velocity {
        true => Statement::equal(&change, derived).and_equal(slope.clone()),
        false => Statement::equal(derived, slope.clone()),
    };
    let spring = subject.times_omega0(1, 2, Formula::from(&displacement))?;
    let forcing = subject.formula(&before.forcing[1])?;
    let balance = Statement::equal(turned(bracketed(slope))? + spring, forcing);
    let definition = Statement::defined(&displacement, subject.formula(&before.motion[0][0])?);
    let nu = Name::new("ν");
    let step = DerivationStep::new("forced-waves", "The waves that the small terms force")
        .say(
            "The waves of the small terms that have other frequencies force small waves of the same frequencies, the first of those that the dots stand for. The answer to a wave of the frequency {} has \
             its form, and its amplitude divided by {}. Together they are",
            [Formula::from(&nu), subject.omega0_squared()? - Formula::from(&nu).squared()],
        )
        .show(CheckedEquation::definition(definition))
        .say(
            "Amplitude and phase change slowly, and {} grows at the rate {}, both but for smaller parts. So the derivative of these waves is",
            [Formula::from(Name::new("ψ")), subject.omega0()?],
        )
        .show(subject.trials.compare_choices(velocity)?)
        .say("and with their second derivative they obey the equation of motion, with what forces them on its right side:", [])
        .show(subject.trials.compare_choices(balance)?);
    Ok(Some(step))
}

/// `true` if terms change with the velocity.
fn changes_velocity(before: &EarlierOrder) -> bool {
    before.changes.iter().any(|term| term.force[0].contains(&before.names[1]))
}

fn bracketed(formula: Formula) -> Formula {
    match formula {
        Formula::Sum(_) => formula,
        one => Formula::Sum(vec![one]),
    }
}

/// The products of the rates that the lowest order leaves out, and the change of the velocity.
pub(super) fn products(
    subject: &SlowFlowSubject,
    first: &SlowFlowSubject,
    before: &EarlierOrder,
) -> Result<Option<DerivationStep>, DerivationError> {
    let Some(products) = &before.products else { return Ok(None) };
    let (a, phi, psi) = (first.amplitude(), first.phase(), Name::new("ψ"));
    let is_turned = first.depends_on_phase()?;
    let parameters = [&*a.letter, &*phi.letter];
    let parameters = if is_turned { &parameters[..] } else { &parameters[..1] };
    let mut trials = with_functions(first, subject.trials.clone(), parameters)?;
    let names = functions(first);
    let at = |name: &str| match is_turned {
        true => apply(name, [Formula::from(&a), Formula::from(&phi)]),
        false => apply(name, [Formula::from(&a)]),
    };
    let [growth, turn] = names.map(at);
    let chained = |name: &str| {
        let along = derivative(at(name), &a.letter) * growth.clone();
        match is_turned {
            true => along + derivative(at(name), &phi.letter) * turn.clone(),
            false => along,
        }
    };
    let excess = match first.turning()? {
        Some(turning) => bracketed(turning + turn.clone()),
        None => turn.clone(),
    };
    let (one, two) = (|name: &Name| name.clone().prime(), |name: &Name| name.clone().prime().prime());
    let omega = subject.omega0()?;
    let detuned = bracketed(Formula::from(one(&psi)) - omega.clone());
    let [a_itself, growing] = [Formula::from(&a), Formula::from(one(&a))];
    let in_phase = Formula::from(two(&a)) - a_itself.clone() * detuned.clone().squared();
    let across = number(2) * growing * detuned + a_itself.clone() * Formula::from(two(&psi));
    let mut step = DerivationStep::new("products", "The products of the rates").say(
        "In the next order the products count that the left side of the equation of motion left out: {} in front of {}, and {} with a minus in front of {}. With {} and {} for the right sides just found, \
         the chain rule gives the second derivatives",
        [in_phase.clone(), cosine(), across.clone(), sin(Name::new("ψ")), growth.clone(), turn.clone()],
    );
    for (second, name) in [two(&a), two(&psi)].iter().zip(names) {
        trials.define(second, chained(name))?;
        step = step.show(CheckedEquation::definition(Statement::equal(second, chained(name))));
    }
    let difference = first.formula(&products.excess)?;
    let at_first =
        trials.with(&one(&a), growth.clone())?.with(&one(&psi), omega.clone() + difference.clone())?;
    if difference != excess {
        let rate = Statement::equal(Formula::from(one(&psi)) - omega, excess.clone()).and_equal(difference);
        step = step
            .say("The difference of the phase is by the definition of its detuning", [])
            .show(at_first.compare_choices(rate)?);
    }
    step = step.say("So the products are", []);
    for (side, product) in [(in_phase, &products.in_phase), (across, &products.across)] {
        step = step.show(at_first.compare_choices(Statement::equal(side, first.formula(product)?))?);
    }
    let [_, change] = &before.motion[1];
    if change.is_empty() || !changes_velocity(before) {
        return Ok(Some(step));
    }
    let mut changes = vec![growth * cos(&psi), -(a_itself * excess * sin(&psi))];
    if !before.wave_velocity[1].is_empty() {
        match subject.formula(&before.wave_velocity[1])? {
            Formula::Sum(terms) => changes.extend(terms),
            term => changes.push(term),
        }
    }
    let velocity =
        Statement::equal(subject.name(&before.names[1]), sum(changes)).and_equal(subject.formula(change)?);
    Ok(Some(
        step.say("The same rates change the velocity, besides the forced waves, by", [])
            .show(trials.compare_choices(velocity)?),
    ))
}

/// The changes of the small terms, and the terms that are of this order themselves.
pub(super) fn changed_terms(
    subject: &SlowFlowSubject,
    before: &EarlierOrder,
) -> Result<DerivationStep, DerivationError> {
    let changes = [(0, "the displacement"), (1, "the velocity")];
    let is_changed = [!before.motion[0][0].is_empty(), changes_velocity(before)];
    let mut added = Prose::text(
        "Each small term of the first order changes by its derivatives times the changes of what is in it",
    );
    for (which, of) in changes.into_iter().filter(|(which, _)| is_changed[*which]) {
        let name = Formula::from(subject.name(&before.names[which]));
        added = added.and(Prose::new(&format!(", {{}} of {of}"), [name]));
    }
    let added = added.and(Prose::text(". Products of waves become sums of waves as before."));
    let mut step =
        DerivationStep::new("second-terms", "The small terms to the second order").paragraph(added);
    for term in before.changes.iter().chain(&subject.steps.terms) {
        step = one_term(subject, step, term)?;
    }
    Ok(step)
}
