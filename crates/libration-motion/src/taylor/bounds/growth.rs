//! Growth of a small deviation of a motion from one moment to another.

use super::matrix::Matrix;
use crate::taylor::{Effort, IntegrationError, Moment, Solution, System, Trajectory, integrate_many};
use libration_numbers::progress::Quiet;

/// The derivatives of the state at each moment by that at the moment before, by differences of motions that begin a small distance apart: if a
/// force jumps, bends or brings to rest in between, it acts on these motions too. `None` if such a motion does not reach the later moment.
pub(in crate::taylor) fn growths(system: &System, moments: &[&Moment], apart: &[f64]) -> Option<Vec<Matrix>> {
    let times: Vec<f64> = moments.iter().map(|moment| moment.time).collect();
    let mut trajectories = vec![];
    for stretch in 0..moments.len().saturating_sub(1) {
        for (number, apart) in apart.iter().enumerate() {
            for by in [*apart, -apart] {
                let mut start = moments[stretch].clone();
                start.state[number] += by;
                let times = &times[stretch + 1..stretch + 2];
                trajectories.push(Trajectory { start, parameters: vec![], times });
            }
        }
    }
    let ends = integrate_many(system, &trajectories, &EFFORT, &Quiet);
    let pairs = trajectories.chunks(2).zip(ends.chunks(2)).enumerate();
    let columns = pairs.map(|(index, (from, to))| column(from, to, index % apart.len()));
    let columns: Vec<Vec<f64>> = columns.collect::<Option<_>>()?;
    Some(columns.chunks(apart.len().max(1)).map(transposed).collect())
}

/// Tolerances with which the errors of a motion are far below the distance of two motions.
const EFFORT: Effort = Effort { relative: 1e-13, absolute: 0.0, most_steps: 10_000 };

/// The distance of a neighbouring motion in a component of this size that covers
/// `way`: a small fraction of the distance covered, and far above the rounding errors.
pub(in crate::taylor) fn distance(way: f64, size: f64) -> f64 {
    let distance = libm::ldexp(way, -24) + libm::ldexp(size, -34);
    if distance > 0.0 { distance } else { libm::ldexp(1.0, -24) }
}

/// The distance in each component, for a motion that is known at several moments.
pub(in crate::taylor) fn distances(moments: &[&Moment]) -> Vec<f64> {
    let numbers = moments.first().map_or(0, |moment| moment.state.len());
    let of_number = |number: usize| {
        let values = || moments.iter().map(|moment| moment.state[number]);
        let way = values().zip(values().skip(1)).map(|(a, b)| (b - a).abs()).fold(0.0, f64::max);
        let size = values().map(f64::abs).fold(0.0, f64::max);
        distance(way, size)
    };
    (0..numbers).map(of_number).collect()
}

/// The derivatives by one component, from two motions on both sides.
fn column(
    from: &[Trajectory<'_>],
    to: &[Result<Solution, IntegrationError>],
    number: usize,
) -> Option<Vec<f64>> {
    let ([above, below], [Ok(end_above), Ok(end_below)]) = (from, to) else { return None };
    let apart = above.start.state[number] - below.start.state[number];
    let pairs = end_above.end.state.iter().zip(&end_below.end.state);
    Some(pairs.map(|(a, b)| (a - b) / apart).collect())
}

fn transposed(columns: &[Vec<f64>]) -> Matrix {
    let row = |row: usize| columns.iter().map(move |column| column[row]);
    Matrix { size: columns.len(), entries: (0..columns.len()).flat_map(row).collect() }
}
