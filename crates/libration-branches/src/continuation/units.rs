//! The scaled units of the unknowns of a motion: half of each coordinate's range,
//! the corresponding velocity, the period, and the range of the parameter.

use super::family::Family;
use super::point::BranchPoint;
use libration_motion::internals::periodic::norm;
use std::f64::consts::TAU;

/// A direction as a unit vector, in scaled units.
pub(super) fn in_units(direction: &[f64], units: &[f64]) -> Vec<f64> {
    let scaled: Vec<f64> = direction.iter().zip(units).map(|(x, unit)| x / unit).collect();
    let size = norm(&scaled);
    scaled.into_iter().map(|x| x / size).collect()
}

/// The largest of the half-ranges of the coordinates, or 1 at an equilibrium.
pub(super) fn largest_swing(point: &BranchPoint) -> f64 {
    let largest = point.ranges.iter().map(|[low, high]| 0.5 * (high - low)).fold(0.0, f64::max);
    if largest > 1e-9 { largest } else { 1.0 }
}

impl Family<'_> {
    /// The sizes of the unknowns, followed by that of the parameter: half of each coordinate's range, the corresponding velocity, and the period
    /// if it is unknown. A component that hardly moves compared with the largest one has a fraction of the largest size.
    pub(super) fn units(&self, point: &BranchPoint, largest: f64, width: f64) -> Vec<f64> {
        const HARDLY: f64 = 0.02;
        let swing = |coordinate: usize| {
            let [low, high] = point.ranges[coordinate];
            (0.5 * (high - low)).max(HARDLY * largest)
        };
        let places = (0..self.layout.coordinates()).map(swing);
        let sizes = self.layout.arrange(places, |coordinate| swing(coordinate) * TAU / point.period);
        let period = (!self.is_driven()).then_some(point.period);
        sizes.into_iter().chain(period).chain([width]).collect()
    }
}

/// A difference in scaled units.
pub(super) fn difference(a: &[f64], b: &[f64], units: &[f64]) -> Vec<f64> {
    a.iter().zip(b).zip(units).map(|((a, b), unit)| (a - b) / unit).collect()
}
