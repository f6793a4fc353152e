//! Which oscillator is meant: a key of the catalogue or an equation, with values for its parameters.

use crate::failure::Failure;
use libration::expression::{Equation, Expression};
use libration::oscillator::{NamedOscillator, Oscillator};

/// The oscillator asked about.
#[derive(Clone, Debug, clap::Args)]
pub(crate) struct OscillatorOptions {
    /// A key of the catalogue, such as pendulum or van_der_pol, or an equation, such as "x'' + x + x^3 = 0"
    #[arg(value_name = "OSCILLATOR|EQUATION")]
    oscillator: String,
    /// The value of a parameter, a number or a formula of numbers; may be given several times
    #[arg(long, value_name = "NAME=VALUE")]
    set: Vec<String>,
    /// The equilibrium, where there are several [default: the stable one nearest to zero]
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
}

impl OscillatorOptions {
    /// The oscillator of this name or equation.
    pub(crate) fn new(oscillator: &str, set: &[String], about: Option<&str>) -> Self {
        Self { oscillator: oscillator.to_owned(), set: set.to_vec(), about: about.map(str::to_owned) }
    }

    pub(crate) fn chosen(&self) -> Result<Chosen, Failure> {
        let named = NamedOscillator::by_key(self.oscillator.trim());
        let (equation, key, title) = match &named {
            Ok(named) => (self.of_catalogue(named)?, Some(named.key), named.title.to_owned()),
            Err(unknown) if !self.oscillator.contains('=') => {
                return Err(Failure::usage("OSCILLATOR|EQUATION", unknown));
            }
            Err(_) => (self.typed()?, None, "an equation of motion".to_owned()),
        };
        let oscillator = match &self.about {
            None => Oscillator::new(&equation),
            Some(place) => {
                let place: Expression = place.parse().map_err(|error| Failure::usage("--about", error))?;
                Oscillator::about(&equation, &place)
            }
        };
        let oscillator = oscillator.map_err(|error| Failure::no_answer("oscillator", error))?;
        Ok(Chosen { oscillator, key, title })
    }

    fn typed(&self) -> Result<Equation, Failure> {
        let equation: Equation =
            self.oscillator.parse().map_err(|error| Failure::usage("OSCILLATOR|EQUATION", error))?;
        let values = self.values()?;
        equation.with(&borrowed(&values)).map_err(|error| Failure::usage("--set", error))
    }

    fn of_catalogue(&self, named: &NamedOscillator) -> Result<Equation, Failure> {
        let values = self.values()?;
        named.equation_with(&borrowed(&values)).map_err(|error| Failure::usage("--set", error))
    }

    fn values(&self) -> Result<Vec<(String, Expression)>, Failure> {
        let items = self.set.iter().flat_map(|items| items.split(','));
        items.map(value).collect()
    }
}

fn borrowed(values: &[(String, Expression)]) -> Vec<(&str, Expression)> {
    values.iter().map(|(name, value)| (name.as_str(), value.clone())).collect()
}

fn value(item: &str) -> Result<(String, Expression), Failure> {
    let (name, value) = item.split_once('=').ok_or_else(|| {
        Failure::usage("--set", format!("`{item}` has no value: give NAME=VALUE, as mu=0.1"))
    })?;
    let value =
        value.parse().map_err(|error| Failure::usage("--set", format!("{}: {error}", name.trim())))?;
    Ok((name.trim().to_owned(), value))
}
