//! A series in numbers: terms and partial sums, with a bound or an estimate of the remainder.
//!
//! # Method
//! Partial sums are floats of 256 bits and rounded once. Remainders are proven where a series with positive coefficients bounds the series or
//! equals it: the remainder of the positive series, from its value, is then the bound (`positive.rs`). For a polynomial force that series is the
//! period of the well that softens as much as the coefficients allow (`majorant/`); for the harmonics of the pendulum it is the series itself, by a
//! theorem on functions that map half planes into half planes (`comparison/pendulum_harmonic.rs`).
//!
//! Other remainders and every radius of convergence are estimates and are called so, the latter with a range. The rules of the estimates were
//! chosen, and are tested, by comparison with exact values. Padé approximants are exact, by Euclid's algorithm; a pole is called spurious when the
//! next lower approximant has none in its direction.

mod bound;
mod convergence;
mod majorant;
mod pade;
mod positive;
mod stride;
mod tail;

use libration_kernels::double_double::DoubleDouble;
use libration_numbers::algebra::{BigFloat, Rational};
use tail::beyond_the_last;

pub use bound::pendulum_period_remainder;
pub use convergence::{Convergence, Singularity};
pub use majorant::{MajorantAt, PeriodMajorant};
pub use pade::{Pade, Pole};
pub(crate) use positive::PositiveSeries;
pub(crate) use stride::stride;

/// A power series Σ cₙxⁿ at one x, term by term. Terms with cₙ = 0 are left out, the constant term excepted.
///
/// # Accuracy Terms, sums and distances between sums are rounded once, from sums with an error below 1e-60 of
/// their largest term. x is taken as the exact `f64`.
///
/// # Examples
/// ```
/// # extern crate libration_perturbation as libration;
/// use libration::period_formulas::period_in_amplitude;
/// use libration::perturbation::{Certainty, SeriesEvaluation, pendulum_period_remainder};
/// // T/T0 of the pendulum by even powers of θ0, here at a right angle.
/// let mut series = vec![];
/// for coefficient in period_in_amplitude(40) {
///     series.extend([coefficient, 0.into()]);
/// }
/// let amplitude = 90_f64.to_radians();
/// let bound = |power| pendulum_period_remainder(amplitude, power / 2);
/// let ratio = SeriesEvaluation::new(&series, amplitude).with_bound(bound);
/// assert!((ratio.value() - 1.180340599016096).abs() < 1e-15);
/// assert_eq!(ratio.steps()[3].remainder.certainty, Certainty::Proven);
/// assert_eq!(ratio.corrections_needed(1e-6), Some(8));
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct SeriesEvaluation {
    at: f64,
    steps: Vec<PartialSum>,
}

/// One term of a series, and the sum so far.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PartialSum {
    /// n.
    pub power: usize,
    /// cₙxⁿ.
    pub term: f64,
    /// c₀ + … + cₙxⁿ.
    pub sum: f64,
    /// Bound or estimate of the distance between the sum and that of the whole series.
    pub remainder: Remainder,
}

/// The magnitude of the omitted part of a sum.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Remainder {
    /// Bound of the omitted part, or an estimate of it, which is too small in about 1 of 100 cases, at order 5 and below in 2 of 100;
    /// infinite where the series does not converge, or is not known to.
    pub size: f64,
    /// Basis of the size.
    pub certainty: Certainty,
}

/// The basis of a remainder.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Certainty {
    /// A theorem.
    Proven,
    /// The last sum, and the decay of the coefficients continued beyond it.
    Estimated,
}

