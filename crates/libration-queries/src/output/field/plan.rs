//! Parts of fields that do not depend on a result, and the formatting of values, which is the same for every result.

use super::content::{Datum, Values};
use super::look::{Look, Shown};
use crate::output::description::Description;
use crate::output::json::Record;
use crate::output::table::Column;
use crate::output::{csv, number};
use libration::internals::InOrder;

/// Placeholder in names and titles for the key of repeated fields.
const KEY: &str = "KEY";
const NAME: &str = "NAME";

/// A field without its value.
#[derive(Default)]
pub(super) struct FieldPlan {
    pub(super) key: &'static str,
    unit: &'static str,
    meaning: &'static str,
    /// The field itself, or the nested ones, with their paths.
    pub(super) described: Vec<Description>,
    pub(super) in_json: bool,
    /// The name of its column, which may have `KEY` in it.
    pub(super) in_csv: Option<&'static str>,
    /// Text of empty values in tables.
    pub(super) blank: &'static str,
    /// The index of the value.
    value: usize,
    columns: Vec<Shown>,
    lines: Vec<Shown>,
}

impl FieldPlan {
    /// Lists and objects, whose names contain the path to their parts, `name[]` or `name.NAME`, appear in JSON only.
    pub(super) fn new(name: &'static str, unit: &'static str, meaning: &'static str) -> Self {
        let key = key_of(name);
        Self {
            key,
            unit,
            meaning,
            described: vec![Description::new(name, unit, meaning)],
            in_json: true,
            in_csv: (key == name).then_some(name),
            blank: "",
            value: 0,
            columns: vec![],
            lines: vec![],
        }
    }

    /// A field that appears in JSON alone and is described by these fields.
    pub(super) fn only_described(name: &'static str, described: Vec<Description>) -> Self {
        Self { in_csv: None, described, ..Self::new(name, "", "") }
    }

    pub(super) fn column(&mut self, title: &'static str, look: Look) {
        self.columns.push(Shown { title, look });
    }

    pub(super) fn line(&mut self, title: &'static str, look: Look) {
        self.lines.push(Shown { title, look });
    }

    /// Shifts the indices of its values by `before`.
    fn behind(&mut self, before: usize) {
        self.value += before;
        for shown in self.columns.iter_mut().chain(&mut self.lines) {
            shown.look.behind(before);
        }
    }

    fn text(&self, look: &Look, values: Values<'_>) -> String {
        let value = values(self.value).to_f64();
        look.text(value, self.unit, values).unwrap_or_else(|| self.blank.to_owned())
    }

    /// Appends the cell to a text, quoted if needed; numbers, of which there may be millions, are written without an intermediate text.
    fn write_cell(&self, text: &mut Vec<u8>, values: Values<'_>) {
        match values(self.value) {
            Datum::Number(value) if value.is_finite() => number::write_exact(text, value),
            other => text.extend_from_slice(csv::quoted(&self.cell_of(&other)).as_bytes()),
        }
    }

    fn cell_of(&self, value: &Datum) -> String {
        value.to_cell().unwrap_or_default()
    }
}

/// The fields of a result in their order.
#[derive(Default)]
pub(super) struct Plans(Vec<FieldPlan>);

impl Plans {
    /// Adds a further field whose values come after `before` others.
    pub(super) fn push(&mut self, mut plan: FieldPlan, before: usize) {
        plan.behind(before);
        self.0.push(plan);
    }

    /// Adds further fields whose values come after `before` others.
    pub(super) fn append(&mut self, others: Self, before: usize) {
        others.0.into_iter().for_each(|plan| self.push(plan, before));
    }

    /// Keeps the fields for a table with these columns, in their order.
    pub(super) fn keep_for_table(&mut self, titles: &[&str]) {
        let index = |plan: &FieldPlan| {
            let title = plan.columns.first()?.title;
            titles.iter().position(|other| *other == title)
        };
        self.0.retain(|plan| index(plan).is_some());
        self.0.put_in_order_by(index);
    }

