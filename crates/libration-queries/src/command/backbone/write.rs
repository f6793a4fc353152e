//! The backbone as table, JSON and CSV.

use super::BackboneResult;
use super::fields::{self, EXACT, ORBIT, Point, SERIES};
use crate::output::json;
use crate::output::number::rounded;
use crate::output::table::{sheet, write_text};
use libration::comparison::Radius;
use std::io::{self, Write};

pub(super) fn json(out: &mut dyn Write, answer: &BackboneResult) -> io::Result<()> {
    let fields = fields::of_point();
    let points = answer.listed().map(|point| fields.record(&point));
    json::document_with_list(out, fields::of_backbone().record(answer), "points", points)
}

pub(super) fn csv(out: &mut dyn Write, answer: &BackboneResult) -> io::Result<()> {
    fields::of_point().write_csv(out, &answer.listed().collect::<Vec<_>>())
}

/// Writes the properties of the backbone, the points if they are to be listed, and the reasons for missing ones.
pub(super) fn table(out: &mut dyn Write, answer: &BackboneResult, listed: bool) -> io::Result<()> {
    sheet(out, &head(answer))?;
    let points: Vec<Point<'_>> = answer.listed().collect();
    if listed {
        writeln!(out)?;
        let mut columns = ORBIT.to_vec();
        columns.extend(SERIES.iter().filter(|_| answer.curve.no_series().is_none()));
        columns.extend(points.iter().any(|point| point.exact().is_some()).then_some(EXACT));
        fields::of_point().for_table(&columns).write_table(out, &points)?;
    }
    write_enclosing(out, answer, &points)?;
    write_reasons(out, answer)
}

/// Writes the amplitude above which orbits belong to another family.
fn write_enclosing(out: &mut dyn Write, answer: &BackboneResult, points: &[Point<'_>]) -> io::Result<()> {
    let enclosing: Vec<(&Point<'_>, f64)> =
        points.iter().filter_map(|point| Some((point, point.encloses()?))).collect();
    let Some((first, equilibrium)) = enclosing.first() else { return Ok(()) };
    let told = format!(
        "At {} of the amplitudes, the first at {}, the orbit also encloses the equilibrium at {}, so that the series does not apply.",
        enclosing.len(),
        answer.amplitude_text(first.point.amplitude, 10),
        answer.amplitude_text(*equilibrium, 6)
    );
    writeln!(out)?;
    write_text(out, "", &told)
}

fn head(answer: &BackboneResult) -> Vec<(&'static str, String)> {
    let mut lines = fields::of_backbone().lines(answer);
    let centre = answer.curve.centre();
    if !answer.curve.has_equilibrium() {
        let told = "no stable one found: amplitudes are measured from 0";
        lines.push(("equilibrium", told.to_owned()));
    } else if centre != 0.0 {
        lines.push(("equilibrium", format!("{} (amplitudes are measured from it)", rounded(centre, 13))));
    }
    lines.extend(answer.curve.omega0().map(|omega0| ("ω0", rounded(omega0, 13))));
    lines.push(("series", series(answer)));
    lines
}

fn series(answer: &BackboneResult) -> String {
    let order = answer.order;
    match (answer.curve.no_series(), answer.curve.radius()) {
        (Some(reason), _) => format!("none: {reason}"),
        (None, None) => format!("to order {order}"),
        (None, Some(radius)) if radius.value().is_infinite() => {
            format!("to order {order}, perhaps convergent everywhere (estimated)")
        }
        (None, Some(radius)) => {
            let (about, word) = match radius {
                Radius::Known(_) => ("", "proven"),
                Radius::Estimated(_) => ("about ", "estimated"),
            };
            let end = answer.amplitude_text(radius.value(), 6);
            format!("to order {order}, convergent below {about}{end} ({word})")
        }
    }
}

/// Writes the reasons why orbits are missing, each once.
fn write_reasons(out: &mut dyn Write, answer: &BackboneResult) -> io::Result<()> {
    let mut missing = answer.points.iter().filter_map(|point| Some((point, point.orbit.as_ref().err()?)));
    let count = missing.clone().count();
    let Some((first, reason)) = missing.next() else { return Ok(()) };
    writeln!(out)?;
    let first = answer.amplitude_text(first.amplitude, 10);
    let text = format!("No orbit at {count} of the amplitudes, the first at {first}: {reason}");
    write_text(out, "", &text)
}