impl SeriesEvaluation {
    /// Σ cₙxⁿ with c₀, c₁, … given; all NaN when x is not finite. The remainders are estimates: the distance from the last sum, and for what is
    /// beyond it a geometric series with the ratio of the last terms. They are infinite where these do not shrink, and where fewer than three terms
    /// follow the first.
    #[must_use]
    pub fn new(coefficients: &[Rational], x: f64) -> Self {
        let (terms, sums) = terms_and_sums(coefficients, x);
        let last = sums.last().cloned().unwrap_or_else(|| float(0.0));
        let present: Vec<(usize, &BigFloat)> =
            terms.iter().filter(|(_, term)| !term.is_zero()).map(|(power, term)| (*power, term)).collect();
        let beyond = beyond_the_last(&present, Convergence::estimate(coefficients).as_ref(), x);
        let rounded = |number: &BigFloat| if x.is_finite() { number.to_f64() } else { f64::NAN };
        let steps = terms.iter().zip(sums).map(|((power, term), sum)| PartialSum {
            power: *power,
            term: rounded(term),
            sum: rounded(&sum),
            remainder: Remainder {
                size: rounded(&(last.clone() - sum)).abs() + beyond,
                certainty: Certainty::Estimated,
            },
        });
        Self { at: x, steps: steps.collect() }
    }

    /// The same terms with proven remainders: `remainder_after` gives a bound on the remainder after the terms up to a power.
    #[must_use]
    pub fn with_bound(mut self, remainder_after: impl Fn(usize) -> f64) -> Self {
        for step in &mut self.steps {
            step.remainder = Remainder { size: remainder_after(step.power), certainty: Certainty::Proven };
        }
        self
    }

    /// x.
    #[must_use]
    pub const fn at(&self) -> f64 {
        self.at
    }

    /// The terms by ascending power.
    #[must_use]
    pub fn steps(&self) -> &[PartialSum] {
        &self.steps
    }

    /// The sum of all terms.
    #[must_use]
    pub fn value(&self) -> f64 {
        self.steps.last().map_or(0.0, |step| step.sum)
    }

    /// The smallest term, beyond the first, when the last two are larger: the sum gets no better after it.
    #[must_use]
    pub fn smallest_term(&self) -> Option<&PartialSum> {
        let size = |step: &PartialSum| step.term.abs();
        let smallest = self.steps.iter().skip(1).min_by(|a, b| size(a).total_cmp(&size(b)))?;
        let last = self.steps.iter().rev().take(2);
        last.map(size).all(|last| last > size(smallest)).then_some(smallest)
    }

    /// The number of terms beyond the first for which the remainder is, and stays, at most this fraction of the
    /// sum; `None` when the terms given do not reach it.
    #[must_use]
    pub fn corrections_needed(&self, tolerance: f64) -> Option<usize> {
        let reached =
            |step: &PartialSum| step.sum.is_finite() && step.remainder.size <= tolerance * step.sum.abs();
        let good = self.steps.iter().rev().take_while(|step| reached(step)).count();
        (good > 0).then(|| self.steps.len() - good)
    }
}

/// Bits of the sums.
const PRECISION: usize = 256;

/// An `f64` as a long float.
fn float(x: f64) -> BigFloat {
    BigFloat::from_words(DoubleDouble::from(x), PRECISION)
}

/// The terms with their powers, and the sums up to each.
fn terms_and_sums(coefficients: &[Rational], x: f64) -> (Vec<(usize, BigFloat)>, Vec<BigFloat>) {
    let powers = std::iter::successors(Some(float(1.0)), |power| Some(power.clone() * float(x)));
    let terms: Vec<(usize, BigFloat)> = coefficients
        .iter()
        .zip(powers)
        .enumerate()
        .filter(|(n, (coefficient, _))| *n == 0 || !coefficient.is_zero())
        .map(|(n, (coefficient, power))| (n, BigFloat::from_rational(coefficient, PRECISION) * power))
        .collect();
    let add = |sum: &mut BigFloat, (_, term): &(usize, BigFloat)| {
        *sum = sum.clone() + term.clone();
        Some(sum.clone())
    };
    let sums = terms.iter().scan(float(0.0), add).collect();
    (terms, sums)
}
