//! Catalogues of named items: entries with keys, their parameters, and the error for an unknown key.

use crate::quantity::{excerpt, nearest};

/// An entry of a catalogue.
pub trait Named {
    /// Kind of the entries.
    const KIND: &'static str;
    /// Other accepted input, as the end of a sentence.
    const OTHERWISE: &'static str;

    /// The key, followed by its synonyms.
    fn keys(&self) -> impl Iterator<Item = &str>;
}

/// Returns `true` if a text can only be a key: it is one word, and thus not an equation.
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
    /// The name in the equations.
    pub name: &'static str,
    /// The default value.
    pub default: &'static str,
    /// The unit: `1` for pure numbers, empty if the equation leaves its units open.
    pub unit: &'static str,
    /// Meaning of the parameter.
    pub meaning: &'static str,
}

/// The error for a key that no entry has.
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
    /// The nearest keys and synonyms.
    pub near: Vec<String>,
    /// All keys.
    pub known: Vec<String>,
    otherwise: &'static str,
}

/// The entry with this key or synonym.
pub fn by_key<'c, E: Named + 'c>(
    entries: impl Iterator<Item = &'c E> + Clone,
    key: &str,
) -> Result<&'c E, UnknownKey> {
    let match_of_key = entries.clone().find(|entry| entry.keys().any(|name| name == key));
    match_of_key.ok_or_else(|| UnknownKey {
        kind: E::KIND,
        key: excerpt(key),
        near: nearest(&excerpt(key), entries.clone().flat_map(E::keys)),
        known: entries.filter_map(|entry| entry.keys().next()).map(str::to_owned).collect(),
        otherwise: E::OTHERWISE,
    })
}
