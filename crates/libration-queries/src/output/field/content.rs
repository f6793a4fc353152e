//! Content of a field: a function of the result, and its value in JSON and CSV.

use super::Of;
use crate::output::json::Record;
use crate::output::number;
use serde_json::Value;

/// The source of a field's value.
pub(super) enum Content<A> {
    Number(Of<A, f64>),
    Known(Of<A, Result<f64, String>>),
    Nullable(Of<A, Option<f64>>),
    Present(Of<A, Option<f64>>),
    Value(Of<A, Value>),
    PresentValue(Of<A, Option<Value>>),
    Note(Of<A, Option<String>>),
    /// Text that is shown in place of the value.
    Text(Of<A, String>),
}

/// The values of a result by index: those of fields, and the texts shown in their place.
pub(super) type Values<'a> = &'a dyn Fn(usize) -> Datum;

/// The value of a field in one result.
pub(super) enum Datum {
    /// Not finite: null with a note.
    Number(f64),
    /// Null, with a note if there is a reason.
    Unknown(String),
    /// A count, words, a list, an object, or null without a note.
    Value(Value),
    /// A note, combined with the fields before it.
    Note(String),
    /// Left out of JSON.
    Absent,
}

impl<A> Content<A> {
    pub(super) fn in_answer(&self, answer: &A) -> Datum {
        match self {
            Self::Number(value) => Datum::Number(value(answer)),
            Self::Known(value) => value(answer).map_or_else(Datum::Unknown, Datum::Number),
            Self::Nullable(value) => value(answer).map_or(Datum::Unknown(String::new()), Datum::Number),
            Self::Present(value) => value(answer).map_or(Datum::Absent, Datum::Number),
            Self::Value(value) => Datum::Value(value(answer)),
            Self::PresentValue(value) => value(answer).map_or(Datum::Absent, Datum::Value),
            Self::Note(note) => note(answer).map_or(Datum::Absent, Datum::Note),
            Self::Text(text) => Datum::Value(Value::String(text(answer))),
        }
    }
}

impl Datum {
    pub(super) fn added_to(self, record: Record, key: &str) -> Record {
        match self {
            Self::Number(value) => record.number(key, value),
            Self::Unknown(why) if why.is_empty() => record.with(key, Value::Null),
            Self::Unknown(why) => record.number_or(key, None, &why),
            Self::Value(value) => record.with(key, value),
            Self::Note(note) => record.note(&note),
            Self::Absent => record,
        }
    }

    /// The value as a cell of CSV; `None` for an empty cell.
    pub(super) fn to_cell(&self) -> Option<String> {
        match self {
            Self::Number(value) => value.is_finite().then(|| number::exact(*value)),
            Self::Value(Value::String(text)) => Some(text.clone()),
            Self::Unknown(_) | Self::Note(_) | Self::Absent | Self::Value(Value::Null) => None,
            Self::Value(other) => Some(other.to_string()),
        }
    }

    pub(super) fn to_f64(&self) -> Option<f64> {
        match self {
            Self::Number(value) => Some(*value),
            Self::Value(value) => value.as_f64(),
            Self::Unknown(_) | Self::Note(_) | Self::Absent => None,
        }
    }
}
