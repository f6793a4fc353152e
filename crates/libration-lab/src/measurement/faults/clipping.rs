//! Values that stay constant while the motion goes on: stuck, or clipped at the ends of the scale.

use super::steps::smallest_step;
use crate::statistics::count;

/// Rows with one value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plateau {
    /// The first row.
    pub first: usize,
    /// Number of rows.
    pub rows: usize,
    /// The value.
    pub value: f64,
}

/// Largest change, in steps of the scale, after a run of equal values at a turning point, with a margin: if r
/// ≥ 3 rows are within one step of the top of a parabola, the next row is (1 + 2/r)² < 3 steps below it.
const STEPS_BESIDE_A_TURN: f64 = 5.0;

/// Difference of two values, in standard deviations of one, that errors exceed once in 6e7 times.
const BEYOND_CHANCE: f64 = 8.0;

/// Runs that a steady motion from the value before to the value after would have left, by more than steps of the scale and
/// noise of this standard deviation explain.
pub(super) fn stuck(values: &[f64], noise: f64) -> Vec<Plateau> {
    let chance = (2.0 * smallest_step(values).unwrap_or(0.0)).max(BEYOND_CHANCE * noise);
    let is_stuck = |run: &Plateau| {
        let Some((before, after)) = neighbours(values, run) else { return false };
        let goes_on = (before < run.value) == (run.value < after);
        let each = (after - before).abs() / count(run.rows + 1);
        run.rows > 1 && goes_on && each * count(run.rows - 1) > chance
    };
    runs(values).into_iter().filter(is_stuck).collect()
}

/// Runs of three rows or more at the largest or the smallest value which the motion enters and leaves fast.
pub fn clipped(values: &[f64]) -> Vec<Plateau> {
    let step = smallest_step(values).unwrap_or(0.0);
    let (low, high) = values.iter().fold((f64::MAX, f64::MIN), |(l, h), &v| (l.min(v), h.max(v)));
    let is_clipped = |run: &Plateau| {
        let Some((before, after)) = neighbours(values, run) else { return false };
        let least = (run.value - before).abs().min((run.value - after).abs());
        let is_an_end = run.value >= high || run.value <= low;
        run.rows > 2 && is_an_end && least > STEPS_BESIDE_A_TURN * step
    };
    runs(values).into_iter().filter(is_clipped).collect()
}

fn runs(values: &[f64]) -> Vec<Plateau> {
    let mut first = 0;
    let pieces = values.chunk_by(|a, b| a.total_cmp(b).is_eq());
    let run = |piece: &[f64]| {
        let run = Plateau { first, rows: piece.len(), value: piece[0] };
        first += piece.len();
        run
    };
    pieces.map(run).collect()
}

fn neighbours(values: &[f64], run: &Plateau) -> Option<(f64, f64)> {
    let before = run.first.checked_sub(1)?;
    Some((values[before], *values.get(run.first + run.rows)?))
}
