//! Choice of an oscillator: a key of the catalogue or an equation, with values for its parameters.

use super::names::EquationText;
use super::reading;
use super::values::{borrowed, values};
use crate::query_error::{Parameter, QueryError, argument, excerpt, option};
use libration::catalogue::is_like_a_key;
use libration::expression::{Equation, Expression, Symbol};
use libration::oscillator::{
    NamedOscillator, NumbersOrLetters, NumbersOrLettersError, Oscillator, OscillatorError, SymbolicOscillator,
};
use libration::quantity::{Angle, Displacement, is_angle_name};
use libration::systems::NamedSystem;

/// The oscillator.
#[derive(Clone, Debug, clap::Args)]
pub(crate) struct OscillatorOptions {
    /// A key of the catalogue, such as `pendulum` or `van_der_pol`, or an equation, such as "x'' + x + x^3 = 0" or "\ddot{x} + \sin x = 0"
    #[arg(value_name = "OSCILLATOR|EQUATION", default_value = "pendulum")]
    oscillator: EquationText,
    /// The value of a parameter: a number, or a formula such as 1/2; may be given several times
    #[arg(long, value_name = "NAME=VALUE")]
    set: Vec<String>,
    /// The equilibrium, if there are several [default: the stable one nearest to zero]
    #[arg(long, value_name = "X")]
    about: Option<String>,
}

/// An oscillator with the words for it.
#[derive(Clone, Debug)]
pub(crate) struct Chosen<O = Oscillator> {
    pub(crate) oscillator: O,
    /// The key in the catalogue.
    pub(crate) key: Option<&'static str>,
    /// Title of the oscillator.
    pub(crate) title: String,
    /// The parameters that have got a value.
    pub(crate) values: Vec<(String, String)>,
    /// The equation as it was read, if its text differs from the plain spelling.
    pub(crate) read_as: Option<String>,
}

/// An oscillator whose parameters have values, or one with symbolic parameters.
#[derive(Clone, Debug)]
pub(crate) enum ChosenWithLetters {
    Numbers(Chosen),
    Letters(Chosen<SymbolicOscillator>),
}

/// An equation of motion with the words for it.
#[derive(Clone, Debug)]
pub(crate) struct Asked {
    pub(crate) equation: Equation,
    /// The requested equilibrium.
    pub(crate) about: Option<Expression>,
    pub(crate) key: Option<&'static str>,
    pub(crate) title: String,
    pub(crate) values: Vec<(String, String)>,
    pub(crate) read_as: Option<String>,
}

impl Chosen {
    /// Returns `true` if the variable is an angle, by its name.
    pub(crate) fn is_angle(&self) -> bool {
        is_angle_name(self.oscillator.variable())
    }

    /// Reads an amplitude: a number, or an angle where the variable is one.
    pub(crate) fn amplitude(&self, argument: &Parameter, text: &str) -> Result<Displacement, QueryError> {
        if let Ok(number) = Displacement::from_number_text(text) {
            if self.is_angle() {
                super::bare::say(text);
            }
            return Ok(number);
        }
        if self.is_angle() {
            return Displacement::from_angle_text(text).map_err(|error| QueryError::usage(argument, error));
        }
        let name = self.oscillator.variable();
        let hint = "angle units are for variables with the name of an angle, such as theta";
        Err(QueryError::usage(
            argument,
            format!(
                "cannot read `{}` as an amplitude of {name}: give a number, such as 0.5; {hint}",
                text.trim()
            ),
        ))
    }
}

impl OscillatorOptions {
    /// The oscillator of this name or equation.
    pub(crate) fn new(oscillator: &str, set: &[String], about: Option<&str>) -> Self {
        Self { oscillator: oscillator.to_owned().into(), set: set.to_vec(), about: about.map(str::to_owned) }
    }

    /// The text of the oscillator, the values and the equilibrium as they were given.
    pub(crate) fn parts(&self) -> (&str, &[String], Option<&str>) {
        (&self.oscillator, &self.set, self.about.as_deref())
    }

    pub(crate) fn chosen(&self) -> Result<Chosen, QueryError> {
        let asked = self.asked()?;
        let oscillator = asked.oscillator().map_err(no_oscillator)?;
        Ok(asked.with(oscillator))
    }

