//! The integral as a series, term by term.

use super::super::check::{DerivationError, equal_rationals, same_series};
use super::super::document::{DerivationStep, DerivationTable};
use super::super::formula::{
    DecimalUnit, Formula, Name, Statement, agm, apply, cos, derivative, double_factorial, integral, letter,
    monomial, number, order, polynomial, rounded, series, sin, sqrt,
};
use super::super::prose::Prose;
use super::super::trials::Trials;
use super::super::words::{
    amplitude, complete_integral, cos_half_amplitude, period_ratio, sin_half_amplitude, theta_0,
};
use libration::algebra::Rational;
use libration::period_formulas::{period_in_amplitude, period_in_sine_squared};

/// Number of terms of a series that are compared exactly.
const COMPARED: usize = 20;
/// Number of partial sums in the table.
const TABLE_ROWS: usize = 8;

fn n() -> Formula {
    letter("n")
}

fn psi() -> Formula {
    letter("ψ")
}

/// (2n − 1)!!/(2n)!!.
fn coefficient() -> Formula {
    double_factorial(2 * n() - 1) / double_factorial(2 * n())
}

/// Σ [(2n − 1)!!/(2n)!!]² xⁿ.
fn period_series(power: Formula) -> Formula {
    series("n", 0, coefficient().squared() * power)
}

pub(super) fn binomial(trials: &Trials) -> Result<DerivationStep, DerivationError> {
    let x = letter("x");
    let root = number(1) / sqrt(number(1) - x.clone());
    let sum = series("n", 0, coefficient() * x.clone().pow(n()));
    let first = [(1, 1), (1, 2), (3, 8), (5, 16), (35, 128)]
        .map(|(p, q)| Rational::new(p, q).unwrap_or_else(|| 0.into()));
    let explicit = polynomial(&first, &x) + order(x.clone().pow(5));
    let integrand = number(1) / sqrt(number(1) - letter("m") * sin(psi()).squared());
    let term = coefficient() * letter("m").pow(n()) * sin(psi()).pow(2 * n());
    Ok(DerivationStep::new("binomial-series", "The binomial series")
        .say("One over a square root is a power series, which converges while {} is below one in size:", [x])
        .show(same_series(&Name::new("x"), COMPARED, Statement::equal(root.clone(), sum))?)
        .show(same_series(&Name::new("x"), first.len(), Statement::equal(root, explicit))?)
        .say(
            "The double factorial is the product of every second integer: 7!! is 7·5·3·1 and 8!! is 8·6·4·2; 0!! and (−1)!! are \
             products of nothing, which are 1.",
            [],
        )
        .remark(
            "The sum begins at {} = 0, with the term 1. Begun at {} = 1 it would lose this term, and the period would lose \
             its largest part, that of small swings.",
            [n(), n()],
        )
        .say("In the integrand of the period it gives", [])
        .show(trials.up_to(SLOW).compare(Statement::equal(integrand, series("n", 0, term)))?)
        .say(
            "Each term is largest at the right angle, where the series is that of {} = {} and still converges. So \
             it converges uniformly and may be integrated term by term.",
            [letter("x"), letter("m")],
        ))
}

/// Amplitude in degrees up to which series in m are summed to all digits.
const SLOW: i64 = 140;

pub(super) fn powers_of_the_sine(trials: &mut Trials) -> Result<DerivationStep, DerivationError> {
    let i = |n: Formula| apply("I", [n]);
    let definition =
        trials.define_function("I", &["n"], integral("ψ", 0, Formula::Pi / 2, sin(psi()).pow(2 * n())));
    let product = -(cos(psi()) * sin(psi()).pow(2 * n() - 1));
    let rest = (2 * n() - 1) * (cos(psi()).squared() * sin(psi()).pow(2 * n() - 2));
    let parts = Statement::equal(derivative(product, "ψ"), sin(psi()).pow(2 * n()) - rest);
    let recurrence = (2 * n() - 1) / (2 * n());
    let unsolved = Statement::equal(i(n()), (2 * n() - 1) * (i(n() - 1) - i(n())));
    let solved = Statement::equal(i(n()), recurrence.clone() * i(n() - 1));
    let step = Statement::equal(
        coefficient(),
        recurrence * (double_factorial(2 * n() - 3) / double_factorial(2 * n() - 2)),
    );
    let closed = Statement::equal(i(n()), coefficient() * (Formula::Pi / 2));
    Ok(DerivationStep::new("wallis", "The integrals of the powers of the sine")
        .say("What remains are the integrals", [])
        .show(definition)
        .say("The first is plain, because a power zero is one:", [])
        .show(trials.compare_once(Statement::equal(i(number(0)), Formula::Pi / 2))?)
        .say("For the others, differentiate a product:", [])
        .show(trials.compare_cases("n", 1..=6, parts)?)
        .say(
            "At both limits the product is zero, so that the integral of the right side is zero too. With the square of \
             the cosine written as one minus the square of the sine this says",
            [],
        )
        .show(trials.compare_cases("n", 1..=6, unsolved)?)
        .say("where {} stands on both sides. Solved for it,", [i(n())])
        .show(trials.compare_cases("n", 1..=6, solved)?)
        .say("The coefficients of the binomial series obey the same recurrence,", [])
        .show(equal_rationals("n", 1..=40, step)?)
        .say("and they begin with 1, so that the integrals are the coefficients times {}:", [Formula::Pi / 2])
        .show(trials.compare_cases("n", 0..=6, closed)?))
}

