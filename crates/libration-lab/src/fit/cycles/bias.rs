//! The bias of measured cycles: the effect of damping on a period in second order, and the error of the local fits.
//!
//! A half swing that loses the part p of its amplitude lasts longer than the exact law gives for its extreme by a part of the order p²:
//! for small amplitudes p²/2π² under linear damping, more under dry friction, whose two equilibria lie on both sides of the centre
//! that is passed. No closed form holds at all amplitudes for all kinds of damping together, and none includes the error of the local
//! fits. Both are measured instead: on simulated cycles of a pendulum that obeys the exact law with the damping of the
//! envelope, sampled with the same number of rows and measured by the same local fits.

use libration::internals::InOrder;
use std::f64::consts::TAU;

use super::cycle_landmarks::CycleLandmarks;
use super::envelope::EnvelopeFit;
use super::landmarks::landmarks;
use super::row::CycleRow;
use super::shape::LARGEST_AMPLITUDE;
use super::swings::swings;
use crate::fit::damped_pendulum::{equation, symbol};
use crate::measurement::{Observable, Trace};
use crate::statistics::mean;
use libration::internals::progress::Watch;
use libration::pendulum::period_ratio;
use libration::progress::Quiet;
use libration::taylor::{Effort, Moment, Solution, System, Trajectory, integrate_many};

/// Simulated swings, from the largest to the smallest amplitude.
const NODES: u32 = 12;
/// Number of cycles of each simulated swing. The first and the last that are measured do not count: beyond their passages no extreme is known.
const CYCLES: f64 = 6.0;
/// The most rows in a simulated period: with more the local fits have no error.
const MOST_ROWS: f64 = 100.0;
/// The relative error of a step of the integration, far below the noise of any instrument.
const TOLERANCE: f64 = 1e-12;

/// The measurement that is simulated.
#[derive(Clone, Copy)]
pub(super) struct SimulatedMeasurement {
    pub(super) observable: Observable,
    /// The angular frequency of small swings, in rad/s.
    pub(super) omega0: f64,
    /// The number of rows in the period of the longest swings.
    pub(super) rows_per_period: f64,
    /// The standard deviation of a value.
    pub(super) noise: f64,
}

/// The part of T0 by which measured periods are longer than those of the exact law, at some amplitudes in radians, which increase.
#[derive(Clone, Debug)]
pub(super) struct Bias(Vec<(f64, f64)>);

impl Bias {
    /// Measures the bias between the smallest and the largest amplitude with this damping; `None` if it cannot be measured.
    pub(super) fn new(
        apparatus: SimulatedMeasurement,
        damping: &EnvelopeFit,
        [smallest, largest]: [f64; 2],
        watch: &Watch<'_>,
    ) -> Option<Self> {
        let parts = (0..NODES).map(|k| f64::from(k) / f64::from(NODES - 1));
        let starts: Vec<(f64, Vec<f64>)> = parts
            .map(|part| {
                let amplitude = smallest * libm::pow(largest / smallest, part);
                let amplitude = amplitude.min(LARGEST_AMPLITUDE);
                (amplitude, apparatus.times(amplitude, part))
            })
            .collect();
        let motions = apparatus.motions(damping, &starts)?;
        let measured = motions.into_iter().zip(&starts).filter_map(|(motion, (_, times))| {
            watch.go_on().ok()?;
            apparatus.measured(times, &motion, watch)
        });
        let mut nodes: Vec<(f64, f64)> = measured.flatten().collect();
        nodes.put_in_order(|a, b| a.0.total_cmp(&b.0));
        nodes.dedup_by(|a, b| a.0 <= b.0);
        (nodes.len() > 1).then_some(Self(nodes))
    }

    /// Returns the row without its bias.
    pub(super) fn removed_from(&self, row: &CycleRow, omega0: f64) -> CycleRow {
        CycleRow { period: row.period - TAU / omega0 * self.at(row.amplitude()), ..row.clone() }
    }

    /// The bias on the line through the two nodes about this amplitude, or at this end.
    fn at(&self, amplitude: f64) -> f64 {
        let nodes = &self.0;
        let after = nodes.partition_point(|node| node.0 < amplitude).clamp(1, nodes.len() - 1);
        let [before, after] = [nodes[after - 1], nodes[after]];
        before.1 + (after.1 - before.1) * (amplitude - before.0) / (after.0 - before.0)
    }
}