    /// The oscillator with values for all its parameters, unless some remain symbolic.
    pub(crate) fn chosen_without(&self, letters: &[String]) -> Result<Chosen, QueryError> {
        match letters {
            [] => self.chosen(),
            _ => Err(QueryError::usage(
                option("letters"),
                format!(
                    "values are computed of numbers only: give {} values with <--set>",
                    letters.join(", ")
                ),
            )),
        }
    }

    /// The oscillator, with symbols for parameters that have no value. The inner error is that of a symbolic strength, for which a slow flow may be
    /// the result.
    pub(crate) fn chosen_with_letters(
        &self,
        letters: &[String],
    ) -> Result<Result<ChosenWithLetters, OscillatorError>, QueryError> {
        let asked = self.asked_with_letters(letters)?;
        match NumbersOrLetters::new(&asked.equation, asked.about.as_ref()) {
            Ok(NumbersOrLetters::Numbers(oscillator)) => {
                Ok(Ok(ChosenWithLetters::Numbers(asked.with(oscillator))))
            }
            Ok(NumbersOrLetters::Letters(oscillator)) => {
                Ok(Ok(ChosenWithLetters::Letters(asked.with(oscillator))))
            }
            Err(NumbersOrLettersError::Numbers(
                error @ (OscillatorError::NoStrength { .. } | OscillatorError::ExcitedNonlinear { .. }),
            )) => Ok(Err(error)),
            Err(error) => Err(QueryError::no_result("oscillator", &error).with_remedies(&error.remedies())),
        }
    }

    /// The requested equation, which may not be an oscillator.
    pub(crate) fn asked(&self) -> Result<Asked, QueryError> {
        self.asked_with_letters(&[])
    }

    /// The equation, where these parameters of a built-in oscillator stay letters.
    pub(crate) fn asked_with_letters(&self, letters: &[String]) -> Result<Asked, QueryError> {
        let named = NamedOscillator::by_key(self.oscillator.trim());
        let given = values(&self.set)?;
        let (equation, key, title) = match &named {
            Ok(named) => (of_catalogue(named, &given, letters)?, Some(named.key), named.title.to_owned()),
            Err(unknown) if is_like_a_key(&self.oscillator) => {
                return Err(QueryError::usage(argument("OSCILLATOR|EQUATION"), unknown));
            }
            Err(_) => (self.typed(&given, letters)?, None, "an equation of motion".to_owned()),
        };
        let about =
            self.about.as_deref().map(|text| value_of_variable(text, &equation, &given)).transpose()?;
        let open = equation.parameters();
        let mut values = values_used(named.ok(), &given);
        values.retain(|(name, _)| !open.contains(name));
        let read_as = if key.is_none() { Equation::read_as(&self.oscillator) } else { None };
        Ok(Asked { equation, about, key, title, values, read_as })
    }

    /// The equation of a key that only the systems have, such as `damped_pendulum`, with this parameter left open, or its first strength of
    /// a damping.
    pub(crate) fn asked_of_system(&self, open: Option<&str>) -> Option<Result<Asked, QueryError>> {
        let key = self.oscillator.trim();
        let named = NamedSystem::by_key(key)
            .ok()
            .filter(|named| named.coordinates.len() == 1 && named.count.is_none())?;
        let is_oscillator = NamedOscillator::by_key(key).is_ok();
        (!is_oscillator).then(|| self.of_system(named, open.unwrap_or(DAMPING)))
    }

    fn of_system(&self, named: &NamedSystem, open: &str) -> Result<Asked, QueryError> {
        let given = values(&self.set)?;
        let parse =
            |text: &str| text.parse::<Equation>().and_then(|equation| equation.with(&borrowed(&given)));
        let equation = parse(named.equations).map_err(|error| QueryError::usage(option("set"), error))?;
        let letters = equation.parameters();
        let defaults = named
            .parameters
            .iter()
            .filter(|parameter| parameter.name != open && letters.contains(parameter.name));
        let defaults: Vec<(String, Expression)> = defaults
            .filter_map(|parameter| Some((parameter.name.to_owned(), parameter.default.parse().ok()?)))
            .collect();
        let equation =
            equation.with(&borrowed(&defaults)).map_err(|error| QueryError::usage(option("set"), error))?;
        let about =
            self.about.as_deref().map(|text| value_of_variable(text, &equation, &given)).transpose()?;
        let absent = |(name, value): &(String, Expression)| {
            given.iter().any(|(given_name, _)| given_name == name) || *value != Expression::from(0)
        };
        let values = given.iter().cloned().chain(defaults.into_iter().filter(absent));
        let values = values.map(|(name, value)| (name, value.to_string())).collect();
        Ok(Asked {
            equation,
            about,
            key: Some(named.key),
            title: named.title.to_owned(),
            values,
            read_as: None,
        })
    }

