//! Common parts of the reports of all fits: headline, measurements, picture, tables, budget, method and origin.

use crate::document::{Block, Document, DocumentFigure, DocumentTable, Section, provenance};
use crate::figure::chart::Picture;
use crate::output::groups::Groups;
use crate::output::normal_gravity::NormalGravity;
use crate::output::table::Column;
use crate::output::{budget, combined, number};
use libration_lab::fit::{BudgetRow, CombinedUncertainty, Uncertain};

/// The content of a report in the order of its sections; sections without blocks are left out.
#[derive(Default)]
pub(super) struct FitReport {
    /// The result in one line.
    pub(super) headline: String,
    /// Normal gravity at the place.
    pub(super) normal: Option<NormalGravity>,
    /// Warnings about the result.
    pub(super) warnings: Vec<String>,
    /// Names and values of inputs and results.
    pub(super) facts: Vec<(&'static str, String)>,
    pub(super) picture: Vec<Block>,
    /// The results of single groups.
    pub(super) groups: Vec<Block>,
    /// The laws or models that were compared.
    pub(super) laws: Vec<Block>,
    pub(super) budget: Vec<Block>,
    /// Three sentences on the method.
    pub(super) method: [&'static str; 3],
    /// The rows that were fitted.
    pub(super) rows: Vec<Block>,
}

impl FitReport {
    /// The document about this file.
    pub(super) fn document(self, subject: &str, file: &str) -> Document {
        let doubts: Vec<String> = self.warnings.iter().map(|text| sentence(text)).collect();
        let doubts = (!doubts.is_empty()).then_some(Block::Aside("Warnings", doubts));
        let normal = self.normal.map(|normal| Block::words(normal_gravity(&normal)));
        let result = [Block::Headline(self.headline)].into_iter().chain(normal).chain(doubts).collect();
        let facts = table("What was read and what was found", &["quantity", "value"], &[], {
            self.facts.into_iter().map(|(name, value)| vec![name.to_owned(), value]).collect()
        });
        let method = self.method.iter().map(|text| (*text).to_owned()).collect();
        let sections = [
            Section::new("Result", result),
            Section::new("What was measured", facts),
            Section::new("The measurements and the fit", self.picture),
            Section::new("Groups", self.groups),
            Section::new("Laws that were compared", self.laws),
            Section::new("The uncertainty of gravity", self.budget),
            Section::new("Method", vec![Block::List(method)]),
            Section::new("All rows", self.rows),
            Section::new("Origin of this report", vec![provenance()]),
        ];
        let title = format!("{subject}: {}", short_name(file));
        Document { title, sections: sections.into_iter().flatten().collect() }
    }
}

/// `g = 9.812 ± 0.012 m/s² (k = 2.0)`, with the expanded uncertainty.
pub(super) fn gravity(gravity: f64, uncertainty: &CombinedUncertainty) -> String {
    let value = number::with_uncertainty(gravity, uncertainty.expanded(), "m/s²");
    format!("g = {value} (k = {})", number::rounded(uncertainty.coverage_factor(), 2))
}

/// The entry of another quantity, with its doubled uncertainty.
pub(super) fn doubled(name: &str, quantity: Uncertain, unit: &str) -> String {
    format!("{name} = {} (k = 2)", number::with_uncertainty(quantity.value, 2.0 * quantity.uncertainty, unit))
}

/// Normal gravity as a sentence.
pub(super) fn normal_gravity(normal: &NormalGravity) -> String {
    format!("Normal gravity at this place: {}.", normal.line().1)
}

/// The picture of a fit.
pub(super) fn picture(name: &str, caption: &str, picture: Picture) -> Vec<Block> {
    vec![Block::Figure(DocumentFigure { name: name.to_owned(), caption: caption.to_owned(), picture })]
}

/// A table with columns of words, and after them columns of numbers.
pub(super) fn table(caption: &str, words: &[&str], numbers: &[&str], rows: Vec<Vec<String>>) -> Vec<Block> {
    let words = words.iter().map(|title| Column::words(*title));
    let columns = words.chain(numbers.iter().map(|title| Column::numbers(*title))).collect();
    of_columns(caption, columns, rows)
}

/// A table with these columns; `None` without rows.
pub(super) fn of_columns(caption: &str, columns: Vec<Column>, rows: Vec<Vec<String>>) -> Vec<Block> {
    if rows.is_empty() {
        return vec![];
    }
    vec![Block::Table(DocumentTable { caption: caption.to_owned(), columns, rows })]
}

/// Results of groups with their mean.
pub(super) fn groups(groups: Option<&Groups>) -> Vec<Block> {
    let Some(groups) = groups else { return vec![] };
    let mean = Block::words(format!(
        "Weighted mean of all groups, with what all share entered once: {}.",
        groups.line()
    ));
    [vec![mean], of_columns("The result of each group", groups.columns(), groups.cells())].concat()
}

/// The budget of gravity: its effects and its inputs, explained.
pub(super) fn uncertainty(effects: &[BudgetRow], uncertainty: &CombinedUncertainty) -> Vec<Block> {
    let effects = of_columns(
        "The budget of the uncertainty of gravity",
        budget::columns(),
        budget::rows(effects, uncertainty),
    );
    let inputs = of_columns(
        "The inputs of gravity with their sensitivity coefficients",
        combined::columns(),
        combined::rows(uncertainty),
    );
    [vec![Block::words(EFFECTS)], effects, vec![Block::words(INPUTS)], inputs].concat()
}

const EFFECTS: &str = "Each line is one effect: the correction of g, the contribution to the uncertainty of g, its evaluation from \
                       scatter (type A) or from other knowledge (type B), and the formula. Contributions add in quadrature, so that only the \
                       largest ones matter. A correction in parentheses was not made, because nothing was given for it.";

const INPUTS: &str = "Input by input: its value x with its standard uncertainty u(x), the sensitivity coefficient ∂g/∂x by which g follows it, \
                      their product, and its share of the variance of g; ν are the degrees of freedom of u(x), ∞ where it is taken as known. The \
                      expanded uncertainty is U = k·u(g) with Student's k for 95 % and the effective degrees of freedom after Welch and \
                      Satterthwaite (Guide to the Expression of Uncertainty in Measurement, JCGM 100:2008).";

/// A number with the digits that its uncertainty determines, or seven.
pub(super) fn to_known_digits(value: f64, uncertainty: Option<f64>) -> Vec<String> {
    match uncertainty.filter(|uncertainty| *uncertainty > 0.0) {
        Some(uncertainty) => {
            let text = number::with_uncertainty(value, uncertainty, "");
            text.split(" ± ").map(str::to_owned).collect()
        }
        None => vec![number::short(value, 7), "–".to_owned()],
    }
}

/// The name of a file without its folders.
fn short_name(file: &str) -> String {
    let name = std::path::Path::new(file).file_name();
    name.map_or_else(|| file.to_owned(), |name| name.to_string_lossy().into_owned())
}

/// A text as a sentence: with a capital letter, if it begins with a word and not with a symbol or a name, and a full stop.
pub fn sentence(text: &str) -> String {
    let stop = if text.ends_with(['.', '!', '?']) { "" } else { "." };
    let first = text.split_whitespace().next().unwrap_or_default().trim_end_matches([',', ':', ';']);
    let is_a_word =
        first == "a" || (first.len() > 1 && first.bytes().all(|letter| letter.is_ascii_lowercase()));
    let (head, rest) = text.split_at(usize::from(is_a_word));
    format!("{}{rest}{stop}", head.to_ascii_uppercase())
}
