//! The steps of the derivation.

use super::super::averaging::in_terms;
use super::super::check::{
    Check, CheckedEquation, DerivationError, Given, QuarterClaim, QuarterFormula, same_series_for_choices,
    same_series_where,
};
use super::super::document::{Cells, DerivationStep, DerivationTable};
use super::super::formula::{
    Formula, Name, Statement, cos, integral, letter, monomial, number, order, polynomial, sin, sum, tenths,
};
use super::super::phase::{PhaseFunction, PiNumber, number as written, series};
use super::super::prose::Prose;
use super::super::trials::Trials;
use super::quarter::QuarterOrder;
use super::subject::TwoSidedSubject;
use libration::algebra::{Polynomial, Rational, Variable};

fn tau() -> Formula {
    letter("τ")
}

fn omega0() -> Formula {
    Name::new("ω").index(0).into()
}

fn whole(n: usize) -> i64 {
    i64::try_from(n).unwrap_or(i64::MAX)
}

fn correction_name(n: usize) -> Name {
    Name::new("d").index(whole(n))
}

/// The name of the largest displacement.
pub(super) fn amplitude() -> Name {
    Name::new("A")
}

fn power_of_amplitude(n: usize) -> Formula {
    monomial(&Rational::from(1), &letter("A"), n)
}

pub(super) fn equation_of_motion(subject: &TwoSidedSubject) -> Result<DerivationStep, DerivationError> {
    let variable = Formula::from(&subject.variable);
    let second = Formula::from(subject.variable.clone().prime().prime());
    let trials = Trials::new(None)?.with(&subject.variable, subject.equilibrium.clone() + tenths(7))?;
    let trials = if subject.is_at_zero() { trials } else { trials.with(&subject.displacement, tenths(7))? };
    let above = Statement::equal(subject.acceleration(), subject.above.clone());
    let step = DerivationStep::new("equation-of-motion", "The equation of motion")
        .say(
            "The oscillator is given by its equation of motion, with a prime for a derivative with respect to the time {}:",
            [letter("t")],
        )
        .show(CheckedEquation::premise(Statement::equal(second, subject.acceleration())));
    let step = match subject.is_at_zero() {
        true => step.say("It can stay at rest at {} = {}, and is driven back from both sides.", [variable, number(0)]),
        false => step
            .say(
                "It can stay at rest at {} = {}, and is driven back from both sides. From here on the displacement is counted from there:",
                [variable.clone(), subject.equilibrium.clone()],
            )
            .show(CheckedEquation::definition(Statement::defined(
                subject.u(),
                variable - subject.equilibrium.clone(),
            ))),
    };
    let square = Statement::defined(omega0().squared(), subject.omega0_squared.clone());
    Ok(step
        .say(
            "No power series holds on both sides. But the force at the opposite displacement is the opposite force: a swing consists of four quarters that are \
             images of each other. So one quarter is enough, from the turning point at a positive displacement to the passage through zero, and there the \
             acceleration is",
            [],
        )
        .show(trials.compare_once(above)?)
        .say(
            "Close to zero the force is proportional to the displacement, with a factor that is the square of the frequency of very small swings,",
            [],
        )
        .show(CheckedEquation::definition(square)))
}

pub(super) fn taylor(subject: &TwoSidedSubject) -> Result<DerivationStep, DerivationError> {
    let force = &subject.quarter.force;
    let coefficients: Vec<Rational> = [Rational::from(0)].iter().chain(force).cloned().collect();
    let next = order(monomial(&Rational::from(1), &subject.u(), coefficients.len()));
    let over = subject.above.clone().negated();
    let over = match &subject.omega0_squared {
        Formula::Number(one) if *one == Rational::from(1) => over,
        square => over / square.clone(),
    };
    let statement = Statement::equal(over, polynomial(&coefficients, &subject.u()) + next);
    let equation = same_series_where(&subject.displacement, coefficients.len(), &[], statement)?;
    Ok(DerivationStep::new("taylor", "The Taylor step")
        .say(
            "On this side the force is a power series. Up to the order at which the derivation stops, the restoring force over the square of {} is",
            [omega0()],
        )
        .show(equation))
}

