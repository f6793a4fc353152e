//! The integral as the arithmetic–geometric mean.

use super::super::check::{CheckedEquation, DerivationError, Given, same_series_where};
use super::super::document::{DerivationStep, DerivationTable};
use super::super::formula::{
    DecimalUnit, Formula, Name, Statement, agm, apply, call, cos, derivative, integral, letter, number,
    order, rounded, series, sin, sqrt,
};
use super::super::prose::Prose;
use super::super::trials::Trials;
use super::super::words::{complete_integral, cos_half_amplitude, period, small_swing_period};
use libration::algebra::Function;

/// Steps of the mean in the table: more than an `f64` can resolve at any amplitude shown.
const STEPS: i64 = 6;

fn a() -> Formula {
    letter("a")
}

fn b() -> Formula {
    letter("b")
}

fn x() -> Formula {
    letter("x")
}

fn y() -> Formula {
    letter("y")
}

/// The mean after n steps.
fn mean(name: &str, n: impl Into<Formula>) -> Name {
    Name::new(name).index(n)
}

/// 1/√(a² cos² φ + b² sin² φ).
fn integrand(angle: &Formula) -> Formula {
    number(1)
        / sqrt(a().squared() * cos(angle.clone()).squared() + b().squared() * sin(angle.clone()).squared())
}

fn gauss(a: impl Into<Formula>, b: impl Into<Formula>) -> Formula {
    apply("J", [a.into(), b.into()])
}

pub(super) fn invariance(trials: &mut Trials) -> Result<DerivationStep, DerivationError> {
    let angle = letter("φ");
    let definition =
        trials.define_function("J", &["a", "b"], integral("φ", 0, Formula::Pi / 2, integrand(&angle)));
    let here = Statement::equal(complete_integral(letter("m")), gauss(1, cos_half_amplitude()));
    // Any two numbers and any angle would serve as an example.
    let examples = trials.with(&Name::new("a"), number(1))?.with(&Name::new("b"), cos_half_amplitude())?;
    let examples = examples.with(&Name::new("x"), number(7) / 10)?;
    let arc = call(Function::Atan, x() / b());
    let in_x = number(1) / sqrt((a().squared() + x().squared()) * (b().squared() + x().squared()));
    let to_x = Statement::equal(integrand(&arc) * derivative(arc, "x"), in_x);
    let new_variable = (x() - a() * b() / x()) / 2;
    let examples = examples.with(&Name::new("y"), new_variable.clone())?;
    let slope = Statement::equal(
        derivative(new_variable.clone(), "x"),
        (x().squared() + a() * b()) / (2 * x().squared()),
    );
    let arithmetic = Statement::equal(
        ((a() + b()) / 2).squared() + y().squared(),
        (a().squared() + x().squared()) * (b().squared() + x().squared()) / (4 * x().squared()),
    );
    let geometric = Statement::equal(
        a() * b() + y().squared(),
        (x().squared() + a() * b()).squared() / (4 * x().squared()),
    );
    let invariant = Statement::equal(gauss(a(), b()), gauss((a() + b()) / 2, sqrt(a() * b())));
    Ok(DerivationStep::new("mean", "The integral as a mean")
        .say("Gauss found a shorter way. Let", [])
        .show(definition)
        .say("Because the squares of sine and cosine add up to one, the integral of the pendulum is", [])
        .show(trials.compare(here)?)
        .say(
            "This integral does not change when its two numbers are replaced by their arithmetic and their geometric mean. \
             To see it, let {} be {} times the tangent of {}, which runs from zero to infinity:",
            [x(), b(), letter("φ")],
        )
        .show(examples.compare(to_x)?)
        .say("Then take, in place of {}, what runs from minus infinity to infinity,", [x()])
        .show(CheckedEquation::definition(Statement::defined(y(), new_variable)))
        .show(examples.compare(slope)?)
        .say("for which two squares come out:", [])
        .show(examples.compare(arithmetic)?)
        .show(examples.compare(geometric)?)
        .remark(
            "The checks take {} for {}, {} for {}, and {} for {}; others would do.",
            [number(1), a(), cos_half_amplitude(), b(), number(7) / 10, x()],
        )
        .say(
            "Put together, the integrand in {} is half of the same integrand in {}, with the arithmetic mean for {} and the \
             geometric mean for {}; and the integral over both signs of {} is twice that over one. So",
            [x(), y(), a(), b(), y()],
        )
        .show(examples.compare(invariant)?))
}

