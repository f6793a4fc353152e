//! The exact ratio, and the formulas that match its series at small amplitudes.

use super::super::check::{DerivationError, Given, equal_fractions, same_series, same_series_where};
use super::super::document::DerivationStep;
use super::super::formula::{
    DecimalUnit, Formula, Name, Statement, agm, letter, monomial, number, order, sin,
};
use super::super::trials::Trials;
use super::super::words::{amplitude, cos_half_amplitude, period_ratio, theta_0};
use super::report::{exact_ratio as ratio, leading_error, stated};
use libration::algebra::Rational;
use libration::period_formulas::{frequency_in_amplitude, period_in_amplitude};

/// Σ cₙθ0²ⁿ and the order of the first omitted power.
pub(super) fn in_even_powers(coefficients: &[Rational]) -> Formula {
    let terms = coefficients.iter().enumerate().map(|(n, c)| monomial(c, &theta_0(), 2 * n));
    let next = i64::try_from(2 * coefficients.len()).unwrap_or(i64::MAX);
    Formula::Sum(terms.chain([order(theta_0().pow(next))]).collect())
}

fn fraction(numerator: i64, denominator: i64) -> Formula {
    Rational::new(numerator, denominator).map_or_else(|| number(0), Formula::from)
}

pub(super) fn exact_ratio(trials: &Trials) -> Result<DerivationStep, DerivationError> {
    let period_series = Statement::equal(ratio(), in_even_powers(&period_in_amplitude(3)));
    let frequency_series =
        Statement::equal(agm(1, cos_half_amplitude()), in_even_powers(&frequency_in_amplitude(3)));
    Ok(DerivationStep::new("approximated", "The quantity that is approximated")
        .say(
            "The exact ratio is one over the arithmetic–geometric mean of one and the cosine of half the amplitude: the \
             common limit of the two numbers when they are replaced, again and again, by their arithmetic and their geometric \
             mean. (The derivation by elliptic integrals shows why.)",
            [],
        )
        .show(trials.compare_with_library(Statement::equal(period_ratio(), ratio()))?)
        .show_all(trials.numbers(&[(ratio(), 11, DecimalUnit::One)])?)
        .say("Doing this with power series gives the series of the period, and that of the frequency, one over it:", [])
        .show(same_series(&amplitude(), 8, period_series)?)
        .show(same_series(&amplitude(), 8, frequency_series)?))
}

pub(super) fn small_angle_and_bernoulli(trials: &Trials) -> Result<DerivationStep, DerivationError> {
    let bernoulli = number(1) + theta_0().squared() / 16;
    Ok(DerivationStep::new("bernoulli", "Small swings, and Bernoulli")
        .say(
            "With nothing but the first term the period does not depend on the amplitude. What is lost is nearly the next \
             term:",
            [],
        )
        .show(leading_error("small_angle", "0", number(1))?)
        .say("Keeping that term gives the correction that goes back to Daniel Bernoulli:", [])
        .show(stated(trials, "bernoulli", "Ber", bernoulli.clone())?)
        .show(leading_error("bernoulli", "Ber", bernoulli)?)
        .say("Every further term of the series adds to the period, so that stopping anywhere leaves it too short.", []))
}

pub(super) fn molina(trials: &Trials) -> Result<DerivationStep, DerivationError> {
    let quotient = || theta_0() / sin(theta_0());
    let power = || letter("p");
    let fourth = power() / 180 + power().squared() / 72;
    let expanded =
        number(1) + power() / 6 * theta_0().squared() + fourth * theta_0().pow(4) + order(theta_0().pow(6));
    let general = Statement::equal(quotient().pow(power()), expanded);
    // Each coefficient is of at most second degree in p: three values decide, the fourth one is the formula's.
    let mut checked = None;
    for (numerator, denominator) in [(0, 1), (1, 1), (1, 2), (3, 8)] {
        let given = [Given::Value(Name::new("p"), fraction(numerator, denominator))];
        checked = Some(same_series_where(&amplitude(), 6, &given, general.clone())?);
    }
    let exponent = Statement::equal(6 * fraction(1, 16), fraction(3, 8));
    let left = Statement::equal(
        fraction(3, 8) / 180 + fraction(3, 8).squared() / 72 - fraction(11, 3072),
        fraction(7, 15360),
    );
    let formula = quotient().pow(fraction(3, 8));
    let step = DerivationStep::new("molina", "Molina: an exponent from the first term")
        .say(
            "Write the force as {} times {}. The second factor is one at the bottom and smallest at the turning point, where \
             it is {}. Replace it, all along the swing, by a power of this smallest value: then the motion is \
             harmonic, its frequency is changed by the square root of that power, and the period by",
            [letter("θ"), sin(letter("θ")) / letter("θ"), sin(theta_0()) / theta_0()],
        )
        .show_all(checked.into_iter().collect())
        .say(
            "with an exponent {} that is still free (checked for its values 0, 1/2, 1 and 3/8, which decides because the \
             coefficients are at most of second degree in it). The first term is that of the exact series if {} is 1/16, that is,",
            [power(), power() / 6],
        );
    Ok(step
        .show(equal_fractions(exponent)?)
        .show(stated(trials, "molina", "Mol", formula.clone())?)
        .say(
            "so that the factor in the force was taken to the power 3/4. In the next term there is a remainder,",
            [],
        )
        .show(equal_fractions(left)?)
        .show(leading_error("molina", "Mol", formula)?)
        .say(
            "nearly eight times smaller than what Bernoulli’s formula leaves out, and of the other sign.",
            [],
        ))
}
