//! A statement of a document: its label, its formulas, and its check.

use super::finding::StatementFinding;
use super::printed::Printed;
use libration::internals::InOrder;

/// One of the two documents.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Document {
    /// B. Black and V. Vel, Am. J. Phys. 91, 776 (2023).
    BlackVel,
    /// J. Côté, Period of a Pendulum.
    Cote,
}

impl Document {
    /// All documents.
    pub const ALL: [Self; 2] = [Self::BlackVel, Self::Cote];

    /// `black-vel` or `cote`.
    #[must_use]
    pub const fn key(self) -> &'static str {
        match self {
            Self::BlackVel => "black-vel",
            Self::Cote => "cote",
        }
    }

    /// The source from which the document was read.
    #[must_use]
    pub const fn read_from(self) -> &'static str {
        match self {
            Self::BlackVel => {
                "a copy of its text, which has lost the lines of roots and fractions: where a formula hangs on one, the error may be \
                 the copy's"
            }
            Self::Cote => "its source, in which formulas are LaTeX",
        }
    }

    /// Author, title and place of publication.
    #[must_use]
    pub const fn title(self) -> &'static str {
        match self {
            Self::BlackVel => {
                "B. Black and V. Vel, An analysis of the large amplitude simple pendulum using Fourier series, \
                 Am. J. Phys. 91, 776 (2023), doi:10.1119/5.0130943"
            }
            Self::Cote => "J. C\u{f4}t\u{e9}, Period of a Pendulum; its displayed equations in their order",
        }
    }
}

/// A statement with its verdict.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// Document that contains the statement.
    pub document: Document,
    /// `(25)`, `(C2)`, `Fig. 1`, or `text: …`.
    pub label: String,
    /// Claim of the document, paraphrased.
    pub claim: String,
    /// Formulas printed there; integrals and sums are given by their integrands and terms.
    pub printed: Vec<String>,
    /// `true` if the document has words or an inequality for which `printed` has an equivalent formula.
    pub paraphrase: bool,
    /// Result of the check.
    pub finding: StatementFinding,
}

/// A check that compares the printed formulas with computed ones; `None` if a formula cannot be evaluated.
pub(super) type StatementCheck = fn(&Printed) -> Option<StatementFinding>;

/// A statement of a document with its check.
#[derive(Clone, Copy, Debug)]
pub struct PrintedStatement {
    /// The label itself, or for text that of the preceding equation or figure.
    pub(super) after: &'static str,
    /// The number of an equation, or the subject of a text.
    pub label: &'static str,
    pub(super) claim: &'static str,
    /// The formulas as the document prints them.
    pub printed: &'static [&'static str],
    pub(super) paraphrase: bool,
    pub(super) check: StatementCheck,
}

/// The evidence if a check could not be carried out.
pub const NOT_EVALUATED: &str = "the check could not be carried out, as a formula has no value here where one is needed: that says nothing about the statement";

impl PrintedStatement {
    /// The statement, marked as a paraphrase of words in the document.
    pub(super) const fn paraphrased(self) -> Self {
        Self { paraphrase: true, ..self }
    }

    /// The statement with the result of its check.
    pub fn row(&self, document: Document) -> Row {
        Row {
            document,
            label: self.label.to_owned(),
            claim: self.claim.to_owned(),
            printed: self.printed.iter().map(|&text| text.to_owned()).collect(),
            paraphrase: self.paraphrase,
            finding: self.finding(self.printed),
        }
    }

    /// The result of the check for these printed formulas.
    pub fn finding(&self, printed: &[&str]) -> StatementFinding {
        let finding = Printed::read(printed).and_then(|printed| (self.check)(&printed));
        finding.unwrap_or_else(|| StatementFinding::not_decided(NOT_EVALUATED))
    }
}

pub(super) const fn statement(
    label: &'static str,
    claim: &'static str,
    printed: &'static [&'static str],
    check: StatementCheck,
) -> PrintedStatement {
    text_after(label, label, claim, printed, check)
}

/// A text statement after an equation.
pub(super) const fn text_after(
    after: &'static str,
    label: &'static str,
    claim: &'static str,
    printed: &'static [&'static str],
    check: StatementCheck,
) -> PrintedStatement {
    PrintedStatement { after, label, claim, printed, paraphrase: false, check }
}

/// The statements of several groups in the order of the document.
pub(super) fn in_order(groups: &[&'static [PrintedStatement]]) -> Vec<&'static PrintedStatement> {
    let mut ordered: Vec<&PrintedStatement> = groups.iter().copied().flatten().collect();
    // The sort is stable: text after an equation follows it in the order of its group.
    ordered.put_in_order_by(|statement| (place_of(statement.after), statement.after != statement.label));
    ordered
}

/// The position of `(25)`, `(C2)` or `Fig. 1` by appendix and number; the figure counts as after equation (51).
fn place_of(label: &str) -> (Option<char>, u32, u32) {
    if label.starts_with("Fig.") {
        return (None, 51, 1);
    }
    let number = label.trim_matches(['(', ')']);
    let digits = number.trim_start_matches(|letter: char| letter.is_ascii_uppercase());
    let appendix = number.chars().next().filter(char::is_ascii_uppercase);
    (appendix, digits.parse().unwrap_or(u32::MAX), 0)
}
