//! JSON results: records whose numbers are unrounded, null with a note if they are not finite.

use serde_json::{Map, Value};
use std::io::{self, Write};

/// The version of the field names, written with every result.
pub(crate) const SCHEMA: u64 = 2;

/// A number, or null when it is not finite.
pub(crate) fn number(value: f64) -> Value {
    serde_json::Number::from_f64(value).map_or(Value::Null, Value::Number)
}

/// Numbers, null for those that are not finite.
pub(crate) fn numbers(values: &[f64]) -> Value {
    list(values.iter().map(|&value| number(value)))
}

/// A list of counts, words or lists.
pub(crate) fn list(values: impl IntoIterator<Item = impl Into<Value>>) -> Value {
    values.into_iter().map(Into::into).collect::<Vec<Value>>().into()
}

/// A list of objects.
pub(crate) fn records(records: impl IntoIterator<Item = Record>) -> Value {
    list(records)
}

/// An object whose names depend on the query.
pub(crate) fn object(fields: impl IntoIterator<Item = (String, impl Into<Value>)>) -> Value {
    Value::Object(fields.into_iter().map(|(name, value)| (name, value.into())).collect())
}

/// A JSON object in the making.
#[derive(Debug, Default)]
pub struct Record {
    fields: Map<String, Value>,
    notes: Vec<String>,
}

impl Record {
    /// A record without fields.
    pub fn new() -> Self {
        Self::default()
    }

    /// A number; null and a note when it is not finite.
    pub fn number(mut self, name: &str, value: f64) -> Self {
        let field = number(value);
        if field.is_null() {
            let what = if value.is_nan() { "not defined" } else { "infinite" };
            self.notes.push(format!("{name} is {what}"));
        }
        self.fields.insert(name.to_owned(), field);
        self
    }

    /// A number, or null with a note on the reason.
    pub(crate) fn number_or(self, name: &str, value: Option<f64>, why_none: &str) -> Self {
        match value {
            Some(value) => self.number(name, value),
            None => self.with(name, Value::Null).note(&format!("{name} is null: {why_none}")),
        }
    }

    /// Adds a field.
    pub fn with(mut self, name: &str, value: impl Into<Value>) -> Self {
        self.fields.insert(name.to_owned(), value.into());
        self
    }

    pub(crate) fn note(mut self, note: &str) -> Self {
        self.notes.push(note.to_owned());
        self
    }
}

impl From<Record> for Value {
    fn from(mut record: Record) -> Self {
        if !record.notes.is_empty() {
            record.fields.insert("note".to_owned(), record.notes.join("; ").into());
        }
        Self::Object(record.fields)
    }
}

/// Writes one record as a whole result.
pub(crate) fn document(out: &mut dyn Write, record: Record) -> io::Result<()> {
    let mut fields = Map::from_iter([("schema".to_owned(), SCHEMA.into())]);
    if let Value::Object(rest) = record.into() {
        fields.extend(rest);
    }
    serde_json::to_writer_pretty(&mut *out, &fields)?;
    out.write_all(b"\n")
}

/// Writes a result that ends in a list, item by item, so that long lists need little memory.
pub fn document_with_list(
    out: &mut dyn Write,
    head: Record,
    name: &str,
    items: impl Iterator<Item = Record>,
) -> io::Result<()> {
    begin_document(out, head)?;
    let mut list = ListWriter::default();
    list.begin(out, name)?;
    for item in items {
        list.item(out, item)?;
    }
    list.end(out)?;
    end_document(out, Record::new())
}

/// Begins a result that is written part by part.
pub(crate) fn begin_document(out: &mut dyn Write, head: Record) -> io::Result<()> {
    write!(out, "{{\"schema\":{SCHEMA}")?;
    fields(out, head)
}

/// Ends a result that is written part by part, with its last fields.
pub(crate) fn end_document(out: &mut dyn Write, tail: Record) -> io::Result<()> {
    fields(out, tail)?;
    out.write_all(b"}\n")
}

fn fields(out: &mut dyn Write, record: Record) -> io::Result<()> {
    if let Value::Object(fields) = record.into() {
        for (field, value) in fields {
            write!(out, ",{}:{value}", Value::from(field))?;
        }
    }
    Ok(())
}

/// Appends an item of such a list to a text.
pub(crate) fn write_item(text: &mut Vec<u8>, item: Record) {
    serde_json::to_writer(text, &Value::from(item)).expect("a record can be written to memory");
}

/// The separator of two items.
pub(crate) const BETWEEN_ITEMS: &[u8] = b",\n";

/// A list in a result that is written part by part, one item a line.
#[derive(Debug, Default)]
pub(crate) struct ListWriter {
    has_items: bool,
}

impl ListWriter {
    pub(crate) fn begin(&mut self, out: &mut dyn Write, name: &str) -> io::Result<()> {
        write!(out, ",{}:[", Value::from(name))
    }

    pub(crate) fn item(&mut self, out: &mut dyn Write, item: Record) -> io::Result<()> {
        let mut text = vec![];
        write_item(&mut text, item);
        self.items(out, &text)
    }

    /// Items that are written already, [`BETWEEN_ITEMS`] between them.
    pub(crate) fn items(&mut self, out: &mut dyn Write, text: &[u8]) -> io::Result<()> {
        out.write_all(if self.has_items { BETWEEN_ITEMS } else { b"\n" })?;
        self.has_items = true;
        out.write_all(text)
    }

    pub(crate) fn end(&mut self, out: &mut dyn Write) -> io::Result<()> {
        out.write_all(b"\n]")
    }
}
