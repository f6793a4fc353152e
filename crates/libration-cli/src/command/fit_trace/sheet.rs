//! The answer as a sheet with tables, for people at a terminal.

use super::answer::Answer;
use crate::output;
use crate::output::number::{self, rounded, short, with_uncertainty};
use crate::output::table::{Column, Table, paragraph, sheet};
use libration::quantity::STANDARD_GRAVITY;
use libration_lab::fit::cycles::Cycles;
use libration_lab::fit::swings::FittedPendulum;
use libration_lab::fit::trace::{Comparison, Parameter, Standing};
use libration_lab::fit::{DampingTerm, alternatives};
use libration_lab::measurement::Seen;
use std::io::{self, Write};

/// Letters in a line.
const WIDTH: usize = 100;

/// Writes everything that is found.
pub(super) fn write(out: &mut dyn Write, answer: &Answer<'_>) -> io::Result<()> {
    sheet(out, &lines(answer))?;
    writeln!(out)?;
    parameters(out, answer)?;
    if answer.measured.traces.len() > 1 {
        writeln!(out)?;
        traces(out, answer)?;
    }
    if let Some(comparison) = &answer.swings.comparison {
        writeln!(out)?;
        models(out, answer, comparison)?;
    }
    if let FittedPendulum::Gravity { budget, .. } = &answer.swings.pendulum {
        writeln!(out)?;
        output::budget::write_table(out, budget)?;
    }
    list(out, "warnings", &answer.warnings())?;
    list(out, "to improve", &answer.advice())?;
    answer.measured.files.iter().try_for_each(|file| {
        list(out, &format!("detected in {} (the option overrides it)", file.name), &file.findings)
    })
}

fn lines(answer: &Answer<'_>) -> Vec<(&'static str, String)> {
    let period = answer.swings.small_angle_period();
    let mut lines = vec![
        ("read", read(answer)),
        ("model", model(answer)),
        ("T₀", number::quantity(period, "s")),
        gravity_or_length(answer),
    ];
    lines.extend(expanded(answer).map(|text| ("expanded", text)));
    lines.extend([("rms residual", residual(answer)), ("cycles", cycles(answer)), ("β", beta(answer))]);
    lines
}

/// The expanded uncertainty of gravity, where there is one.
pub(super) fn expanded(answer: &Answer<'_>) -> Option<String> {
    match &answer.swings.pendulum {
        FittedPendulum::Gravity { budget, .. } => Some(output::combined::expanded(&budget.combined)),
        FittedPendulum::Length(_) => None,
    }
}

fn read(answer: &Answer<'_>) -> String {
    let traces = &answer.measured.traces;
    let rows = answer.swings.fit.rows();
    let seconds =
        |trace: &libration_lab::measurement::Trace| trace.times()[trace.len() - 1] - trace.times()[0];
    match &traces[..] {
        [only] => format!("{rows} rows in {} s from {}", rounded(seconds(only), 4), answer.measured.names()),
        many => format!("{rows} rows in {} traces from {}", many.len(), answer.measured.names()),
    }
}

/// The damping, and how it was chosen.
pub(super) fn model(answer: &Answer<'_>) -> String {
    let chosen = answer.swings.fit.damping.to_string();
    let rivals = answer.swings.rivals();
    match (&answer.swings.comparison, rivals.len()) {
        (None, _) => format!("{chosen} (as asked)"),
        (Some(_), 0) => format!("{chosen} (preferred by the data)"),
        (Some(_), _) => {
            format!("{chosen} (the data cannot exclude {})", alternatives(&rivals))
        }
    }
}

/// Gravity if the length is known, else the length.
pub(super) fn gravity_or_length(answer: &Answer<'_>) -> (&'static str, String) {
    match &answer.swings.pendulum {
        FittedPendulum::Gravity { budget, length } => {
            let length = number::quantity(*length, "m");
            let gravity = number::quantity(budget.gravity(), "m/s²");
            ("gravity", format!("{gravity}  (length {length})"))
        }
        FittedPendulum::Length(length) => {
            let length = number::quantity(*length, "m");
            ("length", format!("{length}  (of a simple pendulum, if g = {STANDARD_GRAVITY} m/s²)"))
        }
    }
}

/// In degrees for angles.
pub(super) fn residual(answer: &Answer<'_>) -> String {
    let rms = in_unit(answer, answer.swings.fit.rms, 3);
    answer.swings.fit.chi2_per_dof.map_or(rms.clone(), |chi2| format!("{rms}, χ²/dof {}", rounded(chi2, 3)))
}

