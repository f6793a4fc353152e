//! The formulas that are steps of the arithmetic–geometric mean.

use super::super::check::{CheckedEquation, DerivationError, Given, same_series_where};
use super::super::document::DerivationStep;
use super::super::elliptic::theta_series;
use super::super::formula::{
    Formula, Name, Statement, agm, apply, call, integral, letter, number, order, sin, sqrt,
};
use super::super::trials::Trials;
use super::super::words::{amplitude, complete_integral, cos_half_amplitude, small_swing_period, theta_0};
use super::report::{exact_ratio, leading_error, period_of, stated};
use libration::algebra::{Function, Rational};

fn mean(name: &str, n: i64) -> Formula {
    Name::new(name).index(n).into()
}

/// √cos(θ0/2).
fn root() -> Formula {
    sqrt(cos_half_amplitude())
}

fn kidd_fogg() -> Formula {
    number(1) / root()
}

fn carvalhaes_suppes() -> Formula {
    number(4) / (number(1) + root()).squared()
}

pub(super) fn kidd_fogg_and_carvalhaes_suppes(
    trials: &mut Trials,
) -> Result<DerivationStep, DerivationError> {
    let mut definitions = Vec::new();
    for (name, n, value) in [
        ("a", 0, number(1)),
        ("b", 0, cos_half_amplitude()),
        ("a", 1, (mean("a", 0) + mean("b", 0)) / 2),
        ("b", 1, sqrt(mean("a", 0) * mean("b", 0))),
        ("a", 2, (mean("a", 1) + mean("b", 1)) / 2),
    ] {
        definitions.push(trials.define(&Name::new(name).index(n), value)?);
    }
    let second = Statement::equal(mean("a", 2), ((number(1) + root()) / 2).squared());
    Ok(DerivationStep::new("steps-of-the-mean", "Kidd and Fogg, Carvalhaes and Suppes: steps of the mean")
        .say("The first steps towards the mean are", [])
        .show_all(definitions)
        .say(
            "The mean lies between the two numbers at each step, so one over either is an approximation to the exact \
             ratio, too small for the arithmetic and too large for the geometric one. One over {} is the formula of Kidd and \
             Fogg:",
            [mean("b", 1)],
        )
        .show(stated(trials, "kidd_fogg", "KF", kidd_fogg())?)
        .show(leading_error("kidd_fogg", "KF", kidd_fogg())?)
        .say("The second arithmetic mean is a square,", [])
        .show(trials.compare(second)?)
        .say("and one over it is the formula of Carvalhaes and Suppes:", [])
        .show(stated(trials, "carvalhaes_suppes", "CS", carvalhaes_suppes())?)
        .show(leading_error("carvalhaes_suppes", "CS", carvalhaes_suppes())?)
        .say("It needs no more than one square root, and the power in its error has doubled.", []))
}

pub(super) fn errors_of_means(trials: &mut Trials) -> Result<DerivationStep, DerivationError> {
    let parameter = sin(theta_0() / 2).squared();
    let psi = letter("ψ");
    let integrand = number(1) / sqrt(number(1) - letter("m") * sin(psi).squared());
    let integral = trials.define_function("K", &["m"], integral("ψ", 0, Formula::Pi / 2, integrand));
    let parameter = trials.define(&Name::new("m"), parameter)?;
    let nome = -(Formula::Pi * complete_integral(number(1) - letter("m")) / complete_integral(letter("m")));
    let nome = trials.define(&Name::new("q"), call(Function::Exp, nome))?;
    let q = || letter("q");
    let theta = trials.define_function("ϑ", &["q"], theta_series());
    let limit = || agm(1, cos_half_amplitude());
    let over = |argument: Formula| number(1) / apply("ϑ", [argument]).squared();
    let geometric = Statement::equal(kidd_fogg() * limit(), over(-q().squared()));
    let arithmetic = Statement::equal(carvalhaes_suppes() * limit(), over(q().pow(4)));
    let small = |argument: Formula, sign: i64, power: i64| {
        let first = number(1) + sign * q().pow(power);
        let statement = Statement::equal(over(argument), first + order(q().pow(2 * power)));
        let length = usize::try_from(2 * power).unwrap_or(0);
        same_series_where(&Name::new("q"), length, &[Given::Function("ϑ", "q", theta_series())], statement)
    };
    Ok(DerivationStep::new("errors-of-the-mean", "The errors of the two, exactly")
        .say("How far these two are from the exact ratio can be said exactly. With the complete elliptic integral", [])
        .show(integral)
        .show(parameter)
        .say("and Jacobi’s nome and theta function", [])
        .show(nome)
        .show(theta)
        .say("the two formulas, divided by the exact ratio, are", [])
        .show(trials.compare(geometric)?)
        .show(trials.compare(arithmetic)?)
        .say("At small {} this is", [q()])
        .show(small(-q().squared(), 4, 2)?)
        .show(small(q().pow(4), -4, 4)?)
        .say("and since {} is nearly {} at small amplitudes, the leading errors above are found again:", [
            q(),
            theta_0().squared() / 64,
        ])
        .show(nome_at_small_amplitudes()?))
}

