//! All even times that round to those written.
//!
//! Each written time bounds first + interval·place from both sides, so that the even times which round to all of them are a convex
//! polygon in the plane of first and interval. If rounding is all that happened each of its points is as likely as the others: its
//! centroid is the answer, its extent the uncertainty. Where it is empty, no equally spaced times round to those written. Of frames whose
//! rate is commensurate with the steps it is wide, and least squares would be sure of more than the times say.

use super::Grid;
use crate::statistics::{count, root_mean_square};

/// Additional error of times that have been rounded twice, in steps. With 0 times of two digits had no equally spaced ones; with 0.1 their interval
/// was seven times less certain.
const TWICE_ROUNDED: f64 = 0.01;

/// Equally spaced times, and the uncertainty of their interval, in seconds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EvenTimes {
    pub(super) first: f64,
    /// Interval between successive times.
    pub interval: f64,
    /// One standard deviation.
    pub interval_uncertainty: f64,
}

impl EvenTimes {
    /// Equally spaced times within these half steps of the times at these positions, if there are any.
    pub fn through(times: &[f64], numbers: &[usize], half_steps: &[f64]) -> Option<Self> {
        let (first, last) = (*times.first()?, *times.last()?);
        let span = count(*numbers.last()?);
        let chord = (last - first) / span;
        let widest = half_steps.iter().copied().fold(0.0, f64::max);
        if !(chord > 0.0 && chord.is_finite() && widest > 0.0) {
            return None;
        }
        // The line is within the widest half step of both ends: in units of it, about the chord, on places from 0 to 1.
        let mut polygon = vec![(-2.0, -4.0), (2.0, -4.0), (2.0, 4.0), (-2.0, 4.0)];
        for ((time, &number), half) in times.iter().zip(numbers).zip(half_steps) {
            let step = count(number);
            let (along, off) = (step / span, (time - chord.mul_add(step, first)) / widest);
            let half = (1.0 + TWICE_ROUNDED) * half / widest;
            polygon = below(&polygon, |(a, b)| along.mul_add(b, a) - off - half);
            polygon = below(&polygon, |(a, b)| off - along.mul_add(b, a) - half);
        }
        let (middle, deviation) = centroid(&polygon)?;
        let interval = chord + widest * middle.1 / span;
        Some(Self {
            first: first + widest * middle.0,
            interval,
            interval_uncertainty: widest * deviation / span,
        })
    }

    /// The grid, with the errors of the times as written.
    pub(super) fn grid(self, times: &[f64], numbers: &[usize]) -> Grid {
        let Self { first, interval, interval_uncertainty } = self;
        let errors =
            || numbers.iter().zip(times).map(|(&number, time)| interval.mul_add(count(number), first) - time);
        let rms_deviation = root_mean_square(errors());
        let largest_deviation = errors().fold(0.0, |largest: f64, error| largest.max(error.abs()));
        Grid {
            first,
            interval,
            interval_uncertainty,
            rms_deviation,
            largest_deviation,
            numbers: numbers.to_vec(),
        }
    }
}

type Vertex = (f64, f64);

/// The part of a convex polygon where this linear function is not above zero.
fn below(polygon: &[Vertex], height: impl Fn(Vertex) -> f64) -> Vec<Vertex> {
    let mut kept = Vec::with_capacity(polygon.len() + 1);
    for (index, &point) in polygon.iter().enumerate() {
        let next = polygon[(index + 1) % polygon.len()];
        let (here, there) = (height(point), height(next));
        if here <= 0.0 {
            kept.push(point);
        }
        if (here < 0.0 && there > 0.0) || (here > 0.0 && there < 0.0) {
            let part = here / (here - there);
            kept.push((part.mul_add(next.0 - point.0, point.0), part.mul_add(next.1 - point.1, point.1)));
        }
    }
    kept
}

/// The centroid of a convex polygon, and the standard deviation of its second coordinate.
pub fn centroid(polygon: &[Vertex]) -> Option<(Vertex, f64)> {
    let origin = *polygon.first()?;
    let (mut area, mut sums, mut squares) = (0.0, (0.0, 0.0), 0.0);
    for pair in polygon[1..].windows(2) {
        let [p, q] = [pair[0], pair[1]].map(|(a, b)| (a - origin.0, b - origin.1));
        let triangle = 0.5 * (p.0 * q.1 - q.0 * p.1);
        area += triangle;
        sums = (sums.0 + triangle * (p.0 + q.0) / 3.0, sums.1 + triangle * (p.1 + q.1) / 3.0);
        squares += triangle * (p.1 * p.1 + p.1 * q.1 + q.1 * q.1) / 6.0;
    }
    if area <= 0.0 {
        return None;
    }
    let (a, b) = (sums.0 / area, sums.1 / area);
    Some(((origin.0 + a, origin.1 + b), (squares / area - b * b).max(0.0).sqrt()))
}
