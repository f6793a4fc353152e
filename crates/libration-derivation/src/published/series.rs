//! The formulas with a series in the amplitude as denominator.

use super::super::check::{DerivationError, equal_fractions, same_series};
use super::super::document::DerivationStep;
use super::super::formula::{DecimalUnit, Formula, Statement, monomial, number, order, rounded};
use super::super::trials::Trials;
use super::super::words::{amplitude, theta_0};
use super::report::{catalogued, leading_error, stated};
use libration::algebra::Rational;
use libration::period_formulas::{ErrorTable, frequency_in_amplitude};
use libration::progress::Quiet;
use libration::quantity::Angle;

/// The inverse of the frequency's series with this many corrections.
fn formula(corrections: usize) -> Formula {
    let coefficients = frequency_in_amplitude(corrections);
    let terms = coefficients.iter().enumerate().map(|(n, c)| monomial(c, &theta_0(), 2 * n));
    number(1) / Formula::Sum(terms.collect())
}

fn fraction(numerator: i64, denominator: i64) -> Formula {
    Rational::new(numerator, denominator).map_or_else(|| number(0), Formula::from)
}

pub(super) fn black_vel(trials: &Trials) -> Result<DerivationStep, DerivationError> {
    let one_term = number(1) / (number(1) - theta_0().squared() / 16);
    let expanded = Statement::equal(
        one_term.clone(),
        number(1) + theta_0().squared() / 16 + theta_0().pow(4) / 256 + order(theta_0().pow(6)),
    );
    let excess = Statement::equal(fraction(1, 256) - fraction(11, 3072), fraction(1, 3072));
    Ok(DerivationStep::new("black-vel", "Denman’s formula: a Padé approximant")
        .say(
            "Perturbation theory gives the frequency as a series, and the period as one over it. With one correction this \
             is the formula of H. H. Denman (Am. J. Phys. 27, 524, 1959), to which P. F. Hinrichsen drew attention again (Phys. Teach. 59, 646, 2021), and the first of \
             Black and Vel’s (2023):",
            [],
        )
        .show(stated(trials, "denman", "De", one_term.clone())?)
        .show(same_series(&amplitude(), 6, expanded)?)
        .say(
            "It has the first two terms of the series of the period, and no other quotient of a number and a polynomial of \
             first degree in {} has them: it is the Padé approximant of degrees zero and one. Its next coefficient is wrong by only",
            [theta_0().squared()],
        )
        .show(equal_fractions(excess)?)
        .say("eleven times less than Bernoulli’s formula, which has none:", [])
        .show(leading_error("denman", "De", one_term.clone())?)
        .say(
            "Like the period it becomes infinite, though at an amplitude of 4 rad, beyond the upright position. So it is \
             too long at first and too short near the top, and in between, at {}, it is exact.",
            [exact_at("denman")?],
        ))
}

pub(super) fn three_terms(trials: &Trials) -> Result<DerivationStep, DerivationError> {
    let mut step = DerivationStep::new("more-terms", "More terms").say(
        "With more terms of the frequency the error at small amplitudes falls by two powers of {} each time,",
        [theta_0()],
    );
    for (corrections, key, mark) in [(2, "black_vel_2", "BV2"), (3, "black_vel_3", "BV3")] {
        step = step.show(stated(trials, key, mark, formula(corrections))?).show(leading_error(
            key,
            mark,
            formula(corrections),
        )?);
    }
    Ok(step.say(
        "but near the top nothing is gained: these polynomials have their zero far beyond it, and the compensation of the \
         one-term formula is gone. Above {} it is better than the formula with two terms, above {} than that with three.",
        [overtaken("black_vel_2", "denman")?, overtaken("black_vel_3", "denman")?],
    ))
}

/// The smallest amplitude at which the formula is exact.
fn exact_at(key: &str) -> Result<Formula, DerivationError> {
    let table = ErrorTable::new(&[catalogued(key)?], &Quiet)?;
    let first = table.amplitudes_where_exact(0).into_iter().next();
    first.map(degrees).ok_or_else(|| missing(key))
}

/// The last amplitude at which the second formula becomes better than the first.
fn overtaken(first: &str, second: &str) -> Result<Formula, DerivationError> {
    let crossovers = catalogued(first)?.crossovers_with(&catalogued(second)?);
    let last = crossovers.into_iter().rfind(|crossover| crossover.better_above == second);
    last.map(|crossover| degrees(crossover.amplitude)).ok_or_else(|| missing(second))
}

fn degrees(angle: Angle) -> Formula {
    rounded(angle.degrees(), 7, DecimalUnit::Degree)
}

fn missing(key: &str) -> DerivationError {
    DerivationError::Failed { formula: key.to_owned(), reason: "there is no such amplitude".to_owned() }
}
