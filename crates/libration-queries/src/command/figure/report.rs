//! Content of a picture as numbers: a summary to read, or every point as JSON or CSV.

use crate::figure::chart::{Picture, Point, Series};
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
            let fields = of_curves();
            let head = of_picture().record(&(name, path));
            json::document_with_list(out, head, "series", curves(picture).map(|curve| fields.record(&curve)))
        }
        Form::Csv => write_csv(out, picture),
        Form::Table => write_summary(out, picture),
    }
}

/// A series with the number of its panel, from 1 at the top.
type PanelCurve<'a> = (usize, &'a Series);

fn curves(picture: &Picture) -> impl Iterator<Item = PanelCurve<'_>> {
    let of_panel = |(panel, series)| std::iter::repeat(panel).zip(series);
    (1..).zip(picture.panels.iter().map(|panel| &panel.series)).flat_map(of_panel)
}

/// The name of the picture and its file.
fn of_picture<'a>() -> Fields<(&'a str, &'a Path)> {
    type Of<'a> = Field<(&'a str, &'a Path)>;
    Fields::from([
        Of::value("figure", "", "name of the picture", |(name, _)| (*name).into()),
        Of::value("output", "", "file that it was drawn to", |(_, path)| path.display().to_string().into()),
    ])
}

fn of_curves<'a>() -> Fields<PanelCurve<'a>> {
    type Of<'a> = Field<PanelCurve<'a>>;
    Fields::from([
        Of::value("panel", "", "number of the panel, from 1 at the top", |(panel, _)| (*panel).into()),
        Of::value("label", "", "name of the curve in the legend", |(_, curve)| curve.label.as_str().into())
            .words("shown", |(_, curve)| curve.label.clone()),
        Of::value(
            "points[][]",
            "",
            "coordinates of the points, x and y, in the units of the axes",
            |(_, curve)| json::list(curve.points.iter().map(|point| json::numbers(&[point.x, point.y]))),
        )
        .numeral("points", |(_, curve)| curve.points.len().to_string()),
    ])
}

/// A point with its curve.
fn of_points<'a>() -> Fields<(PanelCurve<'a>, &'a Point)> {
    type Of<'a> = Field<(PanelCurve<'a>, &'a Point)>;
    Fields::from([
        Of::value("panel", "", "number of the panel, from 1 at the top", |((panel, _), _)| (*panel).into()),
        Of::value("series", "", "name of the curve in the legend", |((_, curve), _)| {
            curve.label.as_str().into()
        }),
        Of::number("x", "", "position on the horizontal axis, in the unit of that axis", |(_, point)| {
            point.x
        }),
        Of::number("y", "", "position on the vertical axis, in the unit of that axis", |(_, point)| point.y),
    ])
}

pub(super) fn answers() -> Vec<Answers> {
    let json = [of_picture().described(""), of_curves().described("series[].")];
    vec![Answers { command: "figure", option: "", json: json.concat(), csv: of_points().described_in_csv() }]
}

fn write_csv(out: &mut dyn Write, picture: &Picture) -> io::Result<()> {
    let fields = of_points();
    csv::line(out, &fields.csv_names())?;
    for curve in curves(picture) {
        for point in &curve.1.points {
            csv::line(out, &fields.csv_cells(&(curve, point)))?;
        }
    }
    Ok(())
}

fn write_summary(out: &mut dyn Write, picture: &Picture) -> io::Result<()> {
    let fields = of_curves();
    let mut table = Table::new(fields.columns());
    for curve in curves(picture).filter(|(_, series)| !series.label.is_empty()) {
        table.row(out, fields.cells(&curve))?;
    }
    table.finish(out)
}
