//! Catalogues of named items: entries with keys, their parameters, and the error where no entry has a key.

use crate::quantity::{excerpt, nearest};

/// An entry of a catalogue.
pub trait Named {
    /// Kind of the entries.
    const KIND: &'static str;
    /// Other input that is accepted, as the end of a sentence.
    const OTHERWISE: &'static str;

    /// The key, then other names for it.
    fn keys(&self) -> impl Iterator<Item = &str>;
}

/// Returns whether a text can only be a key: one word, and so not an equation.
///
/// # Examples
/// ```
/// # extern crate libration_numbers as libration;
/// use libration::catalogue::is_like_a_key;
/// assert!(is_like_a_key("van_der_pol") && !is_like_a_key("x'' + x = 0"));
/// ```
#[must_use]
pub fn is_like_a_key(text: &str) -> bool {
    text.trim().chars().all(|letter| letter.is_alphanumeric() || letter == '_' || letter == '-')
}

/// A parameter of a named equation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct NamedParameter {
    /// Its name in the equations.
    pub name: &'static str,
    /// The value it has unless another is given.
    pub default: &'static str,
    /// Its unit: `1` for pure numbers, empty where the equation leaves all units open.
    pub unit: &'static str,
    /// Meaning of the parameter.
    pub meaning: &'static str,
}

/// A key that no entry has.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error(
    "no {kind} has the key `{key}`; the nearest are {}; the keys are {}{otherwise}",
    near.join(", "),
    known.join(", ")
)]
pub struct UnknownKey {
    /// The kind: `oscillator`, `system`, `formula` or `approximate motion`.
    pub kind: &'static str,
    /// The key given, shortened.
    pub key: String,
    /// The nearest keys and other names there are.
    pub near: Vec<String>,
    /// All keys.
    pub known: Vec<String>,
    otherwise: &'static str,
}

/// The entry with this key, or this other name.
pub fn by_key<'c, E: Named + 'c>(
    entries: impl Iterator<Item = &'c E> + Clone,
    key: &str,
) -> Result<&'c E, UnknownKey> {
    let found = entries.clone().find(|entry| entry.keys().any(|known| known == key));
    found.ok_or_else(|| UnknownKey {
        kind: E::KIND,
        key: excerpt(key),
        near: nearest(&excerpt(key), entries.clone().flat_map(E::keys)),
        known: entries.filter_map(|entry| entry.keys().next()).map(str::to_owned).collect(),
        otherwise: E::OTHERWISE,
    })
}
