//! The tables of the report.

use super::super::answer::{Answer, Pendulum};
use super::super::sheet;
use crate::document::{Block, Table};
use crate::output;

/// The models that were compared.
pub(super) fn models(answer: &Answer<'_>) -> Vec<Block> {
    let Some(comparison) = &answer.comparison else { return vec![] };
    vec![Block::Table(Table {
        caption: "The kinds of damping that were tried, the best first. ΔAICc is Akaike's criterion above that of the best: below 4 \
                  the data do not decide, above 10 they do"
            .to_owned(),
        columns: sheet::model_columns(),
        rows: sheet::model_rows(answer, comparison),
    })]
}

/// The traces one by one, where there are several.
pub(super) fn traces(answer: &Answer<'_>) -> Vec<Block> {
    if answer.measured.traces.len() == 1 {
        return vec![];
    }
    vec![Block::Table(Table {
        caption: "Each trace by itself: the amplitudes of its cycles, and T₀ and β by these alone".to_owned(),
        columns: sheet::trace_columns(),
        rows: sheet::trace_rows(answer),
    })]
}

/// Where the uncertainty of gravity comes from.
pub(super) fn budget(answer: &Answer<'_>) -> Vec<Block> {
    let Pendulum::Gravity { budget, .. } = &answer.pendulum else { return vec![] };
    vec![Block::Table(Table {
        caption: "The budget of the uncertainty of gravity".to_owned(),
        columns: output::budget::columns(),
        rows: output::budget::rows(budget),
    })]
}

/// The fitted parameters.
pub(super) fn parameters(answer: &Answer<'_>) -> Vec<Block> {
    let rows = answer.fit.parameters.iter().map(|parameter| sheet::cells(parameter, answer));
    vec![Block::Table(Table {
        caption: "The fitted parameters with standard uncertainties, and the intervals that hold the truth with 68 % and 95 % \
                  probability by the profile of the likelihood"
            .to_owned(),
        columns: sheet::parameter_columns(),
        rows: rows.collect(),
    })]
}
