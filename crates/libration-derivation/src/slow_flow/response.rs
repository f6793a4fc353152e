//! The response curve: backbone, peak, folds and the drive at which they appear.

use super::super::check::{CheckedEquation, DerivationError};
use super::super::document::DerivationStep;
use super::super::formula::{Formula, Statement, call, derivative, letter, number, sqrt};
use super::super::trials::Trials;
use super::steady::{define_relation, relation_at, relation_name};
use super::subject::SlowFlowSubject;
use libration::algebra::Function;
use libration::expression::{Expression, Symbol};

pub(super) fn curve(subject: &SlowFlowSubject) -> Result<Option<DerivationStep>, DerivationError> {
    let (Some(relation), Some(curve)) = (&subject.flow().steady_state.relation, &subject.steps.curve) else {
        return Ok(None);
    };
    let step = DerivationStep::new("response-curve", "The response curve");
    let step = ridge(subject, relation, step)?;
    let r = relation_name(subject);
    let a = subject.amplitude();
    let mut trials = subject.trials.clone();
    define_relation(subject, &mut trials, relation)?;
    let [factor, rest] = &curve.slope;
    let slope = match factor.as_str() {
        "1" => subject.formula(rest)?,
        _ => subject.formula(factor)? * subject.formula(rest)?,
    };
    let slope = Statement::equal(derivative(relation_at(subject, r), &a.letter), slope);
    let step = step
        .say("The curve turns back, with a vertical tangent over the detuning, where {} does not change with {}:", [letter(r), (&a).into()])
        .show(trials.compare_choices(slope)?)
        .say("These folds, where the last factor is zero as well as {}, are the ends of jumps between a large and a small amplitude.", [relation_at(subject, r)]);
    critical(subject, relation, step).map(Some)
}

/// The backbone and the peak.
fn ridge(
    subject: &SlowFlowSubject,
    relation: &str,
    step: DerivationStep,
) -> Result<DerivationStep, DerivationError> {
    let state = &subject.flow().steady_state;
    let ridge = subject.steps.curve.as_ref().and_then(|curve| curve.ridge.as_ref());
    let (Some([curvature, rest]), Some(backbone)) = (ridge, &state.backbone) else { return Ok(step) };
    let (r, sigma) = (relation_name(subject), subject.detuning());
    let middle = sigma.clone().index(number(0));
    let mut trials = subject.trials.clone();
    define_relation(subject, &mut trials, relation)?;
    let backbone = subject.formula(backbone)?;
    let definition = trials.define(&middle, backbone.clone())?;
    let square = (Formula::from(&sigma) - Formula::from(&middle)).squared();
    let curvature = subject.read(curvature)?;
    let square = match curvature.to_rational() {
        Some(one) if one == 1.into() => square,
        _ => subject.written(&curvature) * square,
    };
    let statement = Statement::equal(relation_at(subject, r), square + subject.formula(rest)?);
    let step = step
        .say("In the detuning the relation is of the second degree. With the middle between its two solutions,", [])
        .show(definition)
        .say("the square is completed:", [])
        .show(trials.compare_choices(statement)?)
        .say(
            "For each amplitude there are two detunings at the same distance from {}, where the last part is negative. As a function of {} their middle is the backbone of the curve.",
            [(&middle).into(), subject.amplitude().into()],
        );
    let Some(peak) = &state.peak_amplitude else { return Ok(step) };
    let detuning = state.peak_detuning.as_ref().map(|text| subject.formula(text)).transpose()?;
    let [peak, rest] = [subject.formula(peak)?, subject.formula(rest)?];
    let name = subject.amplitude().word("max");
    subject.where_real(|mut trials| {
        let defined = trials.define(&name, peak.clone())?;
        let trials = trials.with(&subject.amplitude(), peak.clone())?;
        let zero = trials.compare_choices(Statement::equal(rest.clone(), 0))?;
        let step = step
            .clone()
            .say("At the largest amplitude both are the same, and the last part is zero,", [])
            .show(zero)
            .say("so that the largest amplitude is", [])
            .show(defined);
        let Some(detuning) = &detuning else { return Ok(step) };
        let on_backbone = trials.compare_choices(Statement::equal(backbone.clone(), detuning.clone()))?;
        Ok(step.say("with the detuning of the backbone there,", []).show(on_backbone))
    })
}

