//! The fields of an answer as a whole: a record of JSON, lines of CSV, rows of tables, sheets, descriptions.

use super::Field;
use super::look::Shown;
use crate::output::description::Description;
use crate::output::json::{Record, records};
use crate::output::table::Column;
use serde_json::Value;

/// The fields of an answer `A`, in their order.
pub(crate) struct Fields<A>(Vec<Field<A>>);

impl<A, const N: usize> From<[Field<A>; N]> for Fields<A> {
    fn from(fields: [Field<A>; N]) -> Self {
        Self(fields.into())
    }
}

impl<A> Fields<A> {
    /// With these behind them.
    pub(crate) fn and(mut self, others: impl Into<Self>) -> Self {
        self.0.extend(others.into().0);
        self
    }

    pub(crate) fn record(&self, answer: &A) -> Record {
        self.added_to(Record::new(), answer)
    }

    /// A list of objects.
    pub(crate) fn records<'a>(&self, answers: impl IntoIterator<Item = &'a A>) -> Value
    where
        A: 'a,
    {
        records(answers.into_iter().map(|answer| self.record(answer)))
    }

    pub(crate) fn added_to(&self, record: Record, answer: &A) -> Record {
        self.added_for(NAME, record, answer)
    }

    /// The same where `NAME` in names stands for this one.
    pub(crate) fn added_for(&self, name: &str, record: Record, answer: &A) -> Record {
        let fields = self.0.iter().filter(|field| field.in_json);
        fields.fold(record, |record, field| {
            field.content.in_answer(answer).added_to(record, &field.key.replace(NAME, name))
        })
    }

    /// For a table with these columns, in their order.
    pub(crate) fn for_table(mut self, titles: &[&str]) -> Self {
        let place = |field: &Field<A>| {
            let title = field.columns.first()?.title;
            titles.iter().position(|other| *other == title)
        };
        self.0.retain(|field| place(field).is_some());
        self.0.sort_by_key(place);
        self
    }

    /// The first line of CSV.
    pub(crate) fn csv_names(&self) -> Vec<String> {
        self.0.iter().filter_map(|field| field.in_csv).map(str::to_owned).collect()
    }

    /// The names of what is there for each key: `KEY_ratio` is `bernoulli_ratio`.
    pub(crate) fn csv_names_for(&self, key: &str) -> Vec<String> {
        self.csv_names().iter().map(|name| name.replace(KEY, key)).collect()
    }

    pub(crate) fn csv_cells(&self, answer: &A) -> Vec<String> {
        self.0.iter().filter(|field| field.in_csv.is_some()).map(|field| field.cell(answer)).collect()
    }

    /// The same cells with commas between, behind a text.
    pub(crate) fn write_csv_cells(&self, text: &mut Vec<u8>, answer: &A) {
        for (index, field) in self.0.iter().filter(|field| field.in_csv.is_some()).enumerate() {
            if index > 0 {
                text.push(b',');
            }
            field.write_cell(text, answer);
        }
    }

    pub(crate) fn csv_cells_or_blanks(&self, answer: Option<&A>) -> Vec<String> {
        answer.map_or_else(|| vec![String::new(); self.csv_names().len()], |answer| self.csv_cells(answer))
    }

    pub(crate) fn columns(&self) -> Vec<Column> {
        self.columns_for("")
    }

    pub(crate) fn columns_for(&self, key: &str) -> Vec<Column> {
        let column = |shown: &Shown<A>| match shown.look.is_of_words() {
            true => Column::words(shown.title.replace(KEY, key)),
            false => Column::numbers(shown.title.replace(KEY, key)),
        };
        self.0.iter().flat_map(|field| &field.columns).map(column).collect()
    }

    pub(crate) fn cells(&self, answer: &A) -> Vec<String> {
        let cells = |field: &Field<A>| {
            field.columns.iter().map(|shown| field.text(&shown.look, answer)).collect::<Vec<_>>()
        };
        self.0.iter().flat_map(cells).collect()
    }

    /// The rows of a table.
    pub(crate) fn rows<'a>(&self, answers: impl IntoIterator<Item = &'a A>) -> Vec<Vec<String>>
    where
        A: 'a,
    {
        answers.into_iter().map(|answer| self.cells(answer)).collect()
    }

    pub(crate) fn cells_or_blanks(&self, answer: Option<&A>) -> Vec<String> {
        answer.map_or_else(|| vec![String::new(); self.columns().len()], |answer| self.cells(answer))
    }

    /// The lines of a sheet.
    pub(crate) fn lines(&self, answer: &A) -> Vec<(&'static str, String)> {
        let lines = |field: &Field<A>| {
            let line = |shown: &Shown<A>| (shown.title, field.text(&shown.look, answer));
            field.lines.iter().map(line).collect::<Vec<_>>()
        };
        self.0.iter().flat_map(lines).collect()
    }

    /// What JSON has at `place`, such as `results[].` or nothing.
    pub(crate) fn described(&self, place: &str) -> Vec<Description> {
        let described = self.0.iter().filter(|field| field.in_json).flat_map(|field| &field.described);
        described.map(|it| Description::new(&format!("{place}{}", it.name), it.unit, it.meaning)).collect()
    }

    pub(crate) fn described_in_csv(&self) -> Vec<Description> {
        let described = |field: &Field<A>| Some(Description::new(field.in_csv?, field.unit, field.meaning));
        self.0.iter().filter_map(described).collect()
    }
}

/// Stands in names and titles for the key of what there are several of.
const KEY: &str = "KEY";
const NAME: &str = "NAME";
