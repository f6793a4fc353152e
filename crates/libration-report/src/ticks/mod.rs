//! Positions of the ticks of an axis: as many as have room, at multiples that people expect.

mod linear;
mod logarithmic;

use crate::chart::{Axis, Scale, Units};

/// The ticks of an axis.
#[derive(Clone, Debug, PartialEq)]
pub struct Ticks {
    /// Parts of the length of the axis, with what is written next to them.
    pub labelled: Vec<(f64, String)>,
    /// Minor ticks, as parts of the length.
    pub minor: Vec<f64>,
}

/// More are too many for an axis of any length.
const MOST: usize = 10;

/// The choices for an axis, from the closest ticks to the widest; each has two or more.
pub fn choices(axis: &Axis) -> Vec<Ticks> {
    let found = match (axis.scale, &axis.units) {
        (Scale::Logarithmic, _) => logarithmic::choices(axis),
        (_, Units::Names(names)) => vec![named(axis, names)],
        (_, units) => linear::choices(axis, units),
    };
    let (few, many): (Vec<Ticks>, Vec<Ticks>) =
        found.into_iter().partition(|ticks| ticks.labelled.len() <= MOST);
    if few.is_empty() { many.into_iter().last().into_iter().collect() } else { few }
}

/// The closest ticks whose labels, of this extent along the axis, keep apart on an axis of this length.
pub fn chosen(axis: &Axis, length: f64, extent: impl Fn(&str) -> f64) -> Ticks {
    let mut choices = choices(axis);
    let fits = choices.iter().position(|ticks| ticks.length_needed(&extent) <= length);
    let place = fits.unwrap_or(choices.len().saturating_sub(1));
    let none = Ticks { labelled: vec![], minor: vec![] };
    if choices.is_empty() { none } else { choices.swap_remove(place) }
}

/// The least length of an axis that holds the labels of its fewest ticks.
pub(crate) fn least_length(axis: &Axis, extent: impl Fn(&str) -> f64) -> f64 {
    choices(axis).iter().map(|ticks| ticks.length_needed(&extent)).fold(f64::INFINITY, f64::min)
}

/// Every text that may stand at a tick, whatever the length of the axis.
pub(crate) fn labels(axis: &Axis) -> impl Iterator<Item = String> {
    choices(axis).into_iter().flat_map(|ticks| ticks.labelled).map(|(_, label)| label)
}

fn named(axis: &Axis, names: &[String]) -> Ticks {
    let labelled = (1_u32..).zip(names).map(|(place, name)| (axis.part(f64::from(place)), name.clone()));
    Ticks { labelled: labelled.collect(), minor: vec![] }
}

impl Ticks {
    fn length_needed(&self, extent: impl Fn(&str) -> f64) -> f64 {
        let apart = |pair: &[(f64, String)]| {
            0.5 * (extent(&pair[0].1) + extent(&pair[1].1)) / (pair[1].0 - pair[0].0).abs()
        };
        self.labelled.windows(2).map(apart).fold(0.0, f64::max)
    }
}
