//! Cycles between passages of the bottom as rows of the law, with the errors of the edges that they share.
//!
//! If the errors of two edges are independent and equally large, so are those of their middle and of their distance. The error of the middle is
//! one of the time of a passage; that of the distance is one of its amplitude, which counts in both half swings next to the passage.

use super::amplitudes::Amplitudes;
use super::swings::OrderedPassages;
use crate::fit::cycles::row::{CycleRow, Share, Side, Source};
use crate::fit::law::Law;
use crate::fit::uncertain::Uncertain;

/// A passage of the bottom.
#[derive(Clone, Copy, Debug)]
struct Bottom {
    time: f64,
    /// Variance of the time.
    variance: f64,
    /// Amplitude of the swing, without the mean contribution of the curvature of the law of speeds.
    amplitude: f64,
    /// The standard deviation of the amplitude.
    noise: f64,
    /// The amplitude from the smooth course of the speeds, nearly independent of the error of this one: weights computed from it do not favour
    /// errors of one sign.
    smooth: f64,
}

impl OrderedPassages {
    /// Computes the cycles between passages of the bottom.
    pub(super) fn rows_by_speeds(&self, amplitudes: &Amplitudes) -> Option<Vec<CycleRow>> {
        let blocked = self.scatter(|passage| self.blocked(passage)).map_or(0.0, |scatter| scatter.deviation);
        let bottoms: Vec<Option<Bottom>> =
            (0..self.placed.len()).map(|passage| self.bottom(passage, amplitudes, blocked)).collect();
        let row = |&cycle: &usize| {
            let [first, between, last] = [0, 1, 2].map(|step| bottoms[cycle + step]);
            Some(row(cycle, [first?, between?, last?]))
        };
        Some(self.cycles.iter().filter_map(row).collect())
    }

    /// The passage of the bottom next to one of the gate, with this deviation of the times for which the gate is blocked.
    fn bottom(&self, passage: usize, amplitudes: &Amplitudes, deviation: f64) -> Option<Bottom> {
        let (amplitude, smooth) = (amplitudes.of_passages[passage]?, amplitudes.smooth[passage]?);
        // sin(A/2) goes with one over the time t: A′ = −2 tan(A/2)/t, and the mean of A is too large by half of A″ times the variance.
        let (tangent, part) = (libm::tan(0.5 * smooth), deviation / amplitudes.blocked[passage]);
        let excess = tangent * (2.0 + tangent * tangent) * part * part;
        let noise = 2.0 * tangent * part;
        // A clock without any scatter would give infinite weights.
        let variance = self.timing().map_or(0.0, |timing| timing * timing).max(1e-24);
        let time = self.time(passage) - amplitudes.from_bottom[passage];
        Some(Bottom { time, variance, amplitude: amplitude - excess, noise, smooth })
    }
}

/// Builds the cycle between the first and the last of three passages.
fn row(cycle: usize, bottoms: [Bottom; 3]) -> CycleRow {
    let half_swing = |k: usize| {
        let [one, two] = [bottoms[k], bottoms[k + 1]];
        let noise = 0.5 * libm::hypot(one.noise, two.noise);
        let smooth = 0.5 * (one.smooth + two.smooth);
        // The mean contribution of the law's curvature to T/T0, as an amplitude.
        let excess = 0.5 * noise * noise * curvature(smooth) / Law::exact().slope_at(smooth);
        let value = 0.5 * (one.amplitude + two.amplitude) - excess;
        let slope = 0.25 * Law::exact().slope_at(smooth);
        (Side::new(cycle + k, Uncertain { value, uncertainty: noise }), slope)
    };
    let [(one, before), (two, after)] = [0, 1].map(half_swing);
    let ends = [(0, -1.0), (2, 1.0)];
    let times = ends.map(|(k, of_period)| Share {
        source: Source::Passage(cycle + k),
        variance: bottoms[k].variance,
        of_period,
        of_ratio: 0.0,
    });
    let amplitudes = [before, before + after, after].into_iter().enumerate().map(|(k, of_ratio)| Share {
        source: Source::Amplitude(cycle + k),
        variance: bottoms[k].noise * bottoms[k].noise,
        of_period: 0.0,
        of_ratio,
    });
    let passages = ends.map(|(k, _)| (cycle + k, bottoms[k].variance));
    let row = CycleRow::new([bottoms[0].time, bottoms[2].time], passages, [one, two]);
    row.with_errors(times.into_iter().chain(amplitudes).collect())
}

/// The second derivative of T/T0 with respect to the amplitude.
fn curvature(amplitude: f64) -> f64 {
    /// Interval relative to the amplitude: the curvature enters a correction of second order, and a thousandth of it is enough.
    const STEP: f64 = 1e-2;
    let slope = |amplitude: f64| Law::exact().slope_at(amplitude);
    (slope(amplitude * (1.0 + STEP)) - slope(amplitude * (1.0 - STEP))) / (2.0 * STEP * amplitude)
}
