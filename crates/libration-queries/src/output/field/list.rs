//! The fields of a result as a whole: a record of JSON, lines of CSV, rows of tables, sheets, descriptions.

use super::Field;
use super::content::{Content, Datum};
use super::plan::Plans;
use crate::output::description::Description;
use crate::output::json::Record;
use crate::output::table::Column;
use serde_json::Value;

/// The fields of a result `A`, in their order.
pub struct Fields<A> {
    plans: Plans,
    contents: Vec<Content<A>>,
}

impl<A> std::fmt::Debug for Fields<A> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Fields").finish_non_exhaustive()
    }
}

impl<A, const N: usize> From<[Field<A>; N]> for Fields<A> {
    fn from(mut fields: [Field<A>; N]) -> Self {
        Self::taken_from(&mut fields)
    }
}

impl<A> Fields<A> {
    /// Moves the fields out of an array, so that the compiler does not generate code for the list of each result.
    fn taken_from(list: &mut [Field<A>]) -> Self {
        let mut fields = Self { plans: Plans::default(), contents: vec![] };
        for field in list {
            fields.plans.push(std::mem::take(&mut field.plan), fields.contents.len());
            fields.contents.append(&mut field.contents);
        }
        fields
    }

    /// The fields followed by others.
    pub(crate) fn and(mut self, others: impl Into<Self>) -> Self {
        let mut others = others.into();
        self.plans.append(others.plans, self.contents.len());
        self.contents.append(&mut others.contents);
        self
    }

    /// The value at an index in a result.
    fn values<'a>(&'a self, answer: &'a A) -> impl Fn(usize) -> Datum + 'a {
        |index| self.contents[index].in_answer(answer)
    }

    /// An object with the fields.
    pub fn record(&self, answer: &A) -> Record {
        self.added_to(Record::new(), answer)
    }

    /// A list of objects.
    pub(crate) fn records<'a>(&self, answers: impl IntoIterator<Item = &'a A>) -> Value
    where
        A: 'a,
    {
        let mut records = vec![];
        for answer in answers {
            records.push(self.record(answer).into());
        }
        Value::Array(records)
    }

    pub(crate) fn added_to(&self, record: Record, answer: &A) -> Record {
        self.plans.added_to(record, &self.values(answer))
    }

    /// The fields, where `NAME` in their names stands for this one.
    pub(crate) fn added_for(&self, name: &str, record: Record, answer: &A) -> Record {
        self.plans.added_for(name, record, &self.values(answer))
    }

    /// The fields for a table with these columns, in their order.
    pub(crate) fn for_table(mut self, titles: &[&str]) -> Self {
        self.plans.keep_for_table(titles);
        self
    }

    /// The first line of CSV.
    pub(crate) fn csv_names(&self) -> Vec<String> {
        self.plans.csv_names()
    }

    /// The names of the columns for each key: `KEY_ratio` becomes `bernoulli_ratio`.
    pub fn csv_names_for(&self, key: &str) -> Vec<String> {
        self.plans.csv_names_for(key)
    }

    /// The cells of a line of CSV.
    pub fn csv_cells(&self, answer: &A) -> Vec<String> {
        self.plans.csv_cells(&self.values(answer))
    }

    /// The cells separated by commas, appended to a text.
    pub(crate) fn write_csv_cells(&self, text: &mut Vec<u8>, answer: &A) {
        self.plans.write_csv_cells(text, &self.values(answer));
    }

    pub(crate) fn csv_cells_or_blanks(&self, answer: Option<&A>) -> Vec<String> {
        answer.map_or_else(|| self.plans.csv_blanks(), |answer| self.csv_cells(answer))
    }

    /// The columns of a table.
    pub fn columns(&self) -> Vec<Column> {
        self.columns_for("")
    }

    pub(crate) fn columns_for(&self, key: &str) -> Vec<Column> {
        self.plans.columns_for(key)
    }

    /// The cells of a row of a table.
    pub fn cells(&self, answer: &A) -> Vec<String> {
        self.plans.cells(&self.values(answer))
    }

    /// The rows of a table.
    pub(crate) fn rows<'a>(&self, answers: impl IntoIterator<Item = &'a A>) -> Vec<Vec<String>>
    where
        A: 'a,
    {
        let mut rows = vec![];
        for answer in answers {
            rows.push(self.cells(answer));
        }
        rows
    }

    pub(crate) fn cells_or_blanks(&self, answer: Option<&A>) -> Vec<String> {
        answer.map_or_else(|| self.plans.blank_cells(), |answer| self.cells(answer))
    }

    /// The lines of a sheet.
    pub fn lines(&self, answer: &A) -> Vec<(&'static str, String)> {
        self.plans.lines(&self.values(answer))
    }

    /// The fields of JSON at `prefix`, such as `results[].` or an empty text.
    pub fn described(&self, prefix: &str) -> Vec<Description> {
        self.plans.described(prefix)
    }

    /// The columns of CSV.
    pub fn described_in_csv(&self) -> Vec<Description> {
        self.plans.described_in_csv()
    }
}
