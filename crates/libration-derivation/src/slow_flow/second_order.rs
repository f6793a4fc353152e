//! The order after the first: the waves that the small terms force, the products of the rates, and the changes of the small terms.

use super::super::check::{CheckedEquation, DerivationError};
use super::super::document::DerivationStep;
use super::super::formula::{Formula, Name, Statement, apply, cos, derivative, number, sin, sum};
use super::super::prose::Prose;
use super::super::trials::Trials;
use super::small_terms::{left_sides, one_term, solved};
use super::steady::{functions, with_functions};
use super::subject::{SlowFlowSubject, cosine};
use libration::perturbation::{EarlierOrder, RateProducts, SmallTerm};

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
    let is_velocity = before.products.is_none() && changes_velocity(subject, before)?;
    let velocity = match is_velocity {
        true => Statement::equal(&change, derived).and_equal(slope.clone()),
        false => Statement::equal(derived, slope.clone()),
    };
    let spring = subject.times_omega0(1, 2, Formula::from(&displacement))?;
    let forcing = subject.formula(&before.forcing[1])?;
    let balance = Statement::equal(turned(slope)? + spring, forcing);
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
fn changes_velocity(subject: &SlowFlowSubject, before: &EarlierOrder) -> Result<bool, DerivationError> {
    for term in &before.changes {
        if subject.read(&term.force[0])?.symbols().into_iter().any(|symbol| symbol.name == before.names[1]) {
            return Ok(true);
        }
    }
    Ok(false)
}

/// The right sides of the slow flow of the first order as functions of amplitude and phase, or of the amplitude if they contain no phase.
struct FirstRates<'a> {
    first: &'a SlowFlowSubject,
    /// Values of all symbols of both orders, and the functions.
    trials: Trials,
    /// ∂/∂A and ∂/∂φ, as far as they are not zero, with the rates of both.
    directions: Vec<(Name, Formula)>,
    at: [Formula; 2],
}

impl<'a> FirstRates<'a> {
    fn new(subject: &SlowFlowSubject, first: &'a SlowFlowSubject) -> Result<Self, DerivationError> {
        let mut names = vec![first.amplitude()];
        if first.depends_on_phase()? {
            names.push(first.phase());
        }
        let parameters: Vec<&str> = names.iter().map(|name| &*name.letter).collect();
        let trials = with_functions(first, subject.trials.clone(), &parameters)?;
        let at = functions(first).map(|name| match &names[..] {
            [a, phi] => apply(name, [Formula::from(a), Formula::from(phi)]),
            _ => apply(name, [Formula::from(&names[0])]),
        });
        let directions = names.into_iter().zip(at.clone()).collect();
        Ok(Self { first, trials, directions, at })
    }

    /// The derivative of one of both with respect to the time, by the chain rule.
    fn derived(&self, of: &Formula) -> Formula {
        let along = |(name, rate): &(Name, Formula)| derivative(of.clone(), &name.letter) * rate.clone();
        sum(self.directions.iter().map(along).collect())
    }
}

