//! The backbone as table, JSON and CSV.

use super::Answer;
use crate::output::csv;
use crate::output::json::{self, Record};
use crate::output::number::{at_most, exact, rounded, short};
use crate::output::table::{Column, Table, sheet, write_text};
use libration::comparison::{BackbonePoint, ExactValue, Radius, SeriesFrequency};
use libration::perturbation::Certainty;
use serde_json::Value;
use std::io::{self, Write};

pub(super) fn json(out: &mut dyn Write, answer: &Answer) -> io::Result<()> {
    let no_series = answer.curve.no_series().map(ToString::to_string);
    let why = no_series.clone().unwrap_or_default();
    let head = Record::new()
        .with("oscillator", answer.asked.key)
        .with("equation", answer.asked.equation.to_string())
        .with("parameters", Value::from_iter(answer.asked.values.iter().cloned()))
        .with("order", answer.order)
        .number("centre", answer.curve.centre())
        .with("centre_is_equilibrium", answer.curve.has_equilibrium())
        .number_or("omega0", answer.curve.omega0(), &why)
        .with("no_series", no_series);
    let head = match answer.curve.radius() {
        Some(radius) => {
            head.number("series_radius", radius.value()).with("series_radius_is", certainty(&radius))
        }
        None => head,
    };
    let head = if answer.interruption().is_some() { head.with("interrupted", true) } else { head };
    json::document_with_list(out, head, "points", answer.points.iter().map(record))
}

fn certainty(radius: &Radius) -> &'static str {
    match radius {
        Radius::Known(_) => "proven",
        Radius::Estimated(_) => "estimated",
    }
}

fn record(point: &BackbonePoint) -> Record {
    let record = Record::new().number("amplitude", point.amplitude);
    let record = match &point.orbit {
        Ok(orbit) => record
            .number("frequency", orbit.frequency)
            .number("uncertainty", orbit.uncertainty)
            .number("other_turning_point", orbit.other_side)
            .with("encloses", orbit.encloses.map(json::number)),
        Err(reason) => record.with("frequency", Value::Null).with("no_orbit", reason.to_string()),
    };
    let record = match &point.series {
        Some(SeriesFrequency { frequency, remainder }) => {
            let record = record.number("series", *frequency);
            let size = json::number(remainder.size);
            record.with("series_remainder", size).with("series_remainder_is", word(remainder.certainty))
        }
        None => record.with("series", Value::Null),
    };
    let record = match encloses(point) {
        Some(place) => record.note(&enclosing(place)),
        None => record,
    };
    match &point.exact {
        Some(Ok(exact)) => record.number("exact", exact.value).number("exact_uncertainty", exact.uncertainty),
        Some(Err(reason)) => record.number_or("exact", None, &reason.to_string()),
        None => record.with("exact", Value::Null),
    }
}

/// Another equilibrium that the orbit goes around.
fn encloses(point: &BackbonePoint) -> Option<f64> {
    point.orbit.as_ref().ok()?.encloses
}

fn enclosing(place: f64) -> String {
    format!(
        "the orbit goes around another equilibrium too, at {}, and is not of the family that the series is for",
        short(place, 6)
    )
}

fn word(certainty: Certainty) -> &'static str {
    match certainty {
        Certainty::Proven => "proven",
        Certainty::Estimated => "estimated",
    }
}

pub(super) fn csv(out: &mut dyn Write, answer: &Answer) -> io::Result<()> {
    csv::line(
        out,
        &[
            "amplitude",
            "frequency",
            "uncertainty",
            "other_turning_point",
            "series",
            "exact",
            "exact_uncertainty",
        ],
    )?;
    for point in &answer.points {
        let orbit = point.orbit.as_ref().ok();
        let cells = [
            Some(point.amplitude),
            orbit.map(|it| it.frequency),
            orbit.map(|it| it.uncertainty),
            orbit.map(|it| it.other_side),
            point.series.as_ref().map(|it| it.frequency),
            known(point).map(|it| it.value),
            known(point).map(|it| it.uncertainty),
        ];
        csv::line(out, &cells.map(|cell| cell.map_or_else(String::new, exact)))?;
    }
    Ok(())
}

/// What is known of the whole, the points if they are to be listed, and why some are missing.
pub(super) fn table(out: &mut dyn Write, answer: &Answer, listed: bool) -> io::Result<()> {
    sheet(out, &head(answer))?;
    if listed {
        writeln!(out)?;
        points(out, answer)?;
    }
    write_enclosing(out, answer)?;
    write_reasons(out, answer)
}

fn points(out: &mut dyn Write, answer: &Answer) -> io::Result<()> {
    let pendulum = answer.points.iter().any(|point| known(point).is_some());
    let mut table = Table::new(columns(answer, pendulum));
    for point in &answer.points {
        table.row(out, cells(answer, point, pendulum))?;
    }
    table.finish(out)
}

