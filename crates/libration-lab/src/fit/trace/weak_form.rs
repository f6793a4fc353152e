//! ω0, the offset and the first state from a trace without any integration of the motion, good enough for a start.
//!
//! The equation of motion times a function φ that vanishes smoothly at the ends of a window, integrated by parts, has no
//! derivatives of the measured values: ∫φ″θ = −k cos o·∫φ sin θ + k sin o·∫φ cos θ + b·∫φ′θ, with k = ω0² and the offset o.
//! It is linear in k cos o, k sin o and b, holds at any amplitude, over the top too, and needs no guess.

use std::f64::consts::PI;

use libration::internals::progress::Watch;
use libration::pendulum::period_ratio;
use libration::progress::Quiet;
use nalgebra::{DMatrix, DVector};

use super::sine::{Sine, sine};
use crate::measurement::{Observable, Trace};
use crate::parallel;
use crate::statistics::count;
use crate::statistics::median;
use crate::statistics::{least_squares, weighted_least_squares};

/// Start of a fit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Beginning {
    pub(super) omega0: f64,
    /// Offset of the measured quantity: an angle, or an angular velocity.
    pub(super) offset: f64,
    /// The first angle from the bottom, and the first velocity.
    pub(super) state: [f64; 2],
}

/// A row with the sine and cosine of its angle.
#[derive(Clone, Copy, Debug)]
struct Sample {
    time: f64,
    angle: f64,
    sine: f64,
    cosine: f64,
}

/// Estimate by windows of one length.
#[derive(Clone, Copy, Debug)]
struct WindowEstimate {
    omega0: f64,
    offset: f64,
    /// Residual of the equation in the median window, relative to its terms and to the root of the number of windows.
    misfit: f64,
}

/// Computes the start, by windows of the length at which the equation holds best, or by a sine where there are too few windows of each length; `None`
/// if neither describes the trace.
pub(super) fn beginning(trace: &Trace) -> Option<Beginning> {
    let times = trace.times();
    let (angles, bias) = match trace.observable() {
        Observable::Angle => (trace.values().to_vec(), None),
        Observable::AngularVelocity => integrated(times, trace.values()),
    };
    let Some(estimate) = best_estimate(times, &angles) else { return by_sine(trace) };
    let turns = libm::round((median(angles.clone())? - estimate.offset) / (2.0 * PI));
    let offset = estimate.offset + 2.0 * PI * turns;
    let [angle, velocity] = first_state(times, &angles, estimate.omega0)?;
    Some(Beginning {
        omega0: estimate.omega0,
        offset: bias.unwrap_or(offset),
        state: [angle - offset, velocity],
    })
}

/// The start by a sine of the angle or of the velocity, whose frequency is that of an undamped swing of its amplitude.
fn by_sine(trace: &Trace) -> Option<Beginning> {
    let Sine { frequency, constant, state: [value, rate] } = sine(trace.times(), trace.values())?;
    let state = match trace.observable() {
        Observable::Angle => [value, rate],
        Observable::AngularVelocity => [-rate / (frequency * frequency), value],
    };
    // The amplitude of the first harmonic tends to 4 for swings to the top; with 2.0 and 3.1 in place of 3.0 all of 436 traces ended alike.
    let amplitude = libm::hypot(state[0], state[1] / frequency).min(3.0);
    Some(Beginning { omega0: frequency * period_ratio(amplitude), offset: constant, state })
}

/// Least number of windows for a reliable residual of the equation. With 6 and 24 twelve recordings (`search.rs`) ended
/// alike.
const LEAST_WINDOWS: usize = 12;

/// Tries window lengths from a few samples to the whole trace: in short ones noise prevails, in long ones φ averages
/// the signal away.
fn best_estimate(times: &[f64], angles: &[f64]) -> Option<WindowEstimate> {
    let span = times.last()? - times.first()?;
    let interval = median(times.windows(2).map(|pair| pair[1] - pair[0]).collect())?;
    let sample = |(&time, &angle): (&f64, &f64)| {
        let (sine, cosine) = libm::sincos(angle);
        Sample { time, angle, sine, cosine }
    };
    let samples: Vec<Sample> = times.iter().zip(angles).map(sample).collect();
    // Rows before which others are missing.
    let is_late = |&row: &usize| times[row] - times[row - 1] > 3.0 * interval;
    let gaps: Vec<usize> = (1..times.len()).filter(is_late).collect();
    let first = Some(8.0 * interval).filter(|half| *half > 0.0);
    let halves =
        std::iter::successors(first, |half| Some(1.25 * half)).take_while(|half| *half <= 0.5 * span);
    let halves: Vec<f64> = halves.collect();
    let estimates = parallel::map(&halves, &Watch::new(&Quiet), |&half, _| estimate(&samples, &gaps, half));
    let estimates = estimates.into_iter().flatten();
    estimates.min_by(|a, b| a.misfit.total_cmp(&b.misfit))
}

