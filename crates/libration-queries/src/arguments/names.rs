//! Texts whose meaning depends on another parameter: equations or their keys, and names of coordinates.

use std::ops::Deref;

/// The key of a catalogue, or an equation as typed.
#[derive(Clone, Debug)]
pub(crate) struct EquationText(String);

/// The name of a coordinate, or of another component of the state.
#[derive(Clone, Debug)]
pub(crate) struct CoordinateName(String);

impl From<String> for EquationText {
    fn from(text: String) -> Self {
        Self(text)
    }
}

impl Deref for EquationText {
    type Target = str;

    fn deref(&self) -> &str {
        &self.0
    }
}

impl From<String> for CoordinateName {
    fn from(text: String) -> Self {
        Self(text)
    }
}

impl Deref for CoordinateName {
    type Target = str;

    fn deref(&self) -> &str {
        &self.0
    }
}
