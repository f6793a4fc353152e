//! The amplitude as a function of the expansion parameter, its inverse, and the measurable quantities.

use super::super::check::{
    CheckedEquation, DerivationError, Given, failed, same_series, same_series_where, series_value,
};
use super::super::document::DerivationStep;
use super::super::formula::{
    Formula, Name, Statement, agm, apply, cos, letter, monomial, number, order, polynomial, sum,
};
use super::names::harmonic_name;
use super::question::LindstedtQuestion;
use super::solution::{PolynomialSeries, Solution};
use super::substitution::in_epsilon;
use libration::algebra::{Polynomial, Rational};
use libration::period_formulas::period_in_amplitude;
use libration::perturbation::{AmplitudeSeries, Gauge};

/// Σ cₙAⁿ + O(…), with the powers that occur.
fn in_amplitude(question: &LindstedtQuestion, coefficients: &[Polynomial], next: usize) -> Formula {
    let amplitude = Formula::from(question.amplitude());
    let powers = coefficients.iter().enumerate().take(next).filter(|(_, c)| !c.is_zero());
    let terms = powers.map(|(n, c)| monomial(c, &amplitude, n));
    let next = order(amplitude.clone().pow(i64::try_from(next).unwrap_or(i64::MAX)));
    Formula::Sum(terms.chain([next]).collect())
}

/// The relations between measurable quantities.
pub(super) fn of_amplitude<'a>(
    question: &LindstedtQuestion,
    solution: &'a Solution,
) -> Result<&'a AmplitudeSeries<Polynomial>, DerivationError> {
    solution.of_amplitude.as_ref().ok_or_else(|| {
        failed(
            &Statement::from(Formula::from(question.amplitude())),
            "there is no series in the amplitude".to_owned(),
        )
    })
}

pub(super) fn iteration(question: &LindstedtQuestion) -> Result<DerivationStep, DerivationError> {
    let sum_of_harmonics = &question.solution.x_max;
    let total = question.harmonics().into_iter().map(|k| Formula::from(harmonic_name(k)));
    let statement = Statement::equal(question.amplitude(), sum(total.collect()))
        .and_equal(in_epsilon(sum_of_harmonics, question.order + 1));
    let mut given = harmonics_in_epsilon(question, &question.solution);
    given.push(Given::Value(question.amplitude(), polynomial(sum_of_harmonics, &letter("ε"))));
    let step = DerivationStep::new("amplitude", "From the amplitude to the expansion parameter")
        .say(
            "What is known of a swing is its largest displacement {}, at {} = 0, where all cosines are one:",
            [question.amplitude().into(), letter("τ")],
        )
        .show(same_series_where(&Name::new("ε"), question.order + 1, &given, statement)?);
    if question.solution.gauge == Gauge::XMax {
        return Ok(
            step.say("In this gauge nothing is left to do: the expansion parameter is the amplitude.", [])
        );
    }
    passes(question, step, sum_of_harmonics)
}

/// The symbols, and aₖ as series in ε.
fn harmonics_in_epsilon<'a>(question: &LindstedtQuestion, solution: &Solution) -> Vec<Given<'a>> {
    let series = |k: usize| Given::Value(harmonic_name(k), polynomial(&solution.harmonic(k), &letter("ε")));
    let mut given = question.free_symbols();
    given.extend(question.harmonics().into_iter().map(series));
    given
}

/// The name of ε after `pass` iterations.
fn answer(pass: usize) -> Name {
    Name::new("ε").index(i64::try_from(pass).unwrap_or(i64::MAX))
}