    fn typed(&self, values: &[(String, Expression)], letters: &[String]) -> Result<Equation, QueryError> {
        let equation: Equation = self
            .oscillator
            .parse()
            .map_err(|error| QueryError::usage(argument("OSCILLATOR|EQUATION"), error))?;
        reading::say(&self.oscillator);
        let equation =
            equation.with(&borrowed(values)).map_err(|error| QueryError::usage(option("set"), error))?;
        let letters: Vec<&str> = letters.iter().map(String::as_str).collect();
        equation.parameters_called(&letters).map_err(|error| QueryError::usage(option("letters"), error))?;
        Ok(equation)
    }
}

/// The name of the damping strength in the systems that have one.
const DAMPING: &str = "c";

impl Asked {
    fn oscillator(&self) -> Result<Oscillator, OscillatorError> {
        match &self.about {
            None => Oscillator::new(&self.equation),
            Some(equilibrium) => Oscillator::about(&self.equation, equilibrium),
        }
    }

    fn with<O>(self, oscillator: O) -> Chosen<O> {
        let Self { key, title, values, read_as, .. } = self;
        Chosen { oscillator, key, title, values, read_as }
    }
}

/// A value of the variable: a formula of numbers and parameters, or an angle if the variable is one.
fn value_of_variable(
    text: &str,
    equation: &Equation,
    given: &[(String, Expression)],
) -> Result<Expression, QueryError> {
    let refusal = |reason: String| QueryError::usage(option("about"), reason);
    let variable = equation.variables().first().map_or("", String::as_str);
    let with_value = |formula: Expression, (name, value): &(String, Expression)| {
        formula.substitute(&Symbol::plain(name), value)
    };
    let formula = text.parse::<Expression>().map(|formula| given.iter().fold(formula, with_value));
    if let Ok(constant) = formula.as_ref()
        && constant
            .symbols()
            .iter()
            .all(|symbol| symbol.primes == 0 && equation.parameters().contains(&symbol.name))
    {
        return Ok(constant.clone());
    }
    let angle = text.parse::<Angle>().ok().filter(|_| is_angle_name(variable));
    if let Some(radians) = angle.and_then(|angle| format!("{:e}", angle.radians()).parse().ok()) {
        return Ok(radians);
    }
    let shown = excerpt(text.trim());
    Err(refusal(match formula {
        Err(error) => error.to_string(),
        Ok(_) if is_angle_name(variable) => {
            format!(
                "cannot read `{shown}` as a position: give a number or an angle, such as 0.5, pi/2 or 90deg"
            )
        }
        Ok(_) => format!(
            "cannot read `{shown}` as a position: give a number, such as 0.5 or sqrt(2)/2; angle units are for \
             variables with the name of an angle, such as theta"
        ),
    }))
}

fn of_catalogue(
    named: &NamedOscillator,
    values: &[(String, Expression)],
    letters: &[String],
) -> Result<Equation, QueryError> {
    // Values first, so that the option that is wrong is the one that is blamed.
    named.equation_with(&borrowed(values)).map_err(|error| QueryError::usage(option("set"), error))?;
    let letters: Vec<&str> = letters.iter().map(String::as_str).collect();
    let equation = named.equation_with_letters(&borrowed(values), &letters);
    equation.map_err(|error| QueryError::usage(option("letters"), error))
}

/// The given values, and those of the catalogue for the other parameters.
fn values_used(named: Option<&NamedOscillator>, given: &[(String, Expression)]) -> Vec<(String, String)> {
    let defaults = named.into_iter().flat_map(|named| {
        named.parameters.iter().filter(|parameter| Some(parameter.name) != named.expansion_parameter)
    });
    let defaults = defaults
        .filter(|parameter| given.iter().all(|(name, _)| name != parameter.name))
        .map(|parameter| (parameter.name.to_owned(), parameter.default.to_owned()));
    let given = given.iter().map(|(name, value)| (name.clone(), value.to_string()));
    given.chain(defaults).collect()
}

pub(crate) fn no_oscillator(error: OscillatorError) -> QueryError {
    QueryError::no_result("oscillator", &error).with_remedies(&error.remedies())
}
