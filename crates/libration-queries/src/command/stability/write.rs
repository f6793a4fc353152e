//! A chart as a sheet with its curves and words, JSON and CSV.

use super::StabilityResult;
use super::fields::{AtEnd, NumberedBoundary, of_answer, of_curve, of_row};
use crate::output::number::short;
use crate::output::table::{Table, paragraph, write_text};
use crate::output::{Form, csv, json};
use libration::continuation::{BoundaryPart, Ending};
use std::io::{self, Write};

/// Width at which lines are broken, in columns.
const COLUMNS: usize = 100;

impl StabilityResult {
    /// Writes the result in the given form; the table lists the ends of the curves only if requested.
    pub(super) fn write(&self, out: &mut dyn Write, form: Form, listed: bool) -> io::Result<()> {
        match form {
            Form::Json => {
                let fields = of_curve();
                let curves = self.numbered().map(|curve| fields.record(&curve));
                json::document_with_list(out, of_answer().record(self), "curves", curves)
            }
            Form::Csv => self.write_csv(out),
            Form::Table => self.write_sheet(out, listed),
        }
    }

    fn write_csv(&self, out: &mut dyn Write) -> io::Result<()> {
        csv::line(out, &of_row().csv_names())?;
        for curve in self.numbered() {
            let fields = of_row();
            for point in curve.points().chain(curve.cusps()) {
                csv::line(out, &fields.csv_cells(&point))?;
            }
        }
        Ok(())
    }

    fn write_sheet(&self, out: &mut dyn Write, listed: bool) -> io::Result<()> {
        for (name, text) in of_answer().lines(self) {
            writeln!(out, "{}", paragraph(&format!("{name:<10}"), &text, COLUMNS))?;
        }
        for curve in self.numbered() {
            let name = format!("curve {:<4}", curve.number);
            writeln!(out, "{}", paragraph(&name, &summary(&curve), COLUMNS))?;
        }
        if listed && !self.chart.curves.is_empty() {
            writeln!(out)?;
            let mut table = Table::new(of_row().columns());
            for curve in self.numbered() {
                let fields = of_row();
                for point in curve.ends_and_cusps() {
                    table.row(out, fields.cells(&point))?;
                }
            }
            table.finish(out)?;
        }
        writeln!(out)?;
        for end in self.rest_at_ends() {
            write_text(out, "", &self.told_at(&end))?;
        }
        if self.chart.curves.is_empty() {
            write_text(out, "", "No stability boundary and no singular point was found on this map.")?;
        }
        for text in self.told_of_grid() {
            write_text(out, "", &text)?;
        }
        Ok(())
    }

    /// Statements about the stability of the equilibrium that the grid shows beyond the curves.
    fn told_of_grid(&self) -> Vec<String> {
        let Some(rest) = self.chart.rest.as_ref().filter(|_| !self.chart.interrupted) else { return vec![] };
        let [first, second] = &self.parameters;
        let [columns, rows] = [0, 1].map(|which| rest.values[which].len());
        let stabilities = || rest.stable.iter().flatten().flatten();
        let stable =
            match (stabilities().any(|stability| *stability), stabilities().any(|stability| !*stability)) {
                (true, false) => "stable at all of them",
                (false, true) => "unstable at all of them",
                (true, true) => "stable at some of them and unstable at others",
                (false, false) => "followed at none of them",
            };
        let mut told = vec![format!(
            "Tested at {columns} × {rows} points of the map, the equilibrium is {stable}; tongues that lie between the points may be missing."
        )];
        if let Some([x, y]) = rest.unresolved.first() {
            let others = match rest.unresolved.len() - 1 {
                0 => String::new(),
                1 => " and at one other place".to_owned(),
                more => format!(" and at {more} other places"),
            };
            told.push(format!(
                "Next to {first} = {}, {second} = {}{others} the equilibrium is stable at one point and unstable at the next, but no boundary could be followed between them: a smaller map there may show it.",
                short(*x, 6),
                short(*y, 6)
            ));
        }
        told
    }

    /// A statement of the ranges in which the equilibrium is stable at an end of the first parameter.
    fn told_at(&self, AtEnd { value, ranges }: &AtEnd) -> String {
        let [first, second] = &self.parameters;
        let range =
            |[from, to]: &[f64; 2]| format!("for {second} from {} to {}", short(*from, 6), short(*to, 6));
        let where_to = match &ranges[..] {
            [] => "nowhere on this map".to_owned(),
            some => some.iter().map(range).collect::<Vec<_>>().join(" and "),
        };
        format!("At {first} = {} the equilibrium is stable {where_to}.", short(*value, 6))
    }
}

/// The kind of a curve, and its ends.
fn summary(curve: &NumberedBoundary<'_>) -> String {
    let (answer, points) = (curve.answer, &curve.curve.points);
    let [before, behind] = curve.curve.endings;
    let kind = curve.curve.kind;
    let kind = match (curve.curve.at_rest, curve.curve.stability_boundary()) {
        (true, BoundaryPart::Whole) => format!("stability boundary of the equilibrium: {kind}"),
        (true, BoundaryPart::Part) => format!("equilibrium, in part a stability boundary: {kind}"),
        (true, BoundaryPart::None) => format!("equilibrium, unstable on both sides: {kind}"),
        (false, BoundaryPart::None) => format!("{kind} of unstable driven motions"),
        (false, _) => format!("{kind} of driven motions"),
    };
    let text_of = |point: Option<&_>| point.map_or_else(String::new, |point| answer.values_text(point));
    let ends = match behind {
        Ending::Closed => "closed".to_owned(),
        _ => format!(
            "from {}{} to {}{}",
            text_of(points.first()),
            said(before),
            text_of(points.last()),
            said(behind)
        ),
    };
    let cusps: Vec<String> = curve.curve.cusps.iter().map(|cusp| answer.values_text(cusp)).collect();
    let through = match cusps.len() {
        0 => String::new(),
        1 => format!("; through a cusp at {}", cusps[0]),
        _ => format!("; through cusps at {}", cusps.join(" and at ")),
    };
    format!("{kind}, {} points, {ends}{through}", points.len())
}

/// The reason why a curve ends, unless it ends at the edge of the map.
fn said(ending: Ending) -> &'static str {
    match ending {
        Ending::RangeEnd | Ending::Closed => "",
        Ending::BranchPoint => " (it ends in another curve)",
        Ending::Rest | Ending::SlowDrive | Ending::InfinitePeriod | Ending::Sensitive | Ending::Lost => {
            " (it could not be continued)"
        }
        Ending::PointLimit => " (the largest number of points)",
        Ending::Unbounded => " (grows without bound)",
        Ending::Interrupted => " (interrupted)",
    }
}
