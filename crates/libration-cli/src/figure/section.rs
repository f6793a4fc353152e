//! Poincaré sections and bifurcation diagrams: many dots.

use super::chart::{Axis, Look, Panel, Picture, Series, Units};
use super::names::{name, symbol};
use super::parameters::{Angles, of_model, of_start};
use super::range::around;
use super::style;
use crate::command::bifurcation::{Diagram, Sweep};
use crate::command::section::Answer;
use libration::chaos::{PoincareSection, folded};
use std::f64::consts::PI;

/// One number of the state: what the axis is called, and whether it is an angle, folded into a turn.
#[derive(Clone, Debug)]
pub(crate) struct Shown {
    pub(crate) place: usize,
    pub(crate) label: String,
    pub(crate) is_angle: bool,
}

/// The section: one number of the state against another, one colour a motion.
pub(crate) fn section(answer: &Answer<'_>, [across, up]: &[Shown; 2]) -> Picture {
    let all: usize = answer.sections.iter().map(|section| section.points.len()).sum();
    let of_motion = |(number, section): (usize, &PoincareSection)| {
        let points = section.points.iter().map(|point| (across.value(&point.state), up.value(&point.state)));
        Series::line("", style::dots(number, all), points)
    };
    let series: Vec<Series> = answer.sections.iter().enumerate().map(of_motion).collect();
    let x = across.axis(series.iter().flat_map(|one| one.points.iter().map(|point| point.x)));
    let y = up.axis(series.iter().flat_map(|one| one.points.iter().map(|point| point.y)));
    let title = format!("Poincaré section: {}", name(answer.model));
    let picture = Picture::new(&title, vec![Panel { x, y, series, share: 1.0 }]);
    let start = match &answer.starts[..] {
        [start] => of_start(answer.model, start, Angles::Radians),
        _ => vec![],
    };
    Picture { aspect: 0.8, ..picture.with_parameters([of_model(answer.model), start].concat()) }
}

/// The diagram: one number of the state against the parameter, one colour a sweep.
pub(crate) fn bifurcation(diagram: &Diagram<'_>, up: &Shown) -> Picture {
    let all: usize = diagram.rows().count();
    let of_sweep = |(number, sweep): (usize, &Sweep)| {
        let columns = sweep.columns.iter();
        let points = columns.flat_map(|column| {
            column.section.points.iter().map(|point| (column.value, up.value(&point.state)))
        });
        let label = if diagram.sweeps.len() > 1 { sweep.name } else { "" };
        // The sweep that is drawn first shows behind the other.
        let look = style::dots(number, all);
        let wider = if number + 1 < diagram.sweeps.len() { 1.7 } else { 1.0 };
        Series::line(label, Look { width: wider * look.width, ..look }, points)
    };
    let series: Vec<Series> = diagram.sweeps.iter().enumerate().map(of_sweep).collect();
    let (from, to) =
        around(diagram.sweeps.iter().flat_map(|sweep| &sweep.columns).map(|column| column.value));
    let x = Axis::linear(&symbol(&diagram.parameter.name), from, to);
    let y = up.axis(series.iter().flat_map(|one| one.points.iter().map(|point| point.y)));
    let title = format!("Bifurcation diagram: {}", name(diagram.model));
    Picture::new(&title, vec![Panel { x, y, series, share: 1.0 }]).with_parameters(of_model(diagram.model))
}

impl Shown {
    fn value(&self, state: &[f64]) -> f64 {
        let value = state[self.place];
        if self.is_angle { folded(value) } else { value }
    }

    /// What it is called, without its unit.
    pub(super) fn name(&self) -> &str {
        self.label.split(" / ").next().unwrap_or_default()
    }

    /// The values as they are, with ticks at parts of π for angles.
    pub(super) fn unfolded_axis(&self, values: impl Iterator<Item = f64>) -> Axis {
        let (low, high) = around(values);
        let axis = Axis::linear(&self.label, low, high);
        if self.is_angle { axis.in_units(Units::HalfTurns(PI)) } else { axis }
    }

    /// The whole turn for an angle that goes almost around, otherwise what the values need.
    fn axis(&self, values: impl Iterator<Item = f64>) -> Axis {
        let (low, high) = around(values);
        let turns = self.is_angle && high - low > PI;
        match turns {
            true => Axis::linear(&self.label, -PI, PI).in_units(Units::HalfTurns(PI)),
            false => Axis::linear(&self.label, low, high),
        }
    }
}
