//! The tables of the report.

use super::super::answer::Answer;
use super::super::sheet;
use crate::document::{Block, Table};
use crate::output;
use crate::output::number::{short, with_uncertainty};
use crate::output::table::Column;
use libration_lab::fit::cycles::Cycle;
use libration_lab::fit::swings::FittedPendulum;

/// The models that were compared.
pub(super) fn models(answer: &Answer<'_>) -> Vec<Block> {
    let Some(comparison) = &answer.swings.comparison else { return vec![] };
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
    let FittedPendulum::Gravity { budget, .. } = &answer.swings.pendulum else { return vec![] };
    vec![Block::Table(Table {
        caption: "The budget of the uncertainty of gravity".to_owned(),
        columns: output::budget::columns(),
        rows: output::budget::rows(budget),
    })]
}

/// Its inputs one by one.
pub(super) fn inputs(answer: &Answer<'_>) -> Vec<Block> {
    let FittedPendulum::Gravity { budget, .. } = &answer.swings.pendulum else { return vec![] };
    vec![Block::Table(Table {
        caption: "The inputs of gravity with their sensitivity coefficients".to_owned(),
        columns: output::combined::columns(),
        rows: output::combined::rows(&budget.combined),
    })]
}

/// Every cycle that was measured.
pub(super) fn cycles(answer: &Answer<'_>) -> Vec<Block> {
    let several = answer.measured.traces.len() > 1;
    let rows: Vec<Vec<String>> = answer
        .swings
        .all_cycles()
        .zip(1..)
        .map(|(cycle, number)| of_cycle(answer, number, cycle, several))
        .collect();
    if rows.is_empty() {
        return vec![];
    }
    let numbers =
        ["cycle", "start / s", "period / s", "± / s", "amplitude / °", "± / °"].map(Column::numbers);
    let of_trace = several.then(|| Column::words("trace"));
    vec![Block::Table(Table {
        caption: "Every cycle by itself, from one passage of the centre to the next in the same direction; they overlap by half. An \
                  asterisk marks those that do not count because their period is far from the law"
            .to_owned(),
        columns: numbers.into_iter().chain(of_trace).collect(),
        rows,
    })]
}

fn of_cycle(
    answer: &Answer<'_>,
    number: usize,
    (trace, cycle): (usize, &Cycle),
    several: bool,
) -> Vec<String> {
    let both = |value: f64, uncertainty: f64| -> [String; 2] {
        let text = with_uncertainty(value, uncertainty, "");
        let (value, uncertainty) = text.split_once(" ± ").unwrap_or((&text, "–"));
        [value.to_owned(), uncertainty.to_owned()]
    };
    let mark = if cycle.outlier { "*" } else { "" };
    let [period, of_period] = both(cycle.period, cycle.period_uncertainty);
    let [amplitude, of_amplitude] =
        both(cycle.amplitude.to_degrees(), cycle.amplitude_uncertainty.to_degrees());
    let start = short(cycle.time - 0.5 * cycle.period, 6);
    let name = several.then(|| answer.measured.traces[trace].name().to_owned());
    [format!("{number}{mark}"), start, period, of_period, amplitude, of_amplitude]
        .into_iter()
        .chain(name)
        .collect()
}

/// The fitted parameters.
pub(super) fn parameters(answer: &Answer<'_>) -> Vec<Block> {
    let rows = answer.swings.fit.parameters.iter().map(|parameter| sheet::cells(parameter, answer));
    vec![Block::Table(Table {
        caption: "The fitted parameters with standard uncertainties, and the intervals that hold the truth with 68 % and 95 % \
                  probability by the profile of the likelihood"
            .to_owned(),
        columns: sheet::parameter_columns(),
        rows: rows.collect(),
    })]
}
