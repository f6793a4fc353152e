//! Report of a measurement, for a student in the first year and for the person who marks it.

pub(super) mod pictures;
mod tables;
mod words;

use super::answer::Answer;
use crate::document::{Block, Document, Section, provenance};

/// The whole report.
pub(super) fn document(answer: &Answer<'_>) -> Document {
    let sections = [
        Section::new("Result", [words::result(answer), doubts(answer), words::meaning(answer)].concat()),
        Section::new("Interpretation of the file", words::read(answer)),
        Section::new("The motion and the fit", pictures::of_motion(answer)),
        Section::new("The residuals", [words::residuals(answer), pictures::of_residuals(answer)].concat()),
        Section::new(
            "Period and amplitude",
            [words::periods(answer), pictures::of_periods(answer), tables::traces(answer)].concat(),
        ),
        Section::new(
            "Damping",
            [words::damping(answer), tables::models(answer), pictures::of_damping(answer)].concat(),
        ),
        Section::new(
            "The uncertainty of gravity",
            [words::budget(answer), tables::budget(answer), words::inputs(answer), tables::inputs(answer)]
                .concat(),
        ),
        Section::new("All numbers", [tables::parameters(answer), words::numbers(answer)].concat()),
        Section::new("Improving the measurement", list(&answer.advice())),
        Section::new("All cycles", tables::cycles(answer)),
        Section::new("Origin of this report", vec![provenance()]),
    ];
    let title = format!("A pendulum's swing: {}", answer.measured.short_names());
    Document { title, sections: sections.into_iter().flatten().collect() }
}

/// The warnings about the result.
fn doubts(answer: &Answer<'_>) -> Vec<Block> {
    match answer.swings.warnings.is_empty() {
        true => vec![],
        false => vec![Block::Aside("Warnings", sentences(&answer.warnings()))],
    }
}

/// The sentences as a list.
fn list(items: &[String]) -> Vec<Block> {
    if items.is_empty() { vec![] } else { vec![Block::List(sentences(items))] }
}

fn sentences(items: &[String]) -> Vec<String> {
    items.iter().map(|text| sentence(text)).collect()
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
