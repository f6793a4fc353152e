//! A measured response: amplitudes, and phases if measured, with the fitted curve, whose unstable part is dashed.

use super::chart::{Axis, Panel, Picture, Point, Series, Units};
use super::parameters::estimate;
use super::range::around_bars;
use super::response::look;
use super::style;
use libration_lab::fit::response::{FittedCurve, FittedCurvePoint, ResponseFit, ResponseTable};

/// The measurements, in rad/s, the unit of the amplitudes, and rad.
#[derive(Clone, Debug)]
pub(crate) struct MeasuredResponse {
    pub(crate) frequencies: Vec<f64>,
    pub(crate) amplitudes: Vec<f64>,
    pub(crate) phases: Option<Vec<f64>>,
    pub(crate) frequency_uncertainties: Option<Vec<f64>>,
    pub(crate) amplitude_uncertainties: Option<Vec<f64>>,
    pub(crate) phase_uncertainties: Option<Vec<f64>>,
    pub(crate) is_angle: bool,
    pub(crate) unit: &'static str,
    pub(crate) table: ResponseTable,
}

/// The measurements with the curve through them.
pub(crate) fn fitted(measured: &MeasuredResponse, fit: &ResponseFit, curve: &FittedCurve) -> Picture {
    let scale = if measured.is_angle { 1_f64.to_degrees() } else { 1.0 };
    let amplitude = |point: &FittedCurvePoint| scale * point.amplitude;
    let lines = stretches(curve, amplitude, true);
    let data = points(measured, &measured.amplitudes, measured.amplitude_uncertainties.as_deref(), scale);
    let on_curve = curve.branches.iter().flatten().map(|point| point.frequency);
    let (from, to) = extent(measured.frequencies.iter().copied().chain(on_curve));
    let top = lines
        .iter()
        .flat_map(|line| &line.points)
        .chain(&data)
        .flat_map(Point::vertical_ends)
        .fold(0.0, f64::max);
    let label = match measured.is_angle {
        true => "amplitude / degrees".to_owned(),
        false => format!("amplitude / {}", measured.unit),
    };
    let y = Axis::linear(&label, 0.0, 1.05 * top);
    let y = if measured.is_angle { y.in_units(Units::Degrees) } else { y };
    let x = Axis::linear("frequency of the drive Ω / (rad/s)", from, to);
    let has_phases = measured.phases.is_some();
    let above = Panel {
        x: if has_phases { x.unlabelled() } else { x.clone() },
        y,
        series: [lines, vec![markers("measured", data)]].concat(),
        share: if has_phases { 0.6 } else { 1.0 },
    };
    let below = measured.phases.as_ref().map(|phases| of_phases(measured, phases, curve, x));
    let unit = format!("{}/s²", measured.unit);
    let cubic = fit.cubic.map(|cubic| estimate("κ", cubic, &format!("1/(s² {}²)", measured.unit)));
    let parameters = [
        estimate("ω₀", fit.natural_frequency, "rad/s"),
        estimate("c", fit.damping, "1/s"),
        estimate("A", fit.drive, &unit),
    ];
    let panels = [above].into_iter().chain(below).collect();
    Picture::new(&format!("Response, {} fitted", fit.model), panels)
        .with_parameters(parameters.into_iter().chain(cubic))
}

fn of_phases(measured: &MeasuredResponse, phases: &[f64], curve: &FittedCurve, x: Axis) -> Panel {
    let lines = stretches(curve, |point| point.phase.to_degrees(), false);
    let sign = if measured.table.leads() { -1.0 } else { 1.0 };
    // From −90° on, so that what scatters about zero stays together.
    let lag = |phase: &f64| {
        let turns = (sign * phase.to_degrees() + 90.0) / 360.0;
        360.0 * (turns - turns.floor()) - 90.0
    };
    let degrees: Vec<f64> = phases.iter().map(lag).collect();
    let uncertainties: Option<Vec<f64>> = measured
        .phase_uncertainties
        .as_ref()
        .map(|column| column.iter().map(|uncertainty| uncertainty.to_degrees()).collect());
    let data = points(measured, &degrees, uncertainties.as_deref(), 1.0);
    let (low, high) = around_bars(&data, &[0.0, 180.0]);
    let y = Axis::linear("lag / degrees", low, high).in_units(Units::Degrees);
    Panel { x, y, series: [lines, vec![markers("", data)]].concat(), share: 0.4 }
}

fn points(
    measured: &MeasuredResponse,
    values: &[f64],
    uncertainties: Option<&[f64]>,
    scale: f64,
) -> Vec<Point> {
    let point = |row: usize| Point {
        x: measured.frequencies[row],
        y: scale * values[row],
        x_uncertainty: measured.frequency_uncertainties.as_ref().map(|column| column[row]),
        y_uncertainty: uncertainties.map(|column| scale * column[row]),
    };
    (0..values.len()).map(point).collect()
}

fn markers(label: &str, points: Vec<Point>) -> Series {
    Series { label: label.to_owned(), look: style::measurements(points.len()), points }
}

fn extent(values: impl Iterator<Item = f64>) -> (f64, f64) {
    values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| (low.min(value), high.max(value)))
}

/// The stretches of the curve that are stable or not, each begun where the one before ends; with names in the legend once.
fn stretches(curve: &FittedCurve, height: impl Fn(&FittedCurvePoint) -> f64, named: bool) -> Vec<Series> {
    let mut stretches: Vec<(bool, Vec<(f64, f64)>)> = vec![];
    for branch in &curve.branches {
        let mut last: Option<bool> = None;
        for point in branch {
            let position = (point.frequency, height(point));
            if let (Some(stable), Some((_, points))) = (last, stretches.last_mut())
                && stable == point.stability.may_last()
            {
                points.push(position);
            } else {
                let joint = last.and_then(|_| stretches.last()?.1.last().copied());
                stretches.push((point.stability.may_last(), joint.into_iter().chain([position]).collect()));
            }
            last = Some(point.stability.may_last());
        }
    }
    let mut seen = [!named; 2];
    let mut label = |stable: bool| {
        let first = !std::mem::replace(&mut seen[usize::from(stable)], true);
        let name = if stable { "stable" } else { "unstable" };
        if first { name } else { "" }
    };
    stretches.into_iter().map(|(stable, points)| Series::line(label(stable), look(stable), points)).collect()
}