impl SimulatedMeasurement {
    /// The times of the rows: the release, and then a row in each step, the first at this fraction of a step. A half period has a whole number of
    /// steps, so that passages of one swing have the same error: errors that differ between passages of a measured trace cancel in the sum of many.
    fn times(&self, amplitude: f64, part: f64) -> Vec<f64> {
        let period = TAU / self.omega0 * period_ratio(amplitude);
        let step = 0.5 * period / libm::round(0.5 * self.rows_per_period.min(MOST_ROWS));
        let later = std::iter::successors(Some(part.max(0.1)), |row| Some(row + 1.0));
        let rows = later.take_while(|row| row * step < CYCLES * period);
        std::iter::once(0.0).chain(rows.map(|row| row * step)).collect()
    }

    /// Releases from these amplitudes, at these times.
    fn motions(&self, damping: &EnvelopeFit, starts: &[(f64, Vec<f64>)]) -> Option<Vec<Solution>> {
        let terms = damping.damping;
        let names: Vec<&str> = std::iter::once("k").chain(terms.iter().map(symbol)).collect();
        let system = System::with_parameters(&equation(terms), &names).ok()?;
        let coefficients = damping.coefficients.iter().map(|coefficient| coefficient.estimate.value);
        let parameters: Vec<f64> = std::iter::once(self.omega0 * self.omega0).chain(coefficients).collect();
        let released = starts.iter().map(|(amplitude, times)| Trajectory {
            start: Moment { time: 0.0, state: vec![*amplitude, 0.0] },
            parameters: parameters.clone(),
            times,
        });
        let trajectories: Vec<Trajectory<'_>> = released.collect();
        integrate_many(&system, &trajectories, &Effort::to_tolerance(TOLERANCE), &Quiet)
            .into_iter()
            .collect::<Result<_, _>>()
            .ok()
    }

    /// The mean amplitudes and the mean biases of the cycles of like amplitudes in these values.
    fn measured(&self, times: &[f64], motion: &Solution, watch: &Watch<'_>) -> Option<Vec<(f64, f64)>> {
        let component = usize::from(self.observable == Observable::AngularVelocity);
        let values = motion.samples.iter().map(|sample| sample.state[component]).collect();
        let trace = Trace::new("simulated", self.observable, times.to_vec(), values, None).ok()?;
        let swings = swings(&trace).ok()?;
        let marks = landmarks(&trace, swings.stretches.first()?, Some(self.noise), watch)?;
        let landmarks = CycleLandmarks::new(&[marks], 1.0);
        let rows = landmarks.rows(&landmarks.half_swings(self.observable, self.omega0));
        let inner = rows.get(1..rows.len().saturating_sub(1))?;
        Some(like_amplitudes(inner).filter_map(|cycles| self.mean_bias(cycles)).collect())
    }

    /// The mean amplitude and the mean bias of these cycles.
    fn mean_bias(&self, cycles: &[CycleRow]) -> Option<(f64, f64)> {
        let t0 = TAU / self.omega0;
        let of = |value: &dyn Fn(&CycleRow) -> f64| mean(cycles.iter().map(value));
        let bias = of(&|row| row.period / t0 - row.ratio);
        bias.is_finite().then(|| (of(&CycleRow::amplitude), bias))
    }
}

/// Consecutive cycles in groups of almost the same amplitude. Under dry friction the bias is inverse to the square of the amplitude: its mean over
/// cycles whose amplitudes fall to a half is an eighth above that at the mean of the amplitudes.
fn like_amplitudes(mut cycles: &[CycleRow]) -> impl Iterator<Item = &[CycleRow]> {
    /// Largest difference from the first of a group, relative to it: the mean over such a fall is 7e-4 of the bias above that at the mean.
    const ALIKE: f64 = 0.05;
    std::iter::from_fn(move || {
        let first = cycles.first()?.amplitude();
        let is_alike = |row: &&CycleRow| (row.amplitude() - first).abs() <= ALIKE * first;
        let (group, later) = cycles.split_at(cycles.iter().take_while(is_alike).count().max(1));
        cycles = later;
        Some(group)
    })
}
