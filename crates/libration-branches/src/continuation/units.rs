//! The scaled units of the unknowns of a motion: half of each coordinate's range,
//! the corresponding velocity, the period, and the range of the parameter.

use super::family::Family;
use super::point::BranchPoint;
use libration_motion::internals::periodic::norm;
use std::f64::consts::TAU;

/// The largest of the half-ranges of the coordinates.
pub(super) fn largest_half_range(point: &BranchPoint) -> f64 {
    point.ranges.iter().map(|[low, high]| 0.5 * (high - low)).fold(0.0, f64::max)
}

/// Part of the scale of a family below which the size of a motion does not matter.
pub(super) const LEAST: f64 = 1e-6;

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
    pub(super) fn first_units(&self, position: &[f64], width: f64) -> Vec<f64> {
        let (unknowns, parameter) = position.split_at(position.len() - 1);
        let period = unknowns.get(self.layout.numbers()).copied();
        let beat = self.drive_period(parameter).or(period).unwrap_or(TAU);
        self.sizes_in(beat).into_iter().chain(period).chain([width]).collect()
    }

    /// The sizes of the components of a state for motions of the scale of the family with a period.
    pub(super) fn sizes_in(&self, period: f64) -> Vec<f64> {
        let sizes = (0..self.layout.coordinates()).map(|_| self.scale);
        self.layout.arrange(sizes, |_| self.scale * TAU / period.abs())
    }

    /// The sizes of the components of a state at a value of the parameter: an amplitude and its velocity, as large as its largest component, and at
    /// least a part of the scale of the family.
    pub(super) fn sizes_of(&self, unknowns: &[f64], value: f64, part: f64) -> Vec<f64> {
        let period = unknowns.get(self.layout.numbers()).copied();
        let units = self.sizes_in(self.drive_period(&[value]).or(period).unwrap_or(TAU));
        let of_component = |(x, unit): (&f64, &f64)| (x / unit).abs();
        let largest = self.state(unknowns).iter().zip(&units).map(of_component).fold(part, f64::max);
        units.into_iter().map(|unit| largest * unit).collect()
    }

    /// The sizes of the unknowns, followed by that of the parameter: half of each coordinate's range, the corresponding velocity, and the period
    /// if it is unknown. A component that hardly moves compared with the largest one has a fraction of the largest size.
    pub(super) fn units(&self, point: &BranchPoint, largest: f64, width: f64) -> Vec<f64> {
        const HARDLY: f64 = 0.02;
        let swing = |coordinate: usize| {
            let [low, high] = point.ranges[coordinate];
            (0.5 * (high - low)).max(HARDLY * largest)
        };
        let of_coordinates = (0..self.layout.coordinates()).map(swing);
        let sizes = self.layout.arrange(of_coordinates, |coordinate| swing(coordinate) * TAU / point.period);
        let period = (!self.is_driven()).then_some(point.period);
        sizes.into_iter().chain(period).chain([width]).collect()
    }
}

/// A difference in scaled units.
pub(super) fn difference(a: &[f64], b: &[f64], units: &[f64]) -> Vec<f64> {
    a.iter().zip(b).zip(units).map(|((a, b), unit)| (a - b) / unit).collect()
}
