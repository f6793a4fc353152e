//! Tests of residuals for white noise: their correlation from row to row, and their distribution.

use super::super::chart::{Axis, Panel, Picture, Series, Units};
use super::super::range::around;
use super::super::style;
use crate::output::number::count;
use libration_lab::fit::trace::Autocorrelation;
use std::f64::consts::TAU;

/// Lags that are shown.
const LAGS: usize = 60;
/// Bars of the histogram, from −4 to 4 standard deviations.
const BARS: u32 = 32;
const WIDEST: f64 = 4.0;

/// The autocorrelation of the residuals with the range noise would keep to, and their histogram with the normal one.
pub(crate) fn residuals(correlation: &Autocorrelation, residuals: &[f64]) -> Picture {
    let panels = vec![autocorrelation(correlation, residuals.len()), histogram(residuals)];
    Picture { aspect: 0.8, ..Picture::new("Residuals compared with white noise", panels) }
}

fn autocorrelation(correlation: &Autocorrelation, rows: usize) -> Panel {
    let shown = &correlation.correlations[..correlation.correlations.len().min(LAGS + 1)];
    let points: Vec<(f64, f64)> =
        shown.iter().enumerate().skip(1).map(|(lag, &value)| (count(lag), value)).collect();
    let last = count(shown.len().saturating_sub(1).max(1));
    // Two standard deviations of the autocorrelation of as much noise.
    let bound = 2.0 / count(rows).sqrt();
    let line = |label, height| Series::line(label, style::reference(), [(0.0, height), (last, height)]);
    let (low, high) = around(points.iter().map(|point| point.1).chain([-bound, bound]));
    let series = vec![
        line("range of white noise", bound),
        line("", -bound),
        Series::line("", style::thin(0), points.clone()),
        Series::line("residuals", style::marks(0), points),
    ];
    let x = Axis::linear("lag / rows", 0.0, last);
    Panel { x: x.in_units(Units::Whole), y: Axis::linear("autocorrelation", low, high), series, share: 1.0 }
}

fn histogram(residuals: &[f64]) -> Panel {
    let deviation =
        (residuals.iter().map(|value| value * value).sum::<f64>() / count(residuals.len())).sqrt();
    let width = 2.0 * WIDEST / f64::from(BARS);
    let edge = |bar: u32| width.mul_add(f64::from(bar), -WIDEST);
    let inside = |bar: u32| {
        let within = |value: &&f64| (edge(bar)..edge(bar + 1)).contains(&(**value / deviation));
        count(residuals.iter().filter(within).count())
    };
    let outline = (0..BARS).flat_map(|bar| {
        let height = inside(bar);
        [(edge(bar), height), (edge(bar + 1), height)]
    });
    let outline: Vec<(f64, f64)> = outline.collect();
    let normal = (0..=4 * BARS).map(|part| {
        let x = 2.0_f64.mul_add(WIDEST * f64::from(part) / f64::from(4 * BARS), -WIDEST);
        (x, count(residuals.len()) * width * (-0.5 * x * x).exp() / TAU.sqrt())
    });
    let normal: Vec<(f64, f64)> = normal.collect();
    let (_, high) = around(outline.iter().chain(&normal).map(|point| point.1));
    let series = vec![
        Series::line("normal distribution", style::exact_law(), normal),
        Series::line("residuals", style::thin(0), outline),
    ];
    let x = Axis::linear("residual / standard deviation", -WIDEST, WIDEST).in_units(Units::Whole);
    Panel { x, y: Axis::linear("rows", 0.0, high), series, share: 1.0 }
}
