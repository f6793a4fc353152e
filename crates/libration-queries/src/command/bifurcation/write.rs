//! The points of a bifurcation diagram as table, JSON and CSV.

use super::{Diagram, DiagramSweep};
use crate::command::section::point_errors::{self, PointErrors};
use crate::output::description::{self, Answers, descriptions};
use crate::output::field::{Field, Fields};
use crate::output::json;
use crate::output::table::{Column, Table, sheet};
use crate::output::{Form, csv, number};
use libration::chaos::{PoincareSection, Points, SectionEnding};
use std::io::{self, Write};

/// One point: the sweep, the value of the parameter, time and state.
pub(crate) struct DiagramPoint<'a> {
    sweep: &'static str,
    value: f64,
    time: f64,
    state: Vec<f64>,
    errors: PointErrors<'a>,
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
    pub(crate) fn rows(&self) -> impl Iterator<Item = DiagramPoint<'_>> + '_ {
        let columns =
            self.sweeps.iter().flat_map(|sweep| sweep.columns.iter().map(move |column| (sweep.name, column)));
        columns
            .flat_map(|(sweep, column)| {
                column
                    .section
                    .points
                    .iter()
                    .enumerate()
                    .map(move |(index, point)| (sweep, column, index, point))
            })
            .map(|(sweep, column, index, point)| DiagramPoint {
                sweep,
                value: column.value,
                time: point.time,
                state: self.options.shown(&point.state, &self.angles),
                errors: PointErrors::of(&column.section, index),
            })
    }

    /// Returns `true` if errors were estimated.
    fn has_errors(&self) -> bool {
        self.sections().any(|section| section.errors.is_some())
    }

    /// The number of motions that are not determined throughout, in words; `None` if all are.
    fn determined_text(&self) -> Option<String> {
        let is_lost = |section: &&PoincareSection| {
            section.errors.as_ref().is_some_and(|errors| errors.determined_until.is_some())
        };
        let lost = self.sections().filter(is_lost).count();
        (lost > 0).then(|| {
            let all = self.sections().count();
            format!(
                "{lost} of {all} motions are not determined in double precision to their end: points with three digits are those of nearby motions"
            )
        })
    }

    /// Returns `true` if each sweep has all values.
    pub(super) fn is_complete(&self) -> bool {
        self.sweeps.iter().all(|sweep: &DiagramSweep| sweep.columns.len() == self.parameter.values.len())
    }

    /// The first reason for a missing point; `None` if there are points.
    pub(super) fn without_points(&self) -> Option<SectionEnding> {
        let stopped = self.sections().find_map(|section| section.stopped);
        stopped.filter(|_| self.sections().all(|section| section.points.is_empty()))
    }

    fn sections(&self) -> impl Iterator<Item = &PoincareSection> {
        self.sweeps.iter().flat_map(|sweep| &sweep.columns).map(|column| &column.section)
    }

    fn write_json(&self, out: &mut dyn Write) -> io::Result<()> {
        let fields = of_row();
        let points = self.rows().map(|row| fields.record(&row));
        json::document_with_list(out, of_diagram().record(self), "points", points)
    }

    fn write_csv(&self, out: &mut dyn Write) -> io::Result<()> {
        let fields = of_row();
        let mut names = [fields.csv_names_for(&self.parameter.name), self.model.state_names()].concat();
        if self.has_errors() {
            names.extend(point_errors::csv_names(self.model));
        }
        csv::line(out, &names)?;
        for row in self.rows() {
            let numbers = row.errors.csv_cells(&row.state);
            csv::line(out, &fields.csv_cells(&row).into_iter().chain(numbers).collect::<Vec<_>>())?;
        }
        Ok(())
    }

    fn write_table(&self, out: &mut dyn Write, listed: bool) -> io::Result<()> {
        let mut lines = of_diagram().lines(self);
        lines.extend(self.determined_text().map(|text| ("determined", text)));
        lines.extend(self.stopped().map(|text| ("stopped", text)));
        sheet(out, &lines)?;
        if !listed {
            return Ok(());
        }
        writeln!(out)?;
        let fields = of_row();
        let numbers = ["time".to_owned()].into_iter().chain(self.model.state_names()).map(Column::numbers);
        let columns = fields.columns_for(&self.parameter.name);
        let mut table = Table::new(columns.into_iter().chain(numbers).collect());
        for row in self.rows() {
            let numbers = row.errors.cells(row.time, &row.state);
            table.row(out, fields.cells(&row).into_iter().chain(numbers).collect())?;
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
        Of::value("determined_until_s[]", "s", point_errors::DETERMINED, |diagram| {
            point_errors::determined_until(diagram.sections())
        }),
        Of::value("complete", "", "true if each sweep has all values", |diagram| {
            diagram.is_complete().into()
        }),
        Of::value("stopped[]", "", "values for which the motion stopped early, and why", |diagram| {
            json::list(diagram.stopped())
        }),
    ])
}

fn of_row<'a>() -> Fields<DiagramPoint<'a>> {
    type Of<'a> = Field<DiagramPoint<'a>>;
    Fields::from([
        Of::value("sweep", "", "order of the values: up, down or same start", |point| point.sweep.into())
            .numeral("sweep", |point| point.sweep.to_owned()),
        Of::number("value", "", "value of the parameter, in its unit", |point| point.value)
            .in_csv_as("KEY")
            .short("KEY", 10),
        Of::number("time_s", "s", "time of the point", |point| point.time),
        Of::value("state[]", "", "state there, in the order of the names", |point| {
            json::numbers(&point.state)
        }),
        Of::present_value("time_error_s", "s", point_errors::MEANING, |point| point.errors.of_time())
            .only_json(),
        Of::present_value("error[]", "", point_errors::MEANING, |point| point.errors.of_state(&point.state)),
    ])
}

pub(crate) fn answers() -> Vec<Answers> {
    const NUMBER: description::DescriptionRow = ("NAME", "", "state variable of this name");
    let json = [of_diagram().described(""), of_row().described("points[].")];
    let csv =
        [of_row().described_in_csv(), descriptions("", &[&[NUMBER], &point_errors::IN_CSV[..]].concat())];
    vec![Answers { command: "bifurcation", option: "", json: json.concat(), csv: csv.concat() }]
}