fn estimate(samples: &[Sample], gaps: &[usize], half: f64) -> Option<WindowEstimate> {
    let (begin, end) = (samples.first()?.time, samples.last()?.time);
    let mut rows = vec![];
    let mut centre = begin + half;
    while centre + half <= end {
        rows.extend(window(samples, gaps, centre, half));
        centre += 0.5 * half;
    }
    if rows.len() < LEAST_WINDOWS {
        return None;
    }
    let mut weights = vec![1.0; rows.len()];
    let (mut solution, mut scale) = (DVector::zeros(3), 0.0);
    // Windows with outliers are down-weighted by the size of their residuals.
    for _ in 0..6 {
        let matrix = DMatrix::from_fn(rows.len(), 3, |i, k| rows[i][k + 1]);
        let values = DVector::from_fn(rows.len(), |i, _| rows[i][0]);
        solution = weighted_least_squares(matrix, values, &weights).ok()?.coefficients;
        let explained = |row: &[f64; 4]| row[1..].iter().zip(&solution).map(|(x, p)| x * p).sum::<f64>();
        let residuals: Vec<f64> = rows.iter().map(|row| (row[0] - explained(row)).abs()).collect();
        scale = median(residuals.clone())?;
        weights =
            residuals.iter().map(|r| if *r > 2.0 * scale { (2.0 * scale / r).sqrt() } else { 1.0 }).collect();
    }
    let size = (rows.iter().map(|row| row[0] * row[0]).sum::<f64>() / count(rows.len())).sqrt();
    let misfit = scale / size / count(rows.len() - 3).sqrt();
    let omega0 = libm::hypot(solution[0], solution[1]).sqrt();
    let offset = libm::atan2(solution[1], solution[0]);
    (omega0 > 0.0 && misfit.is_finite()).then_some(WindowEstimate { omega0, offset, misfit })
}

/// ∫φ″θ, −∫φ sin θ, ∫φ cos θ and ∫φ′θ over a window without gaps, with φ = (1 − u²)³.
fn window(samples: &[Sample], gaps: &[usize], centre: f64, half: f64) -> Option<[f64; 4]> {
    let first = samples.partition_point(|sample| sample.time < centre - half);
    let last = samples.partition_point(|sample| sample.time <= centre + half);
    let samples = &samples[first..last];
    let next_gap = gaps.get(gaps.partition_point(|&row| row <= first));
    if samples.len() < 6 || next_gap.is_some_and(|&row| row < last) {
        return None;
    }
    // A constant has no part in ∫φ″θ and ∫φ′θ, but in their sums.
    let mean = samples.iter().map(|sample| sample.angle).sum::<f64>() / count(samples.len());
    let terms = |sample: &Sample| {
        let u = (sample.time - centre) / half;
        let v = 1.0 - u * u;
        let second = (24.0 * u * u - 6.0 * v) * v / (half * half);
        let deviation = sample.angle - mean;
        let cube = v * v * v;
        [second * deviation, -cube * sample.sine, cube * sample.cosine, -6.0 * u * v * v / half * deviation]
    };
    // Integration by the trapezoidal rule.
    let (mut sums, mut before) = ([0.0; 4], terms(&samples[0]));
    for pair in samples.windows(2) {
        let after = terms(&pair[1]);
        let length = pair[1].time - pair[0].time;
        for ((sum, before), after) in sums.iter_mut().zip(before).zip(after) {
            *sum += 0.5 * (before + after) * length;
        }
        before = after;
    }
    Some(sums)
}

/// The angles of angular velocities, up to a constant, and the measured velocity at rest: the mean over whole cycles, from the first turning point
/// on one side, where the velocity crosses its mean, to the last one on the same side. The amplitude falls, so that the mean for one side deviates
/// upwards and that for the other downwards: their average does not.
fn integrated(times: &[f64], velocities: &[f64]) -> (Vec<f64>, Option<f64>) {
    let mean = |from: usize, to: usize| {
        integral(&times[from..=to], &velocities[from..=to]) / (times[to] - times[from]).max(f64::MIN_POSITIVE)
    };
    let whole = mean(0, times.len() - 1);
    let over_cycles = |rising: bool| {
        let crosses = |row: &usize| {
            let [before, after] = [velocities[row - 1] >= whole, velocities[*row] >= whole];
            before != after && after == rising
        };
        let mut crossings = (1..times.len()).filter(crosses);
        Some(mean(crossings.next()?, crossings.next_back()?))
    };
    let bias = match [true, false].map(over_cycles) {
        [Some(up), Some(down)] => 0.5 * (up + down),
        [Some(one), None] | [None, Some(one)] => one,
        [None, None] => whole,
    };
    let mut angle = 0.0;
    let mut angles = vec![0.0];
    for i in 1..times.len() {
        angle += (0.5 * (velocities[i - 1] + velocities[i]) - bias) * (times[i] - times[i - 1]);
        angles.push(angle);
    }
    (angles, Some(bias))
}

/// Integral of samples, by the trapezoidal rule.
fn integral(times: &[f64], values: &[f64]) -> f64 {
    let pairs = times.windows(2).zip(values.windows(2));
    pairs.map(|(time, value)| 0.5 * (value[0] + value[1]) * (time[1] - time[0])).sum()
}

/// The angle and its slope at the first time, from a parabola through the rows of the first 0.6 radians of phase.
fn first_state(times: &[f64], angles: &[f64], omega0: f64) -> Option<[f64; 2]> {
    let near = times.partition_point(|&time| (time - times[0]) * omega0 < 0.6).clamp(4, times.len().max(4));
    let since: Vec<f64> = times.get(..near)?.iter().map(|time| time - times[0]).collect();
    let columns = [
        DVector::repeat(near, 1.0),
        DVector::from_fn(near, |i, _| since[i]),
        DVector::from_fn(near, |i, _| since[i] * since[i]),
    ];
    let values = DVector::from_row_slice(angles.get(..near)?);
    let parabola = least_squares(&DMatrix::from_columns(&columns), &values).ok()?.coefficients;
    Some([parabola[0], parabola[1]])
}