/// The drive at which folds appear.
fn critical(
    subject: &SlowFlowSubject,
    relation: &str,
    step: DerivationStep,
) -> Result<DerivationStep, DerivationError> {
    let state = &subject.flow().steady_state;
    let Some(curve) = &subject.steps.curve else { return Ok(step) };
    let (Some([bend, rate]), Some(amplitude), Some(value)) =
        (&curve.cubic, &state.drive_amplitude, &state.critical_drive)
    else {
        return Ok(step);
    };
    let read = subject.read(relation)?;
    let drive = squared_drive(&read, &subject.read(amplitude)?);
    let Some(drive) = drive else { return Ok(step) };
    let names = [
        subject.free_letter([("beta", "β"), ("kappa", "κ")]),
        subject.free_letter([("delta", "δ"), ("gamma", "γ")]),
    ];
    let [b, delta] = names.each_ref().map(Formula::from);
    let step = step
        .say(
            "Weak drives have no folds. With the bend {} of the backbone and the rate of decay {},",
            [b.clone(), delta.clone()],
        )
        .show(CheckedEquation::definition(Statement::defined(&names[0], subject.formula(bend)?)))
        .show(CheckedEquation::definition(Statement::defined(&names[1], subject.formula(rate)?)));
    let [amplitude, value] = [subject.formula(amplitude)?, subject.formula(value)?];
    let threshold = Statement::equal(amplitude, value);
    subject.where_real(|mut trials| {
        trials.define(&names[0], subject.formula(bend)?)?;
        trials.define(&names[1], subject.formula(rate)?)?;
        let at = |value: i64| subject.written(&read.substitute(&drive, &Expression::from(value)));
        let size = || call(Function::Abs, b.clone());
        let cusp = [
            sqrt(2 * delta.clone() / (sqrt(number(3)) * size())),
            sqrt(number(3)) * delta.clone() * b.clone() / size(),
        ];
        let step = two_folds(subject, &trials, step.clone(), [&b, &delta])?;
        let mut here = trials.with(&subject.amplitude(), cusp[0].clone())?;
        here.define(&subject.detuning(), cusp[1].clone())?;
        here.define(&subject.name(&drive.name), sqrt(-at(0) / (at(1) - at(0))))?;
        let zero = here.compare_choices(Statement::equal(subject.formula(relation)?, 0))?;
        let flat = here.compare_choices(Statement::equal(subject.formula(&curve.slope[1])?, 0))?;
        let [a, s] = cusp;
        Ok(step
            .say(
                "is positive for a detuning beyond {} on the side to which the backbone bends. Both folds begin at its end, where {} is {} and {} is {}. There the condition of the folds is met,",
                [sqrt(number(3)) * delta.clone(), subject.detuning().into(), s, subject.amplitude().into(), a],
            )
            .show(flat)
            .say("and the relation itself,", [])
            .show(zero)
            .say("for one strength of the drive alone. Stronger drives make jumps:", [])
            .show(here.compare_choices(threshold.clone())?))
    })
}

/// The symbol of the drive's amplitude of which the relation contains the square alone.
fn squared_drive(relation: &Expression, amplitude: &Expression) -> Option<Symbol> {
    let is_squared = |symbol: &Symbol| {
        let slope = relation.derivative(symbol).substitute(symbol, &Expression::from(0)).simplified();
        relation.polynomial_degree(std::slice::from_ref(symbol)) == Some(2) && slope.vanishes()
    };
    amplitude.symbols().into_iter().find(is_squared)
}

/// The condition of the folds as a polynomial of the second degree in A².
fn two_folds(
    subject: &SlowFlowSubject,
    trials: &Trials,
    step: DerivationStep,
    [b, delta]: [&Formula; 2],
) -> Result<DerivationStep, DerivationError> {
    let (b, delta) = (|| b.clone(), || delta.clone());
    let (s, a) = (|| Formula::from(subject.detuning()), || Formula::from(subject.amplitude()));
    let factors = (s() - b() * a().squared()) * (s() - 3 * b() * a().squared()) + delta().squared();
    let expanded =
        3 * b().squared() * a().pow(4) - 4 * b() * s() * a().squared() + s().squared() + delta().squared();
    let discriminant = Statement::equal(
        (4 * b() * s()).squared() - 12 * b().squared() * (s().squared() + delta().squared()),
        4 * b().squared() * (s().squared() - 3 * delta().squared()),
    );
    Ok(step
        .say("the folds are, up to a factor, the zeros of", [])
        .show(trials.compare_choices(Statement::equal(factors, expanded))?)
        .say("a polynomial of the second degree in {}, whose discriminant", [a().squared()])
        .show(trials.compare_choices(discriminant)?))
}
