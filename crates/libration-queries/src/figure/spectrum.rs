//! The harmonics of the angle: |aₙ| against n.

use super::chart::{Axis, Panel, Picture, Series, Units};
use super::style;
use libration::pendulum::FourierSeries;

/// The spectra of several amplitudes, each with its label, down to `lowest` (rad).
pub(crate) fn spectra(spectra: &[(String, FourierSeries)], lowest: f64) -> Picture {
    let points = |harmonics: &FourierSeries| -> Vec<(f64, f64)> {
        harmonics
            .terms
            .iter()
            .map(|term| (order(term.n), term.angle.abs()))
            .filter(|(_, a)| *a >= lowest)
            .collect()
    };
    let mut series = vec![];
    for (number, (label, harmonics)) in spectra.iter().enumerate() {
        let points = points(harmonics);
        series.push(Series::line("", style::thin(number), points.clone()));
        series.push(Series::line(label, style::markers(number), points));
    }
    let last = series.iter().flat_map(|series| &series.points).map(|point| point.x).fold(1.0, f64::max);
    let x = Axis::linear("harmonic n", 0.0, last + 1.0);
    let x = x.in_units(Units::Whole);
    let y = Axis::logarithmic("coefficient |aₙ| / rad", lowest, 10.0);
    Picture::new("Harmonics of the angle", vec![Panel { x, y, series, share: 1.0 }])
}

fn order(n: usize) -> f64 {
    u32::try_from(n).map_or(f64::INFINITY, f64::from)
}
