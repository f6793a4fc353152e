//! Measured periods against amplitude, with the exact law, the constant period and the residuals.

use super::chart::{Axis, Panel, Picture, Point, Series, Units};
use super::parameters::estimate;
use super::range::{around, around_bars};
use super::style;
use libration_lab::fit::{Law, PeriodFit};

const SAMPLES: u32 = 400;

/// One row: rad and s.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Measurement {
    pub(crate) amplitude: f64,
    pub(crate) period: f64,
    pub(crate) amplitude_uncertainty: Option<f64>,
    pub(crate) period_uncertainty: Option<f64>,
}

/// The measurements that were fitted, in the order of the fit's residuals.
pub(crate) fn fitted(measurements: &[Measurement], fit: &PeriodFit) -> Picture {
    let (from, to) = around(measurements.iter().map(|row| row.amplitude.to_degrees()).chain([0.0]));
    let (from, to) = (from.max(0.0), to.min(180.0));
    let data: Vec<Point> = measurements.iter().map(measured).collect();
    let residuals: Vec<Point> =
        measurements.iter().enumerate().map(|(row, m)| residual(row, m, fit)).collect();
    let x = Axis::linear("amplitude θ₀ / degrees", from, to).in_units(Units::Degrees);
    let curves = laws(fit, from, to);
    let unlabelled = x.unlabelled();
    let above = Panel {
        x: unlabelled,
        y: vertical("period T / s", &data),
        series: [curves, vec![markers("measured", data)]].concat(),
        share: 0.62,
    };
    let zero = Series::line("", style::exact_law(), [(from, 0.0), (to, 0.0)]);
    let below = Panel {
        x,
        y: vertical("residual / s", &residuals),
        series: vec![zero, markers("", residuals)],
        share: 0.38,
    };
    let picture = Picture::new("Period against amplitude", vec![above, below]);
    picture.with_parameters([estimate("T₀", fit.exact.t0, "s")])
}

/// The two laws, drawn below the measurements.
fn laws(fit: &PeriodFit, from: f64, to: f64) -> Vec<Series> {
    let degrees = |step| from + (to - from) * f64::from(step) / f64::from(SAMPLES);
    let curve = |law: Law, t0: f64| {
        (0..=SAMPLES).map(degrees).map(|x| (x, t0 * law.ratio_at(x.to_radians()))).collect::<Vec<_>>()
    };
    vec![
        Series::line("exact law", style::exact_law(), curve(Law::exact(), fit.exact.t0.value)),
        Series::line("constant period", style::curve(4), curve(Law::constant(), fit.constant.t0.value)),
    ]
}

fn markers(label: &str, points: Vec<Point>) -> Series {
    Series { label: label.to_owned(), look: style::measurements(points.len()), points }
}

fn measured(row: &Measurement) -> Point {
    Point {
        x: row.amplitude.to_degrees(),
        y: row.period,
        x_uncertainty: row.amplitude_uncertainty.map(f64::to_degrees),
        y_uncertainty: row.period_uncertainty,
    }
}

fn residual(row: usize, measurement: &Measurement, fit: &PeriodFit) -> Point {
    Point {
        x: measurement.amplitude.to_degrees(),
        y: fit.exact.residuals[row],
        x_uncertainty: None,
        y_uncertainty: Some(fit.exact.standard_deviations[row]),
    }
}

fn vertical(label: &str, points: &[Point]) -> Axis {
    let (low, high) = around_bars(points, &[]);
    Axis::linear(label, low, high)
}
