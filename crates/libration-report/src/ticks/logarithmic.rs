//! Ticks at powers of ten, with minor ticks at their multiples; on short axes at multiples of a step.

use super::{Ticks, linear};
use crate::chart::{Axis, Units};
use crate::numbers::power_of_ten;

/// Steps between labelled powers of ten.
const STEPS: [i32; 9] = [1, 2, 3, 4, 5, 10, 20, 50, 100];

pub(super) fn choices(axis: &Axis) -> Vec<Ticks> {
    let held = powers(axis);
    let choices: Vec<Ticks> = STEPS
        .into_iter()
        .map(|step| of_powers(axis, &held, step))
        .filter(|ticks| ticks.labelled.len() >= 2)
        .collect();
    if choices.is_empty() { linear::choices(axis, &Units::Decimal) } else { choices }
}

/// The exponents of the powers of ten on the axis.
fn powers(axis: &Axis) -> Vec<i32> {
    let (from, to) = axis.ends();
    // Powers at the ends are drawn in spite of rounding errors.
    (-330..=310).filter(|&power| (from - 1e-9..=to + 1e-9).contains(&f64::from(power))).collect()
}

fn of_powers(axis: &Axis, held: &[i32], step: i32) -> Ticks {
    let part = |value: f64| axis.part(value);
    let (labelled, others): (Vec<i32>, Vec<i32>) = held.iter().partition(|power| *power % step == 0);
    let label = |power: &i32| (part(10f64.powi(*power)).clamp(0.0, 1.0), power_of_ten(*power));
    let labelled: Vec<_> = labelled.iter().map(label).collect();
    let minor = match step {
        1 => between(axis, held),
        _ => others.iter().map(|power| part(10f64.powi(*power))).collect(),
    };
    Ticks { labelled, minor }
}

/// Minor ticks at two to nine times the powers, also below the lowest power on the axis.
fn between(axis: &Axis, held: &[i32]) -> Vec<f64> {
    let below = held.first().map(|power| power - 1);
    let values = below.into_iter().chain(held.iter().copied());
    let multiples = values.flat_map(|power| (2..10).map(move |factor| f64::from(factor) * 10f64.powi(power)));
    multiples.map(|value| axis.part(value)).filter(|part| (0.0..=1.0).contains(part)).collect()
}
