//! `libration paper`: two published derivations checked equation by equation.

use crate::output::description::Answers;
use crate::output::field::{Field, Fields};
use crate::output::table::paragraph;
use crate::output::{Form, FormOptions, csv, json, json::Record, number};
use crate::query_error::QueryError;
use libration_derivation::paper::{Document, Row, StatementVerdict, rows_where};
use std::io::{self, Write};

/// Every equation of two published derivations, checked by computation and corrected where it is wrong
///
/// The documents are B. Black and V. Vel, Am. J. Phys. 91, 776 (2023), and J. Côté, Period of a Pendulum. What they print is compared with what the program computes, exactly where possible. Where they state something in words,
/// `paraphrase` marks the formula.
#[derive(Debug, clap::Args)]
#[cfg_attr(
    not(target_arch = "wasm32"),
    command(after_help = "Examples:
  libration paper                    # every equation, verdict and evidence
  libration paper --only wrong       # wrong statements, with corrections
  libration paper --label 25 --json")
)]
pub(crate) struct Paper {
    /// Show only statements with this verdict
    #[arg(long, value_parser = verdict, value_name = "VERDICT")]
    only: Option<StatementVerdict>,
    /// Show only one document: black-vel or cote
    #[arg(long, value_parser = document, value_name = "DOCUMENT")]
    document: Option<Document>,
    /// Show only labels that contain this number or these words, such as 25, C2 or "Fig. 1"
    #[arg(long)]
    label: Option<String>,
    #[command(flatten)]
    form: FormOptions,
}

impl Paper {
    pub(crate) fn answer(&self, out: &mut dyn Write) -> Result<(), QueryError> {
        let mut chosen = rows_where(|document, label| self.asks_for(document, label));
        chosen.retain(|row| self.only.is_none_or(|verdict| verdict == row.finding.verdict));
        if chosen.is_empty() {
            return Err(QueryError::no_result(
                "paper",
                "no statement matches: leave out <--label> or <--only>",
            ));
        }
        match self.form.form() {
            Form::Json => {
                let fields = of_statement();
                let records = chosen.iter().map(|row| fields.record(row));
                json::document_with_list(out, Record::new(), "equations", records)?;
            }
            Form::Csv => {
                let fields = of_statement();
                csv::line(out, &fields.csv_names())?;
                chosen.iter().try_for_each(|row| csv::line(out, &fields.csv_cells(row)))?;
            }
            Form::Table => write_pages(out, &chosen)?,
        }
        Ok(())
    }

    fn asks_for(&self, document: Document, label: &str) -> bool {
        self.document.is_none_or(|asked| asked == document)
            && self.label.as_ref().is_none_or(|asked| is_named(label, asked))
    }
}

/// Returns `true` if a label has this number as a whole, or these words as a part.
fn is_named(label: &str, asked: &str) -> bool {
    let bare = |text: &str| text.trim().trim_matches(['(', ')']).to_lowercase();
    bare(label) == bare(asked) || (!label.starts_with('(') && label.to_lowercase().contains(&bare(asked)))
}

fn verdict(text: &str) -> Result<StatementVerdict, String> {
    let verdict = StatementVerdict::ALL.into_iter().find(|verdict| verdict.name() == text.replace('-', " "));
    verdict.ok_or_else(|| format!("unknown verdict `{text}`: give verified, typo, wrong or not-decided"))
}

fn document(text: &str) -> Result<Document, String> {
    let document = Document::ALL.into_iter().find(|document| document.key() == text.replace('_', "-"));
    document.ok_or_else(|| format!("unknown document `{text}`: give black-vel or cote"))
}

/// Meaning of the field with the amplitudes at which a claim holds.
const HOLDS: &str = "amplitudes, from and to, at which a numerical claim holds";
const PARAPHRASE: &str =
    "true if the formula is a paraphrase, for a statement that the document makes in words";

