//! A periodic orbit: its coordinates over a period, and each velocity against its coordinate.

use super::chart::{Axis, Panel, Picture, Series};
use super::names::{axis_label, subject, symbol};
use super::parameters::of_model;
use super::range::around;
use super::style;
use crate::output::number::short;
use libration::orbit::Orbit;
use libration::systems::Model;

/// Number of points of a smooth curve.
const SAMPLES: u32 = 400;
/// Largest number of halvings of an interval in which the curve leaves its chord by more than `SEEN` of its whole extent: relaxation
/// oscillations jump in a thousandth of their period.
const HALVINGS: u32 = 6;
const SEEN: f64 = 5e-4;

/// Panels one above the other, with one colour for each coordinate. A coordinate without velocity is drawn against the first coordinate.
pub(crate) fn orbit(model: &Model, orbit: &Orbit) -> Picture {
    let period = orbit.period();
    let states = states(orbit);
    let (names, layout) = (model.state_names(), model.layout());
    let places = 0..layout.coordinates();
    let curve = |number: usize, label: String, points: Vec<(f64, f64)>| {
        Series::line(&label, style::curve(number), points)
    };
    let in_time = |index: usize| {
        curve(
            index,
            symbol(&names[index]),
            states.iter().map(|(time, state)| (*time, state[index])).collect(),
        )
    };
    let in_plane = |index: usize| {
        let up = layout.velocity(index).unwrap_or(index);
        let across = if up == index { 0 } else { index };
        curve(index, String::new(), states.iter().map(|(_, state)| (state[across], state[up])).collect())
    };
    let (first, second) =
        (places.clone().map(in_time).collect::<Vec<_>>(), places.map(in_plane).collect::<Vec<_>>());
    let (coordinate, velocity) = labels(model);
    let panels = vec![
        panel(Axis::linear("time t / s", 0.0, period), &coordinate, first),
        panel(across(&second, &coordinate), &velocity, second),
    ];
    let title = format!("Periodic orbit of {}", subject(model));
    let told = format!("T = {} s", short(period, 8));
    Picture { aspect: 0.9, ..Picture::new(&title, panels) }
        .with_parameters([of_model(model), vec![told]].concat())
}

/// The states over a period, denser where they change fast.
fn states(orbit: &Orbit) -> Vec<(f64, Vec<f64>)> {
    let at = |time: f64| (time, orbit.state_at(time));
    let time = |step: u32| orbit.period() * f64::from(step) / f64::from(SAMPLES);
    let mut states: Vec<(f64, Vec<f64>)> = (0..=SAMPLES).map(|step| at(time(step))).collect();
    let width = |number: usize| {
        let numbers = || states.iter().map(|(_, state)| state[number]);
        numbers().fold(f64::NEG_INFINITY, f64::max) - numbers().fold(f64::INFINITY, f64::min)
    };
    let widths: Vec<f64> = (0..states[0].1.len()).map(width).collect();
    for _ in 0..HALVINGS {
        let is_bent = |ends: &[(f64, Vec<f64>)], middle: &[f64]| {
            let off = |number: usize| middle[number] - 0.5 * (ends[0].1[number] + ends[1].1[number]);
            (0..widths.len()).any(|number| off(number).abs() > SEEN * widths[number])
        };
        let middles = states.windows(2).map(|ends| {
            let middle = at(0.5 * (ends[0].0 + ends[1].0));
            is_bent(ends, &middle.1).then_some(middle)
        });
        let middles: Vec<Option<(f64, Vec<f64>)>> = middles.chain([None]).collect();
        if middles.iter().all(Option::is_none) {
            break;
        }
        states =
            states.into_iter().zip(middles).flat_map(|(state, next)| [Some(state), next]).flatten().collect();
    }
    states
}

/// The labels of the axes: the names for one coordinate, else common labels.
fn labels(model: &Model) -> (String, String) {
    let (names, units) = (model.state_names(), model.state_units());
    match (model.coordinates().len(), model.layout().velocity(0)) {
        (1, Some(velocity)) => {
            (axis_label(&names[0], &units[0]), axis_label(&names[velocity], &units[velocity]))
        }
        (_, Some(_)) => ("coordinates".to_owned(), "velocities".to_owned()),
        (_, None) => ("coordinates".to_owned(), "coordinates".to_owned()),
    }
}

fn panel(x: Axis, label: &str, series: Vec<Series>) -> Panel {
    let (low, high) = around(series.iter().flat_map(|one| one.points.iter().map(|point| point.y)));
    Panel { x, y: Axis::linear(label, low, high), series, share: 1.0 }
}

fn across(series: &[Series], label: &str) -> Axis {
    let (low, high) = around(series.iter().flat_map(|one| one.points.iter().map(|point| point.x)));
    Axis::linear(label, low, high)
}
