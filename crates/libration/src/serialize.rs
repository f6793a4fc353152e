//! How answers are serialised where deriving does not tell.

use serde::ser::SerializeStruct;
use serde::{Serialize, Serializer};

use crate::algebra::{Polynomial, Rational, Surd};
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

as_text!(Rational, Surd, Polynomial, Constant, Displacement, Symbol, Expression, Equation, Gauge);

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

/// The value, or an object whose `error` says why there is none.
pub(crate) fn outcome<T: Serialize, E: std::fmt::Display, S: Serializer>(
    outcome: &Result<T, E>,
    serializer: S,
) -> Result<S::Ok, S::Error> {
    match outcome {
        Ok(value) => value.serialize(serializer),
        Err(error) => {
            let mut fields = serializer.serialize_struct("Error", 1)?;
            fields.serialize_field("error", &error.to_string())?;
            fields.end()
        }
    }
}

/// As [`outcome`], where even the question may be missing.
pub(crate) fn optional_outcome<T: Serialize, E: std::fmt::Display, S: Serializer>(
    optional: &Option<Result<T, E>>,
    serializer: S,
) -> Result<S::Ok, S::Error> {
    match optional {
        Some(found) => outcome(found, serializer),
        None => serializer.serialize_none(),
    }
}