pub(super) fn ansatz(subject: &TwoSidedSubject) -> DerivationStep {
    let u = |n: usize| Formula::from(subject.part(n));
    let phase = Statement::defined(tau(), letter("Ω") * letter("t"));
    let ratio = Statement::defined(letter("Δ"), letter("Ω") / omega0());
    let second = Formula::from(subject.displacement.clone().prime().prime());
    let force = polynomial(
        &[Rational::from(0)].iter().chain(&subject.quarter.force).cloned().collect::<Vec<_>>(),
        &subject.u(),
    );
    let motion = Statement::equal(letter("Δ").squared() * second + force, 0);
    let terms = (1..=subject.order).map(|n| match n {
        1 => letter("A") * u(1),
        n => power_of_amplitude(n) * u(n),
    });
    let dots = |terms: Vec<Formula>| sum(terms.into_iter().chain([letter("…")]).collect());
    let displacement = Statement::equal(subject.u(), dots(terms.collect()));
    let corrections = (1..subject.order).map(|n| Formula::from(correction_name(n)) * power_of_amplitude(n));
    let frequency = Statement::equal(letter("Δ"), dots([number(1)].into_iter().chain(corrections).collect()));
    let part = subject.displacement.clone().index(letter("n"));
    let at = |name: Name, argument: Formula| Formula::Apply(name, vec![argument]);
    let vanishing =
        |name: Name, argument: Formula| CheckedEquation::premise(Statement::equal(at(name, argument), 0));
    DerivationStep::new("ansatz", "The ansatz")
        .say("The frequency {} is not known yet. So time is counted by the phase, in which a quarter of the period is always {},", [letter("Ω"), Formula::Pi / 2])
        .show(CheckedEquation::definition(phase))
        .show(CheckedEquation::definition(ratio))
        .say("and with primes now for derivatives with respect to {} the equation of motion is", [tau()])
        .show(CheckedEquation::premise(motion))
        .say(
            "The swing begins at rest at its largest displacement {}. Displacement and frequency are power series in it, without a gap: the force has even powers too.",
            [letter("A")],
        )
        .show(CheckedEquation::definition(displacement))
        .show(CheckedEquation::definition(frequency))
        .say(
            "Each function {} depends on the phase alone. Of all of them but the first the value at the beginning is zero, since {} is the whole displacement there; and each of them has no velocity \
             there, and is zero after a quarter of the period:",
            [(&part).into(), letter("A")],
        )
        .show(CheckedEquation::premise(Statement::equal(at(subject.part(1), number(0)), 1)))
        .show(vanishing(part.clone(), number(0)))
        .show(vanishing(part.clone().prime(), number(0)))
        .show(vanishing(part, Formula::Pi / 2))
        .say(
            "In the first power the equation is {} = {}, and {} = {} meets all of this. In every other power the last condition fixes the correction of the frequency.",
            [Formula::from(subject.part(1).prime().prime()) + u(1), number(0), u(1), cos(tau())],
        )
}

/// The solutions that begin at rest in zero.
pub(super) fn solutions() -> Result<DerivationStep, DerivationError> {
    let trials = Trials::new(None)?.with(&Name::new("τ"), tenths(7))?;
    let (s, k) = (|| letter("s"), || letter("k"));
    let of = |r: Formula| integral("s", 0, tau(), r * sin(tau() - s()));
    let constant = Statement::equal(integral("s", 0, tau(), sin(tau() - s())), number(1) - cos(tau()));
    let first = Statement::equal(of(cos(s())), tau() * sin(tau()) / 2);
    let others =
        Statement::equal(of(cos(k() * s())), (cos(tau()) - cos(k() * tau())) / (k().squared() - number(1)));
    Ok(DerivationStep::new("solutions", "The motion under a given force")
        .say(
            "In each power an equation {} = {} is to be solved, with a right side that is known. Its solution that begins at rest in zero is the sum of what each moment of the force leaves behind, {}, for example",
            [
                letter("y").clone() + Formula::from(Name::new("y").prime().prime()),
                letter("r"),
                integral("s", 0, tau(), Formula::Apply(Name::new("r"), vec![s()]) * sin(tau() - s())),
            ],
        )
        .show(trials.compare_once(constant)?)
        .show(trials.compare_once(first)?)
        .say("and for other harmonics, whole {} from {} on,", [k(), number(2)])
        .show(trials.compare_cases("k", 2..=5, others)?)
        .say(
            "With {} before a harmonic the integral is done by parts. The second of these formulas says what the correction of the frequency does: a right side {} leads to {}.",
            [tau(), number(2) * letter("d") * cos(tau()), letter("d") * tau() * sin(tau())],
        ))
}

fn checked(
    subject: &TwoSidedSubject,
    power: usize,
    statement: Statement,
    claim: QuarterClaim,
) -> CheckedEquation {
    let force = subject.quarter.force.iter().skip(1).cloned().collect();
    CheckedEquation::new(statement, Check::Quarter(Box::new(QuarterFormula { force, power, claim })))
}

