//! Measured amplitudes: on a logarithmic scale with the law that is fitted and others that the rows do not exclude, and the residuals.

use super::chart::{Axis, Look, Panel, Picture, Point, Series};
use super::parameters::estimate;
use super::range::{around, around_bars};
use super::style;
use libration_lab::fit::amplitudes::{AmplitudeTable, AmplitudesFit, LawOfAmplitudes, Position};

/// The measurements, with the unit of the fitted amplitudes.
#[derive(Clone, Debug)]
pub(crate) struct MeasuredAmplitudes {
    pub(crate) unit: &'static str,
    /// `true` if the readings are metres and the amplitudes angles.
    pub(crate) is_horizontal: bool,
    pub(crate) table: AmplitudeTable,
}

/// Laws whose criterion exceeds the least one by at most this are drawn too.
const DRAWN: f64 = 4.0;

/// The measurements with the laws through them.
pub(crate) fn fitted(measured: &MeasuredAmplitudes, fit: &AmplitudesFit) -> Picture {
    let law = fit.law();
    let scale = if measured.unit == "rad" { 1_f64.to_degrees() } else { 1.0 };
    let unit = if measured.unit == "rad" { "degrees" } else { measured.unit };
    let data = amplitudes(measured, law, scale);
    let (from, to) = around(measured.table.positions());
    let label = match measured.table.against() {
        Position::Time => "time t / s",
        Position::Swings => "number of swings",
    };
    let x = Axis::linear(label, from, to);
    let others = fit.laws.iter().enumerate().filter(|(index, other)| {
        *index != fit.chosen && other.aicc_difference <= DRAWN && other.damping.count() <= law.damping.count()
    });
    let mut series: Vec<Series> = others.map(|(_, other)| curve(other, style::reference(), scale)).collect();
    series.push(curve(law, style::exact_law(), scale));
    let heights = series.iter().flat_map(|one| &one.points).chain(&data).flat_map(Point::vertical_ends);
    let (low, high) = heights
        .filter(|height| *height > 0.0)
        .fold((f64::INFINITY, 0.0_f64), |(low, high), height| (low.min(height), high.max(height)));
    series.push(markers("measured", data));
    let above = Panel {
        x: x.unlabelled(),
        y: Axis::logarithmic(&format!("amplitude A / {unit}"), 0.9 * low, 1.1 * high),
        series,
        share: 0.62,
    };
    let panels = vec![above, residuals(measured, law, x)];
    let quality = fit.quality.map(|quality| format!("Q = {}", quality.factor));
    let omega0 = fit.natural_frequency.map(|omega0| estimate("ω₀", omega0, "rad/s"));
    let picture = Picture::new(&format!("Amplitudes, {} damping fitted", law.damping), panels);
    picture.with_parameters(quality.into_iter().chain(omega0))
}

fn residuals(measured: &MeasuredAmplitudes, law: &LawOfAmplitudes, x: Axis) -> Panel {
    let (scale, unit) = match (measured.is_horizontal, measured.unit) {
        (true, _) => (1.0, "m"),
        (false, "rad") => (1_f64.to_degrees(), "degrees"),
        (false, unit) => (1.0, unit),
    };
    let rows = measured.table.positions().zip(law.residuals.iter().zip(&law.standard_deviations));
    let point = |(position, (residual, deviation)): (f64, (&f64, &f64))| Point {
        x: position,
        y: scale * residual,
        x_uncertainty: None,
        y_uncertainty: Some(scale * deviation).filter(|deviation| deviation.is_finite()),
    };
    let points: Vec<Point> = rows.map(point).collect();
    let (low, high) = around_bars(&points, &[]);
    let (from, to) = x.ends();
    let zero = Series::line("", style::exact_law(), [(from, 0.0), (to, 0.0)]);
    Panel {
        x,
        y: Axis::linear(&format!("residual / {unit}"), low, high),
        series: vec![zero, markers("", points)],
        share: 0.38,
    }
}

/// The amplitudes of the rows: those of the law, and the residuals of the values.
fn amplitudes(measured: &MeasuredAmplitudes, law: &LawOfAmplitudes, scale: f64) -> Vec<Point> {
    let rows = measured.table.amplitudes(law.zero.map_or(0.0, |zero| zero.value));
    let point = |((position, amplitude), deviation): ((f64, f64), f64)| Point {
        x: position,
        y: scale * amplitude,
        x_uncertainty: None,
        y_uncertainty: Some(scale * deviation).filter(|deviation| deviation.is_finite()),
    };
    let deviations = measured.table.amplitude_deviations(&law.amplitudes, &law.standard_deviations);
    rows.zip(deviations).map(point).filter(|point| point.y > 0.0).collect()
}

fn curve(law: &LawOfAmplitudes, look: Look, scale: f64) -> Series {
    let points = law.curve.iter().filter(|point| point.1 > 0.0);
    let points: Vec<(f64, f64)> =
        points.map(|(position, amplitude)| (*position, scale * amplitude)).collect();
    Series::line(&law.damping.to_string(), look, points)
}

fn markers(label: &str, points: Vec<Point>) -> Series {
    Series { label: label.to_owned(), look: style::measurements(points.len()), points }
}
