//! Positions of the ticks of an axis: as many as there is room for, at familiar multiples.

mod linear;
mod logarithmic;

use crate::chart::{Axis, Scale, Units};

/// The ticks of an axis.
#[derive(Clone, Debug, PartialEq)]
pub struct Ticks {
    /// Fractions of the length of the axis, with the labels.
    pub labelled: Vec<(f64, String)>,
    /// Minor ticks, as fractions of the length.
    pub minor: Vec<f64>,
}

/// Largest number of labelled ticks, for an axis of any length.
const MOST: usize = 10;

/// The possible sets of ticks, from the closest to the widest spacing; each has at least two ticks.
pub fn choices(axis: &Axis) -> Vec<Ticks> {
    let candidates = match (axis.scale, &axis.units) {
        (Scale::Logarithmic, _) => logarithmic::choices(axis),
        (_, Units::Names(names)) => vec![named(axis, names)],
        (_, units) => linear::choices(axis, units),
    };
    let (few, many): (Vec<Ticks>, Vec<Ticks>) =
        candidates.into_iter().partition(|ticks| ticks.labelled.len() <= MOST);
    if few.is_empty() { many.into_iter().last().into_iter().collect() } else { few }
}

/// The closest ticks whose labels do not touch on an axis of this length; `extent` is the size of a label along the axis.
pub fn chosen(axis: &Axis, length: f64, extent: impl Fn(&str) -> f64) -> Ticks {
    let mut choices = choices(axis);
    let fits = choices.iter().position(|ticks| ticks.length_needed(&extent) <= length);
    let index = fits.unwrap_or(choices.len().saturating_sub(1));
    let none = Ticks { labelled: vec![], minor: vec![] };
    if choices.is_empty() { none } else { choices.swap_remove(index) }
}

/// The least length of an axis that holds the labels of its smallest set of ticks.
pub(crate) fn least_length(axis: &Axis, extent: impl Fn(&str) -> f64) -> f64 {
    choices(axis).iter().map(|ticks| ticks.length_needed(&extent)).fold(f64::INFINITY, f64::min)
}

/// All labels that the ticks may have, for any length of the axis.
pub(crate) fn labels(axis: &Axis) -> impl Iterator<Item = String> {
    choices(axis).into_iter().flat_map(|ticks| ticks.labelled).map(|(_, label)| label)
}

fn named(axis: &Axis, names: &[String]) -> Ticks {
    let labelled = (1_u32..).zip(names).map(|(number, name)| (axis.part(f64::from(number)), name.clone()));
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
