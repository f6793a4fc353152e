//! Ticks at multiples of a step.

use super::Ticks;
use crate::chart::{Axis, Units};
use crate::numbers;

/// Steps in degrees from one up to a turn; a step of ten degrees serves ranges below half a right angle.
const DEGREES: [f64; 9] = [1.0, 2.0, 5.0, 15.0, 30.0, 45.0, 90.0, 180.0, 360.0];
/// Largest number of ticks at one step.
const MOST: u32 = 20;

/// The ticks for each step that gives at least two of them and at most the largest number.
pub(super) fn choices(axis: &Axis, units: &Units) -> Vec<Ticks> {
    let range = axis.to - axis.from;
    if !(range.is_finite() && range > 0.0) {
        return vec![];
    }
    let written = |step: f64| -> Box<dyn Fn(f64) -> String> {
        let largest = axis.from.abs().max(axis.to.abs());
        match units {
            Units::HalfTurns(half) if range >= *half => {
                let half = *half;
                Box::new(move |value| parts_of_pi(value / half))
            }
            _ => Box::new(move |value| numbers::of_steps(value, step, largest)),
        }
    };
    steps(units, range)
        .into_iter()
        .map(|step| Ticks { labelled: multiples(axis, step, &*written(step)), minor: vec![] })
        .filter(|ticks| ticks.labelled.len() >= 2)
        .collect()
}

/// The multiples of the step on the axis, as fractions of its length, with their labels.
fn multiples(axis: &Axis, step: f64, written: &dyn Fn(f64) -> String) -> Vec<(f64, String)> {
    // Ticks at the ends are drawn in spite of rounding errors.
    let slack = 1e-6 * step;
    let first = ((axis.from - slack) / step).ceil();
    let values = (0..=MOST).map(|number| (first + f64::from(number)) * step);
    let held = values.take_while(|value| *value <= axis.to + slack);
    held.map(|value| (axis.part(value).clamp(0.0, 1.0), written(value))).collect()
}

/// Steps that divide the range into at most [`MOST`] parts, from the smallest.
fn steps(units: &Units, range: f64) -> Vec<f64> {
    let all: Vec<f64> = match units {
        Units::Degrees if range > 20.0 => {
            let turns = decimal(range / 360.0).into_iter().filter(|turns| *turns > 1.5);
            let below = DEGREES.into_iter().chain((range < 46.0).then_some(10.0));
            below.chain(turns.map(|turns| 360.0 * turns)).collect()
        }
        Units::HalfTurns(half) if range >= *half => {
            let turns = decimal(range / half).into_iter().filter(|turns| *turns > 0.9);
            [0.25, 0.5].into_iter().chain(turns).map(|turns| turns * half).collect()
        }
        Units::Whole => decimal(range).into_iter().filter(|step| *step > 0.9).collect(),
        _ => decimal(range),
    };
    let mut fitting: Vec<f64> = all.into_iter().filter(|step| range / step < f64::from(MOST)).collect();
    fitting.sort_by(f64::total_cmp);
    // An axis of whole numbers may hold fewer than two ticks.
    if fitting.is_empty() { decimal(range) } else { fitting }
}

/// 1, 2 and 5 times powers of ten, from about a twentieth of the range up to all of it.
fn decimal(range: f64) -> Vec<f64> {
    let power = 10f64.powf((range / f64::from(MOST)).log10().floor());
    let factors = [1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0];
    factors
        .into_iter()
        .map(|factor| factor * power)
        .filter(|step| *step <= range && range / step < f64::from(MOST))
        .collect()
}

/// `−3π/2` for −1.5.
fn parts_of_pi(half_turns: f64) -> String {
    let quarters = (4.0 * half_turns).round();
    let denominator = if quarters % 2.0 != 0.0 {
        4.0
    } else if quarters % 4.0 != 0.0 {
        2.0
    } else {
        1.0
    };
    let numerator = quarters * denominator / 4.0;
    let sign = if numerator < 0.0 { "−" } else { "" };
    let times = if numerator.abs() > 1.5 { format!("{:.0}", numerator.abs()) } else { String::new() };
    match (numerator == 0.0, denominator > 1.5) {
        (true, _) => "0".to_owned(),
        (_, true) => format!("{sign}{times}π/{denominator:.0}"),
        (_, false) => format!("{sign}{times}π"),
    }
}
