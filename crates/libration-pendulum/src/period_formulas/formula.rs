//! A formula with its source and properties, and its methods.

use std::fmt;

use super::error::Exact;
use super::law::Law;
use super::swing::{Swing, SwingAmplitude};
use libration_numbers::algebra::Rational;
use libration_numbers::internals::catalogue::Named;
use libration_numbers::quantity::Angle;

/// An approximation to T/T0, the period over that of small swings, with its source and properties.
///
/// # Examples
/// ```
/// # extern crate libration_pendulum as libration;
/// use libration::period_formulas::PeriodFormula;
/// use libration::quantity::Angle;
/// let molina = PeriodFormula::by_key("molina")?;
/// let error = molina.fractional_error(&Angle::from_degrees(60.0)?);
/// assert!((error - 6.0660e-4).abs() < 1e-8);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct PeriodFormula {
    pub(super) key: String,
    pub(super) also: Vec<String>,
    pub(super) name: String,
    pub(super) authors: String,
    pub(super) year: Option<u16>,
    pub(super) source: String,
    pub(super) attribution: Attribution,
    pub(super) text: String,
    pub(super) derivation: String,
    pub(super) latex: String,
    pub(super) domain: String,
    pub(super) complexity: Complexity,
    pub(super) leading_error: Option<LeadingTerm>,
    pub(super) law: Law,
}

/// The certainty of a source.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Attribution {
    /// The source was read, or a text was read that states the formula with its origin.
    Certain,
    /// The formula is verified; its origin is attributed from memory.
    Attributed,
}

/// The operations of an evaluation on a pocket calculator.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Complexity {
    /// Sines, cosines, logarithms, powers, Bessel functions.
    pub functions: u16,
    /// Square roots.
    pub roots: u16,
    /// Additions, subtractions, multiplications, divisions.
    pub operations: u16,
}

impl Complexity {
    /// A weighted count that orders formulas, beginning with the simplest: an operation counts 1, a root 2, a function 3.
    #[must_use]
    pub fn rank(&self) -> u32 {
        u32::from(self.operations) + 2 * u32::from(self.roots) + 3 * u32::from(self.functions)
    }
}

/// The leading term, coefficient·θ0^power, of a fractional error at small amplitude.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LeadingTerm {
    /// The coefficient, exactly.
    pub coefficient: Rational,
    /// The power of the amplitude in radians.
    pub power: u32,
}

impl fmt::Display for LeadingTerm {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(formatter, "{}·θ0^{}", self.coefficient, self.power)
    }
}

impl Named for PeriodFormula {
    const KIND: &'static str = "formula";
    const OTHERWISE: &'static str = "; power_series_N, black_vel_N and sin2_series_N have up to 1000 corrections, pade_power_N and pade_sin2_N up to degree 5";

    fn keys(&self) -> impl Iterator<Item = &str> {
        std::iter::once(&self.key).chain(&self.also).map(String::as_str)
    }
}

impl PeriodFormula {
    /// The series or iteration of which the formula is a member, such as `power_series` for `power_series_3` and `bernoulli`; the key of a
    /// formula that stands alone.
    #[must_use]
    pub fn family(&self) -> &str {
        let keys = || std::iter::once(&self.key).chain(&self.also).map(String::as_str);
        let numbered = |key: &&str| key.ends_with(|letter: char| letter.is_ascii_digit());
        let is_digit = |letter: char| letter.is_ascii_digit();
        keys().find(numbered).map_or(&self.key, |key| key.trim_end_matches(is_digit).trim_end_matches('_'))
    }

    /// The formula's T/T0 as an `f64`, to a few ulp; NaN where the formula or the period is not defined.
    #[must_use]
    pub fn period_ratio(&self, amplitude: &Angle) -> f64 {
        SwingAmplitude::from_angle(amplitude).map_or(f64::NAN, |amplitude| self.ratio(amplitude))
    }

    /// [`period_ratio`](Self::period_ratio) of an amplitude in radians, within [0, π).
    #[must_use]
    pub fn period_ratio_at(&self, amplitude: f64) -> f64 {
        SwingAmplitude::from_radians(amplitude).map_or(f64::NAN, |amplitude| self.ratio(amplitude))
    }

    /// formula/exact − 1 with full relative accuracy however small, in floats of as many digits as necessary; zero only below the smallest
    /// `f64`, infinite where the formula is not defined, NaN where the period is not.
    #[must_use]
    pub fn fractional_error(&self, amplitude: &Angle) -> f64 {
        SwingAmplitude::from_angle(amplitude).map_or(f64::NAN, |amplitude| self.error(amplitude))
    }