fn cycles(answer: &Answer<'_>) -> String {
    let count = answer.swings.all_cycles().count();
    answer.swings.amplitudes().map_or("none".to_owned(), |amplitudes| {
        let [largest, smallest] = amplitudes.map(|amplitude| rounded(amplitude.to_degrees(), 3));
        format!("{count}, with amplitudes from {largest}° to {smallest}°")
    })
}

/// β with what it should be, or why there is none.
pub(super) fn beta(answer: &Answer<'_>) -> String {
    match &answer.swings.beta {
        Ok(beta) => {
            let angles =
                if answer.swings.scale_is_fitted() { "; of the angles before they are scaled" } else { "" };
            format!("{}  (1 is the exact law{angles})", beta.factor)
        }
        Err(reason) => format!("none: {reason}"),
    }
}

pub(super) fn parameter_columns() -> Vec<Column> {
    let numbers = ["value", "±", "68 %", "95 %"].map(Column::numbers);
    [vec![Column::words("parameter")], numbers.to_vec(), vec![Column::words("unit")]].concat()
}

fn parameters(out: &mut dyn Write, answer: &Answer<'_>) -> io::Result<()> {
    let mut table = Table::new(parameter_columns());
    for parameter in &answer.swings.fit.parameters {
        table.row(out, cells(parameter, answer))?;
    }
    table.finish(out)
}

/// Name, value, uncertainty, both intervals, unit.
pub(super) fn cells(parameter: &Parameter, answer: &Answer<'_>) -> Vec<String> {
    let interval = |place: usize| {
        let ends = parameter.intervals[place].map(|end| to_the_digit(end, parameter.uncertainty));
        format!("{} … {}", ends[0], ends[1])
    };
    vec![
        name(parameter, answer),
        to_the_digit(parameter.value, parameter.uncertainty),
        rounded(parameter.uncertainty, 2),
        interval(0),
        interval(1),
        unit(parameter.unit),
    ]
}

/// As people write it.
pub(super) fn unit(unit: &str) -> String {
    if unit == "1" { String::new() } else { unit.replace("^2", "²") }
}

/// With the trace it belongs to, where there are several.
fn name(parameter: &Parameter, answer: &Answer<'_>) -> String {
    match parameter.trace.filter(|_| answer.measured.traces.len() > 1) {
        Some(trace) => format!("{}, {}", parameter.name, answer.measured.traces[trace].name()),
        None => parameter.name.to_owned(),
    }
}

/// A value to the last digit of its uncertainty.
fn to_the_digit(value: f64, uncertainty: f64) -> String {
    let text = with_uncertainty(value, uncertainty, "");
    text.split_once(' ').map_or_else(|| short(value, 8), |(value, _)| value.to_owned())
}

pub(super) fn trace_columns() -> Vec<Column> {
    let numbers = ["rows", "rms residual", "cycles", "largest", "smallest", "T₀ by cycles / s", "β"]
        .map(Column::numbers);
    [vec![Column::words("trace")], numbers.to_vec()].concat()
}

fn traces(out: &mut dyn Write, answer: &Answer<'_>) -> io::Result<()> {
    let mut table = Table::new(trace_columns());
    for row in trace_rows(answer) {
        table.row(out, row)?;
    }
    table.finish(out)
}

/// Each trace by itself: rows, what the fit leaves of it, its cycles, their T0 and β.
pub(super) fn trace_rows(answer: &Answer<'_>) -> Vec<Vec<String>> {
    let row = |trace: usize| {
        let measured = &answer.measured.traces[trace];
        let rms = in_unit(answer, answer.swings.fit.traces[trace].rms(), 3);
        let first = vec![measured.name().to_owned(), measured.len().to_string(), rms];
        let none = || std::array::from_fn(|_| "–".to_owned());
        let rest = answer.swings.cycles[trace].as_ref().map_or_else(|_| none(), of_cycles);
        [first, rest.to_vec()].concat()
    };
    (0..answer.measured.traces.len()).map(row).collect()
}

/// How many cycles, the largest and the smallest amplitude, T0 and β.
fn of_cycles(found: &Cycles) -> [String; 5] {
    let sizes = || found.cycles.iter().map(|cycle| cycle.amplitude.to_degrees());
    let size = |size: Option<f64>| size.map_or("–".to_owned(), |size| format!("{}°", rounded(size, 3)));
    let beta = found.beta.as_ref().map(|beta| beta.factor);
    [
        found.cycles.len().to_string(),
        size(sizes().reduce(f64::max)),
        size(sizes().reduce(f64::min)),
        with_uncertainty(found.t0, found.t0_uncertainty, ""),
        beta.map_or("–".to_owned(), |beta| beta.to_string()),
    ]
}

