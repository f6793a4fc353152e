//! What a pivot that was fitted to positions leaves open in T0, β, the offset and the damping: by how much they change with it.

use std::f64::consts::TAU;

use super::fall::Fall;
use super::{Cycles, Envelope, HalfSwing};

/// Adds the difference to what would be found with the pivot moved by one standard deviation.
pub(super) fn add(found: &mut Cycles, moved: Cycles) {
    found.t0 = found.t0.with_error(moved.t0.value - found.t0.value);
    found.offset = found.offset.with_error(moved.offset.value - found.offset.value);
    if let (Ok(beta), Ok(moved)) = (&mut found.beta, &moved.beta) {
        *beta = beta.with_error(moved);
    }
    if let Ok(envelope) = &mut found.envelope {
        let t0 = moved.t0.value;
        widen(envelope, &paired(&found.half_swings, &moved.half_swings, 0.25 * t0), TAU / t0);
    }
    found.about_moved_pivot.push(moved.rows);
}

/// The coefficients of every law with what they change by when these are the half swings. Which extremes are outliers, and how
/// much the others count, stays.
fn widen(envelope: &mut Envelope, moved: &[HalfSwing], omega0: f64) {
    let fall = Fall { weights: envelope.weights.clone(), ..Fall::new(moved, omega0) };
    for fit in &mut envelope.fits {
        let Some(curve) = fall.fit(fit.damping) else { continue };
        for (coefficient, value) in fit.coefficients.iter_mut().zip(&curve.parameters[1..]) {
            coefficient.estimate = coefficient.estimate.with_error(value - coefficient.estimate.value);
        }
    }
}

/// Of each half swing the one of the others at its time; itself where they have none.
fn paired(found: &[HalfSwing], moved: &[HalfSwing], apart: f64) -> Vec<HalfSwing> {
    let distance = |one: &HalfSwing, other: &HalfSwing| (one.time - other.time).abs();
    let pair = |own: &HalfSwing| {
        let nearest = moved.iter().min_by(|a, b| distance(own, a).total_cmp(&distance(own, b)));
        *nearest.filter(|nearest| distance(own, nearest) < apart).unwrap_or(own)
    };
    found.iter().map(pair).collect()
}