    /// [`fractional_error`](Self::fractional_error) of an amplitude in radians, within [0, π).
    #[must_use]
    pub fn fractional_error_at(&self, amplitude: f64) -> f64 {
        SwingAmplitude::from_radians(amplitude).map_or(f64::NAN, |amplitude| self.error(amplitude))
    }

    #[doc(hidden)]
    pub const fn law(&self) -> &Law {
        &self.law
    }

    fn ratio(&self, amplitude: SwingAmplitude) -> f64 {
        self.law.ratio(&Swing::new(amplitude))
    }

    pub(super) fn error(&self, amplitude: SwingAmplitude) -> f64 {
        self.error_beside(&mut Exact::new(amplitude))
    }

    /// The fractional error for an exact period that other formulas share; infinite where the formula is not defined.
    pub(super) fn error_beside(&self, exact: &mut Exact) -> f64 {
        if self.is_defined(exact.amplitude()) { exact.fractional_error(&self.law) } else { f64::INFINITY }
    }

    fn is_defined(&self, amplitude: SwingAmplitude) -> bool {
        !matches!(self.law, Law::CubicForce) || amplitude.radians() < self.defined_below()
    }

    /// The amplitude in radians from which on the formula has no value; π for most formulas.
    #[must_use]
    pub fn defined_below(&self) -> f64 {
        match self.law {
            // 1 − θ0²/8 stays positive.
            Law::CubicForce => 2.0 * std::f64::consts::SQRT_2,
            _ => std::f64::consts::PI,
        }
    }

    /// The key, lower snake case.
    #[must_use]
    pub fn key(&self) -> &str {
        &self.key
    }

    /// Other keys of the same formula.
    #[must_use]
    pub fn other_keys(&self) -> &[String] {
        &self.also
    }

    /// The name to print.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.name
    }

    /// The authors of the publication; empty where no author is known.
    #[must_use]
    pub fn authors(&self) -> &str {
        &self.authors
    }

    /// The year of publication.
    #[must_use]
    pub fn year(&self) -> Option<u16> {
        self.year
    }

    /// The place of publication; a source that was not read begins with `attributed to`.
    #[must_use]
    pub fn source(&self) -> &str {
        &self.source
    }

    /// The certainty of the source.
    #[must_use]
    pub fn attribution(&self) -> Attribution {
        self.attribution
    }

    /// T/T0 as a line of text, θ0 the amplitude, with the [`ABBREVIATIONS`](super::ABBREVIATIONS).
    #[must_use]
    pub fn text(&self) -> &str {
        &self.text
    }

    /// The argument that leads to the formula, in a sentence without its stop.
    #[must_use]
    pub fn derivation(&self) -> &str {
        &self.derivation
    }

    /// T/T0 in LaTeX, θ0 the amplitude.
    #[must_use]
    pub fn latex(&self) -> &str {
        &self.latex
    }

    /// The range of good accuracy and the behaviour at its end, in words.
    #[must_use]
    pub fn domain(&self) -> &str {
        &self.domain
    }

    /// The operations of an evaluation.
    #[must_use]
    pub fn complexity(&self) -> Complexity {
        self.complexity
    }

    /// The leading fractional error at small amplitude, where it is known exactly.
    #[must_use]
    pub fn leading_error(&self) -> Option<&LeadingTerm> {
        self.leading_error.as_ref()
    }
}

impl LeadingTerm {
    pub(super) fn from_text((coefficient, power): (&str, u32)) -> Option<Self> {
        coefficient.parse().ok().map(|coefficient| Self { coefficient, power })
    }
}

/// The fractional errors of the formulas at each amplitude in turn, as [`PeriodFormula::fractional_error`] gives them: a row of `formulas.len()`
/// numbers for the first amplitude, one for the second, and so on. The exact period is computed once for all formulas, and for many amplitudes
/// at a time.
///
/// # Examples
/// ```
/// # extern crate libration_pendulum as libration;
/// use libration::period_formulas::{catalogue, fractional_errors};
/// use libration::quantity::Angle;
/// let amplitudes = [Angle::from_degrees(60.0)?, Angle::from_degrees(120.0)?];
/// let errors = fractional_errors(&catalogue()[..3], &amplitudes);
/// assert_eq!(errors[3 + 2], catalogue()[2].fractional_error(&amplitudes[1]));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[must_use]
pub fn fractional_errors(formulas: &[PeriodFormula], amplitudes: &[Angle]) -> Vec<f64> {
    let amplitudes: Vec<_> = amplitudes.iter().map(SwingAmplitude::from_angle).collect();
    let mut errors = Vec::with_capacity(formulas.len() * amplitudes.len());
    for mut exact in Exact::each(&amplitudes) {
        let error =
            |formula: &PeriodFormula| exact.as_mut().map_or(f64::NAN, |exact| formula.error_beside(exact));
        errors.extend(formulas.iter().map(error));
    }
    errors
}
