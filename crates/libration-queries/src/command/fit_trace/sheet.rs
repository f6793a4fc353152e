//! The result as a sheet with tables, for people at a terminal.

use super::answer::FitTraceResult;
use super::fields::{self, DampingModel};
use super::units::in_unit;
use crate::output;
use crate::output::number::{self, rounded};
use crate::output::table::{paragraph, sheet};
use libration::internals::InOrder;
use libration::quantity::STANDARD_GRAVITY;
use libration_lab::fit::swings::{FittedPendulum, Warning};
use libration_lab::fit::trace::Comparison;
use libration_lab::fit::{Quality, alternatives};
use std::io::{self, Write};

/// Letters in a line.
const WIDTH: usize = 100;

/// Writes all results.
pub(super) fn write(out: &mut dyn Write, answer: &FitTraceResult<'_>) -> io::Result<()> {
    sheet(out, &lines(answer))?;
    writeln!(out)?;
    fields::shown_parameters().write_table(out, &fields::parameters(answer))?;
    if answer.measured.traces.len() > 1 {
        writeln!(out)?;
        fields::of_trace().write_table(out, &fields::traces(answer))?;
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

fn lines(answer: &FitTraceResult<'_>) -> Vec<(&'static str, String)> {
    let period = answer.swings.small_angle_period();
    let refuted = answer.swings.warnings.iter().find(|warning| matches!(warning, Warning::ModelRefuted(_)));
    let mut lines: Vec<_> = refuted.map(|warning| ("refuted", warning.to_string())).into_iter().collect();
    lines.extend([
        ("data", data(answer)),
        ("model", model(answer)),
        ("T₀", number::quantity(period, "s")),
        gravity_or_length(answer),
    ]);
    lines.extend(expanded(answer).map(|text| ("expanded", text)));
    lines.extend(answer.normal.map(|normal| normal.line()));
    lines.extend(answer.swings.quality().map(|factor| ("Q", quality(factor))));
    lines.extend([("rms residual", residual(answer)), ("cycles", cycles(answer)), ("β", beta(answer))]);
    lines
}

/// Q, and the amplitude at which it holds.
pub(super) fn quality(quality: Quality) -> String {
    let at = quality.amplitude.map_or("ω0/c, at every amplitude".to_owned(), |amplitude| {
        format!("2πE/ΔE at {}°", rounded(amplitude.to_degrees(), 3))
    });
    format!("{}  ({at})", number::quantity(quality.factor, ""))
}

/// The expanded uncertainty of gravity, if there is one.
pub(super) fn expanded(answer: &FitTraceResult<'_>) -> Option<String> {
    match &answer.swings.pendulum {
        FittedPendulum::Gravity { budget, .. } => Some(output::combined::expanded(&budget.combined)),
        FittedPendulum::Length(_) => None,
    }
}

fn data(answer: &FitTraceResult<'_>) -> String {
    let traces = &answer.measured.traces;
    let rows = answer.swings.fit.rows();
    let seconds =
        |trace: &libration_lab::measurement::Trace| trace.times()[trace.len() - 1] - trace.times()[0];
    match &traces[..] {
        [only] => {
            format!("{rows} rows over {} s from {}", rounded(seconds(only), 4), answer.measured.names())
        }
        many => format!("{rows} rows in {} traces from {}", many.len(), answer.measured.names()),
    }
}

/// The damping, and the way in which it was chosen.
pub(super) fn model(answer: &FitTraceResult<'_>) -> String {
    let chosen = answer.swings.fit.damping.to_string();
    let rivals = answer.swings.rivals();
    match (&answer.swings.comparison, rivals.len()) {
        (None, _) => format!("{chosen} (as requested)"),
        (Some(_), 0) => format!("{chosen} (preferred by the data)"),
        (Some(_), _) => {
            format!("{chosen} (the data cannot exclude {})", alternatives(&rivals))
        }
    }
}

/// Gravity if the length is known, else the length.
pub(super) fn gravity_or_length(answer: &FitTraceResult<'_>) -> (&'static str, String) {
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

/// The residual, in degrees for angles.
pub(super) fn residual(answer: &FitTraceResult<'_>) -> String {
    let rms = in_unit(answer, answer.swings.fit.rms, 3);
    answer.swings.fit.chi2_per_dof.map_or(rms.clone(), |chi2| format!("{rms}, χ²/dof {}", rounded(chi2, 3)))
}

fn cycles(answer: &FitTraceResult<'_>) -> String {
    let count = answer.swings.all_cycles().count();
    answer.swings.amplitudes().map_or("none".to_owned(), |amplitudes| {
        let [largest, smallest] = amplitudes.map(|amplitude| rounded(amplitude.to_degrees(), 3));
        format!("{count}, with amplitudes from {largest}° to {smallest}°")
    })
}

/// β with its expected value, or the reason why there is none.
pub(super) fn beta(answer: &FitTraceResult<'_>) -> String {
    match &answer.swings.beta {
        Ok(beta) => {
            let angles =
                if answer.swings.scale_is_fitted() { "; of the angles before they are scaled" } else { "" };
            format!("{}  (1 is the exact law{angles})", beta.factor)
        }
        Err(reason) => format!("none: {reason}"),
    }
}

fn models(out: &mut dyn Write, answer: &FitTraceResult<'_>, comparison: &Comparison) -> io::Result<()> {
    fields::shown_models().write_table(out, &best_first(answer, comparison))?;
    writeln!(out, "{}", paragraph("", &counted_rows(answer, comparison), WIDTH))?;
    if comparison.rivals().is_empty() {
        return Ok(());
    }
    writeln!(out)?;
    let left = fields::models(answer, comparison).into_iter().filter(DampingModel::is_left);
    fields::coefficients().write_table(out, &left.collect::<Vec<_>>())
}

pub(super) fn best_first<'a>(
    answer: &'a FitTraceResult<'a>,
    comparison: &'a Comparison,
) -> Vec<DampingModel<'a>> {
    let mut models = fields::models(answer, comparison);
    models.put_in_order(|a, b| a.excess().total_cmp(&b.excess()));
    models
}

/// The number of independent rows for Akaike's criterion.
pub(super) fn counted_rows(answer: &FitTraceResult<'_>, comparison: &Comparison) -> String {
    format!(
        "{} rows count as {} independent ones.",
        answer.swings.fit.rows(),
        rounded(comparison.independent_rows, 3)
    )
}

fn list(out: &mut dyn Write, title: &str, items: &[String]) -> io::Result<()> {
    if items.is_empty() {
        return Ok(());
    }
    writeln!(out, "\n{title}")?;
    items.iter().try_for_each(|item| writeln!(out, "{}", paragraph("  - ", item, WIDTH)))
}
