//! Passages and extremes of all stretches of a trace together.

use std::f64::consts::PI;

use super::HalfSwing;
use super::landmarks::Landmarks;
use super::passage::CentrePassage;
use super::row::{CycleRow, Side};
use super::shape::{amplitude_of_velocity, slope_of_amplitude};
use super::turning_point::Extreme;
use crate::fit::uncertain::Uncertain;
use crate::measurement::Observable;
use crate::statistics::median;

/// Number of standard deviations of a value below which extremes are left out. With 8 all recordings (`mod.rs`) had the same cycles; with 2 the
/// noisiest, a swing of three standard deviations, had 25 instead of none.
const FAINTEST: f64 = 4.0;

impl Landmarks {
    pub(super) fn period(&self) -> Option<f64> {
        let periods = self.passages.windows(3).filter_map(|three| Some(three[2]?.time - three[0]?.time));
        median(periods.collect())
    }
}

/// Passages and extremes of all stretches, numbered through.
#[derive(Default)]
pub(super) struct CycleLandmarks {
    passages: Vec<Option<CentrePassage>>,
    extremes: Vec<Option<Extreme>>,
    /// Numbers of the first passage and of the first extreme of each possible cycle.
    pub(super) cycles: Vec<(usize, usize)>,
}

impl CycleLandmarks {
    /// The passages and extremes of stretches whose noise is in units of these uncertainties of the rows.
    pub(super) fn new(stretches: &[Landmarks], uncertainty: f64) -> Self {
        let mut landmarks = Self::default();
        for stretch in stretches {
            let (passage, extreme) = (landmarks.passages.len(), landmarks.extremes.len());
            let cycles = stretch.passages.len().saturating_sub(2);
            landmarks.cycles.extend((0..cycles).map(|k| (passage + k, extreme + k)));
            landmarks.passages.extend(&stretch.passages);
            let bright = |extreme: &Extreme| extreme.value.abs() >= FAINTEST * stretch.noise * uncertainty;
            landmarks.extremes.extend(stretch.extremes.iter().map(|extreme| extreme.filter(bright)));
        }
        landmarks
    }

    /// The half swings by number, where they are known and do not lead over the top.
    pub(super) fn half_swings(&self, observable: Observable, omega0: f64) -> Vec<Option<HalfSwing>> {
        let half_swing = |extreme: &Extreme| {
            let (time, size) = (extreme.time, extreme.value.abs());
            let (amplitude, slope) = match observable {
                Observable::Angle => (size, 1.0),
                Observable::AngularVelocity => {
                    let amplitude = amplitude_of_velocity(size, omega0)?;
                    (amplitude, slope_of_amplitude(amplitude, omega0))
                }
            };
            let amplitude = Uncertain { value: amplitude, uncertainty: slope * extreme.uncertainty };
            (amplitude.value < PI).then_some(HalfSwing { time, amplitude })
        };
        self.extremes.iter().map(|extreme| half_swing(extreme.as_ref()?)).collect()
    }

    /// The cycles that are complete.
    pub(super) fn rows(&self, half_swings: &[Option<HalfSwing>]) -> Vec<CycleRow> {
        let row = |&(passage, extreme): &(usize, usize)| {
            let ends = [passage, passage + 2].map(|k| self.passages[k].map(|passage| (k, passage)));
            let sides = [extreme, extreme + 1].map(|k| half_swings[k].map(|half_swing| (k, half_swing)));
            let ([Some(begin), Some(end)], [Some(one), Some(two)]) = (ends, sides) else { return None };
            let square = |x: f64| x * x;
            Some(CycleRow::new(
                [begin.1.time, end.1.time],
                [begin, end].map(|(k, passage)| (k, square(passage.uncertainty))),
                [one, two].map(|(k, side)| Side::new(k, side.amplitude)),
            ))
        };
        self.cycles.iter().filter_map(row).collect()
    }
}
