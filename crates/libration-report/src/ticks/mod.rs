//! Where an axis has its ticks: as many as have room, at multiples that people expect.

mod linear;
mod logarithmic;

use crate::chart::{Axis, Scale, Units};

/// The ticks of an axis.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Ticks {
    /// Parts of the length of the axis, with what is written beside them.
    pub(crate) labelled: Vec<(f64, String)>,
    /// Those between them, as parts of the length.
    pub(crate) minor: Vec<f64>,
}

/// More are too many for an axis of any length.
const MOST: usize = 10;

/// The choices for an axis, from the closest ticks to the widest; each has two or more.
pub(crate) fn choices(axis: &Axis) -> Vec<Ticks> {
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
pub(crate) fn chosen(axis: &Axis, length: f64, extent: impl Fn(&str) -> f64) -> Ticks {
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

#[cfg(test)]
mod tests {
    use super::*;

    fn labels_of(axis: &Axis, length: f64) -> Vec<String> {
        chosen(axis, length, |label| 8.0 * label.chars().map(|_| 1.0).sum::<f64>())
            .labelled
            .into_iter()
            .map(|it| it.1)
            .collect()
    }

    #[test]
    fn degrees_have_ticks_where_people_look_for_them() {
        let axis = |from, to| Axis::linear("", from, to).in_units(Units::Degrees);
        assert_eq!(labels_of(&axis(0.0, 180.0), 400.0), ["0", "30", "60", "90", "120", "150", "180"]);
        assert_eq!(labels_of(&axis(0.0, 180.0), 60.0), ["0", "90", "180"]);
        assert_eq!(labels_of(&axis(0.0, 63.0), 400.0), ["0", "15", "30", "45", "60"]);
        assert_eq!(labels_of(&axis(-100.0, 1000.0), 400.0), ["0", "180", "360", "540", "720", "900"]);
    }

    #[test]
    fn half_turns_are_named_after_pi() {
        let axis = Axis::linear("", -3.2, 3.2).in_units(Units::HalfTurns(std::f64::consts::PI));
        assert_eq!(labels_of(&axis, 200.0), ["−π", "−π/2", "0", "π/2", "π"]);
    }

    #[test]
    fn powers_of_ten_have_minor_ticks_between_them() {
        let axis = Axis::logarithmic("", 1e-3, 10.0);
        let ticks = chosen(&axis, 400.0, |_| 20.0);
        assert_eq!(
            ticks.labelled.iter().map(|it| it.1.as_str()).collect::<Vec<_>>(),
            ["10⁻³", "10⁻²", "10⁻¹", "10⁰", "10¹"]
        );
        assert_eq!(ticks.minor.len(), 4 * 8);
    }

    #[test]
    fn every_axis_has_two_ticks() {
        for (from, to) in [
            (0.0, 1.0),
            (0.3, 0.9),
            (-1e-9, 2e-9),
            (1e7, 1.0001e7),
            (3.0, 17.0),
            (0.99, 1.02),
            (44.0, 47.3),
            (91.0, 119.0),
            (0.0, 359.0),
        ] {
            for units in [Units::Decimal, Units::Degrees, Units::HalfTurns(1.0)] {
                let axis = Axis::linear("", from, to).in_units(units.clone());
                let all = choices(&axis);
                assert!(
                    !all.is_empty() && all.iter().all(|ticks| ticks.labelled.len() >= 2),
                    "{from} {to} {units:?}: {all:?}"
                );
                let parts = all.iter().flat_map(|ticks| &ticks.labelled).map(|it| it.0);
                assert!(parts.into_iter().all(|part| (-1e-6..=1.0 + 1e-6).contains(&part)));
            }
        }
        for (from, to) in [(1e-8, 10.0), (2e-3, 5e-3), (0.5, 1.5), (1e-300, 1e300), (0.2, 30.0)] {
            let all = choices(&Axis::logarithmic("", from, to));
            assert!(
                !all.is_empty() && all.iter().all(|ticks| ticks.labelled.len() >= 2),
                "{from} {to}: {all:?}"
            );
        }
    }
}