    /// Adds the fields of JSON, in whose names `NAME` stands for this one.
    pub(super) fn added_for(&self, name: &str, record: Record, values: Values<'_>) -> Record {
        let plans = self.0.iter().filter(|plan| plan.in_json);
        plans.fold(record, |record, plan| values(plan.value).added_to(record, &plan.key.replace(NAME, name)))
    }

    /// Adds the fields under their own names.
    pub(super) fn added_to(&self, record: Record, values: Values<'_>) -> Record {
        self.added_for(NAME, record, values)
    }

    fn in_csv(&self) -> impl Iterator<Item = &FieldPlan> {
        self.0.iter().filter(|plan| plan.in_csv.is_some())
    }

    /// The first line of CSV.
    pub(super) fn csv_names(&self) -> Vec<String> {
        self.0.iter().filter_map(|plan| plan.in_csv).map(str::to_owned).collect()
    }

    /// The names of the columns for a key.
    pub(super) fn csv_names_for(&self, key: &str) -> Vec<String> {
        self.csv_names().iter().map(|name| name.replace(KEY, key)).collect()
    }

    pub(super) fn csv_cells(&self, values: Values<'_>) -> Vec<String> {
        self.in_csv().map(|plan| plan.cell_of(&values(plan.value))).collect()
    }

    pub(super) fn csv_blanks(&self) -> Vec<String> {
        vec![String::new(); self.in_csv().count()]
    }

    /// Appends the cells, separated by commas, to a text.
    pub(super) fn write_csv_cells(&self, text: &mut Vec<u8>, values: Values<'_>) {
        for (index, plan) in self.in_csv().enumerate() {
            if index > 0 {
                text.push(b',');
            }
            plan.write_cell(text, values);
        }
    }

    pub(super) fn columns_for(&self, key: &str) -> Vec<Column> {
        let column = |shown: &Shown| match shown.look.is_of_words() {
            true => Column::words(shown.title.replace(KEY, key)),
            false => Column::numbers(shown.title.replace(KEY, key)),
        };
        self.0.iter().flat_map(|plan| &plan.columns).map(column).collect()
    }

    pub(super) fn cells(&self, values: Values<'_>) -> Vec<String> {
        let of_plan = |plan: &FieldPlan| {
            plan.columns.iter().map(|shown| plan.text(&shown.look, values)).collect::<Vec<_>>()
        };
        self.0.iter().flat_map(of_plan).collect()
    }

    pub(super) fn blank_cells(&self) -> Vec<String> {
        vec![String::new(); self.0.iter().map(|plan| plan.columns.len()).sum()]
    }

    /// The lines of a sheet.
    pub(super) fn lines(&self, values: Values<'_>) -> Vec<(&'static str, String)> {
        let of_plan = |plan: &FieldPlan| {
            let line = |shown: &Shown| (shown.title, plan.text(&shown.look, values));
            plan.lines.iter().map(line).collect::<Vec<_>>()
        };
        self.0.iter().flat_map(of_plan).collect()
    }

    /// The fields of JSON at `prefix`, such as `results[].` or an empty text.
    pub(super) fn described(&self, prefix: &str) -> Vec<Description> {
        let described = self.0.iter().filter(|plan| plan.in_json).flat_map(|plan| &plan.described);
        described
            .map(|described| {
                Description::new(&format!("{prefix}{}", described.name), described.unit, described.meaning)
            })
            .collect()
    }

    pub(super) fn described_in_csv(&self) -> Vec<Description> {
        let described = |plan: &FieldPlan| Some(Description::new(plan.in_csv?, plan.unit, plan.meaning));
        self.0.iter().filter_map(described).collect()
    }
}

/// The name in its object: `initial` for `initial[][]`.
pub(super) fn key_of(name: &'static str) -> &'static str {
    name.split(['[', '.']).next().unwrap_or(name)
}