/// The products of the rates that the lowest order leaves out, and the change of the velocity.
pub(super) fn rate_products(
    subject: &SlowFlowSubject,
    first: &SlowFlowSubject,
    (before, products): (&EarlierOrder, &RateProducts),
) -> Result<DerivationStep, DerivationError> {
    let mut rates = FirstRates::new(subject, first)?;
    let [growth, turn] = rates.at.clone();
    let (a, psi) = (first.amplitude(), Name::new("ψ"));
    let (one, two) = (|name: &Name| name.clone().prime(), |name: &Name| name.clone().prime().prime());
    let omega = subject.omega0()?;
    let detuned = Formula::from(one(&psi)) - omega.clone();
    let in_phase = Formula::from(two(&a)) - Formula::from(&a) * detuned.clone().squared();
    let across =
        number(2) * Formula::from(one(&a)) * detuned.clone() + Formula::from(&a) * Formula::from(two(&psi));
    let mut step = DerivationStep::new("products", "The products of the rates").say(
        "In the next order the products count that the left side of the equation of motion left out: {} in front of {}, and {} with a minus in front of {}. With {} and {} for the right sides just found, \
         the chain rule gives the second derivatives",
        [in_phase.clone(), cosine(), across.clone(), sin(Name::new("ψ")), growth.clone(), turn.clone()],
    );
    for (second, rate) in [two(&a), two(&psi)].iter().zip(&rates.at) {
        let derived = rates.derived(rate);
        rates.trials.define(second, derived.clone())?;
        step = step.show(CheckedEquation::definition(Statement::equal(second, derived)));
    }
    let excess = first.excess(turn)?;
    let difference = first.formula(&products.excess)?;
    let at_first = rates.trials.with(&one(&a), growth)?.with(&one(&psi), omega + difference.clone())?;
    if difference != excess {
        let rate = Statement::equal(detuned, excess).and_equal(difference);
        step = step
            .say("The difference of the phase is by the definition of its detuning", [])
            .show(at_first.compare_choices(rate)?);
    }
    step = step.say("So the products are", []);
    for (side, product) in [(in_phase, &products.in_phase), (across, &products.across)] {
        step = step.show(at_first.compare_choices(Statement::equal(side, first.formula(product)?))?);
    }
    velocity_change(subject, before, &rates, step)
}

/// The change of the velocity by the rates of the first order and the forced waves, if a small term contains the velocity.
fn velocity_change(
    subject: &SlowFlowSubject,
    before: &EarlierOrder,
    rates: &FirstRates<'_>,
    step: DerivationStep,
) -> Result<DerivationStep, DerivationError> {
    let [_, change] = &before.motion[1];
    if change.is_empty() || !changes_velocity(subject, before)? {
        return Ok(step);
    }
    let [growth, turn] = rates.at.clone();
    let psi = Name::new("ψ");
    let excess = rates.first.excess(turn)?;
    let mut changes = vec![growth * cos(&psi), -(Formula::from(subject.amplitude()) * excess * sin(&psi))];
    if !before.wave_velocity[1].is_empty() {
        match subject.formula(&before.wave_velocity[1])? {
            Formula::Sum(terms) => changes.extend(terms),
            term => changes.push(term),
        }
    }
    let name = subject.name(&before.names[1]);
    let velocity = Statement::equal(name, sum(changes)).and_equal(subject.formula(change)?);
    Ok(step
        .say("The same rates change the velocity, besides the forced waves, by", [])
        .show(rates.trials.compare_choices(velocity)?))
}

/// The slow flow by the terms of both orders, with the products of the rates.
pub(super) fn averaged(
    subject: &SlowFlowSubject,
    terms: &[&SmallTerm],
    products: &RateProducts,
) -> Result<DerivationStep, DerivationError> {
    let [mut before_cosine, mut before_sine] = left_sides(subject)?;
    let [in_phase, across] = [subject.read(&products.in_phase)?, subject.read(&products.across)?];
    if !in_phase.vanishes() {
        before_cosine = before_cosine + subject.written(&in_phase);
    }
    if !across.vanishes() {
        before_sine = before_sine + subject.written(&across).negated();
    }
    let step = DerivationStep::new("second-slow-flow", "The slow flow to the second order").say(
        "With these products on the left, and the small terms of both orders on the right, {} has the same factor on both sides, and so has {}:",
        [cosine(), sin(Name::new("ψ"))],
    );
    solved(subject, step, [before_cosine, before_sine], terms)
}

/// The changes of the small terms, and the terms that are of this order themselves.
pub(super) fn changed_terms(
    subject: &SlowFlowSubject,
    before: &EarlierOrder,
) -> Result<DerivationStep, DerivationError> {
    let changes = [(0, "the displacement"), (1, "the velocity")];
    let is_changed = [!before.motion[0][0].is_empty(), changes_velocity(subject, before)?];
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
