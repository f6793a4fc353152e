//! Report of a measurement, for a student in the first year and for the person who marks it.

pub(super) mod pictures;
mod tables;
mod words;

use super::answer::FitTraceResult;
use crate::command::fit_report::{self, sentence};
use crate::document::{Block, Document, Section, provenance};
use libration_lab::fit::Budget;
use libration_lab::fit::swings::FittedPendulum;

/// The whole report.
pub(super) fn document(answer: &FitTraceResult<'_>) -> Document {
    let sections = [
        Section::new(
            "Result",
            [headline(answer), doubts(answer), words::result(answer), words::meaning(answer)].concat(),
        ),
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
            budget(answer)
                .map(|budget| fit_report::uncertainty(&budget.rows, &budget.combined))
                .unwrap_or_default(),
        ),
        Section::new("Method", vec![Block::List(METHOD.map(str::to_owned).to_vec())]),
        Section::new("All numbers", [tables::parameters(answer), words::numbers(answer)].concat()),
        Section::new("Improving the measurement", list(&answer.advice())),
        Section::new("All cycles", tables::cycles(answer)),
        Section::new("Origin of this report", vec![provenance()]),
    ];
    let title = format!("A pendulum's swing: {}", answer.measured.short_names());
    Document { title, sections: sections.into_iter().flatten().collect() }
}

/// Three sentences on the method.
const METHOD: [&str; 3] = [
    "The equation of motion of the pendulum with friction was integrated at the full amplitude, without the small-angle approximation, and \
     fitted to all rows by least squares.",
    "The kinds of friction were compared by Akaike's criterion, and T₀ and its uncertainty include those that the data do not exclude.",
    "The period of every cycle was measured separately as well: β = 1 in T = T₀·[1 + β(R − 1)] tests the law of the period and the scale of \
     the angles.",
];

/// The budget, where a length was given.
fn budget<'a>(answer: &'a FitTraceResult<'_>) -> Option<&'a Budget> {
    match &answer.swings.pendulum {
        FittedPendulum::Gravity { budget, .. } => Some(budget),
        FittedPendulum::Length(_) => None,
    }
}

/// The result in one line, and normal gravity at the place.
fn headline(answer: &FitTraceResult<'_>) -> Vec<Block> {
    let text = match budget(answer) {
        Some(budget) => fit_report::gravity(budget.g, &budget.combined),
        None => fit_report::doubled("T₀", answer.swings.small_angle_period(), "s"),
    };
    let normal = answer.normal.map(|normal| Block::words(fit_report::normal_gravity(&normal)));
    [Block::Headline(text)].into_iter().chain(normal).collect()
}

/// The warnings about the result.
fn doubts(answer: &FitTraceResult<'_>) -> Vec<Block> {
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
