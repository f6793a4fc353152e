//! Uncertainty of T0, β, the offset and the damping caused by that of a fitted pivot.

use std::f64::consts::TAU;

use super::fall::Fall;
use super::{Cycles, Envelope, HalfSwing};
use libration::internals::progress::Watch;

/// Adds the difference from the results with the pivot moved by one standard deviation.
pub(super) fn add(cycles: &mut Cycles, moved: Cycles, watch: &Watch<'_>) {
    cycles.t0 = cycles.t0.with_error(moved.t0.value - cycles.t0.value);
    cycles.offset = cycles.offset.with_error(moved.offset.value - cycles.offset.value);
    if let (Ok(beta), Ok(moved)) = (&mut cycles.beta, &moved.beta) {
        *beta = beta.with_error(moved);
    }
    if let Ok(envelope) = &mut cycles.envelope {
        let t0 = moved.t0.value;
        let half_swings = paired(&cycles.half_swings, &moved.half_swings, 0.25 * t0);
        widen(envelope, Fall::new(&half_swings, TAU / t0, watch));
    }
    cycles.about_moved_pivot.push(moved.rows);
}

/// Adds to the coefficients of every law their change with this fall of the amplitude. Outliers and the weights of the other
/// extremes stay the same.
fn widen(envelope: &mut Envelope, moved: Fall<'_>) {
    let fall = Fall { weights: envelope.weights.clone(), ..moved };
    for fit in &mut envelope.fits {
        let Some(curve) = fall.fit(fit.damping) else { continue };
        for (coefficient, value) in fit.coefficients.iter_mut().zip(&curve.parameters[1..]) {
            coefficient.estimate = coefficient.estimate.with_error(value - coefficient.estimate.value);
        }
    }
}

/// For each half swing the one of `moved` at its time; the half swing itself if there is none. Both are in order of time.
fn paired(half_swings: &[HalfSwing], moved: &[HalfSwing], apart: f64) -> Vec<HalfSwing> {
    let distance = |one: &HalfSwing, other: &HalfSwing| (one.time - other.time).abs();
    let pair = |half_swing: &HalfSwing| {
        let after = moved.partition_point(|half| half.time < half_swing.time);
        let neighbours = &moved[after.saturating_sub(1)..moved.len().min(after + 1)];
        let nearest =
            neighbours.iter().min_by(|a, b| distance(half_swing, a).total_cmp(&distance(half_swing, b)));
        *nearest.filter(|nearest| distance(half_swing, nearest) < apart).unwrap_or(half_swing)
    };
    half_swings.iter().map(pair).collect()
}
