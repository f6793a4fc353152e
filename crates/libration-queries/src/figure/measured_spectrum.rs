//! The spectrum of measured swings: amplitude against frequency, with the measured harmonics and those of the pendulum.

use super::chart::{Axis, Panel, Picture, Point, Series};
use super::style;
use libration_lab::fit::spectrum::{Harmonic, Spectrum};
use libration_lab::measurement::Observable;

/// The spectrum of a run.
#[derive(Debug)]
pub(crate) struct MeasuredSpectrum {
    pub(crate) name: String,
    pub(crate) spectrum: Spectrum,
}

/// The unit of harmonics, and the factor to it: angles are shown in degrees.
pub(crate) fn unit_scale(observable: Observable) -> (&'static str, f64) {
    match observable {
        Observable::Angle => ("rad", 1_f64.to_degrees()),
        Observable::AngularVelocity => ("rad/s", 1.0),
    }
}

/// A panel for each run.
pub(crate) fn measured_spectra(spectra: &[MeasuredSpectrum]) -> Picture {
    let last = spectra.len().saturating_sub(1);
    let panels =
        spectra.iter().enumerate().map(|(number, spectrum)| panel(spectrum, number == last, number == 0));
    Picture::new("Harmonics of measured swings", panels.collect())
}

fn panel(run: &MeasuredSpectrum, is_last: bool, is_first: bool) -> Panel {
    let Spectrum { points, harmonics, observable, frequency, .. } = &run.spectrum;
    let (_, scale) = unit_scale(*observable);
    let at = |harmonic: &Harmonic| frequency * crate::output::number::count(harmonic.n);
    let line = points.iter().map(|point| (point.frequency, scale * point.amplitude));
    let line: Vec<(f64, f64)> = line.filter(|(_, y)| *y > 0.0 && y.is_finite()).collect();
    let shown = || harmonics.iter().filter(|harmonic| harmonic.n > 0);
    let theory = shown().filter(|harmonic| harmonic.theory != 0.0);
    let theory: Vec<(f64, f64)> = theory.map(|theory| (at(theory), scale * theory.theory.abs())).collect();
    let point = |harmonic: &Harmonic| {
        let amplitude = harmonic.amplitude();
        let y_uncertainty = Some(scale * amplitude.uncertainty);
        Point { y_uncertainty, ..Point::new(at(harmonic), scale * amplitude.value) }
    };
    // What is lost in noise has no place on a logarithmic axis but its limit.
    let (measured, lost): (Vec<&Harmonic>, Vec<&Harmonic>) =
        shown().partition(|harmonic| harmonic.lag().is_some());
    let measured: Vec<Point> = measured.into_iter().map(point).collect();
    let limit = |harmonic: &Harmonic| {
        let amplitude = harmonic.amplitude();
        (at(harmonic), scale * (amplitude.value + 2.0 * amplitude.uncertainty))
    };
    let limits: Vec<(f64, f64)> = lost.into_iter().map(limit).collect();
    let of_points = measured.iter().map(|point| point.y);
    let heights: Vec<f64> =
        line.iter().chain(&theory).chain(&limits).map(|point| point.1).chain(of_points.clone()).collect();
    let top = heights.into_iter().fold(0.0, f64::max);
    // What theory has far below the noise would leave the spectrum little room.
    let bottom =
        line.iter().chain(&limits).map(|point| point.1).chain(of_points).fold(top, f64::min).max(1e-9 * top);
    let label = match observable {
        Observable::Angle => "amplitude / degrees",
        Observable::AngularVelocity => "amplitude / (rad/s)",
    };
    let y = Axis::logarithmic(label, decade(bottom, f64::floor), decade(top, f64::ceil));
    let right = line.iter().map(|point| point.0).fold(frequency * 1.5, f64::max);
    let x = Axis::linear("frequency / Hz", 0.0, right);
    let named = |name: &str| if is_first { name.to_owned() } else { String::new() };
    let kept = theory.into_iter().filter(|point| point.1 >= y.from);
    let of_pendulum = Series::line(&named("pendulum"), style::markers(1), kept);
    let spectrum = if run.name.is_empty() { named("spectrum") } else { format!("spectrum, {}", run.name) };
    let limits_name = if limits.is_empty() { String::new() } else { named("upper limit (2σ)") };
    let series = vec![
        Series::line(&spectrum, style::thin(0), line),
        of_pendulum,
        Series::line(&limits_name, style::markers(2), limits),
        Series { label: named("measured"), look: style::turning_points(measured.len()), points: measured },
    ];
    Panel { x: if is_last { x } else { x.unlabelled() }, y, series, share: 1.0 }
}

fn decade(value: f64, to: fn(f64) -> f64) -> f64 {
    10_f64.powf(to(value.log10()))
}
