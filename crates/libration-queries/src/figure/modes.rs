//! The shapes of normal modes: the component of each coordinate.

use super::chart::{Axis, Panel, Picture, Series, Units};
use super::names::{subject, symbol};
use super::parameters::of_model;
use super::style;
use crate::output::number::{count, short};
use libration::normal_modes::{Behaviour, Mode, NormalModes};
use libration::systems::Model;

/// The parts of the coordinates, one curve a mode.
pub(crate) fn shapes(model: &Model, modes: &NormalModes) -> Picture {
    let mut series = vec![];
    let last = count(modes.variables.len());
    series.push(Series::line("", style::reference(), [(0.5, 0.0), (last + 0.5, 0.0)]));
    for (number, mode) in modes.modes.iter().enumerate() {
        let places = (1_u32..).map(f64::from);
        let points: Vec<(f64, f64)> = places.zip(mode.shape.iter().map(|part| part.re)).collect();
        series.push(Series::line("", style::thin(number), points.clone()));
        series.push(Series::line(&label(number, mode), style::markers(number), points));
    }
    let names = modes.variables.iter().map(|name| symbol(name)).collect();
    let x = Axis::linear("coordinate", 0.5, last + 0.5).in_units(Units::Names(names));
    let y = Axis::linear("component in the mode", -1.1, 1.1);
    let title = format!("Normal modes of {}", subject(model));
    Picture::new(&title, vec![Panel { x, y, series, share: 1.0 }]).with_parameters(of_model(model))
}

fn label(number: usize, mode: &Mode) -> String {
    let what = match mode.behaviour {
        Behaviour::Oscillating => format!("ω = {}", short(mode.frequency(), 6)),
        Behaviour::Free => "free".to_owned(),
        Behaviour::Unstable => format!("grows, rate {}", short(mode.exponent.re, 4)),
        _ => format!("decays, rate {}", short(-mode.exponent.re, 4)),
    };
    format!("mode {}, {what}", number + 1)
}
