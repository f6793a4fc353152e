//! The errors of partial sums: against the amplitude, with the radius of convergence, or against the last power kept.

use super::chart::{Axis, Look, Panel, Picture, Series, Units};
use super::cusps::sizes;
use super::style;
use crate::output::number::short;

/// The name of a curve, the kind of approximation, and its signed errors.
pub(crate) struct ErrorCurve {
    pub(crate) label: String,
    pub(crate) family: &'static str,
    pub(crate) errors: Vec<(f64, f64)>,
}

/// The setting of the picture.
pub(crate) struct SeriesSetting {
    pub(crate) title: String,
    pub(crate) quantity: String,
    pub(crate) abscissa: Abscissa,
    pub(crate) lowest: f64,
    pub(crate) highest: f64,
}

/// The variable of the series.
pub(crate) struct Abscissa {
    pub(crate) symbol: String,
    pub(crate) name: &'static str,
    pub(crate) in_degrees: bool,
}

impl Abscissa {
    fn value(&self, amplitude: f64) -> f64 {
        if self.in_degrees { amplitude.to_degrees() } else { amplitude }
    }

    /// A value for the legend.
    pub(crate) fn shown(&self, amplitude: f64) -> String {
        let degrees = if self.in_degrees { "°" } else { "" };
        format!("{}{degrees}", short(self.value(amplitude), 4))
    }

    fn label(&self) -> String {
        let unit = if self.in_degrees { " / degrees" } else { "" };
        format!("{} {}{unit}", self.name, self.symbol)
    }
}

/// Errors against the amplitude in radians or in the oscillator's own unit.
pub(crate) fn against_amplitude(
    lines: &[ErrorCurve],
    radius: Option<(f64, &str)>,
    to: f64,
    setting: &SeriesSetting,
) -> Picture {
    let abscissa = &setting.abscissa;
    let looks = style::of_families(lines.iter().map(|line| line.family));
    let mut series: Vec<Series> =
        lines.iter().zip(looks).map(|(line, look)| curve(look, line, abscissa)).collect();
    if let Some((radius, label)) = radius {
        let ends = [setting.lowest, setting.highest].map(|error| (abscissa.value(radius), error));
        let label = format!("{label}, {}", abscissa.shown(radius));
        series.push(Series::line(&label, style::reference(), ends));
    }
    let x = Axis::linear(&abscissa.label(), 0.0, abscissa.value(to));
    let x = if abscissa.in_degrees { x.in_units(Units::Degrees) } else { x };
    picture(x, series, setting)
}

fn curve(look: Look, line: &ErrorCurve, abscissa: &Abscissa) -> Series {
    let errors: Vec<(f64, f64)> = line.errors.iter().map(|(x, error)| (abscissa.value(*x), *error)).collect();
    Series::line(&line.label, look, sizes(&errors))
}

/// Errors against the last power kept.
pub(crate) fn against_terms(lines: &[ErrorCurve], setting: &SeriesSetting) -> Picture {
    let mut series = vec![];
    for (number, line) in lines.iter().enumerate() {
        let points: Vec<(f64, f64)> =
            line.errors.iter().map(|(power, error)| (*power, error.abs())).collect();
        series.push(Series::line("", style::thin(number), points.clone()));
        series.push(Series::line(&line.label, style::markers(number), points));
    }
    let last = series.iter().flat_map(|series| &series.points).map(|point| point.x).fold(1.0, f64::max);
    let x = Axis::linear(&format!("highest power of {}", setting.abscissa.symbol), 0.0, last + 1.0);
    picture(x.in_units(Units::Whole), series, setting)
}

fn picture(x: Axis, series: Vec<Series>, setting: &SeriesSetting) -> Picture {
    let label = format!("|error of {}|", setting.quantity);
    let y = Axis::logarithmic(&label, setting.lowest, setting.highest);
    let title = format!("Partial sums of {}: {}", setting.quantity, setting.title);
    Picture::new(&title, vec![Panel { x, y, series, share: 1.0 }])
}
