//! A field of an answer, described once: JSON, CSV, tables, sheets and `libration fields` follow.

mod content;
mod list;
mod look;
#[cfg(test)]
mod tests;
mod write;

pub(crate) use list::Fields;

use super::description::Description;
use super::{csv, number};
use content::{Content, Datum};
use look::{Look, Shown};
use serde_json::Value;

/// What a field of an answer `A` is.
type Of<A, T> = fn(&A) -> T;

/// A field of an answer `A`.
pub(crate) struct Field<A> {
    key: &'static str,
    unit: &'static str,
    meaning: &'static str,
    /// The field itself, or those inside it, from the place where it stands.
    described: Vec<Description>,
    content: Content<A>,
    in_json: bool,
    /// The name of its column, which may have `KEY` in it.
    in_csv: Option<&'static str>,
    /// Stands in tables, and in CSV, where there is nothing.
    blanks: [&'static str; 2],
    columns: Vec<Shown<A>>,
    lines: Vec<Shown<A>>,
}

impl<A> Field<A> {
    /// Lists and objects have in their name what leads to their parts, `name[]` or `name.NAME`, and stand in JSON alone.
    fn new(name: &'static str, unit: &'static str, meaning: &'static str, content: Content<A>) -> Self {
        let key = key_of(name);
        Self {
            key,
            unit,
            meaning,
            described: vec![Description::new(name, unit, meaning)],
            content,
            in_json: true,
            in_csv: (key == name).then_some(name),
            blanks: ["", ""],
            columns: vec![],
            lines: vec![],
        }
    }

    pub(crate) fn number(
        name: &'static str,
        unit: &'static str,
        meaning: &'static str,
        value: Of<A, f64>,
    ) -> Self {
        Self::new(name, unit, meaning, Content::Number(value))
    }

    /// A number, or why there is none; null without a note where that text is empty.
    pub(crate) fn known(
        name: &'static str,
        unit: &'static str,
        meaning: &'static str,
        value: Of<A, Result<f64, String>>,
    ) -> Self {
        Self::new(name, unit, meaning, Content::Known(value))
    }

    /// A number, or null without a reason.
    pub(crate) fn nullable(
        name: &'static str,
        unit: &'static str,
        meaning: &'static str,
        value: Of<A, Option<f64>>,
    ) -> Self {
        Self::new(name, unit, meaning, Content::Nullable(value))
    }

    /// A number that is left out of JSON where there is none.
    pub(crate) fn present(
        name: &'static str,
        unit: &'static str,
        meaning: &'static str,
        value: Of<A, Option<f64>>,
    ) -> Self {
        Self::new(name, unit, meaning, Content::Present(value))
    }

    /// A count, words, a list, an object, or null.
    pub(crate) fn value(
        name: &'static str,
        unit: &'static str,
        meaning: &'static str,
        value: Of<A, Value>,
    ) -> Self {
        Self::new(name, unit, meaning, Content::Value(value))
    }

    /// The same, left out of JSON where there is none.
    pub(crate) fn present_value(
        name: &'static str,
        unit: &'static str,
        meaning: &'static str,
        value: Of<A, Option<Value>>,
    ) -> Self {
        Self::new(name, unit, meaning, Content::PresentValue(value))
    }

    /// What has fields of its own, to which `place` leads: `name[].` to those of each object of a list, `name.` to those of one.
    pub(crate) fn nested<B>(place: &'static str, fields: &Fields<B>, value: Of<A, Value>) -> Self {
        Self { described: fields.described(place), ..Self::value(key_of(place), "", "", value).only_json() }
    }

    /// The same, left out of JSON where there is nothing.
    pub(crate) fn present_nested<B>(
        place: &'static str,
        fields: &Fields<B>,
        value: Of<A, Option<Value>>,
    ) -> Self {
        let described = fields.described(place);
        Self { described, ..Self::present_value(key_of(place), "", "", value).only_json() }
    }

    /// What is to be said of the fields before it, in the note of JSON.
    pub(crate) fn note(note: Of<A, Option<String>>) -> Self {
        Self { described: vec![], ..Self::new("", "", "", Content::Note(note)).only_json() }
    }

    /// What only people see.
    pub(crate) fn unnamed() -> Self {
        Self { in_json: false, ..Self::value("", "", "", |_| Value::Null).only_json() }
    }

    pub(crate) fn only_json(self) -> Self {
        Self { in_csv: None, ..self }
    }

    pub(crate) fn only_csv(self) -> Self {
        Self { in_json: false, ..self }
    }

    /// The name that it has in CSV alone.
    pub(crate) fn in_csv_as(self, name: &'static str) -> Self {
        Self { in_csv: Some(name), ..self }
    }

    /// What stands in tables where there is nothing.
    pub(crate) fn or(self, blank: &'static str) -> Self {
        Self { blanks: [blank, self.blanks[1]], ..self }
    }

    /// `nan` in CSV where there is nothing.
    pub(crate) fn or_nan_in_csv(self) -> Self {
        Self { blanks: [self.blanks[0], "nan"], ..self }
    }

    fn column(mut self, title: &'static str, look: Look<A>) -> Self {
        self.columns.push(Shown { title, look });
        self
    }

    /// A column of a table, to this many digits.
    pub(crate) fn rounded(self, title: &'static str, digits: usize) -> Self {
        self.column(title, Look::Rounded(digits))
    }

    pub(crate) fn short(self, title: &'static str, digits: usize) -> Self {
        self.column(title, Look::Short(digits))
    }

    pub(crate) fn degrees(self, title: &'static str, digits: usize) -> Self {
        self.column(title, Look::Degrees(digits))
    }

    /// A column of numbers that are written in a way of their own.
    pub(crate) fn numeral(self, title: &'static str, text: Of<A, String>) -> Self {
        self.column(title, Look::Numeral(text))
    }

    pub(crate) fn words(self, title: &'static str, text: Of<A, String>) -> Self {
        self.column(title, Look::Words(text))
    }

    /// A line of a sheet: the number to this many digits with its unit.
    pub(crate) fn line(mut self, title: &'static str, digits: usize) -> Self {
        self.lines.push(Shown { title, look: Look::WithUnit(digits) });
        self
    }

    pub(crate) fn line_of(mut self, title: &'static str, text: Of<A, String>) -> Self {
        self.lines.push(Shown { title, look: Look::Words(text) });
        self
    }

    fn text(&self, look: &Look<A>, answer: &A) -> String {
        let value = self.content.in_answer(answer).to_f64();
        look.text(value, self.unit, answer).unwrap_or_else(|| self.blanks[0].to_owned())
    }

    /// The cell behind a text, quoted where needed; numbers, of which there may be millions, without a text of their own.
    fn write_cell(&self, text: &mut Vec<u8>, answer: &A) {
        match self.content.in_answer(answer) {
            Datum::Number(value) if value.is_finite() => number::write_exact(text, value),
            _ => text.extend_from_slice(csv::quoted(&self.cell(answer)).as_bytes()),
        }
    }

    fn cell(&self, answer: &A) -> String {
        self.content.in_answer(answer).to_cell().unwrap_or_else(|| self.blanks[1].to_owned())
    }
}

/// The name in its object: `initial` for `initial[][]`.
fn key_of(name: &'static str) -> &'static str {
    name.split(['[', '.']).next().unwrap_or(name)
}
