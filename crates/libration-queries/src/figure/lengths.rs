//! Measured periods against length: T² with the line that is fitted, and the residuals.

use super::chart::{Axis, Panel, Picture, Point, Series};
use super::parameters::estimate;
use super::range::{around, around_bars};
use super::style;
use libration_lab::fit::{LengthFit, LengthTable, Uncertain};

const SAMPLES: u32 = 400;

/// The measurements, in m and s.
#[derive(Clone, Debug)]
pub(crate) struct MeasuredLengths {
    pub(crate) lengths: Vec<f64>,
    pub(crate) periods: Vec<f64>,
    pub(crate) length_uncertainties: Option<Vec<f64>>,
    pub(crate) period_uncertainties: Option<Vec<f64>>,
    pub(crate) table: LengthTable,
}

/// The measurements with a fitted law; with the radius of the bob if it is known.
pub(crate) fn fitted(measured: &MeasuredLengths, fit: &LengthFit, radius: Option<f64>) -> Picture {
    if fit.model.is_of_bars() {
        return bar(measured, fit);
    }
    let offset = fit.offset.map_or(0.0, |offset| offset.value);
    let (from, to) = around(measured.lengths.iter().copied().chain([0.0, -offset]));
    // Margins below zero would show lengths that nothing has.
    let from = from.max((-offset).min(0.0));
    let squares = measured.table.small_angle_periods().enumerate();
    let data: Vec<Point> = squares.map(|(row, t0)| square(measured, row, t0)).collect();
    let residuals: Vec<Point> = (0..measured.lengths.len()).map(|row| residual(measured, row, fit)).collect();
    let x = Axis::linear("length L / m", from, to);
    let squares = around_bars(&data, &[0.0]);
    let above = Panel {
        x: x.unlabelled(),
        y: Axis::linear("T₀² / s²", squares.0.max(0.0), squares.1),
        series: vec![line(fit, radius, from, to), markers("measured", data)],
        share: 0.62,
    };
    let offset = fit.offset.map(|offset| estimate("δ", offset, "m"));
    let picture = Picture::new("Period against length", vec![above, below(x, residuals)]);
    picture.with_parameters([estimate("g", fit.g, "m/s²")].into_iter().chain(offset))
}

/// The measurements on a bar: T²h against h², on the line of slope 4π²/g through k².
fn bar(measured: &MeasuredLengths, fit: &LengthFit) -> Picture {
    let offset = fit.offset.map_or(0.0, |offset| offset.value);
    let height = |row: usize| (measured.lengths[row] + offset).abs();
    let point = |(row, t0): (usize, f64)| {
        let h = height(row);
        Point {
            x: h * h,
            y: t0 * t0 * h,
            x_uncertainty: measured.length_uncertainties.as_ref().map(|column| 2.0 * h * column[row]),
            y_uncertainty: Some(2.0 * t0 * h * fit.standard_deviations[row] * t0 / measured.periods[row]),
        }
    };
    let data: Vec<Point> = measured.table.small_angle_periods().enumerate().map(point).collect();
    let (from, to) = around(data.iter().map(|point| point.x).chain([0.0]));
    let from = from.max(0.0);
    let turn = std::f64::consts::TAU;
    let line = fit.gyration.map(|gyration| {
        let at = |square: f64| (square, turn * turn * (square + gyration.value) / fit.g.value);
        Series::line("4π²(k² + h²)/g", style::exact_law(), [at(from), at(to)])
    });
    let on_line: Vec<f64> = line.iter().flat_map(|line| &line.points).map(|point| point.y).collect();
    let squares = around_bars(&data, &on_line);
    let residuals = (0..measured.lengths.len()).map(|row| {
        let of_length = residual(measured, row, fit);
        Point { x: height(row) * height(row), ..of_length }
    });
    let residuals: Vec<Point> = residuals.collect();
    let x = Axis::linear("square of the distance from the centre of mass h² / m²", from, to);
    let above = Panel {
        x: x.unlabelled(),
        y: Axis::linear("T₀²h / (m s²)", squares.0.max(0.0), squares.1),
        series: line.into_iter().chain([markers("measured", data)]).collect(),
        share: 0.62,
    };
    let k = fit.gyration.map(|gyration| {
        let k = gyration.value.sqrt();
        estimate("k", Uncertain { value: k, uncertainty: 0.5 * gyration.uncertainty / k }, "m")
    });
    let picture = Picture::new("Period of a bar", vec![above, below(x, residuals)]);
    picture.with_parameters([estimate("g", fit.g, "m/s²")].into_iter().chain(k))
}

/// The panel of residuals.
fn below(x: Axis, residuals: Vec<Point>) -> Panel {
    let (low, high) = around_bars(&residuals, &[]);
    let zero = Series::line("", style::exact_law(), [(x.ends().0, 0.0), (x.ends().1, 0.0)]);
    Panel {
        x,
        y: Axis::linear("residual / s", low, high),
        series: vec![zero, markers("", residuals)],
        share: 0.38,
    }
}

/// T² of small swings, from its zero.
fn line(fit: &LengthFit, radius: Option<f64>, from: f64, to: f64) -> Series {
    let offset = fit.offset.map_or(0.0, |offset| offset.value);
    let gyration =
        fit.gyration.map_or(radius.map_or(0.0, |radius| 0.4 * radius * radius), |gyration| gyration.value);
    let turn = std::f64::consts::TAU;
    let points = (0..=SAMPLES).filter_map(|step| {
        let length = from + (to - from) * f64::from(step) / f64::from(SAMPLES);
        let whole = length + offset;
        // Where the bob would reach beyond the pivot the law is of no use.
        let usable = whole > 0.0 && whole * whole > gyration.abs();
        usable.then(|| (length, turn * turn * (whole + gyration / whole) / fit.g.value))
    });
    let law = match (fit.offset.is_some(), gyration.abs() > 0.0) {
        (true, true) => "4π²(L + δ + κ/(L + δ))/g",
        (true, false) => "4π²(L + δ)/g",
        (false, true) => "4π²(L + κ/L)/g",
        (false, false) => "4π²L/g",
    };
    Series::line(law, style::exact_law(), points.collect::<Vec<_>>())
}

fn markers(label: &str, points: Vec<Point>) -> Series {
    Series { label: label.to_owned(), look: style::measurements(points.len()), points }
}

fn square(measured: &MeasuredLengths, row: usize, t0: f64) -> Point {
    Point {
        x: measured.lengths[row],
        y: t0 * t0,
        x_uncertainty: measured.length_uncertainties.as_ref().map(|column| column[row]),
        y_uncertainty: measured
            .period_uncertainties
            .as_ref()
            .map(|column| 2.0 * t0 * column[row] * t0 / measured.periods[row]),
    }
}

fn residual(measured: &MeasuredLengths, row: usize, fit: &LengthFit) -> Point {
    Point {
        x: measured.lengths[row],
        y: fit.residuals[row],
        x_uncertainty: None,
        y_uncertainty: Some(fit.standard_deviations[row]),
    }
}