/// From where on orbits are of another family.
fn write_enclosing(out: &mut dyn Write, answer: &Answer) -> io::Result<()> {
    let enclosing: Vec<(&BackbonePoint, f64)> =
        answer.points.iter().filter_map(|point| Some((point, encloses(point)?))).collect();
    let Some((first, place)) = enclosing.first() else { return Ok(()) };
    let told = format!(
        "At {} of the amplitudes, the first at {}, the orbit goes around another equilibrium too, at {}, and is not of the family \
         that the series is for.",
        enclosing.len(),
        amplitude_text(answer, first.amplitude, 10),
        amplitude_text(answer, *place, 6)
    );
    writeln!(out)?;
    write_text(out, "", &told)
}

fn head(answer: &Answer) -> Vec<(&'static str, String)> {
    let mut lines =
        vec![("oscillator", answer.asked.title.clone()), ("equation", answer.asked.equation.to_string())];
    let shown = |amplitude: f64| amplitude_text(answer, amplitude, 6);
    let centre = answer.curve.centre();
    if !answer.curve.has_equilibrium() {
        let told = "none found to which the force drives back: amplitudes count from 0";
        lines.push(("equilibrium", told.to_owned()));
    } else if centre != 0.0 {
        lines.push(("equilibrium", format!("{}, which amplitudes count from", rounded(centre, 13))));
    }
    lines.extend(answer.curve.omega0().map(|omega0| ("ω0", rounded(omega0, 13))));
    lines.push(match (answer.curve.no_series(), answer.curve.radius()) {
        (Some(reason), _) => ("series", format!("none: {reason}")),
        (None, None) => ("series", format!("to order {}", answer.order)),
        (None, Some(radius)) if radius.value().is_infinite() => {
            ("series", format!("to order {}, perhaps convergent everywhere (estimated)", answer.order))
        }
        (None, Some(radius)) => {
            let (about, word) = match radius {
                Radius::Known(_) => ("", "proven"),
                Radius::Estimated(_) => ("about ", "estimated"),
            };
            let end = shown(radius.value());
            ("series", format!("to order {}, convergent below {about}{end} ({word})", answer.order))
        }
    });
    lines
}

fn amplitude_text(answer: &Answer, amplitude: f64, digits: usize) -> String {
    if answer.is_angle() {
        format!("{}°", short(amplitude.to_degrees(), digits))
    } else {
        short(amplitude, digits)
    }
}

fn columns(answer: &Answer, pendulum: bool) -> Vec<Column> {
    let mut columns =
        vec![Column::numbers("amplitude"), Column::numbers("Ω by orbit"), Column::numbers("uncertain by")];
    if answer.curve.no_series().is_none() {
        columns.push(Column::numbers("Ω by series"));
        columns.push(Column::numbers("its error"));
    }
    if pendulum {
        columns.push(Column::numbers("Ω exactly"));
    }
    columns
}

fn cells(answer: &Answer, point: &BackbonePoint, pendulum: bool) -> Vec<String> {
    let none = || "none".to_owned();
    let orbit = point.orbit.as_ref().ok();
    let mut cells = vec![
        amplitude_text(answer, point.amplitude, 10),
        orbit.map_or_else(none, |it| rounded(it.frequency, 15)),
        orbit.map_or_else(String::new, |it| at_most(it.uncertainty)),
    ];
    if answer.curve.no_series().is_none() {
        cells.push(point.series.as_ref().map_or_else(none, |it| rounded(it.frequency, 15)));
        cells.push(error(point));
    }
    if pendulum {
        cells.push(known(point).map_or_else(none, |it| rounded(it.value, 15)));
    }
    cells
}

fn known(point: &BackbonePoint) -> Option<ExactValue> {
    point.exact.as_ref().and_then(|exact| exact.as_ref().ok().copied())
}

/// How far the series is from the exact value, or else from the orbit.
fn error(point: &BackbonePoint) -> String {
    let orbit = point.orbit.as_ref().ok();
    let best = known(point).map(|it| (it.value, it.uncertainty));
    let best = best.or_else(|| orbit.map(|it| (it.frequency, it.uncertainty)));
    match (&point.series, best) {
        (Some(series), Some((value, uncertainty))) if (series.frequency - value).abs() <= uncertainty => {
            format!("below {}", at_most(uncertainty))
        }
        (Some(series), Some((value, _))) => rounded(series.frequency - value, 2),
        _ => "unknown".to_owned(),
    }
}

/// Why there are no orbits, each reason once.
fn write_reasons(out: &mut dyn Write, answer: &Answer) -> io::Result<()> {
    let missing: Vec<&BackbonePoint> = answer.points.iter().filter(|point| point.orbit.is_err()).collect();
    let Some(first) = missing.first() else { return Ok(()) };
    let reason = first.orbit.as_ref().err().map(ToString::to_string).unwrap_or_default();
    writeln!(out)?;
    let first = amplitude_text(answer, first.amplitude, 10);
    let text = format!("No orbit at {} of the amplitudes, the first at {first}: {reason}", missing.len());
    write_text(out, "", &text)
}
