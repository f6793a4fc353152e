//! Poincaré sections and bifurcation diagrams: many dots.

use super::chart::{Axis, Look, Panel, Picture, Series, Units};
use super::names::{axis_label, name, symbol};
use super::parameters::{AngleUnit, of_model, of_start};
use super::range::around;
use super::style;
use libration::chaos::{DiagramColumn, PoincareSection, angles, folded};
use libration::systems::Model;
use std::f64::consts::PI;

/// One state component: the label of its axis, and `true` if it is an angle, folded into a turn.
#[derive(Clone, Debug)]
pub(crate) struct StateAxis {
    pub(crate) component: usize,
    label: String,
    pub(crate) is_angle: bool,
}

/// The columns for one direction through the values of a parameter.
pub(crate) struct DiagramSweep {
    pub(crate) name: &'static str,
    pub(crate) columns: Vec<DiagramColumn>,
}

/// The section: one state component against another, one colour for each motion.
pub(crate) fn section(
    model: &Model,
    starts: &[Vec<f64>],
    sections: &[PoincareSection],
    [across, up]: &[StateAxis; 2],
) -> Picture {
    let all: usize = sections.iter().map(|section| section.points.len()).sum();
    let of_motion = |(number, section): (usize, &PoincareSection)| {
        let points = section.points.iter().map(|point| (across.value(&point.state), up.value(&point.state)));
        Series::line("", style::dots(number, all), points)
    };
    let series: Vec<Series> = sections.iter().enumerate().map(of_motion).collect();
    let x = across.axis(series.iter().flat_map(|one| one.points.iter().map(|point| point.x)));
    let y = up.axis(series.iter().flat_map(|one| one.points.iter().map(|point| point.y)));
    let title = format!("Poincaré section: {}", name(model));
    let picture = Picture::new(&title, vec![Panel { x, y, series, share: 1.0 }]);
    let start = match starts {
        [start] => of_start(model, start, AngleUnit::Radians),
        _ => vec![],
    };
    Picture { aspect: 0.8, ..picture.with_parameters([of_model(model), start].concat()) }
}

/// The diagram: one number of the state against the parameter, one colour a sweep.
pub(crate) fn bifurcation(
    model: &Model,
    parameter: &str,
    sweeps: &[DiagramSweep],
    up: &StateAxis,
) -> Picture {
    let columns = || sweeps.iter().flat_map(|sweep| &sweep.columns);
    let all: usize = columns().map(|column| column.section.points.len()).sum();
    let of_sweep = |(number, sweep): (usize, &DiagramSweep)| {
        let columns = sweep.columns.iter();
        let points = columns.flat_map(|column| {
            column.section.points.iter().map(|point| (column.value, up.value(&point.state)))
        });
        let label = if sweeps.len() > 1 { sweep.name } else { "" };
        // The sweep that is drawn first shows behind the other.
        let look = style::dots(number, all);
        let wider = if number + 1 < sweeps.len() { 1.7 } else { 1.0 };
        Series::line(label, Look { width: wider * look.width, ..look }, points)
    };
    let series: Vec<Series> = sweeps.iter().enumerate().map(of_sweep).collect();
    let (from, to) = around(columns().map(|column| column.value));
    let x = Axis::linear(&symbol(parameter), from, to);
    let y = up.axis(series.iter().flat_map(|one| one.points.iter().map(|point| point.y)));
    let title = format!("Bifurcation diagram: {}", name(model));
    Picture::new(&title, vec![Panel { x, y, series, share: 1.0 }]).with_parameters(of_model(model))
}

impl StateAxis {
    /// The state component with this index.
    pub(crate) fn new(model: &Model, component: usize) -> Self {
        let label = axis_label(&model.state_names()[component], &model.state_units()[component]);
        let is_angle = angles(model.equation()).get(component) == Some(&true);
        Self { component, label, is_angle }
    }

    fn value(&self, state: &[f64]) -> f64 {
        let value = state[self.component];
        if self.is_angle { folded(value) } else { value }
    }

    /// The name of the axis, with its unit.
    pub(super) fn label(&self) -> &str {
        &self.label
    }

    /// The name of the axis, without its unit.
    pub(crate) fn name(&self) -> &str {
        self.label.split(" / ").next().unwrap_or_default()
    }

    /// The unfolded values, with ticks at multiples of π for angles.
    pub(super) fn unfolded_axis(&self, values: impl Iterator<Item = f64>) -> Axis {
        let (low, high) = around(values);
        let axis = Axis::linear(&self.label, low, high);
        if self.is_angle { axis.in_units(Units::HalfTurns(PI)) } else { axis }
    }

    /// The whole turn for an angle that goes almost around, otherwise the range of the values.
    fn axis(&self, values: impl Iterator<Item = f64>) -> Axis {
        let (low, high) = around(values);
        let turns = self.is_angle && high - low > PI;
        match turns {
            true => Axis::linear(&self.label, -PI, PI).in_units(Units::HalfTurns(PI)),
            false => Axis::linear(&self.label, low, high),
        }
    }
}
