//! The scaled units of the unknowns of a motion: half of each coordinate's range,
//! the corresponding velocity, the period, and the range of the parameter.

use super::family::Family;
use super::point::BranchPoint;
use libration_motion::internals::periodic::norm;
use std::f64::consts::TAU;

fn largest_half_range(point: &BranchPoint) -> f64 {
    point.ranges.iter().map(|[low, high]| 0.5 * (high - low)).fold(0.0, f64::max)
}

/// A direction as a unit vector, in scaled units.
pub(super) fn in_units(direction: &[f64], units: &[f64]) -> Vec<f64> {
    let scaled: Vec<f64> = direction.iter().zip(units).map(|(x, unit)| x / unit).collect();
    let size = norm(&scaled);
    scaled.into_iter().map(|x| x / size).collect()
}

/// Motions smaller than this part of the scale of a family are equilibria.
const AT_REST: f64 = 1e-9;

impl Family<'_> {
    /// The largest of the half-ranges of the coordinates, or the scale of the family at an equilibrium.
    pub(super) fn largest_swing(&self, point: &BranchPoint) -> f64 {
        if self.is_at_rest(point) { self.scale } else { largest_half_range(point) }
    }

    /// Returns `true` for an equilibrium.
    pub(super) fn is_at_rest(&self, point: &BranchPoint) -> bool {
        largest_half_range(point) <= AT_REST * self.scale
    }

    /// The sizes of the unknowns where no motion is known yet: the scale of the family, the corresponding velocity, and the period if it is
    /// unknown; followed by that of the parameter.
    pub(super) fn first_units(&self, place: &[f64], width: f64) -> Vec<f64> {
        let own = &place[self.layout.numbers()..];
        let (parameter, period) = own.split_last().map_or((f64::NAN, None), |(it, own)| (*it, own.first()));
        let period = period.copied();
        let pace = TAU / self.drive_period(&[parameter]).or(period).unwrap_or(TAU).abs();
        let places = (0..self.layout.coordinates()).map(|_| self.scale);
        let sizes = self.layout.arrange(places, |_| self.scale * pace);
        sizes.into_iter().chain(period).chain([width]).collect()
    }

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
