//! Descriptions of the fields of results: name, unit, meaning.

/// A field of a result. Parts of a name in capitals stand for names that depend on the query.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Description {
    /// Name with its path in JSON: `results[].formulas[].ratio`.
    pub name: String,
    /// `1` for ratios, empty for a field that is not a number or has the unit of what it describes.
    pub(crate) unit: &'static str,
    pub(crate) meaning: &'static str,
}

impl Description {
    /// A name with its unit and meaning.
    pub fn new(name: &str, unit: &'static str, meaning: &'static str) -> Self {
        Self { name: name.to_owned(), unit, meaning }
    }
}

/// The fields of one kind of result.
#[derive(Clone, Debug)]
pub(crate) struct Answers {
    /// The command as typed, without `libration`.
    pub(crate) command: &'static str,
    /// The option, or an oscillator, that requests this kind; empty for the default kind.
    pub(crate) option: &'static str,
    pub(crate) json: Vec<Description>,
    pub(crate) csv: Vec<Description>,
}

/// Name, unit and meaning, as listed in a table.
pub(crate) type DescriptionRow = (&'static str, &'static str, &'static str);

/// The descriptions of a table, after `prefix`, such as `cycles[].` or an empty text.
pub(crate) fn descriptions(prefix: &str, rows: &[DescriptionRow]) -> Vec<Description> {
    let row =
        |&(name, unit, meaning): &DescriptionRow| Description::new(&format!("{prefix}{name}"), unit, meaning);
    rows.iter().map(row).collect()
}
