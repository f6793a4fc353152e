//! How answers are serialised where deriving does not tell, with the feature `serde`.

use std::fmt;

use serde::ser::SerializeStruct;
use serde::{Serialize, Serializer};

use crate::algebra::{LaurentPolynomial, PiSum, Polynomial, Rational, Surd};
use crate::decay::Damping;
use crate::expression::{Equation, Expression, Symbol};
use crate::oscillator::Constant;
use crate::pendulum::Amplitude;
use crate::perturbation::Gauge;
use crate::quantity::{Angle, Displacement};

/// As the text that is read back as the same.
macro_rules! as_text {
    ($($type:ty),*) => {
        $(impl Serialize for $type {
            fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
                serializer.collect_str(self)
            }
        })*
    };
}

as_text!(
    Rational,
    Surd,
    PiSum,
    Polynomial,
    LaurentPolynomial,
    Constant,
    Displacement,
    Symbol,
    Expression,
    Equation,
    Gauge
);

/// Radians, and the distance to the upright position, which they have lost near the top.
impl Serialize for Angle {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut fields = serializer.serialize_struct("Angle", 2)?;
        fields.serialize_field("radians", &self.radians())?;
        fields.serialize_field("complement", &self.complement())?;
        fields.end()
    }
}

impl Serialize for Amplitude {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        self.angle().serialize(serializer)
    }
}

impl Serialize for Damping {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        self.terms().serialize(serializer)
    }
}

/// What was found or why nothing was: the value, or an object whose `error` says the reason.
#[derive(Clone, Copy, Debug)]
pub struct Outcome<'a, T, E>(pub &'a Result<T, E>);

impl<T: Serialize, E: fmt::Display> Serialize for Outcome<'_, T, E> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self.0 {
            Ok(value) => value.serialize(serializer),
            Err(error) => {
                let mut fields = serializer.serialize_struct("Error", 1)?;
                fields.serialize_field("error", &error.to_string())?;
                fields.end()
            }
        }
    }
}

/// An [`Outcome`], for fields: `serialize_with`.
///
/// # Errors
/// Those of the serializer.
pub fn outcome<T: Serialize, E: fmt::Display, S: Serializer>(
    outcome: &Result<T, E>,
    serializer: S,
) -> Result<S::Ok, S::Error> {
    Outcome(outcome).serialize(serializer)
}

/// An [`Outcome`] where even the question may be missing, for fields.
///
/// # Errors
/// Those of the serializer.
pub fn optional_outcome<T: Serialize, E: fmt::Display, S: Serializer>(
    optional: &Option<Result<T, E>>,
    serializer: S,
) -> Result<S::Ok, S::Error> {
    optional.as_ref().map(Outcome).serialize(serializer)
}

/// The outcomes, for fields.
///
/// # Errors
/// Those of the serializer.
pub fn outcomes<T: Serialize, E: fmt::Display, S: Serializer>(
    outcomes: &[Result<T, E>],
    serializer: S,
) -> Result<S::Ok, S::Error> {
    serializer.collect_seq(outcomes.iter().map(Outcome))
}

/// Outcomes by their names, for fields.
///
/// # Errors
/// Those of the serializer.
pub fn named_outcomes<T: Serialize, E: fmt::Display, S: Serializer>(
    outcomes: &[(String, Result<T, E>)],
    serializer: S,
) -> Result<S::Ok, S::Error> {
    serializer.collect_map(outcomes.iter().map(|(name, found)| (name, Outcome(found))))
}

/// As text, for fields.
///
/// # Errors
/// Those of the serializer.
pub fn text<T: fmt::Display, S: Serializer>(value: &T, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_str(value)
}
