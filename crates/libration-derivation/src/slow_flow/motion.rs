//! The equation of motion, the ansatz, and its derivatives to the lowest order.

use super::super::check::{CheckedEquation, DerivationError, Given, chosen, same_series_for_choices};
use super::super::document::DerivationStep;
use super::super::formula::{
    Formula, Name, Statement, cos, derivative, letter, number, order, scaled, sin, sum, tenths,
};
use super::super::prose::Prose;
use super::super::trials::Trials;
use super::subject::{SlowFlowSubject, cosine};

pub(super) fn equation_of_motion(subject: &SlowFlowSubject) -> Result<DerivationStep, DerivationError> {
    let x = subject.variable();
    let second = Formula::from(x.clone().prime().prime());
    let acceleration = subject.written(&subject.equation.accelerations()[0]);
    let mut step = DerivationStep::new("equation-of-motion", "The equation of motion")
        .say(
            "The oscillator is given by its equation of motion, with a prime for a derivative with respect to the time {}:",
            [letter("t")],
        )
        .show(CheckedEquation::premise(Statement::equal(second.clone(), acceleration.clone())))
        .paragraph(smallness(subject));
    if let (Some(name), Some(value)) =
        (subject.meaning("natural_frequency"), subject.meaning("natural_frequency_value"))
    {
        let name = subject.name(name);
        step = step
            .say("The frequency of small free oscillations is", [])
            .show(CheckedEquation::definition(Statement::defined(name, subject.formula(value)?)));
    }
    let left = second + subject.times_omega0(1, 2, Formula::from(&x))?;
    let mut terms = vec![];
    if !subject.steps.drive.is_empty() {
        terms.push(subject.formula(&subject.steps.drive)?);
    }
    let before = subject.steps.before.iter().flat_map(|before| &before.terms);
    for term in before.chain(&subject.steps.terms) {
        terms.push(subject.formula(&term.force[0])?);
    }
    let moved = subject.to_lowest_order(Statement::equal(left, sum(terms)), &acceleration)?;
    step = step.say("With the linear spring on the left side alone it is", []).show(moved);
    let (Some(drive), Some(value)) = (subject.drive()?, &subject.flow().drive_frequency) else {
        return Ok(step);
    };
    let (p, q) = subject.flow().resonance.unwrap_or((1, 1));
    let resonant = scaled(&subject.resonance(), subject.omega0()?);
    Ok(step
        .say(
            &format!(
                "The frequency {{}} of the drive is close to {{}}, the resonance {p}:{q} of drive and oscillation. The difference is measured by the detuning {{}}:"
            ),
            [drive.clone(), resonant, subject.detuning().into()],
        )
        .show(CheckedEquation::definition(Statement::equal(drive, subject.formula(value)?))))
}

/// The sentences about the orders of the terms.
fn smallness(subject: &SlowFlowSubject) -> Prose {
    let small = |name: &str| Formula::from(subject.name(name));
    let has_two_orders = !subject.steps.has_one_order;
    match (subject.small.as_slice(), subject.steps.is_by_amplitude) {
        ([], _) => Prose::text(
            "The nonlinear terms are small because the amplitude is: a term of the third degree is smaller than the linear one by the square of the amplitude.",
        ),
        ([(name, _)], false) if has_two_orders => Prose::new(
            "Terms with {} are small. What follows is to the second power of {}.",
            [small(name), small(name)],
        ),
        ([(name, _)], false) => Prose::new(
            "Terms with {} are small. What follows is to the lowest power of {} that changes amplitude or phase.",
            [small(name), small(name)],
        ),
        (all, by_amplitude) => {
            let mut prose = Prose::text("Small parameters are ");
            for (index, (name, order)) in all.iter().enumerate() {
                let comma = if index > 0 { ", " } else { "" };
                prose = prose.and(Prose::text(comma)).and(Prose::formula(small(name)));
                if all.iter().any(|(_, other)| *other != 1) {
                    prose = prose.and(Prose::text(format!(" of order {order}")));
                }
            }
            let amplitude = match by_amplitude {
                true => {
                    "; the nonlinear terms without them are small because the amplitude is, a term of the third degree by the square of the amplitude"
                }
                false => "",
            };
            let order = match (has_two_orders, by_amplitude) {
                (true, _) => "highest of these orders, or that of products of two terms",
                (false, true) => "lowest order",
                (false, false) => "lowest order that changes amplitude or phase",
            };
            let rest = format!("{amplitude}. What follows is to the {order}.");
            prose.and(Prose::text(rest))
        }
    }
}