pub(super) fn iteration(trials: &Trials) -> Result<DerivationStep, DerivationError> {
    let mut trials = trials.clone();
    let n = || letter("n");
    let starts =
        [trials.define(&mean("a", 0), number(1))?, trials.define(&mean("b", 0), cos_half_amplitude())?];
    for step in 0..STEPS {
        let (a, b) = (Formula::from(mean("a", step)), Formula::from(mean("b", step)));
        trials.define(&mean("a", step + 1), (a.clone() + b.clone()) / 2)?;
        trials.define(&mean("b", step + 1), sqrt(a * b))?;
    }
    let (a_n, b_n) = (Formula::from(mean("a", n())), Formula::from(mean("b", n())));
    let arithmetic =
        CheckedEquation::definition(Statement::defined(mean("a", n() + 1), (a_n.clone() + b_n.clone()) / 2));
    let geometric =
        CheckedEquation::definition(Statement::defined(mean("b", n() + 1), sqrt(a_n.clone() * b_n.clone())));
    let limit = agm(1, cos_half_amplitude());
    let ratio = number(2) / Formula::Pi * complete_integral(letter("m"));
    let same = Statement::equal(ratio, number(1) / limit.clone());
    let law = Statement::equal(period(), small_swing_period() / limit.clone());
    let nome = -(Formula::Pi * complete_integral(number(1) - letter("m")) / complete_integral(letter("m")));
    let nome = trials.define(&Name::new("q"), call(Function::Exp, nome))?;
    let theta = trials.define_function("ϑ", &["q"], theta_series());
    let power = letter("q").pow(number(2).pow(n()));
    let error =
        Statement::equal(limit.clone() / a_n.clone(), number(1) / apply("ϑ", [power.clone()]).squared());
    let small = theta_squared()?;
    Ok(DerivationStep::new("few-steps", "The period in a few steps")
        .say("Repeat the two means, beginning with", [])
        .show_all(starts.into())
        .show(arithmetic)
        .show(geometric)
        .say(
            "The two numbers close in on each other, from above and from below, and their common limit is called \
             their arithmetic–geometric mean, agm. For two equal numbers the integrand is constant and the integral is \
             {} over that number. So",
            [Formula::Pi / 2],
        )
        .show(trials.compare(same)?)
        .show(trials.compare_with_library(law)?)
        .show_all(trials.numbers(&[(small_swing_period() / limit, 11, DecimalUnit::Second)])?)
        .say(
            "At each step the period lies between {} and {}. At an amplitude of {}:",
            [small_swing_period() / a_n.clone(), small_swing_period() / b_n, trials.amplitude()],
        )
        .table(iterates(&trials)?)
        .say(
            "Each step doubles the number of good digits. How large the error of an iterate is can be said exactly, \
             with the nome {} and one of Jacobi’s theta functions:",
            [letter("q")],
        )
        .show(nome)
        .show(theta)
        .show(trials.compare_cases("n", 0..=3, error)?)
        .say("As a power series the right side begins", [])
        .show(small)
        .say("so that the error of {} is nearly {}, which is squared, and divided by four, at each step.", [small_swing_period() / a_n, -(4 * power)]))
}

/// 1 + 2 Σ q^(j²).
pub(in super::super) fn theta_series() -> Formula {
    number(1) + 2 * series("j", 1, letter("q").pow(letter("j").squared()))
}

/// ϑ(q)⁻² up to a few powers of the nome.
fn theta_squared() -> Result<CheckedEquation, DerivationError> {
    let q = letter("q");
    let expanded = number(1) - 4 * q.clone() + 12 * q.clone().squared() + order(q.clone().pow(3));
    let statement = Statement::equal(number(1) / apply("ϑ", [q]).squared(), expanded);
    same_series_where(&Name::new("q"), 3, &[Given::Function("ϑ", "q", theta_series())], statement)
}

fn iterates(trials: &Trials) -> Result<DerivationTable, DerivationError> {
    let limit = agm(1, cos_half_amplitude());
    let mut rows = Vec::new();
    for n in 0..=STEPS {
        let (a, b) = (Formula::from(mean("a", n)), Formula::from(mean("b", n)));
        let error = |mean: &Formula| limit.clone() / mean.clone() - 1;
        let cell = |formula: Formula, digits| {
            let value = trials.value(&formula)?.to_f64();
            Ok::<Prose, DerivationError>(Prose::formula(rounded(value, digits, DecimalUnit::One)))
        };
        let errors = [cell(error(&a), 2)?, cell(error(&b), 2)?];
        rows.push(
            [vec![Prose::formula(number(n)), cell(a.clone(), 12)?, cell(b.clone(), 12)?], errors.to_vec()]
                .concat(),
        );
        // The table has twelve digits, and the mean squares its error in each row.
        if trials.value(&(a - b))?.to_f64() < 1e-30 {
            break;
        }
    }
    let n = || letter("n");
    let over = |name: &str| small_swing_period() / Formula::from(mean(name, n()));
    let head = vec![
        Prose::formula(n()),
        Prose::formula(mean("a", n()).into()),
        Prose::formula(mean("b", n()).into()),
        Prose::text("error of ").and(Prose::formula(over("a"))),
        Prose::text("error of ").and(Prose::formula(over("b"))),
    ];
    Ok(DerivationTable::numbers(head, rows, Prose::text("computed with 77 digits; errors are relative")))
}