pub(super) fn period(trials: &Trials) -> Result<DerivationStep, DerivationError> {
    let m = letter("m");
    let ratio = number(2) / Formula::Pi * complete_integral(m.clone());
    let sum = Statement::equal(ratio, period_series(m.clone().pow(n())));
    let sine = |n: usize| sin_half_amplitude().pow(i64::try_from(2 * n).unwrap_or(i64::MAX));
    let coefficients = period_in_sine_squared(3);
    let mut terms = vec![number(1)];
    terms.extend(coefficients.iter().enumerate().skip(1).map(|(n, c)| Formula::from(c.clone()) * sine(n)));
    terms.push(order(theta_0().pow(8)));
    let in_sines = Statement::equal(period_series(sin_half_amplitude().pow(2 * n())), Formula::Sum(terms));
    Ok(DerivationStep::new("period-series", "The period as a series")
        .say(
            "The coefficient enters twice, once from the binomial series and once from the integral. What multiplies the \
             period of small swings is",
            [],
        )
        .show(trials.up_to(SLOW).compare(sum)?)
        .show(same_series(&amplitude(), 8, in_sines)?)
        .say("Here is how the sum approaches the period at an amplitude of {}:", [trials.amplitude()])
        .table(partial_sums(trials)?)
        .remark(
            "It converges for every amplitude below the upright position, slowly when {} is near one: each term is the one \
             before it times {} and the square of {}.",
            [m.clone(), m, (2 * n() - 1) / (2 * n())],
        ))
}

fn partial_sums(trials: &Trials) -> Result<DerivationTable, DerivationError> {
    let m = trials.value(&letter("m"))?.to_f64();
    let ratio = trials.value(&(number(1) / agm(1, cos_half_amplitude())))?.to_f64();
    let mut rows = Vec::new();
    let (mut sum, mut power) = (0.0, 1.0);
    for (n, coefficient) in period_in_sine_squared(TABLE_ROWS - 1).iter().enumerate() {
        let term = coefficient.to_f64() * power;
        sum += term;
        power *= m;
        rows.push(vec![
            Prose::formula(number(i64::try_from(n).unwrap_or(i64::MAX))),
            Prose::formula(coefficient.clone().into()),
            Prose::formula(rounded(term, 6, DecimalUnit::One)),
            Prose::formula(rounded(sum, 11, DecimalUnit::One)),
            Prose::formula(rounded(sum / ratio - 1.0, 2, DecimalUnit::One)),
        ]);
    }
    let titles = [
        Prose::formula(n()),
        Prose::text("coefficient"),
        Prose::text("term"),
        Prose::text("sum"),
        Prose::text("error"),
    ];
    let note =
        Prose::new("the error is relative to {} from the mean of two numbers, below", [period_ratio()]);
    Ok(DerivationTable::numbers(titles.into(), rows, note))
}

pub(super) fn in_the_amplitude() -> Result<DerivationStep, DerivationError> {
    let coefficients = period_in_amplitude(3);
    let mut terms: Vec<Formula> =
        coefficients.iter().enumerate().map(|(n, c)| monomial(c, &theta_0(), 2 * n)).collect();
    terms.push(order(theta_0().pow(8)));
    let expanded = Statement::equal(period_series(sin_half_amplitude().pow(2 * n())), Formula::Sum(terms));
    Ok(DerivationStep::new("powers-of-the-amplitude", "In powers of the amplitude")
        .say("With the power series of the sine itself the same sum becomes a series in the amplitude, in radians:", [])
        .show(same_series(&amplitude(), 8, expanded)?)
        .remark(
            "Its terms are smaller, because the square of {} is below {}: the two series stop converging at the same \
             amplitude, the upright position, but on the way there this one needs fewer terms.",
            [theta_0() / Formula::Pi, sin_half_amplitude().squared()],
        ))
}
