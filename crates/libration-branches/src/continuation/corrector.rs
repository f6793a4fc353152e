//! Newton's method for a state and a parameter together.

use super::family::{Family, Image};
use super::space::Space;
use libration_motion::internals::periodic::{NewtonStep, norm};

/// A state followed by the parameter, with their image under the motion.
#[derive(Clone, Debug)]
pub(super) struct Corrected {
    /// The unknowns of the motion, then the parameter.
    pub(super) place: Vec<f64>,
    pub(super) image: Image,
    /// Size of the first Newton correction, in units.
    pub(super) first: f64,
    /// The change of the map with the place, as a part of its norm for each unit.
    pub(super) map_slope: f64,
    /// The distance in units of the place from that of the map, where this is the one before the last correction.
    pub(super) stale: f64,
}

/// Newton's rounds; each doubles the digits once the guess is near.
const MOST_ROUNDS: usize = 12;
/// Size of a correction after which the iteration ends: the remaining error, of the order of its square, is below rounding.
const CLOSE: f64 = 3e-9;
/// A correction that no longer shrinks counts as rounding if it is below this.
const ROUNDING: f64 = 1e-9;

/// Newton corrector of a family in one space.
#[derive(Clone, Debug)]
pub(super) struct Corrector<'a> {
    pub(super) family: &'a Family<'a>,
    pub(super) space: Space,
    pub(super) tolerance: f64,
    /// Largest last correction, in units, after which the derivatives from before it are kept: they change by about as much.
    pub(super) stale: f64,
}

impl Corrector<'_> {
    /// The motion of the space nearest to a guess in the plane across a direction, which is given in units.
    pub(super) fn corrected(&self, guess: &[f64], across: &[f64], units: &[f64]) -> Option<Corrected> {
        let mut place = guess.to_vec();
        let (mut first, mut before) = (0.0, f64::INFINITY);
        let mut last: Option<Image> = None;
        for round in 0..MOST_ROUNDS {
            let image = self.image(&place)?;
            if round == 0 && is_rounding(&image, &place, units) {
                return Some(Corrected { place, image, first, map_slope: 1.0, stale: 0.0 });
            }
            let off: f64 = (0..place.len()).map(|j| across[j] * (place[j] - guess[j]) / units[j]).sum();
            let change = bordered(&image, across, units).change(&image.defect, &[off])?;
            let size = norm(&change);
            if round == 0 {
                first = size;
            }
            if !size.is_finite() || (size > 0.5 * before && size > ROUNDING) {
                return None;
            }
            for ((number, change), unit) in place.iter_mut().zip(&change).zip(units) {
                *number += change * unit;
            }
            if size < CLOSE || (size > 0.5 * before && size <= ROUNDING) {
                // Without a second map the change is taken to be that of a quantity in proportion to the place.
                let map_slope = last.map_or(1.0, |it| (image.change(&it, units) / before).max(1.0));
                let is_stale = size <= self.stale;
                let (image, stale) = if is_stale { (image, size) } else { (self.image(&place)?, 0.0) };
                return Some(Corrected { place, image, first, map_slope, stale });
            }
            before = size;
            last = Some(image);
        }
        None
    }

    /// A motion where branches cross, so that corrections of the state have no bound: only the period is corrected, where no drive sets it.
    pub(super) fn closed_by_period(&self, mut place: Vec<f64>) -> Option<Corrected> {
        const ROUNDS: usize = 3;
        let period = self.family.layout.numbers();
        for _ in 0..if self.family.is_driven() { 0 } else { ROUNDS } {
            let Image { defect, map, .. } = self.image(&place)?;
            let rate = || map[..period].iter().map(|row| row[period]);
            let product: f64 = rate().zip(&defect).map(|(rate, missed)| rate * missed).sum();
            place[period] -= product / rate().map(|rate| rate * rate).sum::<f64>();
        }
        Some(Corrected { image: self.image(&place)?, place, first: 0.0, map_slope: 1.0, stale: 0.0 })
    }

    pub(super) fn image(&self, place: &[f64]) -> Option<Image> {
        let (parameter, state) = place.split_last()?;
        self.family.image(self.space, state, &[*parameter], self.tolerance)
    }

    /// The unit vector along the branch, in units, that goes with another one.
    pub(super) fn tangent(&self, image: &Image, along: &[f64], units: &[f64]) -> Option<Vec<f64>> {
        let tangent = bordered(image, along, units).change(&vec![0.0; image.defect.len()], &[-1.0])?;
        let size = norm(&tangent);
        size.is_finite().then(|| tangent.iter().map(|x| x / size).collect())
    }
}

/// Returns whether an orbit closes up to the rounding of its state. No correction improves it, and at a state of rest where other branches begin the
/// correction of a rounding error has no bound.
fn is_rounding(image: &Image, place: &[f64], units: &[f64]) -> bool {
    const ROUNDINGS: f64 = 4.0;
    let largest =
        |numbers: &[f64]| numbers.iter().zip(units).map(|(x, unit)| (x / unit).abs()).fold(0.0, f64::max);
    largest(&image.defect) <= ROUNDINGS * f64::EPSILON * largest(&place[..image.defect.len()])
}

/// The equations of the next step for state and parameter, with the condition of a row.
pub(super) fn bordered(image: &Image, last: &[f64], units: &[f64]) -> NewtonStep {
    let free: Vec<usize> = (0..image.map.len()).collect();
    let parameter = (&image.by_parameters[0][..], units[free.len()]);
    NewtonStep::new(&image.map, units, &free, &[parameter]).bordered(last)
}