/// A difference of two values, in degrees for angles.
fn in_unit(answer: &Answer<'_>, difference: f64, digits: usize) -> String {
    match answer.measured.traces[0].seen() {
        Seen::Angle => format!("{}°", rounded(difference.to_degrees(), digits)),
        Seen::AngularVelocity => format!("{} rad/s", rounded(difference, digits)),
    }
}

pub(super) fn model_columns() -> Vec<Column> {
    let numbers = ["ΔAICc", "weight", "rms residual", "T₀ / s"].map(Column::numbers);
    [vec![Column::words("damping")], numbers.to_vec(), vec![Column::words("")]].concat()
}

fn models(out: &mut dyn Write, answer: &Answer<'_>, comparison: &Comparison) -> io::Result<()> {
    let mut table = Table::new(model_columns());
    for row in model_rows(answer, comparison) {
        table.row(out, row)?;
    }
    table.finish(out)?;
    writeln!(out, "{}", paragraph("", &counted_rows(answer, comparison), WIDTH))?;
    coefficients(out, comparison)
}

/// What Akaike's criterion was made with.
pub(super) fn counted_rows(answer: &Answer<'_>, comparison: &Comparison) -> String {
    format!(
        "{} rows count as {} independent ones.",
        answer.swings.fit.rows(),
        rounded(comparison.independent_rows, 3)
    )
}

/// The coefficients side by side, where several models are left.
fn coefficients(out: &mut dyn Write, comparison: &Comparison) -> io::Result<()> {
    if comparison.rivals().is_empty() {
        return Ok(());
    }
    writeln!(out)?;
    let titles = ["dry / (rad/s²)", "linear / (1/s)", "quadratic"].map(Column::numbers);
    let mut table = Table::new([vec![Column::words("damping")], titles.to_vec()].concat());
    for fit in comparison.weights().iter().zip(&comparison.fits).filter(|it| *it.0 > 0.0).map(|it| it.1) {
        let cell = |term: DampingTerm| {
            let parameter = fit.parameter(term.name());
            parameter.map_or("–".to_owned(), |it| with_uncertainty(it.value, it.uncertainty, ""))
        };
        table.row(out, [vec![fit.damping.to_string()], DampingTerm::ALL.map(cell).to_vec()].concat())?;
    }
    table.finish(out)
}

/// Damping, excess of information, weight, residual, T0, remark; the best first.
pub(super) fn model_rows(answer: &Answer<'_>, comparison: &Comparison) -> Vec<Vec<String>> {
    let mut order: Vec<usize> = (0..comparison.fits.len()).collect();
    order.sort_by(|&a, &b| comparison.excess_information[a].total_cmp(&comparison.excess_information[b]));
    let weights = comparison.weights();
    let row = |place: usize| {
        let fit = &comparison.fits[place];
        let rms = in_unit(answer, fit.rms, 4);
        vec![
            fit.damping.to_string(),
            format!("{:.1}", comparison.excess_information[place]),
            format!("{:.2}", weights[place]),
            rms,
            fit.small_angle_period().to_string(),
            remark(comparison, place),
        ]
    };
    order.into_iter().map(row).collect()
}

/// How a model stands, and which coefficients are negative.
fn remark(comparison: &Comparison, place: usize) -> String {
    let standing = match comparison.standing(place) {
        Standing::Preferred => "preferred",
        Standing::Tied => "tied",
        Standing::Possible => "possible",
        Standing::Negative => "not believed",
        Standing::FeedsEnergy => "feeds energy",
        Standing::Excluded => "",
    };
    let negative =
        comparison.fits[place].negative_terms().into_iter().map(|term| format!("{} < 0", term.name()));
    let words: Vec<String> =
        [standing.to_owned()].into_iter().filter(|word| !word.is_empty()).chain(negative).collect();
    words.join(", ")
}

fn list(out: &mut dyn Write, title: &str, items: &[String]) -> io::Result<()> {
    if items.is_empty() {
        return Ok(());
    }
    writeln!(out, "\n{title}")?;
    items.iter().try_for_each(|item| writeln!(out, "{}", paragraph("  - ", item, WIDTH)))
}
