//! The fields of an answer, each described once: JSON, CSV, tables, sheets and `libration fields` follow.

use super::description::Description;
use super::json::Record;
use super::number;
use super::table::Column;
use serde_json::Value;

/// What a field of an answer `A` is.
type Of<A, T> = fn(&A) -> T;

/// A field of an answer `A`.
pub(crate) struct Field<A> {
    name: &'static str,
    unit: &'static str,
    meaning: &'static str,
    value: Content<A>,
    in_json: bool,
    /// The name of its column, which may have `KEY` in it.
    in_csv: Option<&'static str>,
    columns: Vec<Shown<A>>,
    lines: Vec<Shown<A>>,
}

enum Content<A> {
    /// Not finite: null with a note.
    Number(Of<A, f64>),
    /// A number, or null with a note why there is none.
    Known(Of<A, Result<f64, String>>),
    /// Left out where there is none.
    Present(Of<A, Option<f64>>),
    /// Counts, words, and what is null without a note.
    Value(Of<A, Value>),
    List(Of<A, Vec<Value>>),
    /// A list whose entries have fields of their own, which are described there.
    Records(Of<A, Vec<Value>>),
}

/// How people see a field: below a title, or behind it.
struct Shown<A> {
    title: &'static str,
    look: Look<A>,
}

enum Look<A> {
    Rounded(usize),
    Short(usize),
    /// An angle, which is in radians otherwise.
    Degrees(usize),
    /// With its unit behind it.
    WithUnit(usize),
    Words(Of<A, String>),
    Numeral(Of<A, String>),
}

impl<A> Field<A> {
    fn new(name: &'static str, unit: &'static str, meaning: &'static str, value: Content<A>) -> Self {
        Self { name, unit, meaning, value, in_json: true, in_csv: Some(name), columns: vec![], lines: vec![] }
    }

    pub(crate) fn number(
        name: &'static str,
        unit: &'static str,
        meaning: &'static str,
        value: Of<A, f64>,
    ) -> Self {
        Self::new(name, unit, meaning, Content::Number(value))
    }