/// Highest power whose table is shown unfolded; those of higher powers are folded.
const OPEN_TO_READ: usize = 3;

pub(super) fn one_power(subject: &TwoSidedSubject, order: &QuarterOrder) -> DerivationStep {
    let n = order.power;
    let (part, correction) = (subject.part(n), correction_name(n - 1));
    let force = series(&order.forcing, "τ");
    let left = Formula::from(part.clone().prime().prime()) + Formula::from(&part);
    let of_correction = number(2) * Formula::from(&correction) * cos(tau());
    let right = if order.forcing.is_zero() { of_correction } else { of_correction + force.clone() };
    let forcing = checked(subject, n, Statement::equal(left, right), QuarterClaim::Forcing { value: force });
    let step = DerivationStep::new(&format!("order-{n}"), &format!("Power {n} of the amplitude"));
    if order.forcing.is_zero() {
        return step
            .say("Lower powers bring nothing to the right side. The equation in this power is", [])
            .show(forcing)
            .say(
                "and its solution from rest, {}, vanishes at {} only if the correction does:",
                [Formula::from(&correction) * tau() * sin(tau()), Formula::Pi / 2],
            )
            .show(checked(subject, n, Statement::equal(&correction, 0), QuarterClaim::Correction))
            .show(checked(subject, n, Statement::equal(&part, 0), QuarterClaim::Motion));
    }
    let way = |step: DerivationStep| {
        step.say("The parts of the equation of motion bring to the right side", [])
            .table(table(subject, order))
            .say("so that the equation in this power is", [])
            .show(forcing)
    };
    let step = match n <= OPEN_TO_READ {
        true => way(step),
        false => step.fold("Contributions of lower powers, and the equation", way),
    };
    let y = Name::new("y").index(whole(n));
    let begun = Statement::equal(&y, series(&order.begun, "τ"));
    let value = subject.quarter.ratio.get(n - 1).cloned().unwrap_or_default();
    let at_end = order.begun.at_quarter_turn();
    let vanishing = Statement::equal(&correction, over_half_pi(&at_end.negated())).and_equal(written(&value));
    let motion = subject.quarter.motion.get(n).cloned().unwrap_or_default();
    let motion = Statement::equal(&part, series(&motion, "τ"));
    step.say("Without the correction {} its solution that begins at rest in zero is", [(&correction).into()])
        .show(checked(subject, n, begun, QuarterClaim::Begun))
        .say(
            "With it {} is added. At {} the first is {} and the second {}; together they must vanish:",
            [
                Formula::from(&correction) * tau() * sin(tau()),
                Formula::Pi / 2,
                written(&at_end),
                Formula::from(&correction) * Formula::Pi / 2,
            ],
        )
        .show(checked(subject, n, vanishing, QuarterClaim::Correction))
        .say("so that the motion has the part", [])
        .show(checked(subject, n, motion, QuarterClaim::Motion))
}

/// 2/π times a number, with a sign of a single term before the product.
fn over_half_pi(value: &PiNumber) -> Formula {
    let product = |value: &PiNumber| number(2) / Formula::Pi * written(value);
    let is_negative = value.terms().all(|(_, factor)| factor.is_negative()) && value.terms().count() == 1;
    if is_negative { -product(&value.negated()) } else { product(value) }
}

fn table(subject: &TwoSidedSubject, order: &QuarterOrder) -> DerivationTable {
    let n = order.power;
    let second = Formula::from(subject.displacement.clone().prime().prime());
    let linear = -(letter("Δ").squared() * second);
    let mut rows = vec![];
    if !order.of_acceleration.is_zero() {
        rows.push((linear, of_acceleration(subject, n), &order.of_acceleration));
    }
    let powers = subject.quarter.force.iter().enumerate().skip(1).zip(&order.of_powers);
    for ((index, factor), part) in powers.filter(|(_, part)| !part.is_zero()) {
        let exponent = index + 1;
        let part_name = monomial(&-factor.clone(), &subject.u(), exponent);
        rows.push((part_name, of_power(subject, factor, exponent, n), part));
    }
    let cells = |(part, products, value): (Formula, Formula, &PhaseFunction)| {
        vec![Prose::formula(part), in_terms(&products), in_terms(&series(value, "τ"))]
    };
    let head = [Prose::text("part"), Prose::text("products that it comes from"), Prose::text("their value")];
    DerivationTable {
        cells: Cells::Formulas,
        head: head.into(),
        rows: rows.into_iter().map(cells).collect(),
        note: Prose::new("without the term of {}", [correction_name(n - 1).into()]),
    }
}

