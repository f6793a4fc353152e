//! Expansions with numbers that are not all fractions, such as √2 and π, which stay exact under names.

use super::{SymbolicExpansion, SymbolicExpansionError, expand_symbolically};
use crate::perturbation::expand::{expand, expand_with_pi, is_rational};
use crate::perturbation::two_sided::{AGREEING_PRECISION, agree};
use crate::perturbation::{Certificate, Expansion, ExpansionError, Gauge};
use libration_motion::oscillator::{Kind, Oscillator, SymbolicOscillator};
use libration_numbers::algebra::{BigFloat, Floats, LaurentPolynomials, Rational, Ring};
use libration_numbers::expression::Expression;
use libration_numbers::internals::expression::{Jet, Tape};
use libration_numbers::progress::Progress;

/// The highest order to which constants keep their names; above it coefficients have hundreds of terms.
const MAX_NAMED_ORDER: usize = 15;
/// The largest number of constants under names.
const MAX_NAMES: usize = 3;

/// The exact expansion of an oscillator whose numbers are not all fractions: π, √2 and other constants have names in the
/// coefficients, also π in those of two-sided forces ([`Kind::TwoSided`]) and the root ω0 where even harmonics are in proportion to it.
/// [`expand`] gives the same in digits, with which it is compared. `None` where the coefficients of [`expand`] are fractions, above
/// order 15, with more than three constants, and for limit cycles and equilibria that are not fractions.
///
/// # Examples
/// ```
/// # extern crate libration_perturbation as libration;
/// use libration::oscillator::Oscillator;
/// use libration::perturbation::{Gauge, expand_with_constants};
/// use libration::progress::Quiet;
/// let oscillator = Oscillator::new(&"x'' + sqrt(2)*x + x^3 = 0".parse()?)?;
/// let expansion = expand_with_constants(&oscillator, 3, &Gauge::XMax, &Quiet)?.ok_or("fractions")?;
/// assert_eq!(expansion.series.frequency_ratio[2].to_string(), "3/(8*c1)");
/// assert_eq!(expansion.constants[0].1.to_string(), "sqrt(2)");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// As [`expand`] and [`expand_symbolically`].
pub fn expand_with_constants(
    oscillator: &Oscillator,
    order: usize,
    gauge: &Gauge,
    progress: &dyn Progress,
) -> Result<Option<SymbolicExpansion>, SymbolicExpansionError> {
    if let Some(series) = expand_with_pi(oscillator, order, gauge, progress)? {
        let ring = LaurentPolynomials::new(vec!["pi".to_owned()]);
        let omega0 = Rational::new(1, 2).and_then(|half| ring.power(&series.omega0_squared, &half));
        let constants = vec![("pi".to_owned(), Expression::Pi)];
        return Ok(Some(SymbolicExpansion { letters: vec![], constants, omega0, omega0_name: None, series }));
    }
    let has_names = !matches!(oscillator.kind(), Kind::LimitCycle { .. } | Kind::TwoSided);
    if !has_names || order > MAX_NAMED_ORDER || is_rational(oscillator, order, gauge)? {
        return Ok(None);
    }
    let Some(equilibrium) = oscillator.equilibrium().exact() else { return Ok(None) };
    let centre = Expression::Number(equilibrium.clone());
    let Ok(symbolic) = SymbolicOscillator::about(oscillator.equation(), &centre) else { return Ok(None) };
    if symbolic.constants().len() > MAX_NAMES {
        return Ok(None);
    }
    let mut expansion = match expand_symbolically(&symbolic, order, gauge, progress) {
        Ok(expansion) => expansion,
        Err(SymbolicExpansionError::NoSeries | SymbolicExpansionError::TooManyTerms) => return Ok(None),
        Err(error) => return Err(error),
    };
    if expansion.series.certificate == Certificate::Unchecked {
        let digits = expand(oscillator, order, gauge, progress)?;
        expansion.series.certificate = match agree_with_values(&expansion, &digits) {
            Some(true) => Certificate::Digits,
            Some(false) => return Err(ExpansionError::Contradiction.into()),
            None => return Ok(None),
        };
    }
    Ok(Some(expansion))
}

/// Returns `true` if frequency and harmonics with the values of the constants are those in digits; `None` for constants without a value.
fn agree_with_values(expansion: &SymbolicExpansion, digits: &Expansion) -> Option<bool> {
    let values =
        expansion.constants.iter().map(|(_, constant)| value(constant)).collect::<Option<Vec<_>>>()?;
    Some(agree(&coefficients(&expansion.series), &values, &coefficients(digits)))
}

/// The value of a formula without symbols.
fn value(constant: &Expression) -> Option<BigFloat> {
    let floats = Floats { precision: AGREEING_PRECISION };
    let tape = Tape::new(&[constant], &[]).ok()?;
    Some(Jet::new(&floats, &tape, &[]).ok()?.result(0).first()?.clone())
}

/// The coefficients of the frequency and of all harmonics.
fn coefficients<C: Clone>(of: &Expansion<C>) -> Vec<C> {
    let harmonics = of.harmonics.iter().flat_map(|harmonic| harmonic.cos.iter().chain(&harmonic.sin));
    of.frequency_ratio.iter().chain(harmonics).cloned().collect()
}
