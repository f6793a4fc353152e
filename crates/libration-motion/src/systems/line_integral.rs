//! Integrals along straight lines.

use libration_numbers::quadrature::{Integral, gauss_kronrod};

/// The work ∫ F·dx of forces from one state to another, along the straight line between them;
/// the number of forces is the number of coordinates, which are the first components of a state.
pub(super) fn work(from: &[f64], to: &[f64], mut forces: impl FnMut(&[f64]) -> Vec<f64>) -> Integral {
    gauss_kronrod(|s| {
        let point: Vec<f64> = from.iter().zip(to).map(|(a, b)| a + s * (b - a)).collect();
        let ways = from.iter().zip(to).map(|(a, b)| b - a);
        forces(&point).iter().zip(ways).map(|(force, way)| force * way).sum()
    })
}