/// ϑ(q)² is the exact ratio, which determines q as a series in θ0.
fn nome_at_small_amplitudes() -> Result<CheckedEquation, DerivationError> {
    let q = theta_0().squared() / 64 + theta_0().pow(4) / 1536;
    let statement = Statement::equal(apply("ϑ", [q]).squared(), exact_ratio() + order(theta_0().pow(6)));
    same_series_where(&amplitude(), 6, &[Given::Function("ϑ", "q", theta_series())], statement)
}

pub(super) fn belendez(trials: &mut Trials) -> Result<DerivationStep, DerivationError> {
    let gap = trials.define(&Name::new("c").index(2), (mean("a", 1) - mean("b", 1)) / 2)?;
    let (a, c) = (mean("a", 2), mean("c", 2));
    let as_square = Statement::equal(c.clone(), ((number(1) - root()) / 2).squared());
    let rest = number(2) / (Formula::Pi * a.clone()) * complete_integral((c.clone() / a.clone()).squared());
    let after = Statement::equal(exact_ratio(), rest);
    let formula = number(64) / (16 * (number(1) + root()).squared() - (number(1) - root()).pow(4));
    let collected = Statement::equal(number(1) / (a.clone() - c.clone().squared() / 4), formula.clone());
    Ok(DerivationStep::new("belendez", "Bélendez and others: a mean and a series")
        .say("Two steps of the mean leave a gap between the two numbers that is itself small and a square:", [])
        .show(gap)
        .show(trials.compare(as_square)?)
        .say("What is still missing after two steps is the exact ratio of a pendulum of very small amplitude,", [])
        .show(trials.compare(after)?)
        .say(
            "and of its series, which begins with one plus a quarter of the argument of {}, the first term is enough. In one over \
             the ratio it takes {} from {}; where {} is nearly one, that is {}:",
            [
                letter("K"),
                c.clone().squared() / (4 * a.clone()),
                a.clone(),
                a.clone(),
                c.squared() / 4,
            ],
        )
        .show(trials.compare(collected)?)
        .show(stated(trials, "belendez", "Bel", formula.clone())?)
        .show(leading_error("belendez", "Bel", formula)?)
        .remark(
            "The roots are of the cosine of half the amplitude. Read in any other way, the formula does not have the right \
             small-swing period.",
            [],
        )
        .say("Keeping {} under the small term costs one more division and gains far more:", [a.clone()])
        .show(CheckedEquation::definition(Statement::defined(
            Formula::from(period_of("kept")) / small_swing_period(),
            number(1) / (a.clone() - mean("c", 2).squared() / (4 * a)),
        )))
        .show(kept_denominator()?))
}

/// The error if a₂ is kept as the denominator of the small term.
fn kept_denominator() -> Result<CheckedEquation, DerivationError> {
    let name = period_of("kept");
    let (a, c) = (((number(1) + root()) / 2).squared(), ((number(1) - root()) / 2).squared());
    let ratio = number(1) / (a.clone() - c.squared() / (4 * a));
    let given = [Given::Value(Name::new("T"), exact_ratio()), Given::Value(name.clone(), ratio.clone())];
    let error = Rational::new(-5, 1 << 46).map_or_else(|| number(0), Formula::from);
    let error = error * theta_0().pow(16) + order(theta_0().pow(18));
    let statement = Statement::equal(Formula::from(name) / letter("T") - 1, error);
    same_series_where(&amplitude(), 18, &given, statement)
}
