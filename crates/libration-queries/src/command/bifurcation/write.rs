//! The points of a bifurcation diagram as table, JSON and CSV.

use super::{Diagram, DiagramSweep};
use crate::output::description::{self, Answers, descriptions};
use crate::output::field::{Field, Fields};
use crate::output::json;
use crate::output::table::{Column, Table, sheet};
use crate::output::{Form, csv, number};
use libration::chaos::{Points, SectionEnding};
use std::io::{self, Write};

/// One point: the sweep, the value of the parameter, time and state.
pub(crate) struct DiagramPoint {
    sweep: &'static str,
    value: f64,
    time: f64,
    state: Vec<f64>,
}

impl Diagram<'_> {
    /// Writes the result in the given form; the table lists the points only if requested.
    pub(super) fn write(&self, out: &mut dyn Write, form: Form, listed: bool) -> io::Result<()> {
        match form {
            Form::Json => self.write_json(out),
            Form::Csv => self.write_csv(out),
            Form::Table => self.write_table(out, listed),
        }
    }

    /// All points, with angles folded if requested.
    pub(crate) fn rows(&self) -> impl Iterator<Item = DiagramPoint> + '_ {
        let columns =
            self.sweeps.iter().flat_map(|sweep| sweep.columns.iter().map(move |column| (sweep.name, column)));
        columns
            .flat_map(|(sweep, column)| {
                column.section.points.iter().map(move |point| (sweep, column.value, point))
            })
            .map(|(sweep, value, point)| DiagramPoint {
                sweep,
                value,
                time: point.time,
                state: self.options.shown(&point.state, &self.angles),
            })
    }
    /// Returns `true` if each sweep has all values.
    pub(super) fn is_complete(&self) -> bool {
        self.sweeps.iter().all(|sweep: &DiagramSweep| sweep.columns.len() == self.parameter.values.len())
    }

    /// The first reason for a missing point; `None` if there are points.
    pub(super) fn without_points(&self) -> Option<SectionEnding> {
        let sections = || self.sweeps.iter().flat_map(|sweep| &sweep.columns).map(|column| &column.section);
        sections()
            .find_map(|section| section.stopped)
            .filter(|_| sections().all(|section| section.points.is_empty()))
    }

    fn write_json(&self, out: &mut dyn Write) -> io::Result<()> {
        let fields = of_row();
        let points = self.rows().map(|row| fields.record(&row));
        json::document_with_list(out, of_diagram().record(self), "points", points)
    }

    fn write_csv(&self, out: &mut dyn Write) -> io::Result<()> {
        let fields = of_row();
        let names = fields.csv_names_for(&self.parameter.name);
        csv::line(out, &[names, self.model.state_names()].concat())?;
        for row in self.rows() {
            let state = row.state.iter().map(|&value| csv::number(value));
            csv::line(out, &fields.csv_cells(&row).into_iter().chain(state).collect::<Vec<_>>())?;
        }
        Ok(())
    }

    fn write_table(&self, out: &mut dyn Write, listed: bool) -> io::Result<()> {
        let mut lines = of_diagram().lines(self);
        lines.extend(self.stopped().map(|text| ("stopped", text)));
        sheet(out, &lines)?;
        if !listed {
            return Ok(());
        }
        writeln!(out)?;
        let fields = of_row();
        let state = self.model.state_names().into_iter().map(Column::numbers);
        let columns = fields.columns_for(&self.parameter.name);
        let mut table = Table::new(columns.into_iter().chain(state).collect());
        for row in self.rows() {
            let state = row.state.iter().map(|&value| number::short(value, 10));
            table.row(out, fields.cells(&row).into_iter().chain(state).collect())?;
        }
        table.finish(out)
    }

    fn points_text(&self) -> String {
        let Points { recorded, skipped } = self.points;
        format!("{recorded} for each value, {}, after discarding {skipped} as transient", self.section)
    }

    /// The values at which the motion ended early, with the reasons.
    fn stopped(&self) -> impl Iterator<Item = String> + '_ {
        let columns = self.sweeps.iter().flat_map(|sweep| &sweep.columns);
        columns.filter_map(|column| {
            let ending = column.section.stopped?;
            Some(format!("{} = {}: {ending}", self.parameter.name, number::short(column.value, 10)))
        })
    }
}

fn of_diagram<'a>() -> Fields<Diagram<'a>> {
    type Of<'a> = Field<Diagram<'a>>;
    Fields::from([
        Of::value("system", "", "key of the system, null where its equations were typed", |diagram| {
            diagram.model.key().into()
        })
        .line_of("system", |diagram| diagram.model.title().to_owned()),
        Of::value("equation", "", "equations of motion as they were read", |diagram| {
            diagram.model.equation().to_string().into()
        })
        .line_of("equation", |diagram| diagram.model.equation().to_string()),
        Of::value("parameter", "", "name of the parameter that is varied", |diagram| {
            diagram.parameter.name.as_str().into()
        }),
        Of::value("section", "", "condition at which points are recorded, in words", |diagram| {
            diagram.section.as_str().into()
        })
        .line_of("points", Diagram::points_text),
        Of::value("skipped", "1", "number of points discarded as transient, for each value", |diagram| {
            diagram.points.skipped.into()
        }),
        Of::value("state[]", "", "names of the state variables", |diagram| {
            json::list(diagram.model.state_names())
        }),
        Of::value("complete", "", "true if each sweep has all values", |diagram| {
            diagram.is_complete().into()
        }),
        Of::value("stopped[]", "", "values for which the motion stopped early, and why", |diagram| {
            json::list(diagram.stopped())
        }),
    ])
}

fn of_row() -> Fields<DiagramPoint> {
    type Of = Field<DiagramPoint>;
    Fields::from([
        Of::value("sweep", "", "order of the values: up, down or same start", |point| point.sweep.into())
            .numeral("sweep", |point| point.sweep.to_owned()),
        Of::number("value", "", "value of the parameter, in its unit", |point| point.value)
            .in_csv_as("KEY")
            .short("KEY", 10),
        Of::number("time_s", "s", "time of the point", |point| point.time).short("time", 10),
        Of::value("state[]", "", "state there, in the order of the names", |point| {
            json::numbers(&point.state)
        }),
    ])
}

pub(crate) fn answers() -> Vec<Answers> {
    const NUMBER: description::DescriptionRow = ("NAME", "", "state variable of this name");
    let json = [of_diagram().described(""), of_row().described("points[].")];
    let csv = [of_row().described_in_csv(), descriptions("", &[NUMBER])];
    vec![Answers { command: "bifurcation", option: "", json: json.concat(), csv: csv.concat() }]
}
