//! About what the values swing: a fixed value, or one that is followed where it wanders.

use super::turning_point::Extreme;
use crate::fit::Uncertain;
use crate::statistics::{count, median, robust_deviation};

/// Fewer middles of swings than this do not tell a wandering centre from noise. With 3 one recording by an encoder was said to wander
/// (`mod.rs`); with 9 one by a camera, of eight cycles, had a β of 12 for 1.0 ± 0.5.
const FEWEST_TO_FOLLOW: usize = 5;
/// Middles that scatter by so many times what the noise lets expect make a wandering centre. With 2 nothing changed; with 5 β of the
/// recording that begins over the top moved by two uncertainties.
const WANDERING: f64 = 3.0;

/// The centre of a stretch.
#[derive(Clone, Debug)]
pub(super) struct Centre {
    /// The middle one of the centres of all swings.
    pub(super) value: Uncertain,
    /// How far the centres of single swings are from it, as a standard deviation; zero where noise explains it.
    pub(super) wander: f64,
    /// Times and centres of single swings, where the centre is followed.
    followed: Vec<(f64, f64)>,
}

impl Centre {
    pub(super) fn fixed(value: f64) -> Self {
        Self { value: Uncertain { value, uncertainty: 0.0 }, wander: 0.0, followed: vec![] }
    }

    /// The centre at a time.
    pub(super) fn at(&self, time: f64) -> f64 {
        let after = self.followed.partition_point(|node| node.0 < time);
        match (after.checked_sub(1).and_then(|before| self.followed.get(before)), self.followed.get(after)) {
            (Some(before), Some(after)) => {
                before.1 + (after.1 - before.1) * (time - before.0) / (after.0 - before.0)
            }
            (Some(end), None) | (None, Some(end)) => end.1,
            (None, None) => self.value.value,
        }
    }

    /// The centre by extremes that were measured from this one: (e₋ + 2e + e₊)/4, from which a steady decay drops out.
    pub(super) fn renewed(&self, extremes: &[Option<Extreme>]) -> Self {
        let absolute = |extreme: Extreme| extreme.value + self.at(extreme.time);
        let middles = extremes.windows(3).filter_map(|three| {
            let (before, own, after) = (three[0]?, three[1]?, three[2]?);
            Some((own.time, 0.25 * (absolute(before) + 2.0 * absolute(own) + absolute(after))))
        });
        let middles: Vec<(f64, f64)> = middles.collect();
        if middles.is_empty() {
            let pairs = extremes.windows(2).filter_map(|pair| Some((pair[0]?, pair[1]?)));
            let values = pairs.map(|(first, second)| 0.5 * (absolute(first) + absolute(second)));
            return Self::fixed(median(values.collect()).unwrap_or(self.value.value));
        }
        let noise = median(extremes.iter().flatten().map(|extreme| extreme.uncertainty).collect());
        Self::through(middles, noise.unwrap_or(0.0))
    }

    /// The centre with these of single swings, whose extremes are so uncertain.
    fn through(middles: Vec<(f64, f64)>, noise: f64) -> Self {
        let Some(value) = median(middles.iter().map(|middle| middle.1).collect()) else {
            return Self::fixed(0.0);
        };
        let deviations: Vec<f64> = middles.iter().map(|middle| middle.1 - value).collect();
        let scatter = robust_deviation(&deviations).unwrap_or(0.0);
        // √(1 + 4 + 1)/4 of the noise of one extreme.
        let expected = 0.612 * noise;
        // Centres share extremes with their neighbours: about half as many are independent.
        let independent = (0.5 * count(middles.len())).max(1.0);
        let uncertainty = scatter.max(expected) / independent.sqrt();
        let wanders = middles.len() >= FEWEST_TO_FOLLOW && scatter > WANDERING * expected;
        let (wander, followed) = if wanders { (scatter, middles) } else { (0.0, vec![]) };
        Self { value: Uncertain { value, uncertainty }, wander, followed }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn extremes(centre: impl Fn(f64) -> f64) -> Vec<Option<Extreme>> {
        let extreme = |k: u32| {
            let (time, side) = (f64::from(k), if k.is_multiple_of(2) { 1.0 } else { -1.0 });
            // A decay by a hundredth a swing.
            let value = side * (1.0 - 0.01 * time) + centre(time);
            Some(Extreme { time, value, uncertainty: 1e-4 })
        };
        (0..40).map(extreme).collect()
    }

    #[test]
    fn the_decay_does_not_move_the_centre() {
        let centre = Centre::fixed(0.0).renewed(&extremes(|_| 0.3));
        assert!((centre.value.value - 0.3).abs() < 1e-12 && centre.wander.to_bits() == 0, "{centre:?}");
        assert!((centre.at(7.3) - 0.3).abs() < 1e-12);
    }

    #[test]
    fn a_centre_that_moves_is_followed() {
        let centre = Centre::fixed(0.0).renewed(&extremes(|t| 0.002 * t));
        assert!(centre.wander > 0.01 && (centre.at(20.5) - 0.041).abs() < 1e-6, "{centre:?}");
    }
}
