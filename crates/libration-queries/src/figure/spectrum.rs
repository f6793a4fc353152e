//! The harmonics of a motion: |aₙ| against n.

use super::chart::{Axis, Panel, Picture, Series, Units};
use super::range::around;
use super::style;
use libration::pendulum::{FourierSeries, FourierTerm};

/// The spectra of several amplitudes, each with its label, down to `lowest` (rad).
pub(crate) fn spectra(spectra: &[(String, FourierSeries)], lowest: f64) -> Picture {
    let terms = |harmonics| coefficients(harmonics, |term| term.angle, lowest);
    let series = spectra.iter().enumerate();
    let series = series.flat_map(|(number, (label, harmonics))| marked(number, label, terms(harmonics)));
    let y = Axis::logarithmic("coefficient |aₙ| / rad", lowest, 10.0);
    Picture::new("Harmonics of the angle", vec![panel(y, series.collect())])
}

/// The harmonics of the angle and of the angular velocity of one motion.
pub(crate) fn of_motion(harmonics: &FourierSeries) -> Picture {
    type Coefficient = fn(&FourierTerm) -> f64;
    let kinds: [(_, Coefficient); 2] =
        [("angle / rad", |term| term.angle), ("velocity / (rad/s)", |term| term.velocity)];
    let series = kinds.iter().enumerate().flat_map(|(number, (label, coefficient))| {
        marked(number, label, coefficients(harmonics, *coefficient, f64::MIN_POSITIVE))
    });
    let series: Vec<Series> = series.collect();
    let points = series.iter().flat_map(|series| &series.points);
    let (low, high) = around(points.map(|point| point.y.log10()));
    let y = Axis::logarithmic("absolute value of the coefficient", 10_f64.powf(low), 10_f64.powf(high));
    Picture::new("Harmonics of the motion", vec![panel(y, series)])
}

/// The coefficients that are at least this large, against their numbers.
fn coefficients(
    harmonics: &FourierSeries,
    coefficient: impl Fn(&FourierTerm) -> f64,
    lowest: f64,
) -> Vec<(f64, f64)> {
    let terms = harmonics.terms.iter().map(|term| (order(term.n), coefficient(term).abs()));
    terms.filter(|(_, a)| *a >= lowest).collect()
}

fn marked(number: usize, label: &str, points: Vec<(f64, f64)>) -> [Series; 2] {
    let line = Series::line("", style::thin(number), points.clone());
    [line, Series::line(label, style::markers(number), points)]
}

fn panel(y: Axis, series: Vec<Series>) -> Panel {
    let last = series.iter().flat_map(|series| &series.points).map(|point| point.x).fold(1.0, f64::max);
    let x = Axis::linear("harmonic n", 0.0, last + 1.0).in_units(Units::Whole);
    Panel { x, y, series, share: 1.0 }
}

fn order(n: usize) -> f64 {
    u32::try_from(n).map_or(f64::INFINITY, f64::from)
}
