//! Warnings about a result: their texts, and stable names of their kinds.

use super::field::Field;
use super::json;
use serde_json::Value;

/// The name that stays, and the text.
pub(crate) type NamedWarning = (&'static str, String);

/// Fields with the texts, and with the names.
pub(crate) fn fields<A>(texts: fn(&A) -> Value, names: fn(&A) -> Value) -> [Field<A>; 2] {
    [
        Field::value("warnings[]", "", "warnings about the result", texts),
        Field::value("warning_kinds[]", "", "kind of each warning, in the same order", names),
    ]
}

pub(crate) fn texts(warnings: Vec<NamedWarning>) -> Value {
    json::list(warnings.into_iter().map(|(_, text)| text))
}

pub(crate) fn names(warnings: Vec<NamedWarning>) -> Value {
    json::list(warnings.into_iter().map(|(name, _)| name))
}
