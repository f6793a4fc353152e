//! The content of a picture as JSON, for other programs.

use super::Layout;
use super::chart::{Axis, Look, Mark, Panel, Picture, Point, Scale, Series, Units};
use crate::call;
use crate::output::json::{self, Record, SCHEMA};
use serde_json::Value;

/// Names of the shapes of markers.
const SHAPES: [&str; 4] = ["circle", "square", "triangle", "diamond"];

/// The bytes of a JSON file.
#[expect(clippy::unnecessary_wraps, reason = "a page has no such file")]
pub(crate) fn file(picture: &Picture) -> Result<Vec<u8>, String> {
    Ok(text(picture).into_bytes())
}

/// Passes a picture to the host, if it takes charts; it is made when the host reads it.
pub(crate) fn pass(layout: &Layout, picture: impl Fn() -> Picture + Send + Sync + 'static) {
    let (call, layout) = (call::current(), layout.clone());
    if call.host().takes_chart() {
        call.host().chart(Box::new(move || text(&layout.content(&picture()))));
    }
}

fn text(picture: &Picture) -> String {
    let chart = Record::new()
        .with("schema", SCHEMA)
        .with("title", picture.title.as_str())
        .with("parameters", json::list(picture.parameters.iter().map(String::as_str)))
        .with("aspect", json::number(picture.aspect))
        .with("panels", json::records(picture.panels.iter().map(panel)));
    format!("{}\n", Value::from(chart))
}

fn panel(panel: &Panel) -> Record {
    Record::new()
        .with("share", json::number(panel.share))
        .with("x", axis(&panel.x))
        .with("y", axis(&panel.y))
        .with("series", json::records(panel.series.iter().map(series)))
}

fn axis(axis: &Axis) -> Record {
    let scale = match axis.scale {
        Scale::Linear => "linear",
        Scale::Logarithmic => "logarithmic",
    };
    let record = Record::new()
        .with("label", axis.label.as_str())
        .with("from", json::number(axis.from))
        .with("to", json::number(axis.to))
        .with("scale", scale);
    match &axis.units {
        Units::Decimal => record.with("ticks", "decimal"),
        Units::Whole => record.with("ticks", "whole"),
        Units::Degrees => record.with("ticks", "degrees"),
        Units::HalfTurns(half_turn) => {
            record.with("ticks", "half_turns").with("half_turn", json::number(*half_turn))
        }
        Units::Names(names) => {
            record.with("ticks", "names").with("names", json::list(names.iter().map(String::as_str)))
        }
    }
}

fn series(series: &Series) -> Record {
    let column = |value: fn(&Point) -> f64| json::list(series.points.iter().map(value).map(json::number));
    let record = look(&series.look, Record::new().with("label", series.label.as_str()))
        .with("x", column(|point| point.x))
        .with("y", column(|point| point.y));
    type Uncertainty = fn(&Point) -> Option<f64>;
    let uncertainties: [(_, Uncertainty); 2] =
        [("x_uncertainty", |point| point.x_uncertainty), ("y_uncertainty", |point| point.y_uncertainty)];
    uncertainties.into_iter().fold(record, |record, (name, value)| {
        if series.points.iter().all(|point| value(point).is_none()) {
            return record;
        }
        let numbers = series.points.iter().map(|point| value(point).map_or(Value::Null, json::number));
        record.with(name, json::list(numbers))
    })
}

fn look(look: &Look, record: Record) -> Record {
    let record = record.with("colour", look.colour).with("opacity", json::number(look.opacity));
    match look.mark {
        Mark::Line(dashes) => record
            .with("mark", "line")
            .with("line_width", json::number(look.width))
            .with("dashes", json::numbers(dashes)),
        Mark::Markers(shape) => {
            record.with("mark", SHAPES[shape % SHAPES.len()]).with("marker_radius", json::number(look.width))
        }
        Mark::Band => record.with("mark", "band"),
    }
}
