//! Which oscillator is meant: a key of the catalogue or an equation, with values for its parameters.

use super::values::{borrowed, is_like_a_key, values};
use crate::failure::{Failure, excerpt};
use libration::expression::{Equation, Expression};
use libration::oscillator::{NamedOscillator, Oscillator};
use libration::quantity::{Angle, Displacement, is_angle_name};

/// The oscillator asked about.
#[derive(Clone, Debug, clap::Args)]
pub(crate) struct OscillatorOptions {
    /// A key of the catalogue, such as `pendulum` or `van_der_pol`, or an equation, such as "x'' + x + x^3 = 0"
    #[arg(value_name = "OSCILLATOR|EQUATION", default_value = "pendulum")]
    oscillator: String,
    /// The value of a parameter: a number, or a formula such as 1/2; may be given several times
    #[arg(long, value_name = "NAME=VALUE")]
    set: Vec<String>,
    /// Which equilibrium, where there are several [default: the stable one nearest to zero]
    #[arg(long, value_name = "X")]
    about: Option<String>,
}

/// An oscillator with the words for it.
#[derive(Clone, Debug)]
pub(crate) struct Chosen {
    pub(crate) oscillator: Oscillator,
    /// Its key in the catalogue.
    pub(crate) key: Option<&'static str>,
    /// What it is called.
    pub(crate) title: String,
    /// The parameters that have got a value.
    pub(crate) values: Vec<(String, String)>,
}

/// An equation of motion with the words for it.
#[derive(Clone, Debug)]
pub(crate) struct Asked {
    pub(crate) equation: Equation,
    /// The equilibrium that is meant.
    pub(crate) about: Option<Expression>,
    pub(crate) key: Option<&'static str>,
    pub(crate) title: String,
    pub(crate) values: Vec<(String, String)>,
}

impl Chosen {
    /// Whether the variable is an angle, by its name.
    pub(crate) fn is_angle(&self) -> bool {
        is_angle_name(self.oscillator.variable())
    }

    /// Reads an amplitude: a number, or an angle where the variable is one.
    pub(crate) fn amplitude(&self, argument: &str, text: &str) -> Result<Displacement, Failure> {
        if let Ok(number) = Displacement::from_number_text(text) {
            if self.is_angle() {
                super::bare::say(text);
            }
            return Ok(number);
        }
        if self.is_angle() {
            return Displacement::from_angle_text(text).map_err(|error| Failure::usage(argument, error));
        }
        let name = self.oscillator.variable();
        let hint = "angle units are for variables with the name of an angle, such as theta";
        Err(Failure::usage(
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
        Self { oscillator: oscillator.to_owned(), set: set.to_vec(), about: about.map(str::to_owned) }
    }

    pub(crate) fn chosen(&self) -> Result<Chosen, Failure> {
        let Asked { equation, about, key, title, values } = self.asked()?;
        let oscillator = match about {
            None => Oscillator::new(&equation),
            Some(place) => Oscillator::about(&equation, &place),
        };
        let oscillator = oscillator.map_err(|error| Failure::no_answer("oscillator", error))?;
        Ok(Chosen { oscillator, key, title, values })
    }

    /// The equation, whether it is an oscillator or not.
    pub(crate) fn asked(&self) -> Result<Asked, Failure> {
        let named = NamedOscillator::by_key(self.oscillator.trim());
        let given = values(&self.set)?;
        let (equation, key, title) = match &named {
            Ok(named) => (of_catalogue(named, &given)?, Some(named.key), named.title.to_owned()),
            Err(unknown) if is_like_a_key(&self.oscillator) => {
                return Err(Failure::usage("OSCILLATOR|EQUATION", unknown));
            }
            Err(_) => (self.typed(&given)?, None, "an equation of motion".to_owned()),
        };
        let variable = equation.variables().first().map_or("", String::as_str);
        let about = self.about.as_deref().map(|text| place(text, variable)).transpose()?;
        Ok(Asked { equation, about, key, title, values: values_used(named.ok(), &given) })
    }

    fn typed(&self, values: &[(String, Expression)]) -> Result<Equation, Failure> {
        let equation: Equation =
            self.oscillator.parse().map_err(|error| Failure::usage("OSCILLATOR|EQUATION", error))?;
        equation.with(&borrowed(values)).map_err(|error| Failure::usage("--set", error))
    }
}

/// A place on the axis of a variable: a formula of numbers, or an angle where the variable is one.
fn place(text: &str, variable: &str) -> Result<Expression, Failure> {
    let refusal = |reason: String| Failure::usage("--about", reason);
    let formula = text.parse::<Expression>();
    if let Ok(constant) = formula.as_ref()
        && constant.symbols().is_empty()
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

fn of_catalogue(named: &NamedOscillator, values: &[(String, Expression)]) -> Result<Equation, Failure> {
    named.equation_with(&borrowed(values)).map_err(|error| Failure::usage("--set", error))
}

/// The values that were given, and the catalogue's for the other parameters.
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
