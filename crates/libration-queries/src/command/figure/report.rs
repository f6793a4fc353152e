//! Content of a picture as numbers: a summary to read, or every point as JSON or CSV.

use crate::figure::chart::{Picture, Series};
use crate::output::description::Answers;
use crate::output::field::{Field, Fields};
use crate::output::json;
use crate::output::table::Table;
use crate::output::{Form, csv};
use std::io::{self, Write};
use std::path::Path;

pub(super) fn write(
    out: &mut dyn Write,
    form: Form,
    name: &str,
    path: &Path,
    picture: &Picture,
) -> io::Result<()> {
    match form {
        Form::Json => {
            let fields = of_series();
            let head = of_picture().record(&(name, path));
            json::document_with_list(out, head, "series", series(picture).map(|it| fields.record(it)))
        }
        Form::Csv => write_csv(out, picture),
        Form::Table => write_summary(out, picture),
    }
}

fn series(picture: &Picture) -> impl Iterator<Item = &Series> {
    picture.panels.iter().flat_map(|panel| &panel.series)
}

/// The name of the picture and its file.
fn of_picture<'a>() -> Fields<(&'a str, &'a Path)> {
    type Of<'a> = Field<(&'a str, &'a Path)>;
    Fields::from([
        Of::value("figure", "", "name of the picture", |(name, _)| (*name).into()),
        Of::value("output", "", "file that it was drawn to", |(_, path)| path.display().to_string().into()),
    ])
}

fn of_series() -> Fields<Series> {
    type Of = Field<Series>;
    Fields::from([
        Of::value("label", "", "name of the curve in the legend", |it| it.label.as_str().into())
            .words("shown", |it| it.label.clone()),
        Of::value("points[][]", "", "coordinates of the points, x and y, in the units of the axes", |it| {
            json::list(it.points.iter().map(|point| json::numbers(&[point.x, point.y])))
        })
        .numeral("points", |it| it.points.len().to_string()),
    ])
}

/// A point with the name of its curve.
fn of_point<'a>() -> Fields<(&'a str, f64, f64)> {
    type Of<'a> = Field<(&'a str, f64, f64)>;
    Fields::from([
        Of::value("series", "", "name of the curve in the legend", |it| it.0.into()),
        Of::number("x", "", "position on the horizontal axis, in the unit of that axis", |it| it.1),
        Of::number("y", "", "position on the vertical axis, in the unit of that axis", |it| it.2),
    ])
}

pub(super) fn answers() -> Vec<Answers> {
    let json = [of_picture().described(""), of_series().described("series[].")];
    vec![Answers { command: "figure", option: "", json: json.concat(), csv: of_point().described_in_csv() }]
}

fn write_csv(out: &mut dyn Write, picture: &Picture) -> io::Result<()> {
    let fields = of_point();
    csv::line(out, &fields.csv_names())?;
    for series in series(picture) {
        for point in &series.points {
            csv::line(out, &fields.csv_cells(&(&series.label, point.x, point.y)))?;
        }
    }
    Ok(())
}

fn write_summary(out: &mut dyn Write, picture: &Picture) -> io::Result<()> {
    let fields = of_series();
    let mut table = Table::new(fields.columns());
    for series in series(picture).filter(|series| !series.label.is_empty()) {
        table.row(out, fields.cells(series))?;
    }
    table.finish(out)
}