pub(super) fn ansatz(subject: &SlowFlowSubject) -> Result<DerivationStep, DerivationError> {
    let (x, a, phi) = (subject.variable(), subject.amplitude(), subject.phase());
    let [position, velocity] = &subject.steps.motion[0];
    let psi = Statement::defined(letter("ψ"), subject.angle()?);
    let position = Statement::equal(&x, subject.formula(position)? + letter("…"));
    let velocity = Statement::equal(x.clone().prime(), subject.formula(velocity)? + letter("…"));
    let step = DerivationStep::new("ansatz", "The ansatz");
    let step = match subject.steps.drive.is_empty() {
        true => step.say(
            "Without the small terms the motion is {} with constant amplitude {} and constant phase {}. With them both change slowly, and small waves of other frequencies are added, which the dots \
             stand for:",
            [Formula::from(&a) * cosine(), (&a).into(), (&phi).into()],
        ),
        false => step.say(
            "The drive is not small, and without the small terms the motion is the sum of a free oscillation with constant amplitude {} and constant phase {}, and of the forced motion, which follows \
             the drive. With them both change slowly, and small waves of other frequencies are added, which the dots stand for:",
            [(&a).into(), (&phi).into()],
        ),
    };
    let mut step = step
        .show(CheckedEquation::definition(position))
        .show(CheckedEquation::definition(psi))
        .say("{} is the whole amplitude of the part with the phase {}.", [(&a).into(), letter("ψ")]);
    if !subject.steps.drive.is_empty() {
        let square = subject.omega0_squared()?;
        let slower = scaled(&subject.resonance(), subject.omega0()?).squared();
        let forced = Formula::from(&x) - Formula::from(&a) * cosine();
        let statement = Statement::equal((square - slower) * forced, subject.formula(&subject.steps.drive)?);
        step = step
            .say(
                "The forced motion is what is left of {} without {}. Its second derivative takes down the factor {} with a minus, so that the equation of motion without small terms demands, with the small detuning left out,",
                [(&x).into(), Formula::from(&a) * cosine(), scaled(&subject.resonance(), subject.omega0()?).squared()],
            )
            .show(subject.trials.compare_choices(statement)?);
    }
    Ok(step
        .say("Where the velocity stands in a small term, its lowest order is enough:", [])
        .show(CheckedEquation::definition(velocity)))
}

pub(super) fn derivatives(subject: &SlowFlowSubject) -> Result<DerivationStep, DerivationError> {
    let (a, psi) = (subject.amplitude(), Name::new("ψ"));
    let primed =
        |name: &Name, primes: usize| Formula::from((0..primes).fold(name.clone(), |name, _| name.prime()));
    let trials = moving([&a, &psi])?;
    let (zero, one, two) =
        (|name: &Name| primed(name, 0), |name: &Name| primed(name, 1), |name: &Name| primed(name, 2));
    let velocity = || one(&a) * cos(&psi) - zero(&a) * one(&psi) * sin(&psi);
    let inner = || two(&a) - zero(&a) * one(&psi).squared();
    let outer = || number(2) * one(&a) * one(&psi) + zero(&a) * two(&psi);
    let acceleration = || inner() * cos(&psi) - outer() * sin(&psi);
    let first = Statement::equal(derivative(zero(&a) * cosine(), "t"), velocity());
    let second = Statement::equal(derivative(velocity(), "t"), acceleration());
    let [first, second] = [trials.compare_choices(first)?, trials.compare_choices(second)?];
    let omega = subject.omega0()?;
    let left = (inner() + subject.times_omega0(1, 2, zero(&a))?) * cos(&psi) - outer() * sin(&psi);
    let by_cosine = zero(&a) * (one(&psi) - omega.clone()) * cos(&psi);
    let resonant =
        -subject.times_omega0(2, 1, by_cosine)? - subject.times_omega0(2, 1, one(&a) * sin(&psi))?;
    let small = Name::new("ε");
    let given = slow([a.clone(), psi.clone()], omega.clone());
    let rounded = Statement::equal(left, resonant + order(Formula::from(&small).squared()));
    let rounded = same_series_for_choices(&small, 2, 3, &given, rounded)?;
    Ok(DerivationStep::new("derivatives", "The derivatives of the motion")
        .say("Amplitude and phase depend on the time. So the first derivative of {} is", [zero(&a) * cosine()])
        .show(first)
        .say("and the second", [])
        .show(second)
        .say(
            "The rate {} and the difference {} are small, of the order {} of the small terms. Their products, and the second derivatives {} and {}, are smaller by another factor of this kind. In {} only {} is left. \
             So the left side of the equation of motion is, of the free oscillation,",
            [
                one(&a),
                one(&psi) - omega.clone(),
                (&small).into(),
                two(&a),
                two(&psi),
                subject.omega0_squared()? - one(&psi).squared(),
                -subject.times_omega0(2, 1, one(&psi) - omega)?,
            ],
        )
        .show(rounded))
}

/// Values of an amplitude and a phase with their derivatives, all independent.
fn moving(names: [&Name; 2]) -> Result<Trials, DerivationError> {
    let mut trials = Trials::choices()?;
    for (index, name) in names.into_iter().enumerate() {
        for primes in 0..3 {
            let derivative = (0..primes).fold(name.clone(), |name, _| name.prime());
            let offset = i64::try_from(3 * index + primes).unwrap_or(0);
            trials
                .choose(&derivative, &|choice| tenths(7 + 4 * offset + i64::try_from(choice).unwrap_or(0)))?;
        }
        trials.let_move(name);
        trials.let_move(&name.clone().prime());
    }
    Ok(trials)
}

/// Values of an amplitude and a phase whose derivatives are small, power by power of ε, but for the frequency.
fn slow([a, psi]: [Name; 2], frequency: Formula) -> impl Fn(usize) -> Vec<Given<'static>> {
    let free: Vec<Name> = frequency.free_names();
    move |choice| {
        let power = |n: i64| Formula::from(Name::new("ε")).pow(n);
        let value = |index: usize| Formula::Number(chosen(index, choice));
        let of_symbol = |(index, name): (usize, &Name)| Given::Value(name.clone(), value(index + 9));
        let slow = [
            Given::Value(a.clone(), value(0)),
            Given::Value(psi.clone(), value(1)),
            Given::Value(a.clone().prime(), value(2) * power(1)),
            Given::Value(psi.clone().prime(), frequency.clone() + value(3) * power(1)),
            Given::Value(a.clone().prime().prime(), value(4) * power(2)),
            Given::Value(psi.clone().prime().prime(), value(5) * power(2)),
        ];
        free.iter().enumerate().map(of_symbol).chain(slow).collect()
    }
}
