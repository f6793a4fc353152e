//! The report of a measurement, for a student in the first year and for whoever marks it.

pub(super) mod pictures;
mod tables;
mod words;

use super::answer::Answer;
use crate::document::{Block, Document, Section};

/// The whole report.
pub(super) fn document(answer: &Answer<'_>) -> Document {
    let sections = [
        Section::new("Result", words::result(answer)),
        Section::new("What was read", words::read(answer)),
        Section::new("The motion and the fit", pictures::of_motion(answer)),
        Section::new(
            "What the fit leaves over",
            [words::residuals(answer), pictures::of_residuals(answer)].concat(),
        ),
        Section::new(
            "Period and amplitude",
            [words::periods(answer), pictures::of_periods(answer), tables::traces(answer)].concat(),
        ),
        Section::new(
            "Damping",
            [words::damping(answer), tables::models(answer), pictures::of_damping(answer)].concat(),
        ),
        Section::new("The uncertainty of gravity", [words::budget(answer), tables::budget(answer)].concat()),
        Section::new("All numbers", [tables::parameters(answer), words::numbers(answer)].concat()),
        Section::new("Doubts", list(&answer.warnings)),
        Section::new("What would make it better", list(&answer.advice)),
    ];
    let title = format!("A pendulum's swing: {}", answer.measured.short_names());
    Document { title, sections: sections.into_iter().flatten().collect() }
}

/// The sentences as a list, each with a capital letter and a full stop.
fn list(sentences: &[String]) -> Vec<Block> {
    let items: Vec<String> = sentences.iter().map(|text| sentence(text)).collect();
    if items.is_empty() { vec![] } else { vec![Block::List(items)] }
}

fn sentence(text: &str) -> String {
    let mut letters = text.chars();
    let first = letters.next().map(|letter| letter.to_uppercase().to_string()).unwrap_or_default();
    let stop = if text.ends_with(['.', '!', '?']) { "" } else { "." };
    format!("{first}{}{stop}", letters.as_str())
}
