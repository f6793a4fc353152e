//! The tables of the report.

use super::super::answer::FitTraceResult;
use super::super::{fields, sheet};
use crate::document::{Block, DocumentTable};

/// The models that were compared.
pub(super) fn models(answer: &FitTraceResult<'_>) -> Vec<Block> {
    let Some(comparison) = &answer.swings.comparison else { return vec![] };
    vec![Block::Table(DocumentTable {
        caption: "The damping models that were tried, the best first. ΔAICc is Akaike's criterion above that of the best: below 4 \
                  the data do not decide, above 10 they do"
            .to_owned(),
        columns: fields::shown_models().columns(),
        rows: fields::shown_models().rows(&sheet::best_first(answer, comparison)),
    })]
}

/// The traces one by one, if there are several.
pub(super) fn traces(answer: &FitTraceResult<'_>) -> Vec<Block> {
    if answer.measured.traces.len() == 1 {
        return vec![];
    }
    vec![Block::Table(DocumentTable {
        caption: "Each trace separately: the amplitudes of its cycles, and T₀ and β from these alone"
            .to_owned(),
        columns: fields::of_trace().columns(),
        rows: fields::of_trace().rows(&fields::traces(answer)),
    })]
}

/// Every cycle that was measured.
pub(super) fn cycles(answer: &FitTraceResult<'_>) -> Vec<Block> {
    let cycles = fields::cycles(answer);
    if cycles.is_empty() {
        return vec![];
    }
    let several = answer.measured.traces.len() > 1;
    let columns = &fields::CYCLE_COLUMNS[..if several { 7 } else { 6 }];
    let shown = fields::of_cycle().for_table(columns);
    vec![Block::Table(DocumentTable {
        caption: "Every cycle separately, from one passage of the centre to the next in the same direction; they overlap by half. An \
                  asterisk marks those that do not count because their period is far from the law"
            .to_owned(),
        columns: shown.columns(),
        rows: shown.rows(&cycles),
    })]
}

/// The fitted parameters.
pub(super) fn parameters(answer: &FitTraceResult<'_>) -> Vec<Block> {
    vec![Block::Table(DocumentTable {
        caption:
            "The fitted parameters with standard uncertainties, and the confidence intervals of 68 % and \
                  95 % from the profile likelihood"
                .to_owned(),
        columns: fields::shown_parameters().columns(),
        rows: fields::shown_parameters().rows(&fields::parameters(answer)),
    })]
}
