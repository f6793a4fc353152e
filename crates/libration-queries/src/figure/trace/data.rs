//! The data with the fitted curve, and the residuals.

use super::super::chart::{Axis, Look, Panel, Picture, Series, Units};
use super::super::range::around;
use super::super::style;
use super::Fitted;
use super::curve::smooth;
use super::thinned::{one_of, representative, thinned};
use std::ops::Range;

/// Number of periods beyond which the curve cannot be seen in a picture of the whole.
const LONG: f64 = 12.0;
/// Periods in each stretch of a long trace.
const STRETCH: f64 = 4.0;
/// Largest number of rows within view of a smooth curve; with more rows it is drawn from row to row.
const MANY: usize = 1500;

/// Returns `true` if single swings cannot be seen in a picture of the whole.
pub(crate) fn is_long(swing: &Fitted<'_>) -> bool {
    duration(swing) > LONG * swing.small_angle_period
}

fn duration(swing: &Fitted<'_>) -> f64 {
    let times = swing.trace.times();
    times.last().zip(times.first()).map_or(0.0, |(last, first)| last - first)
}

/// The whole trace; below, the residuals.
pub(crate) fn whole(swing: &Fitted<'_>, title: &str) -> Picture {
    let rows = 0..swing.trace.len();
    let x = time_axis(swing, &rows);
    let unlabelled = x.unlabelled();
    let above = panel(unlabelled, &swing.label(), both(swing, &rows, true), 0.62);
    let zero = [x.from, x.to].map(|time| (time, 0.0));
    let residuals = points(swing, &rows, &swing.fitted.residuals);
    let name = match one_of(rows.len()) {
        1 => String::new(),
        many => format!("one of {many} rows, and all beyond 4 standard deviations"),
    };
    let left = vec![
        Series::line("", style::exact_law(), zero),
        Series::line(&name, small_dots(rows.len()), representative(residuals)),
    ];
    Picture::new(title, vec![above, panel(x, &residual_label(swing), left, 0.38)])
}

fn residual_label(swing: &Fitted<'_>) -> String {
    format!("residual / {}", swing.unit())
}

/// The beginning, the middle and the end of a long trace, some periods each.
pub(crate) fn stretches(swing: &Fitted<'_>, title: &str) -> Picture {
    let times = swing.trace.times();
    let (first, rest) = (times[0], duration(swing) - STRETCH * swing.small_angle_period);
    let parts = ["beginning", "middle", "end"].into_iter().zip([0.0, 0.5, 1.0]);
    let panels = parts.filter_map(|(name, part)| {
        let from = first + part * rest;
        let to = from + STRETCH * swing.small_angle_period;
        let rows = times.partition_point(|&time| time < from)..times.partition_point(|&time| time <= to);
        let shown = both(swing, &rows, name == "beginning");
        let label = if name == "end" { "time t / s" } else { "" };
        let x = Axis { label: label.to_owned(), ..time_axis(swing, &rows) };
        (rows.len() > 1).then(|| panel(x, &format!("{name} / {}", swing.unit()), shown, 1.0))
    });
    let panels: Vec<Panel> = panels.collect();
    Picture { aspect: 1.0, ..Picture::new(title, panels) }
}

fn time_axis(swing: &Fitted<'_>, rows: &Range<usize>) -> Axis {
    let times = &swing.trace.times()[rows.clone()];
    let (from, to) = (times.first().copied().unwrap_or(0.0), times.last().copied().unwrap_or(1.0));
    Axis::linear("time t / s", from, to)
}

/// The fitted curve with the measured points over it.
fn both(swing: &Fitted<'_>, rows: &Range<usize>, with_names: bool) -> Vec<Series> {
    let name = |name: &'static str| if with_names { name } else { "" };
    let fitted: Vec<f64> =
        swing.fitted.fitted[rows.clone()].iter().map(|&value| swing.shown(value)).collect();
    let curve = if rows.len() > MANY {
        thinned(points(swing, rows, &swing.fitted.fitted))
    } else {
        smooth(&swing.trace.times()[rows.clone()], &fitted)
    };
    vec![
        Series::line(name("fitted"), Look { width: 1.6, ..style::exact_law() }, curve),
        Series::line(
            name("measured"),
            small_dots(rows.len()),
            thinned(points(swing, rows, swing.trace.values())),
        ),
    ]
}

fn points(swing: &Fitted<'_>, rows: &Range<usize>, values: &[f64]) -> Vec<(f64, f64)> {
    rows.clone().map(|row| (swing.trace.times()[row], swing.shown(values[row]))).collect()
}

fn small_dots(count: usize) -> Look {
    let look = style::measurements(count);
    if count > 1000 { Look { width: 1.1, ..look } } else { look }
}

fn panel(x: Axis, label: &str, series: Vec<Series>, share: f64) -> Panel {
    let (low, high) = around(series.iter().flat_map(|series| series.points.iter().map(|point| point.y)));
    let y = Axis::linear(label, low, high);
    let y = if label.ends_with("degrees") { y.in_units(Units::Degrees) } else { y };
    Panel { x, y, series, share }
}
