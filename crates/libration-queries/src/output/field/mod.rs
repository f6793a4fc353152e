//! A field of a result, described once: JSON, CSV, tables, sheets and `libration fields` follow.

mod content;
pub(crate) mod list;
mod look;
mod plan;
mod write;

pub(crate) use list::Fields;

use content::Content;
use look::Look;
use plan::{FieldPlan, key_of};
use serde_json::Value;

/// A function that gives the value of a field of a result `A`.
type Of<A, T> = fn(&A) -> T;

/// A field of a result `A`.
pub struct Field<A> {
    plan: FieldPlan,
    /// The value, then the texts that are shown in its place.
    contents: Vec<Content<A>>,
}

impl<A> std::fmt::Debug for Field<A> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Field").field("key", &self.plan.key).finish_non_exhaustive()
    }
}

impl<A> Field<A> {
    fn new(name: &'static str, unit: &'static str, meaning: &'static str, content: Content<A>) -> Self {
        Self { plan: FieldPlan::new(name, unit, meaning), contents: vec![content] }
    }

    /// A number.
    pub fn number(name: &'static str, unit: &'static str, meaning: &'static str, value: Of<A, f64>) -> Self {
        Self::new(name, unit, meaning, Content::Number(value))
    }

    /// A number, or the reason why it is unknown; null without a note if the reason is empty.
    pub fn known(
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

    /// A number that is omitted from JSON if it is unknown.
    pub fn present(
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

    /// A value that is omitted from JSON if there is none.
    pub(crate) fn present_value(
        name: &'static str,
        unit: &'static str,
        meaning: &'static str,
        value: Of<A, Option<Value>>,
    ) -> Self {
        Self::new(name, unit, meaning, Content::PresentValue(value))
    }

    /// A value with nested fields, to which `prefix` leads: `name[].` to those of each object of a list, `name.` to those of one.
    pub(crate) fn nested<B>(prefix: &'static str, fields: &Fields<B>, value: Of<A, Value>) -> Self {
        Self::with_parts(prefix, fields, Content::Value(value))
    }

    /// Nested fields that are omitted from JSON if there are none.
    pub(crate) fn present_nested<B>(
        prefix: &'static str,
        fields: &Fields<B>,
        value: Of<A, Option<Value>>,
    ) -> Self {
        Self::with_parts(prefix, fields, Content::PresentValue(value))
    }

    fn with_parts<B>(prefix: &'static str, fields: &Fields<B>, content: Content<A>) -> Self {
        Self {
            plan: FieldPlan::only_described(key_of(prefix), fields.described(prefix)),
            contents: vec![content],
        }
    }

    /// A note on the fields before it, in the note of JSON.
    pub(crate) fn note(note: Of<A, Option<String>>) -> Self {
        Self { plan: FieldPlan::only_described("", vec![]), contents: vec![Content::Note(note)] }
    }

    /// A field that appears in tables and sheets alone.
    pub fn unnamed() -> Self {
        let mut field = Self::value("", "", "", |_| Value::Null).only_json();
        field.plan.in_json = false;
        field
    }

    pub(crate) fn only_json(mut self) -> Self {
        self.plan.in_csv = None;
        self
    }

    pub(crate) fn only_csv(mut self) -> Self {
        self.plan.in_json = false;
        self
    }

    /// The name that it has in CSV alone.
    pub fn in_csv_as(mut self, name: &'static str) -> Self {
        self.plan.in_csv = Some(name);
        self
    }

    /// Sets the text of empty values in tables.
    pub(crate) fn or(mut self, blank: &'static str) -> Self {
        self.plan.blank = blank;
        self
    }

    fn column(mut self, title: &'static str, look: Look) -> Self {
        self.plan.column(title, look);
        self
    }

    /// The index of a text among the contents.
    fn place_of(&mut self, text: Of<A, String>) -> usize {
        self.contents.push(Content::Text(text));
        self.contents.len() - 1
    }

    /// A column of a table, to this many digits.
    pub fn rounded(self, title: &'static str, digits: usize) -> Self {
        self.column(title, Look::Rounded(digits))
    }

    pub(crate) fn short(self, title: &'static str, digits: usize) -> Self {
        self.column(title, Look::Short(digits))
    }

    /// A column with the number as an angle in degrees.
    pub fn degrees(self, title: &'static str, digits: usize) -> Self {
        self.column(title, Look::Degrees(digits))
    }

    /// A column of numbers with a format of their own.
    pub(crate) fn numeral(mut self, title: &'static str, text: Of<A, String>) -> Self {
        let index = self.place_of(text);
        self.column(title, Look::Numeral(index))
    }

    /// A column of words.
    pub fn words(mut self, title: &'static str, text: Of<A, String>) -> Self {
        let index = self.place_of(text);
        self.column(title, Look::Words(index))
    }

    /// A line of a sheet: the number to this many digits with its unit.
    pub fn line(mut self, title: &'static str, digits: usize) -> Self {
        self.plan.line(title, Look::WithUnit(digits));
        self
    }

    pub(crate) fn line_of(mut self, title: &'static str, text: Of<A, String>) -> Self {
        let index = self.place_of(text);
        self.plan.line(title, Look::Words(index));
        self
    }
}
