//! The centre of the swings: fixed, or followed if it drifts.

use super::turning_point::Extreme;
use crate::fit::uncertain::Uncertain;
use crate::statistics::{count, median, robust_deviation};

/// Fewer middles of swings than this do not distinguish a wandering centre from noise. With 3 one recording by an encoder seemed to wander
/// (`mod.rs`); with 9 one by a camera, of eight cycles, had a β of 12 for 1.0 ± 0.5.
const FEWEST_TO_FOLLOW: usize = 5;
/// Scatter of the middles, over that expected from noise, above which the centre is taken as wandering. With 2 nothing changed; with 5 β of the
/// recording that begins over the top moved by two uncertainties.
const WANDERING: f64 = 3.0;

/// Weights of extremes on alternating sides. A decay that is a polynomial of the third degree over five extremes cancels in their sum; of an
/// exponential decay by a fraction d from one to the next, d⁴/16 remains. With three weights it is d²/4, which looks like a drifting centre: with
/// damping of 0.2/s from 50°, 0.1°.
const FIVE: [f64; 5] = [0.0625, 0.25, 0.375, 0.25, 0.0625];
/// Weights if there are too few extremes for five: a linear decay cancels.
const THREE: [f64; 3] = [0.25, 0.5, 0.25];

/// The centre of a stretch.
#[derive(Clone, Debug)]
pub struct Centre {
    /// The median of the centres of all swings.
    pub value: Uncertain,
    /// Standard deviation of the centres of single swings from it; zero where noise explains it.
    pub wander: f64,
    /// Times and centres of single swings, where the centre is followed.
    followed: Vec<(f64, f64)>,
}

impl Centre {
    /// Returns a centre that does not move and is known.
    pub fn fixed(value: f64) -> Self {
        Self { value: Uncertain { value, uncertainty: 0.0 }, wander: 0.0, followed: vec![] }
    }

    /// The centre at a time.
    pub fn at(&self, time: f64) -> f64 {
        let after = self.followed.partition_point(|node| node.0 < time);
        match (after.checked_sub(1).and_then(|before| self.followed.get(before)), self.followed.get(after)) {
            (Some(before), Some(after)) => {
                before.1 + (after.1 - before.1) * (time - before.0) / (after.0 - before.0)
            }
            (Some(end), None) | (None, Some(end)) => end.1,
            (None, None) => self.value.value,
        }
    }

    /// Computes the centre from extremes that were measured from this one.
    pub fn renewed(&self, extremes: &[Option<Extreme>]) -> Self {
        let absolute = |extreme: &Extreme| extreme.value + self.at(extreme.time);
        let smooth = self.middles(extremes, &FIVE);
        let (middles, weights) = match smooth.len() >= FEWEST_TO_FOLLOW {
            true => (smooth, &FIVE[..]),
            false => (self.middles(extremes, &THREE), &THREE[..]),
        };
        if middles.is_empty() {
            let pairs = extremes.windows(2).filter_map(|pair| Some((pair[0]?, pair[1]?)));
            let values = pairs.map(|(first, second)| 0.5 * (absolute(&first) + absolute(&second)));
            return Self::fixed(median(values.collect()).unwrap_or(self.value.value));
        }
        let noise = median(extremes.iter().flatten().map(|extreme| extreme.uncertainty).collect());
        let squares: f64 = weights.iter().map(|weight| weight * weight).sum();
        Self::through(middles, squares, noise.unwrap_or(0.0))
    }

    /// Times and centres of single swings, each from as many consecutive extremes as there are weights.
    fn middles(&self, extremes: &[Option<Extreme>], weights: &[f64]) -> Vec<(f64, f64)> {
        let middle = |window: &[Option<Extreme>]| {
            let complete: Vec<Extreme> = window.iter().copied().collect::<Option<_>>()?;
            let weighted =
                complete.iter().zip(weights).map(|(turn, weight)| weight * (turn.value + self.at(turn.time)));
            Some((complete[weights.len() / 2].time, weighted.sum()))
        };
        extremes.windows(weights.len()).filter_map(middle).collect()
    }

    /// The centre from those of single swings, by weights with this sum of squares and extremes with this uncertainty.
    fn through(middles: Vec<(f64, f64)>, squares: f64, noise: f64) -> Self {
        let Some(value) = median(middles.iter().map(|middle| middle.1).collect()) else {
            return Self::fixed(0.0);
        };
        let deviations: Vec<f64> = middles.iter().map(|middle| middle.1 - value).collect();
        let scatter = robust_deviation(&deviations).unwrap_or(0.0);
        let expected = squares.sqrt() * noise;
        // Centres share extremes with their neighbours: the mean of all has the error of the mean of the extremes.
        let independent = (squares * count(middles.len())).max(1.0);
        let uncertainty = scatter.max(expected) / independent.sqrt();
        let wanders = middles.len() >= FEWEST_TO_FOLLOW && scatter > WANDERING * expected;
        let (wander, followed) = if wanders { (scatter, middles) } else { (0.0, vec![]) };
        Self { value: Uncertain { value, uncertainty }, wander, followed }
    }
}
