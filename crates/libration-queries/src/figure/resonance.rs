//! Amplitudes of modes in time: by the slow flow as lines, as the whole motion has them as dots.

use super::chart::{Axis, Panel, Picture, Series};
use super::names::subject;
use super::parameters::{AngleUnit, of_model, of_start};
use super::style;
use crate::output::number::count;
use libration::algebra::Complex;
use libration::systems::Model;

/// The content of the picture.
pub(crate) struct ModeAmplitudes<'a> {
    pub(crate) model: &'a Model,
    pub(crate) initial: &'a [f64],
    /// Seconds between two positions.
    pub(crate) interval: f64,
    /// All amplitudes at each time, by the slow flow.
    pub(crate) slow: Vec<Vec<Complex>>,
    /// The same of the whole motion.
    pub(crate) seen: Vec<Vec<Complex>>,
}

/// Number of positions from one dot to the next.
const DOTS: usize = 4;

/// One line and one row of dots for each mode.
pub(crate) fn amplitudes(of: &ModeAmplitudes<'_>) -> Picture {
    let modes = of.slow.first().map_or(0, Vec::len);
    let places = |path: &[Vec<Complex>], mode: usize| -> Vec<(f64, f64)> {
        path.iter().enumerate().map(|(k, all)| (of.interval * count(k), all[mode].abs())).collect()
    };
    let mut series = vec![];
    for mode in 0..modes {
        let line = places(&of.slow, mode);
        series.push(Series::line(&format!("mode {}, slow flow", mode + 1), style::curve(mode), line));
        let dots = places(&of.seen, mode).into_iter().step_by(DOTS);
        series.push(Series::line(&format!("mode {}, whole motion", mode + 1), style::markers(mode), dots));
    }
    let top = series.iter().flat_map(|one| one.points.iter().map(|point| point.y)).fold(0.0, f64::max);
    let x = Axis::linear("time t / s", 0.0, of.interval * count(of.slow.len().saturating_sub(1)));
    let y = Axis::linear("amplitude |a|", 0.0, if top > 0.0 { 1.05 * top } else { 1.0 });
    let title = format!("Amplitudes of the modes of {}", subject(of.model));
    Picture::new(&title, vec![Panel { x, y, series, share: 1.0 }])
        .with_parameters([of_model(of.model), of_start(of.model, of.initial, AngleUnit::Degrees)].concat())
}
