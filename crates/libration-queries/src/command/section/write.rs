//! The points of a section as table, JSON and CSV.

use super::SectionResult;
use super::point_errors::{self, PointErrors};
use crate::output::description::{self, Answers, descriptions};
use crate::output::field::{Field, Fields};
use crate::output::json;
use crate::output::table::{Column, Table, sheet};
use crate::output::{Form, csv, number};
use std::io::{self, Write};

impl SectionResult<'_> {
    /// Writes the result in the given form; the table lists the points only if requested.
    pub(super) fn write(&self, out: &mut dyn Write, form: Form, listed: bool) -> io::Result<()> {
        match form {
            Form::Json => self.write_json(out),
            Form::Csv => self.write_csv(out),
            Form::Table => self.write_table(out, listed),
        }
    }

    fn rows(&self) -> impl Iterator<Item = SectionRow<'_>> + '_ {
        let motions = (1..).zip(&self.sections);
        motions.flat_map(move |(motion, section)| {
            section.points.iter().enumerate().map(move |(index, point)| SectionRow {
                motion,
                time: point.time,
                state: self.options.shown(&point.state, &self.angles),
                errors: PointErrors::of(section, index),
            })
        })
    }

    /// Returns `true` if errors were estimated.
    fn has_errors(&self) -> bool {
        self.sections.iter().any(|section| section.errors.is_some())
    }

    fn is_complete(&self) -> bool {
        self.sections.iter().all(|section| section.stopped.is_none())
    }

    fn write_json(&self, out: &mut dyn Write) -> io::Result<()> {
        let fields = of_row();
        let points = self.rows().map(|row| fields.record(&row));
        json::document_with_list(out, of_answer().record(self), "points", points)
    }

    fn write_csv(&self, out: &mut dyn Write) -> io::Result<()> {
        let fields = of_row();
        let mut names = [fields.csv_names(), self.model.state_names()].concat();
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
        let mut lines = of_answer().lines(self);
        lines.extend(self.determined_text().map(|text| ("determined", text)));
        sheet(out, &lines)?;
        if !listed {
            return Ok(());
        }
        writeln!(out)?;
        let fields = of_row();
        let numbers = ["time".to_owned()].into_iter().chain(self.model.state_names()).map(Column::numbers);
        let mut table = Table::new(fields.columns().into_iter().chain(numbers).collect());
        for row in self.rows() {
            let numbers = row.errors.cells(row.time, &row.state);
            table.row(out, fields.cells(&row).into_iter().chain(numbers).collect())?;
        }
        table.finish(out)
    }

    /// The time until which each motion is determined, if it is not determined throughout.
    fn determined_text(&self) -> Option<String> {
        let until = (1usize..).zip(&self.sections).filter_map(|(motion, section)| {
            let until = number::rounded(section.errors.as_ref()?.determined_until?, 6);
            Some(match self.sections.len() {
                1 => format!("t = {until} s"),
                _ => format!("t = {until} s (motion {motion})"),
            })
        });
        let until = until.collect::<Vec<_>>().join(", ");
        (!until.is_empty()).then(|| {
            format!(
                "in double precision until {until}; later points, with three digits, are those of a nearby motion"
            )
        })
    }

    fn points_text(&self) -> String {
        let count: usize = self.sections.iter().map(|section| section.points.len()).sum();
        format!("{count}, {}, after discarding {} as transient", self.section, self.points.skipped)
    }
}

/// A point of the section.
struct SectionRow<'a> {
    motion: usize,
    time: f64,
    state: Vec<f64>,
    errors: PointErrors<'a>,
}

fn of_answer<'a>() -> Fields<SectionResult<'a>> {
    type Of<'a> = Field<SectionResult<'a>>;
    Fields::from([
        Of::value("system", "", "key of the system, null where its equations were typed", |result| {
            result.model.key().into()
        })
        .line_of("system", |result| result.model.title().to_owned()),
        Of::value("equation", "", "equations of motion as they were read", |result| {
            result.model.equation().to_string().into()
        })
        .line_of("equation", |result| result.model.equation().to_string()),
        Of::value("section", "", "condition at which points are recorded, in words", |result| {
            result.section.as_str().into()
        })
        .line_of("points", SectionResult::points_text),
        Of::value("skipped", "1", "number of points discarded as transient, for each motion", |result| {
            result.points.skipped.into()
        }),
        Of::value("state[]", "", "names of the state variables", |result| {
            json::list(result.model.state_names())
        }),
        Of::value(
            "initial[][]",
            "",
            "state at the start of each motion, in the order of the names",
            |result| json::list(result.starts.clone()),
        ),
        Of::value("determined_until_s[]", "s", point_errors::DETERMINED, |result| {
            point_errors::determined_until(&result.sections)
        }),
        Of::value("complete", "", "true if all requested points are present", |result| {
            result.is_complete().into()
        }),
    ])
}

fn of_row<'a>() -> Fields<SectionRow<'a>> {
    type Of<'a> = Field<SectionRow<'a>>;
    Fields::from([
        Of::value("motion", "1", "number of the motion, from 1 in the order of --initial", |row| {
            row.motion.into()
        })
        .numeral("motion", |row| row.motion.to_string()),
        Of::number("time_s", "s", "time of the point", |row| row.time),
        Of::value("state[]", "", "state there, in the order of the names", |row| json::numbers(&row.state)),
        Of::present_value("time_error_s", "s", point_errors::MEANING, |row| row.errors.of_time()).only_json(),
        Of::present_value("error[]", "", point_errors::MEANING, |row| row.errors.of_state(&row.state)),
    ])
}

pub(crate) fn answers() -> Vec<Answers> {
    const NUMBER: description::DescriptionRow = ("NAME", "", "state variable of this name");
    let json = [of_answer().described(""), of_row().described("points[].")];
    let csv =
        [of_row().described_in_csv(), descriptions("", &[&[NUMBER], &point_errors::IN_CSV[..]].concat())];
    vec![Answers { command: "section", option: "", json: json.concat(), csv: csv.concat() }]
}
