//! Newton's method for a state and a parameter together.

use super::family::{Family, Image};
use super::space::Space;
use libration_motion::internals::periodic::{NewtonStep, norm};

/// A motion and its parameter after Newton's method, with the image of the state.
#[derive(Clone, Debug)]
pub(super) struct Corrected {
    /// The unknowns of the motion, followed by the parameter.
    pub(super) position: Vec<f64>,
    pub(super) image: Image,
    /// Size of the first Newton correction, in scaled units.
    pub(super) first: f64,
    /// The change of the map with the position, relative to its norm, per unit.
    pub(super) map_slope: f64,
    /// The size in units of the last correction if the image and the map are those before it; zero if they were recomputed.
    pub(super) stale: f64,
}

/// Iteration limit of Newton's method; each iteration doubles the digits once the guess is close.
const MOST_ROUNDS: usize = 12;
/// Size of a correction after which the iteration ends: the remaining error, of the order of its square, is below rounding.
const CLOSE: f64 = 3e-9;
/// Size below which a correction that no longer shrinks counts as rounding.
const ROUNDING: f64 = 1e-9;

/// Newton corrector of a family in one space.
#[derive(Clone, Debug)]
pub(super) struct Corrector<'a> {
    pub(super) family: &'a Family<'a>,
    pub(super) space: Space,
    pub(super) tolerance: f64,
    /// Largest last correction, in scaled units, after which the derivatives from before it are kept: their relative change is about as large.
    pub(super) stale: f64,
}

impl Corrector<'_> {
    /// The motion of the space nearest to a guess, in the plane perpendicular to a direction given in scaled units.
    pub(super) fn corrected(&self, guess: &[f64], across: &[f64], units: &[f64]) -> Option<Corrected> {
        let mut unknowns = guess.to_vec();
        let (mut first, mut before) = (0.0, f64::INFINITY);
        let mut last: Option<Image> = None;
        for round in 0..MOST_ROUNDS {
            let image = self.image(&unknowns)?;
            if round == 0 && is_rounding(&image, &unknowns, units) {
                return Some(Corrected { position: unknowns, image, first, map_slope: 1.0, stale: 0.0 });
            }
            let off: f64 = (0..unknowns.len()).map(|j| across[j] * (unknowns[j] - guess[j]) / units[j]).sum();
            let change = bordered(&image, across, units).change(&image.defect, &[off])?;
            let size = norm(&change);
            if round == 0 {
                first = size;
            }
            if !size.is_finite() || (size > 0.5 * before && size > ROUNDING) {
                return None;
            }
            for ((number, change), unit) in unknowns.iter_mut().zip(&change).zip(units) {
                *number += change * unit;
            }
            if size < CLOSE || (size > 0.5 * before && size <= ROUNDING) {
                // Without a second map its change is assumed to be proportional to the change of position.
                let map_slope = last.map_or(1.0, |earlier| (image.change(&earlier, units) / before).max(1.0));
                let is_stale = size <= self.stale;
                let (image, stale) = if is_stale { (image, size) } else { (self.image(&unknowns)?, 0.0) };
                return Some(Corrected { position: unknowns, image, first, map_slope, stale });
            }
            before = size;
            last = Some(image);
        }
        None
    }

    /// A motion at a crossing of branches, where corrections of the state are unbounded: only the period is corrected, if no drive sets it.
    pub(super) fn closed_by_period(&self, mut position: Vec<f64>) -> Option<Corrected> {
        const ROUNDS: usize = 3;
        let period = self.family.layout.numbers();
        for _ in 0..if self.family.is_driven() { 0 } else { ROUNDS } {
            let Image { defect, map, .. } = self.image(&position)?;
            let rate = || map[..period].iter().map(|row| row[period]);
            let product: f64 = rate().zip(&defect).map(|(rate, missed)| rate * missed).sum();
            position[period] -= product / rate().map(|rate| rate * rate).sum::<f64>();
        }
        Some(Corrected { image: self.image(&position)?, position, first: 0.0, map_slope: 1.0, stale: 0.0 })
    }

    pub(super) fn image(&self, position: &[f64]) -> Option<Image> {
        let (parameter, state) = position.split_last()?;
        self.family.image(self.space, state, &[*parameter], self.tolerance)
    }

    /// The unit tangent of the branch, in scaled units, oriented like a given vector.
    pub(super) fn tangent(&self, image: &Image, along: &[f64], units: &[f64]) -> Option<Vec<f64>> {
        let tangent = bordered(image, along, units).change(&vec![0.0; image.defect.len()], &[-1.0])?;
        let size = norm(&tangent);
        size.is_finite().then(|| tangent.iter().map(|x| x / size).collect())
    }
}

/// Returns `true` if an orbit closes within the rounding error of its state. No correction improves it,
/// and at an equilibrium where other branches begin the correction of a rounding error is unbounded.
fn is_rounding(image: &Image, position: &[f64], units: &[f64]) -> bool {
    /// A component of the image is the sum of several rounded terms.
    const ROUNDINGS: f64 = 4.0;
    let largest =
        |numbers: &[f64]| numbers.iter().zip(units).map(|(x, unit)| (x / unit).abs()).fold(0.0, f64::max);
    largest(&image.defect) <= ROUNDINGS * f64::EPSILON * largest(&position[..image.defect.len()])
}

/// The equations of the next correction for state and parameter, with one row as additional condition.
pub(super) fn bordered(image: &Image, last: &[f64], units: &[f64]) -> NewtonStep {
    let free: Vec<usize> = (0..image.map.len()).collect();
    let parameter = (&image.by_parameters[0][..], units[free.len()]);
    NewtonStep::new(&image.map, units, &free, &[parameter]).bordered(last)
}