fn of_statement() -> Fields<Row> {
    type Of = Field<Row>;
    Fields::from([
        Of::value("document", "", "black-vel or cote", |row| row.document.key().into()),
        Of::value("label", "", "number of the equation, or position of the statement", |row| {
            row.label.as_str().into()
        }),
        Of::value("claim", "", "claim in words", |row| row.claim.as_str().into()),
        Of::value("printed[]", "", "formulas as they are printed", |row| json::list(row.printed.clone())),
        Of::value("printed", "", "formulas as they are printed, with ; between them", |row| {
            row.printed.join("; ").into()
        })
        .only_csv(),
        Of::value("paraphrase", "", PARAPHRASE, |row| row.paraphrase.into()).only_json(),
        Of::value("read_from", "", "text from which the statement was read", |row| {
            row.document.read_from().into()
        })
        .only_json(),
        Of::value("verdict", "", "verified, typo, wrong or not decided, with what restricts it", |row| {
            row.finding.summary().into()
        }),
        Of::value("correct", "", "corrected formula, empty where nothing is wrong", |row| {
            row.finding.correct.as_str().into()
        }),
        Of::value("evidence", "", "evidence for the verdict", |row| row.finding.evidence.as_str().into()),
        Of::present_value("holds_for_rad[][]", "rad", HOLDS, |row| {
            let ends = row.finding.holds_for.iter().map(|&(from, to)| json::numbers(&[from, to]));
            (!row.finding.holds_for.is_empty()).then(|| json::list(ends))
        }),
        Of::value("holds_for_rad", "rad", HOLDS, |row| ranges(row).into()).only_csv(),
        Of::value("paraphrase", "", PARAPHRASE, |row| row.paraphrase.into()).only_csv(),
    ])
}

pub(crate) fn answers() -> Vec<Answers> {
    let json = of_statement().described("equations[].");
    vec![Answers { command: "paper", option: "", json, csv: of_statement().described_in_csv() }]
}

fn ranges(row: &Row) -> String {
    let ends = row.finding.holds_for.iter();
    let texts = ends.map(|&(from, to)| format!("{} to {}", number::exact(from), number::exact(to)));
    texts.collect::<Vec<_>>().join("; ")
}

/// Grouped by document, each statement as a paragraph, the count of verdicts at the end.
fn write_pages(out: &mut dyn Write, rows: &[Row]) -> io::Result<()> {
    for document in Document::ALL {
        let chosen: Vec<&Row> = rows.iter().filter(|row| row.document == document).collect();
        if !chosen.is_empty() {
            writeln!(out, "{}", wrapped(document.title(), 0))?;
            writeln!(out, "{}\n", wrapped(&format!("read from {}", document.read_from()), INDENT))?;
        }
        for row in chosen {
            write_row(out, row)?;
        }
    }
    let count = |verdict: StatementVerdict| rows.iter().filter(|row| row.finding.verdict == verdict).count();
    let counts = StatementVerdict::ALL.map(|verdict| format!("{} {verdict}", count(verdict)));
    writeln!(out, "{} statements: {}", rows.len(), counts.join(", "))
}

fn write_row(out: &mut dyn Write, row: &Row) -> io::Result<()> {
    let finding = &row.finding;
    let verdict = format!("{} {}", finding.verdict.name().to_uppercase(), finding.restriction);
    writeln!(out, "{}", wrapped(&format!("{}  {}", row.label, verdict.trim_end()), 0))?;
    writeln!(out, "{}", wrapped(&row.claim, INDENT))?;
    if !row.printed.is_empty() {
        let said = if row.paraphrase { "paraphrase" } else { "printed  " };
        writeln!(out, "{}", wrapped(&format!("{said} {}", row.printed.join("; ")), INDENT))?;
    }
    if !finding.correct.is_empty() {
        writeln!(out, "{}", wrapped(&format!("correct   {}", finding.correct), INDENT))?;
    }
    writeln!(out, "{}\n", wrapped(&format!("evidence  {}", finding.evidence), INDENT))
}

const INDENT: usize = 4;
const WIDTH: usize = 100;

/// The text in lines after `indent` blanks.
fn wrapped(text: &str, indent: usize) -> String {
    paragraph(&" ".repeat(indent), text, WIDTH)
}
