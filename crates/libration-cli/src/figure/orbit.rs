//! A periodic orbit: its coordinates over a period, and each velocity against its coordinate.

use super::chart::{Axis, Panel, Picture, Series};
use super::names::{axis_label, subject, symbol};
use super::parameters::of_model;
use super::range::around;
use super::style;
use crate::output::number::short;
use libration::orbit::Orbit;
use libration::systems::Model;

/// Points of a curve.
const SAMPLES: u32 = 400;

/// One panel above the other, one colour a coordinate. What has no velocity is drawn against the first coordinate.
pub(crate) fn orbit(model: &Model, orbit: &Orbit) -> Picture {
    let period = orbit.period();
    let times = (0..=SAMPLES).map(|step| period * f64::from(step) / f64::from(SAMPLES));
    let states: Vec<(f64, Vec<f64>)> = times.map(|time| (time, orbit.state_at(time))).collect();
    let (names, layout) = (model.state_names(), model.layout());
    let places = 0..layout.coordinates();
    let curve = |number: usize, label: String, points: Vec<(f64, f64)>| {
        Series::line(&label, style::curve(number), points)
    };
    let in_time = |place: usize| {
        curve(
            place,
            symbol(&names[place]),
            states.iter().map(|(time, state)| (*time, state[place])).collect(),
        )
    };
    let in_plane = |place: usize| {
        let up = layout.velocity(place).unwrap_or(place);
        let across = if up == place { 0 } else { place };
        curve(place, String::new(), states.iter().map(|(_, state)| (state[across], state[up])).collect())
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

/// What the axes show: the names where there is one coordinate, else what they have in common.
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
