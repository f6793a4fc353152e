//! Expansions whose coefficients keep letters: the same recurrences over Laurent polynomials.
//!
//! # Method
//! Where ω0² is a sum, its root is a further symbol, whose square is put back as far as one of the terms of the sum leads the others; the remainder
//! is compared by clearing powers of ω0. The reversion of the potential is checked in symbols, and everything once more with fractions in their
//! place, modulo primes.

mod constants;
mod frequency;

pub use constants::expand_with_constants;

use super::certificate::agrees_with_the_potential;
use super::expand::{ExpansionError, MAX_ORDER};
use super::expansion::{Certificate, Expansion, ExpansionVariable, Heading, Precision};
use super::gauge::Gauge;
use super::model::{Model, Motion};
use super::modular::{Unsolved, exact_series};
use super::series_set::SeriesSet;
use super::shape::{Shape, shape_of};
use frequency::{Frequency, Point};
use libration_motion::oscillator::{Kind, SymbolicOscillator};
use libration_numbers::expression::{Expression, Function, Symbol};
use libration_numbers::internals::progress::Watch;
use libration_numbers::progress::{Progress, Stage};
use libration_numbers::{
    algebra::{LaurentPolynomial, LaurentPolynomials, Rational, Ring},
    internals::algebra::HarmonicSums,
};

/// The expansion of an oscillator with symbolic parameters.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SymbolicExpansion {
    /// The letters, in the order of the alphabet.
    pub letters: Vec<String>,
    /// Names of other constants in the coefficients, with their values: c1 for √2, pi for π.
    pub constants: Vec<(String, Expression)>,
    /// The positive root ω0 of ω0², where that is a product of letters and a fraction.
    pub omega0: Option<LaurentPolynomial>,
    /// The name of ω0 in the coefficients, if ω0² is a sum.
    pub omega0_name: Option<String>,
    /// The series.
    pub series: Expansion<LaurentPolynomial>,
}

impl SymbolicExpansion {
    /// Ω by powers of the variable, where the root of ω0² is a product of letters and a fraction.
    #[must_use]
    pub fn frequency(&self) -> Option<Vec<LaurentPolynomial>> {
        let omega0 = self.omega0.as_ref()?;
        let ring = LaurentPolynomials::new(omega0.letters().to_vec());
        Some(self.series.frequency_ratio.iter().map(|ratio| ring.multiply(omega0, ratio)).collect())
    }
}

/// The exact expansion of the periodic motions of an oscillator with letters, as [`expand`](super::expand) gives it with numbers.
///
/// Coefficients are polynomials in the letters over powers of those in ω0². Where ω0² is a sum, ω0 itself stands in the
/// coefficients as a further letter.
///
/// # Examples
/// ```
/// # extern crate libration_perturbation as libration;
/// use libration::oscillator::SymbolicOscillator;
/// use libration::perturbation::{Gauge, expand_symbolically};
/// use libration::progress::Quiet;
/// let oscillator = SymbolicOscillator::new(&"x'' + w^2*x + a*x^2 + b*x^3 = 0".parse()?)?;
/// let expansion = expand_symbolically(&oscillator, 3, &Gauge::Fundamental, &Quiet)?;
/// assert_eq!(expansion.series.frequency_ratio[2].to_string(), "3*b/(8*w^2) - 5*a^2/(12*w^4)");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// An order out of range, a gauge that the oscillator does not have, and coefficients with more than ten thousand terms.
/// [`SymbolicExpansionError::Interrupted`], with the orders that were found, if the call is cancelled.
pub fn expand_symbolically(
    oscillator: &SymbolicOscillator,
    order: usize,
    gauge: &Gauge,
    progress: &dyn Progress,
) -> Result<SymbolicExpansion, SymbolicExpansionError> {
    if !(1..=MAX_ORDER).contains(&order) {
        return Err(ExpansionError::Order(order).into());
    }
    check_gauge(gauge, oscillator)?;
    SymbolicProblem { oscillator, order, gauge, frequency: Frequency::new(oscillator) }
        .answer(&Watch::new(progress))
}

fn check_gauge(gauge: &Gauge, oscillator: &SymbolicOscillator) -> Result<(), ExpansionError> {
    match gauge {
        Gauge::Energy if *oscillator.kind() != Kind::Conservative => Err(ExpansionError::EnergyOfVelocity),
        Gauge::Nome if !is_pendulum(oscillator) => Err(ExpansionError::NomeOfOther),
        _ => Ok(()),
    }
}

/// Returns `true` if the acceleration is −ω0²·sin x.
fn is_pendulum(oscillator: &SymbolicOscillator) -> bool {
    let x = Symbol::plain(oscillator.variable());
    let slope = oscillator.acceleration().derivative(&x).substitute(&x, &Expression::from(0)).simplified();
    let sine = Expression::Call(Function::Sin, Box::new(Expression::Symbol(x)));
    let pendulum = Expression::Multiply(Box::new(slope), Box::new(sine));
    Expression::Subtract(Box::new(oscillator.acceleration().clone()), Box::new(pendulum)).vanishes()
}

struct SymbolicProblem<'a> {
    oscillator: &'a SymbolicOscillator,
    order: usize,
    gauge: &'a Gauge,
    frequency: Frequency<'a>,
}

