//! The oscillators that can be requested by name.

use super::{Oscillator, OscillatorError};
use libration_numbers::expression::{Equation, EquationError, Expression};
use libration_numbers::{catalogue::NamedParameter, internals::catalogue::Named};

/// An oscillator of the literature, as data.
///
/// # Examples
/// ```
/// # extern crate libration_motion as libration;
/// use libration::oscillator::NamedOscillator;
/// let duffing = NamedOscillator::by_key("duffing")?;
/// let oscillator = duffing.oscillator(&[("epsilon", "0.1".parse()?)])?;
/// assert_eq!(oscillator.acceleration().to_string(), "-x - 0.1*x^3");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct NamedOscillator {
    /// The name by which it is requested.
    pub key: &'static str,
    /// Alternative names.
    pub also: &'static [&'static str],
    /// The name used in a sentence.
    pub title: &'static str,
    /// The equation of motion.
    pub equation: &'static str,
    /// The parameters in the equation.
    pub parameters: &'static [NamedParameter],
    /// The parameter in which a limit cycle is expanded; it keeps no value.
    pub expansion_parameter: Option<&'static str>,
    /// A description of the oscillator.
    pub description: &'static str,
    /// The motions that are oscillations about the equilibrium.
    pub domain: &'static str,
    /// The source, confirmed in the work itself or in a text that cites it; a source that was not read
    /// but remembered begins with `attributed to` and ends with `not verified against the original`.
    pub source: &'static str,
}

impl Named for NamedOscillator {
    const KIND: &'static str = "oscillator";
    const OTHERWISE: &'static str = "; or write its equation, such as x'' + sin(x) = 0";

    fn keys(&self) -> impl Iterator<Item = &str> {
        std::iter::once(self.key).chain(self.also.iter().copied())
    }
}

impl NamedOscillator {
    /// The equation with these values of parameters, and the default values of
    /// the others; an expansion parameter without a given value stays open.
    ///
    /// # Errors
    /// A value for a name that is not a parameter, or one that is not constant.
    pub fn equation_with(&self, values: &[(&str, Expression)]) -> Result<Equation, EquationError> {
        self.equation_with_letters(values, &[])
    }

    /// The equation with these values, in which the parameters of the second argument stay symbols.
    ///
    /// # Errors
    /// The errors of [`equation_with`](Self::equation_with), and a symbol that is not a parameter, or has a value.
    pub fn equation_with_letters(
        &self,
        values: &[(&str, Expression)],
        letters: &[&str],
    ) -> Result<Equation, EquationError> {
        let given = self.equation.parse::<Equation>()?.with(values)?;
        let letters = given.parameters_called(letters)?;
        let mut open = given.parameters();
        open.retain(|name| !letters.contains(name));
        let open = self.parameters.iter().filter(|parameter| open.contains(parameter.name));
        let open = open.filter(|open| Some(open.name) != self.expansion_parameter);
        let defaults = open.map(|open| Ok((open.name, open.default.parse()?)));
        given.with(&defaults.collect::<Result<Vec<_>, EquationError>>()?)
    }

    /// The oscillator about its equilibrium, with these values of parameters.
    ///
    /// # Errors
    /// As [`equation_with`](Self::equation_with) and [`Oscillator::new`].
    pub fn oscillator(&self, values: &[(&str, Expression)]) -> Result<Oscillator, OscillatorError> {
        Oscillator::new(&self.equation_with(values)?)
    }
}
