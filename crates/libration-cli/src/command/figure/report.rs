//! What a picture shows, as numbers: a summary to read, or every point as JSON or CSV.

use crate::figure::chart::{Picture, Series};
use crate::output::json::{self, Record};
use crate::output::table::{Column, Table};
use crate::output::{Form, csv, number};
use serde_json::Value;
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
            let head = Record::new().with("figure", name).with("output", path.display().to_string());
            json::document_with_list(out, head, "series", series(picture).map(record))
        }
        Form::Csv => write_csv(out, picture),
        Form::Table => write_summary(out, picture),
    }
}

fn series(picture: &Picture) -> impl Iterator<Item = &Series> {
    picture.panels.iter().flat_map(|panel| &panel.series)
}

fn record(series: &Series) -> Record {
    let point = |x: f64, y: f64| -> Value { vec![json::number(x), json::number(y)].into() };
    let points: Vec<Value> = series.points.iter().map(|p| point(p.x, p.y)).collect();
    Record::new().with("label", series.label.as_str()).with("points", points)
}

fn write_csv(out: &mut dyn Write, picture: &Picture) -> io::Result<()> {
    csv::line(out, &["series", "x", "y"])?;
    for series in series(picture) {
        for point in &series.points {
            csv::line(out, &[series.label.clone(), number::exact(point.x), number::exact(point.y)])?;
        }
    }
    Ok(())
}

fn write_summary(out: &mut dyn Write, picture: &Picture) -> io::Result<()> {
    let mut table = Table::new(vec![Column::words("shown"), Column::numbers("points")]);
    for series in series(picture).filter(|series| !series.label.is_empty()) {
        table.row(out, vec![series.label.clone(), series.points.len().to_string()])?;
    }
    table.finish(out)
}
