//! Several motions of a system in one picture: against time, one state component against another, or their spectra.

use super::chart::{Axis, Panel, Picture, Series};
use super::names::subject;
use super::section::StateAxis;
use super::style;
use libration::spectrum::Spectrum;
use libration::systems::Model;

/// Points of a curve of a spectrum, which is drawn by its peaks.
const MOST_POINTS: usize = 3000;

/// The states of a motion at evenly spaced times.
#[derive(Clone, Debug)]
pub(crate) struct Sampled {
    pub(crate) label: String,
    pub(crate) times: Vec<f64>,
    pub(crate) states: Vec<Vec<f64>>,
}

impl Sampled {
    fn values<'a>(&'a self, shown: &StateAxis) -> impl Iterator<Item = f64> + use<'a> {
        let component = shown.component;
        self.states.iter().map(move |state| state[component])
    }
}

/// One number of the state against time.
pub(crate) fn against_time(model: &Model, motions: &[Sampled], shown: &StateAxis) -> Picture {
    let (from, to) = ends(motions.iter().flat_map(|motion| motion.times.iter().copied()));
    let series = curves(motions, |motion| motion.times.iter().copied().zip(motion.values(shown)).collect());
    let y = shown.unfolded_axis(motions.iter().flat_map(|motion| motion.values(shown)));
    let panel = Panel { x: Axis::linear("time t / s", from, to), y, series, share: 1.0 };
    Picture::new(&format!("Motion of {}", subject(model)), vec![panel])
}

/// One state component against another.
pub(crate) fn in_plane(model: &Model, motions: &[Sampled], [across, up]: &[StateAxis; 2]) -> Picture {
    let series = curves(motions, |motion| motion.values(across).zip(motion.values(up)).collect());
    let axis =
        |shown: &StateAxis| shown.unfolded_axis(motions.iter().flat_map(|motion| motion.values(shown)));
    let panel = Panel { x: axis(across), y: axis(up), series, share: 1.0 };
    let title = format!("Motion of {}: {} against {}", subject(model), up.name(), across.name());
    Picture { aspect: 0.8, ..Picture::new(&title, vec![panel]) }
}

/// Spectra of one state component, from zero frequency to the one at which all have fallen to the level of the flanks of a line.
pub(crate) fn spectra(model: &Model, spectra: &[(String, Spectrum)], shown: &StateAxis) -> Picture {
    let points = || spectra.iter().flat_map(|(_, spectrum)| spectrum.points());
    let highest = points().map(|(_, amplitude)| amplitude).fold(0.0, f64::max);
    // Nothing moves where all of it is zero.
    let highest = if highest > 0.0 { highest } else { 1.0 };
    let lowest = highest * Spectrum::SIDE_LOBES;
    let last = points().filter(|(_, amplitude)| *amplitude > 2.0 * lowest).map(|(frequency, _)| frequency);
    let widths = spectra.iter().map(|(_, spectrum)| spectrum.resolution());
    let last = 1.1 * last.chain(widths).fold(0.0, f64::max);
    let curve = |(number, (label, spectrum)): (usize, &(String, Spectrum))| {
        Series::line(label, style::curve(number), peaks(spectrum, last, 1e-3 * lowest))
    };
    let series = spectra.iter().enumerate().map(curve).collect();
    let panel = Panel {
        x: Axis::linear("angular frequency ω / (rad/s)", 0.0, last),
        y: Axis::logarithmic(&format!("amplitude of {}", shown.label()), lowest, 3.0 * highest),
        series,
        share: 1.0,
    };
    let title = format!("Spectrum of {}: {}", subject(model), shown.name());
    Picture::new(&title, vec![panel])
}

/// The points up to a frequency, of neighbours that are too many only the largest; a logarithmic axis has no zero.
fn peaks(spectrum: &Spectrum, last: f64, lowest: f64) -> Vec<(f64, f64)> {
    let points: Vec<(f64, f64)> = spectrum.points().take_while(|(frequency, _)| *frequency <= last).collect();
    let higher = |a: (f64, f64), b: &(f64, f64)| if b.1 > a.1 { *b } else { a };
    let neighbours = points.len().div_ceil(MOST_POINTS).max(1);
    let peaks = points.chunks(neighbours).map(|some| some[1..].iter().fold(some[0], higher));
    peaks.map(|(frequency, amplitude)| (frequency, amplitude.max(lowest))).collect()
}

fn curves(motions: &[Sampled], points: impl Fn(&Sampled) -> Vec<(f64, f64)>) -> Vec<Series> {
    let numbered = motions.iter().enumerate();
    numbered
        .map(|(number, motion)| Series::line(&motion.label, style::curve(number), points(motion)))
        .collect()
}

fn ends(values: impl Iterator<Item = f64>) -> (f64, f64) {
    values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| (low.min(value), high.max(value)))
}