/// The solution of A = s₁ε + s₂ε² + … by iterating ε = A/s₁ + F(ε).
fn passes(
    question: &LindstedtQuestion,
    step: DerivationStep,
    sum_of_harmonics: &[Polynomial],
) -> Result<DerivationStep, DerivationError> {
    let amplitude = Formula::from(question.amplitude());
    let one = Rational::from(1);
    let first = sum_of_harmonics.get(1).and_then(Polynomial::to_constant);
    let scale = first.and_then(|first| one.checked_div(&first)).unwrap_or(one);
    let beyond = |(n, c): (usize, &Polynomial)| if n < 2 { Polynomial::zero() } else { -c.scaled(&scale) };
    let rest: PolynomialSeries = sum_of_harmonics.iter().enumerate().map(beyond).collect();
    let function = polynomial(&rest, &letter("z"));
    let start = monomial(&scale, &amplitude, 1);
    let other_side = Statement::equal(apply("F", [letter("ε")]), letter("ε") - start.clone())
        .and_equal(in_epsilon(&rest, question.order + 1));
    let mut given = question.free_symbols();
    given.push(Given::Function("F", "z", function.clone()));
    given.push(Given::Value(question.amplitude(), polynomial(sum_of_harmonics, &letter("ε"))));
    let mut step = step
        .say("The other way round is found by iteration. Bring all but the first term to the other side,", [])
        .show(same_series_where(&Name::new("ε"), question.order + 1, &given, other_side)?)
        .say("begin with the first term alone, and put each result into {} again:", [letter("F")])
        .show(CheckedEquation::definition(Statement::defined(answer(0), start.clone())));
    let wanted = &of_amplitude(question, &question.solution)?.epsilon;
    let mut partial = vec![Polynomial::zero(), Polynomial::constant(scale)];
    for pass in 1..=question.order {
        let again = start.clone() + apply("F", [answer(pass - 1).into()]);
        let mut given = question.free_symbols();
        given.push(Given::Function("F", "z", function.clone()));
        given.push(Given::Value(answer(pass - 1), polynomial(&partial, &amplitude)));
        given.push(Given::Value(answer(pass), again.clone()));
        let mut next = series_value(&question.amplitude(), question.order + 1, &given, &again)?;
        next.truncate(question.order + 1);
        let statement = Statement::equal(answer(pass), again).and_equal(in_amplitude(
            question,
            &next,
            question.order + 1,
        ));
        step = step.show(same_series_where(&question.amplitude(), question.order + 1, &given, statement)?);
        partial = next;
        if partial.iter().eq(wanted.iter().take(question.order + 1)) {
            return Ok(step.say(
                "Each pass has settled at least one more coefficient, and another would change nothing: this is the series of {}.",
                [letter("ε")],
            ));
        }
    }
    let statement = Statement::from(polynomial(&partial, &amplitude));
    Err(failed(&statement, "the iteration does not lead to the series of the engine".to_owned()))
}

pub(super) fn physical_relations(question: &LindstedtQuestion) -> Result<DerivationStep, DerivationError> {
    let step = DerivationStep::new("period", "The period and the harmonics").say(
        "Put in the place of {}, this gives what can be measured: the frequency and the period over those of very small \
         swings, and the harmonics.",
        [letter("ε")],
    );
    let step = relations(question, &question.solution)?.into_iter().fold(step, DerivationStep::show);
    let coefficients = period_in_amplitude(question.order / 2);
    let of = of_amplitude(question, &question.solution)?;
    let even: Option<Vec<Rational>> =
        of.period_ratio.iter().take(question.order).step_by(2).map(Polynomial::to_constant).collect();
    let is_pendulum = even.is_some_and(|even| coefficients.iter().take(even.len()).eq(even.iter()));
    if question.displacement.letter != "θ" || !is_pendulum {
        return Ok(step);
    }
    let exact = number(1) / agm(1, cos(Formula::from(question.amplitude()) / 2));
    let statement = Statement::equal(exact, in_amplitude(question, &of.period_ratio, question.order));
    Ok(step
        .say("For the pendulum the period is known exactly, by the arithmetic–geometric mean, and has the same series:", [])
        .show(same_series(&question.amplitude(), question.order, statement)?))
}

/// Frequency, period and harmonics by powers of the amplitude, from the series in ε.
pub(super) fn relations(
    question: &LindstedtQuestion,
    solution: &Solution,
) -> Result<Vec<CheckedEquation>, DerivationError> {
    let of = of_amplitude(question, solution)?;
    let period = letter("T");
    let small = Name::new("T").index(0);
    let mut given = harmonics_in_epsilon(question, solution);
    let epsilon = Given::Value(Name::new("ε"), polynomial(&of.epsilon, &question.amplitude().into()));
    given.insert(question.symbols().count(), epsilon);
    given.push(Given::Value(Name::new("Δ"), polynomial(&solution.frequency_ratio, &letter("ε"))));
    given.push(Given::Value(Name::new("T"), number(1) / letter("Δ")));
    given.push(Given::Value(small.clone(), number(1)));
    let frequency = in_amplitude(question, &of.frequency_ratio, question.order);
    let ratio = in_amplitude(question, &of.period_ratio, question.order);
    let mut statements = vec![
        (Statement::equal(letter("Δ"), frequency), question.order),
        (
            Statement::equal(period / Formula::from(small), number(1) / letter("Δ")).and_equal(ratio),
            question.order,
        ),
    ];
    for (k, series) in of.harmonics.iter().filter(|(k, _)| *k <= question.order) {
        let series = in_amplitude(question, series, question.order + 1);
        statements.push((Statement::equal(harmonic_name(*k), series), question.order + 1));
    }
    let check = |(statement, length)| same_series_where(&question.amplitude(), length, &given, statement);
    statements.into_iter().map(check).collect()
}