/// The products in the power n of −Δ²u″, without the correction that this power fixes.
fn of_acceleration(subject: &TwoSidedSubject, n: usize) -> Formula {
    let correction = |m: usize| Polynomial::variable(Variable::indexed("d", u32::try_from(m).unwrap_or(0)));
    let one = Polynomial::constant(Rational::from(1));
    let at = |m: usize| match m {
        0 => one.clone(),
        m if m + 1 < n => correction(m),
        _ => Polynomial::zero(),
    };
    let square = |m: usize| (0..=m).fold(Polynomial::zero(), |sum, i| sum + at(i) * at(m - i));
    let terms = (1..n).filter(|m| !square(*m).is_zero()).flat_map(|m| {
        let second = Formula::from(subject.part(n - m).prime().prime());
        let minus = -square(m);
        let each: Vec<Formula> = match Formula::from(&minus) {
            Formula::Sum(terms) => terms,
            term => vec![term],
        };
        each.into_iter().map(move |term| term * second.clone()).collect::<Vec<_>>()
    });
    sum(terms.collect())
}

/// The products in the power n of −factor·u^exponent.
fn of_power(subject: &TwoSidedSubject, factor: &Rational, exponent: usize, n: usize) -> Formula {
    let zero = || vec![Polynomial::zero(); n + 1];
    let letter = subject.displacement.letter.clone();
    let mut motion = zero();
    for (index, part) in motion.iter_mut().enumerate().skip(1) {
        *part = Polynomial::variable(Variable::indexed(&letter, u32::try_from(index).unwrap_or(0)));
    }
    let mut power = motion.clone();
    for _ in 1..exponent {
        let mut next = zero();
        for (i, left) in power.iter().enumerate() {
            for (j, right) in motion.iter().enumerate().filter(|(j, _)| i + j <= n) {
                next[i + j] = next[i + j].clone() + left.clone() * right.clone();
            }
        }
        power = next;
    }
    Formula::from(&power[n].scaled(&-factor.clone()))
}

pub(super) fn result(subject: &TwoSidedSubject) -> Result<DerivationStep, DerivationError> {
    let (ratio, highest) = (&subject.quarter.ratio, subject.order);
    let in_amplitude = |coefficients: &[PiNumber], next: usize| {
        let series = polynomial(coefficients, &letter("A"));
        series + order(power_of_amplitude(next))
    };
    let given = |_: usize| -> Vec<Given<'static>> {
        vec![Given::Value(Name::new("Δ"), polynomial(ratio, &letter("A")))]
    };
    let frequency = Statement::equal(letter("Δ"), in_amplitude(ratio, highest));
    let of_small = letter("T") / Formula::from(Name::new("T").index(0));
    let period = in_amplitude(&subject.period_ratio(), highest);
    let with_period = |choice: usize| -> Vec<Given<'static>> {
        let mut all = given(choice);
        all.push(Given::Value(Name::new("T"), number(1) / letter("Δ")));
        all.push(Given::Value(Name::new("T").index(0), number(1)));
        all
    };
    let period = Statement::equal(of_small, number(1) / letter("Δ")).and_equal(period);
    let mut step = DerivationStep::new("period", "The frequency, the period and the harmonics")
        .say("Together the corrections give the frequency and the period over those of very small swings,", [])
        .show(same_series_for_choices(&amplitude(), highest, 1, &given, frequency)?)
        .show(same_series_for_choices(&amplitude(), highest, 1, &with_period, period)?)
        .say(
            "With its images the quarter makes a sum of cosines of the odd multiples of {}. The factor of {} follows by projection, to which each of the four quarters contributes the same:",
            [tau(), cos(letter("k") * tau())],
        );
    for k in (1..=highest).step_by(2) {
        let wave = if k == 1 { cos(tau()) } else { cos(number(whole(k)) * tau()) };
        let projected = number(4) / Formula::Pi * integral("τ", 0, Formula::Pi / 2, subject.u() * wave);
        let series = in_amplitude(&subject.quarter.harmonic(k), highest + 1);
        let statement = Statement::equal(Name::new("a").index(whole(k)), projected).and_equal(series);
        let claim = QuarterClaim::Harmonic { amplitude: amplitude(), harmonic: k };
        step = step.show(checked(subject, highest, statement, claim));
    }
    Ok(step.say(
        "There is no last one: a derivative of the force jumps at zero, so that infinitely many harmonics begin with the same power of the amplitude.",
        [],
    ))
}