    /// A number, or why there is none.
    pub(crate) fn known(
        name: &'static str,
        unit: &'static str,
        meaning: &'static str,
        value: Of<A, Result<f64, String>>,
    ) -> Self {
        Self::new(name, unit, meaning, Content::Known(value))
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

    /// A count, words, or null.
    pub(crate) fn value(
        name: &'static str,
        unit: &'static str,
        meaning: &'static str,
        value: Of<A, Value>,
    ) -> Self {
        Self::new(name, unit, meaning, Content::Value(value))
    }

    /// A list in JSON alone.
    pub(crate) fn list(
        name: &'static str,
        unit: &'static str,
        meaning: &'static str,
        value: Of<A, Vec<Value>>,
    ) -> Self {
        Self::new(name, unit, meaning, Content::List(value)).only_json()
    }

    /// A list in JSON alone of what has fields of its own.
    pub(crate) fn records(name: &'static str, value: Of<A, Vec<Value>>) -> Self {
        Self::new(name, "", "", Content::Records(value)).only_json()
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

    fn write(&self, record: Record, answer: &A) -> Record {
        match self.value {
            Content::Number(value) => record.number(self.name, value(answer)),
            Content::Known(value) => {
                let (value, why) = match value(answer) {
                    Ok(value) => (Some(value), String::new()),
                    Err(why) => (None, why),
                };
                record.number_or(self.name, value, &why)
            }
            Content::Present(value) => match value(answer) {
                Some(value) => record.number(self.name, value),
                None => record,
            },
            Content::Value(value) => record.with(self.name, value(answer)),
            Content::List(values) | Content::Records(values) => record.with(self.name, values(answer)),
        }
    }

    /// As a cell of CSV: empty where there is nothing.
    fn cell(&self, answer: &A) -> String {
        match self.value {
            Content::Value(value) => match value(answer) {
                Value::Null => String::new(),
                Value::String(text) => text,
                other => other.to_string(),
            },
            _ => self.known_number(answer).map_or_else(String::new, number::exact),
        }
    }

    fn known_number(&self, answer: &A) -> Option<f64> {
        match self.value {
            Content::Number(value) => Some(value(answer)),
            Content::Known(value) => value(answer).ok(),
            Content::Present(value) => value(answer),
            Content::Value(_) | Content::List(_) | Content::Records(_) => None,
        }
    }

    fn text(&self, look: &Look<A>, answer: &A) -> String {
        let number = |text: &dyn Fn(f64) -> String| self.known_number(answer).map_or_else(String::new, text);
        match *look {
            Look::Rounded(digits) => number(&|value| number::rounded(value, digits)),
            Look::Short(digits) => number(&|value| number::short(value, digits)),
            Look::Degrees(digits) => number(&|value| number::rounded(value.to_degrees(), digits)),
            Look::WithUnit(digits) => number(&|value| match self.unit {
                "1" => number::rounded(value, digits),
                "s" => number::seconds(value, digits),
                unit => format!("{} {unit}", number::rounded(value, digits)),
            }),
            Look::Words(text) | Look::Numeral(text) => text(answer),
        }
    }
}

/// The fields of an answer `A`, in their order.
pub(crate) struct Fields<A>(Vec<Field<A>>);

impl<A, const N: usize> From<[Field<A>; N]> for Fields<A> {
    fn from(fields: [Field<A>; N]) -> Self {
        Self(fields.into())
    }
}

impl<A> Fields<A> {
    pub(crate) fn record(&self, answer: &A) -> Record {
        self.added_to(Record::new(), answer)
    }

    pub(crate) fn added_to(&self, record: Record, answer: &A) -> Record {
        self.0.iter().filter(|field| field.in_json).fold(record, |record, field| field.write(record, answer))
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

    pub(crate) fn csv_cells_or_blanks(&self, answer: Option<&A>) -> Vec<String> {
        answer.map_or_else(|| vec![String::new(); self.csv_names().len()], |answer| self.csv_cells(answer))
    }

    pub(crate) fn columns(&self) -> Vec<Column> {
        self.columns_for("")
    }

    pub(crate) fn columns_for(&self, key: &str) -> Vec<Column> {
        let column = |shown: &Shown<A>| match shown.look {
            Look::Words(_) => Column::words(shown.title.replace(KEY, key)),
            _ => Column::numbers(shown.title.replace(KEY, key)),
        };
        self.0.iter().flat_map(|field| &field.columns).map(column).collect()
    }

    pub(crate) fn cells(&self, answer: &A) -> Vec<String> {
        let cells = |field: &Field<A>| {
            field.columns.iter().map(|shown| field.text(&shown.look, answer)).collect::<Vec<_>>()
        };
        self.0.iter().flat_map(cells).collect()
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
        let is_described = |field: &&Field<A>| field.in_json && !matches!(field.value, Content::Records(_));
        let fields = self.0.iter().filter(is_described);
        let described = |field: &Field<A>| {
            let each = if matches!(field.value, Content::List(_)) { "[]" } else { "" };
            Description::new(&format!("{place}{}{each}", field.name), field.unit, field.meaning)
        };
        fields.map(described).collect()
    }

    pub(crate) fn described_in_csv(&self) -> Vec<Description> {
        let described = |field: &Field<A>| Some(Description::new(field.in_csv?, field.unit, field.meaning));
        self.0.iter().filter_map(described).collect()
    }
}

/// Stands in names and titles for the key of what there are several of.
const KEY: &str = "KEY";

#[cfg(test)]
mod tests {
    use super::*;

    struct Swing {
        period: f64,
        amplitude: Option<f64>,
    }

    fn fields() -> Fields<Swing> {
        type Of = Field<Swing>;
        Fields::from([
            Of::number("period_s", "s", "period", |swing| swing.period).rounded("T / s", 3).line("period", 5),
            Of::known("amplitude_rad", "rad", "amplitude", |swing| {
                swing.amplitude.ok_or_else(|| "it rotates".to_owned())
            })
            .degrees("θ₀ / °", 3),
            Of::present("KEY_rad", "rad", "the same", |swing| swing.amplitude).in_csv_as("KEY_angle"),
            Of::unnamed().words("kind", |_| "swing".to_owned()),
        ])
    }

    #[test]
    fn one_description_gives_every_form() {
        let (fields, swing) = (fields(), Swing { period: 2.0, amplitude: Some(1.0) });
        let record = Value::from(fields.record(&swing)).to_string();
        assert_eq!(record, r#"{"period_s":2.0,"amplitude_rad":1.0,"KEY_rad":1.0}"#);
        assert_eq!(fields.csv_names_for("a"), ["period_s", "amplitude_rad", "a_angle"]);
        assert_eq!(fields.csv_cells(&swing), ["2.0", "1.0", "1.0"]);
        assert_eq!(fields.cells(&swing), ["2.00", "57.3", "swing"]);
        assert_eq!(fields.lines(&swing), [("period", "2.0000 s".to_owned())]);
        let titles: Vec<String> = fields.columns().into_iter().map(|column| column.title).collect();
        assert_eq!(titles, ["T / s", "θ₀ / °", "kind"]);
        assert_eq!(fields.described("x[].")[0], Description::new("x[].period_s", "s", "period"));
        assert_eq!(fields.described_in_csv()[2].name, "KEY_angle");
    }

    #[test]
    fn what_is_not_there_is_null_left_out_or_empty() {
        let (fields, swing) = (fields(), Swing { period: f64::NAN, amplitude: None });
        let record = Value::from(fields.record(&swing)).to_string();
        let note = "period_s is not defined; amplitude_rad is null: it rotates";
        assert_eq!(record, format!(r#"{{"period_s":null,"amplitude_rad":null,"note":"{note}"}}"#));
        assert_eq!(fields.csv_cells(&swing), ["nan", "", ""]);
        assert_eq!(fields.cells(&swing), ["nan", "", "swing"]);
        assert_eq!(fields.lines(&swing), [("period", "none".to_owned())]);
    }
}