impl SymbolicProblem<'_> {
    fn answer(&self, watch: &Watch<'_>) -> Result<SymbolicExpansion, SymbolicExpansionError> {
        let model = self.model(self.frequency.squared(), self.oscillator.values().to_vec());
        watch.begin(Stage::Check, Some(self.order));
        let set = self.series(&model, watch).ok_or(SymbolicExpansionError::NoSeries)?;
        if set.numbers().iter().any(LaurentPolynomial::is_beyond_limit) {
            return Err(SymbolicExpansionError::TooManyTerms);
        }
        let interrupted = |set: SeriesSet<_>| {
            let partial = (set.order() > 0).then(|| Box::new(self.heading(set, Certificate::Unchecked)));
            SymbolicExpansionError::Interrupted { known: partial }
        };
        if watch.is_stopped() {
            return Err(interrupted(set));
        }
        let certificate = self.certificate(&model, &set, watch)?;
        if watch.is_stopped() { Err(interrupted(set)) } else { Ok(self.heading(set, certificate)) }
    }

    fn model<N>(&self, omega0_squared: N, values: Vec<N>) -> Model<N> {
        Model {
            tape: self.oscillator.tape().clone(),
            values,
            omega0_squared,
            uses_velocity: *self.oscillator.kind() != Kind::Conservative,
            motion: Motion::Centre { gauge: self.gauge.clone(), shape: self.shape() },
            order: self.order,
        }
    }

    fn shape(&self) -> Shape {
        shape_of(self.oscillator.kind(), self.oscillator.is_odd())
    }

    fn series(
        &self,
        model: &Model<LaurentPolynomial>,
        watch: &Watch<'_>,
    ) -> Option<SeriesSet<LaurentPolynomial>> {
        let ring = HarmonicSums { numbers: self.oscillator.ring().clone() };
        let set =
            model.series(&ring, |number| Some(number.clone()), |_| Some(self.frequency.root()), watch)?;
        set.with_numbers(set.numbers().iter().map(|number| self.frequency.reduced(number)))
    }

    /// Checks by the potential in symbols if there is one, and with numbers in place of symbols.
    fn certificate(
        &self,
        model: &Model<LaurentPolynomial>,
        set: &SeriesSet<LaurentPolynomial>,
        watch: &Watch<'_>,
    ) -> Result<Certificate, SymbolicExpansionError> {
        let proof = (*self.oscillator.kind() == Kind::Conservative).then(|| {
            let same = |a: &Vec<_>, b: &Vec<_>| self.frequency.are_equal(a, b);
            agrees_with_the_potential(self.oscillator.ring(), model, set, same, watch)
        });
        let proof = proof.flatten();
        match (proof, self.agrees_with_numbers(set, watch)) {
            _ if watch.is_stopped() => Ok(Certificate::Unchecked),
            (Some(false), _) | (_, Some(false)) => Err(ExpansionError::Contradiction.into()),
            (Some(true), Some(true)) => Ok(Certificate::Potential),
            (None, Some(true)) => Ok(Certificate::Substitution),
            (_, None) => Ok(Certificate::Unchecked),
        }
    }

    /// Returns `true` if the expansion with numbers, modulo primes, has the same coefficients; `None` without such an expansion.
    fn agrees_with_numbers(&self, set: &SeriesSet<LaurentPolynomial>, watch: &Watch<'_>) -> Option<bool> {
        let coefficients = set.numbers();
        let largest = coefficients.iter().map(LaurentPolynomial::largest_half_power).max().unwrap_or(0);
        let point = Point::new(&self.frequency, largest)?;
        let values = self.oscillator.values().iter().map(|value| point.value(value));
        if *self.oscillator.kind() == Kind::Mirrored && point.omega0_squared().square_root().is_none() {
            return None; // Even harmonics are in proportion to ω0, which no prime has for certain.
        }
        let model = self.model(point.omega0_squared().clone(), values.collect::<Option<Vec<_>>>()?);
        let numbers = match exact_series(&model, watch) {
            Ok(set) => set.numbers(),
            Err(Unsolved::Interrupted(_) | Unsolved::NoPrimes) => return None,
        };
        Some(
            coefficients.len() == numbers.len()
                && coefficients
                    .iter()
                    .zip(&numbers)
                    .all(|(coefficient, number)| point.value(coefficient).as_ref() == Some(number)),
        )
    }

    fn heading(&self, set: SeriesSet<LaurentPolynomial>, certificate: Certificate) -> SymbolicExpansion {
        let (oscillator, ring) = (self.oscillator, self.oscillator.ring());
        let one = ring.rational(&Rational::from(1)).unwrap_or_else(|| ring.zero());
        let mut constants = oscillator.constants().to_vec();
        constants.extend(self.frequency.named_root(&set.numbers()));
        let heading = Heading {
            order: set.order(),
            variable: ExpansionVariable::Epsilon(self.gauge.clone()),
            phase_origin: self.shape().into(),
            has_all_harmonics: true,
            precision: Precision::Exact,
            equilibrium: oscillator.equilibrium().clone(),
            omega0_squared: oscillator.omega0_squared().clone(),
            unit_squared: one,
        };
        SymbolicExpansion {
            letters: oscillator.letters().to_vec(),
            constants,
            omega0: self.frequency.in_letters(),
            omega0_name: self.frequency.name(),
            series: Expansion::new(ring, heading, set, certificate),
        }
    }
}

/// The reason why there is no symbolic expansion.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum SymbolicExpansionError {
    /// An error that expansions in numbers have too.
    #[error(transparent)]
    Expansion(#[from] ExpansionError),
    /// A coefficient that is not a Laurent polynomial.
    #[error(
        "the acceleration has no power series about the equilibrium whose coefficients are sums of products of symbols, their powers and roots: give values to some of the symbols"
    )]
    NoSeries,
    /// Coefficients that are too long.
    #[error(
        "a coefficient would have more than ten thousand terms: give a lower order, or values to some of the symbols"
    )]
    TooManyTerms,
    /// The computation was interrupted.
    #[error("interrupted")]
    Interrupted {
        /// Result up to the cancellation, not checked by another method.
        known: Option<Box<SymbolicExpansion>>,
    },
}
