//! The coordinates of a system, and formulas, in time.

use super::animation::SampledCoordinates;
use super::chart::{Axis, Panel, Picture, Series, Units};
use super::names::{formula, subject, symbol};
use super::parameters::{AngleUnit, of_model, of_start};
use super::range::around;
use super::section::StateAxis;
use super::style;
use libration::systems::{Model, Observables};
use libration::taylor::{Moment, Step};

/// Points of a curve, evenly spaced in time.
pub(crate) const POINTS: u32 = 6000;
/// More marks on one curve would hide it.
const MOST_MARKS: usize = 1000;

/// The coordinates and the values of formulas at evenly spaced times, added during the integration.
#[derive(Debug)]
pub(crate) struct Trace<'a> {
    observables: Option<&'a Observables>,
    /// The earlier and the later end of the time axis.
    pub(super) ends: (f64, f64),
    end: f64,
    next: u32,
    pub(super) times: Vec<f64>,
    /// One list for each number of the state, the coordinates first.
    pub(super) values: Vec<Vec<f64>>,
    /// One list for each formula.
    pub(super) columns: Vec<Vec<f64>>,
    /// Events on the curve of each coordinate.
    pub(super) marks: Vec<Vec<(f64, f64)>>,
}

impl<'a> Trace<'a> {
    /// A trace from 0 to this time.
    pub(crate) fn new(model: &Model, observables: Option<&'a Observables>, end: f64) -> Self {
        let values = vec![vec![]; model.state_names().len()];
        let columns = vec![vec![]; observables.map_or(0, |observables| observables.names().len())];
        let marks = vec![vec![]; model.coordinates().len()];
        let ends = (end.min(0.0), end.max(0.0));
        Self { observables, ends, end, next: 0, times: vec![], values, columns, marks }
    }

    fn time(&self, sample: u32) -> f64 {
        self.end * f64::from(sample) / f64::from(POINTS)
    }

    /// Takes the state of a sample of the earlier result.
    pub(crate) fn earlier(&mut self, moment: &Moment) {
        self.push(moment);
        while self.next <= POINTS && self.time(self.next).abs() <= moment.time.abs() {
            self.next += 1;
        }
    }

    /// Takes the states of a step up to a time.
    pub(crate) fn follow(&mut self, step: &Step<'_>, end: f64) {
        while self.next <= POINTS && self.time(self.next).abs() <= end.abs() {
            let time = self.time(self.next);
            self.push(&Moment { time, state: step.state_at(time) });
            self.next += 1;
        }
    }

    /// Removes everything after a time.
    pub(crate) fn cut(&mut self, end: f64) {
        let kept = self.times.partition_point(|time| time.abs() <= end.abs());
        self.times.truncate(kept);
        self.values.iter_mut().chain(&mut self.columns).for_each(|values| values.truncate(kept));
    }

    /// The names of the formulas.
    pub(super) fn column_names(&self) -> &'a [String] {
        self.observables.map_or(&[], |observables| observables.names())
    }

    /// Marks an event on the curve of a coordinate.
    pub(crate) fn mark(&mut self, coordinate: usize, time: f64, state: &[f64]) {
        if self.marks[coordinate].len() < MOST_MARKS {
            self.marks[coordinate].push((time, state[coordinate]));
        }
    }

    fn push(&mut self, moment: &Moment) {
        self.times.push(moment.time);
        for (values, value) in self.values.iter_mut().zip(&moment.state) {
            values.push(*value);
        }
        let columns = self.observables.map_or(vec![], |observables| observables.values_at(moment));
        for (values, value) in self.columns.iter_mut().zip(columns) {
            values.push(value);
        }
    }

    /// The picture with the bodies that move.
    pub(crate) fn animated(&self, model: &Model, start: &[f64]) -> Picture {
        let sampled = SampledCoordinates { times: &self.times, values: &self.values };
        let units = units(model);
        sampled.animated(self.picture(model, start), model, |coordinate| {
            let unit = model.coordinates()[coordinate].unit.as_str();
            (units.iter().position(|shown| *shown == unit).unwrap_or(0), scale(unit))
        })
    }

    /// A panel for each unit, with the coordinates that have it, and one for each formula.
    pub(crate) fn picture(&self, model: &Model, start: &[f64]) -> Picture {
        let units = units(model);
        let time = Axis::linear("time t / s", self.ends.0, self.ends.1);
        let coordinates = units.iter().map(|unit| self.panel(model, unit, &time));
        let formulas = self
            .column_names()
            .iter()
            .zip(&self.columns)
            .map(|(name, values)| self.column(name, values, &time));
        let mut panels: Vec<Panel> = coordinates.chain(formulas).collect();
        let last = panels.len().saturating_sub(1);
        for panel in &mut panels[..last] {
            panel.x.label.clear();
        }
        let made_with = [of_model(model), of_start(model, start, AngleUnit::Degrees)].concat();
        Picture::new(&format!("Motion of {}", subject(model)), panels).with_parameters(made_with)
    }

    /// One state component against another.
    pub(crate) fn plane(&self, model: &Model, start: &[f64], [across, up]: &[StateAxis; 2]) -> Picture {
        let values = |shown: &StateAxis| self.values[shown.component].iter().copied();
        let path = Series::line("", style::curve(0), values(across).zip(values(up)));
        let begin = start.get(across.component).copied().zip(start.get(up.component).copied());
        let begin = Series::line("start", style::turning_points(1), begin);
        let title = format!("Motion of {}: {} against {}", subject(model), up.name(), across.name());
        let panel = Panel {
            x: across.unfolded_axis(values(across)),
            y: up.unfolded_axis(values(up)),
            series: vec![path, begin],
            share: 1.0,
        };
        let made_with = [of_model(model), of_start(model, start, AngleUnit::Radians)].concat();
        Picture { aspect: 0.8, ..Picture::new(&title, vec![panel]).with_parameters(made_with) }
    }

    fn panel(&self, model: &Model, unit: &str, time: &Axis) -> Panel {
        let shown = model.coordinates().iter().zip(&self.values).enumerate();
        let shown: Vec<_> = shown.filter(|(_, (coordinate, _))| coordinate.unit == unit).collect();
        let scale = scale(unit);
        let alone = shown.len() == 1;
        let mut series: Vec<Series> = shown
            .iter()
            .map(|(number, (coordinate, values))| {
                let label = if alone { String::new() } else { symbol(&coordinate.name) };
                let points = self.times.iter().copied().zip(values.iter().map(|value| scale * value));
                Series::line(&label, style::curve(*number), points)
            })
            .collect();
        series.extend(shown.iter().map(|(number, _)| {
            let points = self.marks[*number].iter().map(|(time, value)| (*time, scale * value));
            Series::line("", style::marks(*number), points)
        }));
        let names: Vec<String> = shown.iter().map(|(_, (coordinate, _))| symbol(&coordinate.name)).collect();
        let (low, high) = around(series.iter().flat_map(|series| series.points.iter().map(|point| point.y)));
        let y = Axis::linear(&label(&names.join(", "), unit), low, high);
        let y = if unit == "rad" { y.in_units(Units::Degrees) } else { y };
        Panel { x: time.clone(), y, series, share: 1.0 }
    }

    /// A formula in time.
    fn column(&self, name: &str, values: &[f64], time: &Axis) -> Panel {
        let points = self.times.iter().copied().zip(values.iter().copied());
        let series = vec![Series::line("", style::curve(0), points)];
        let (low, high) = around(values.iter().copied());
        Panel { x: time.clone(), y: Axis::linear(&formula(name), low, high), series, share: 1.0 }
    }
}

/// Traces before and after the start.
pub(crate) struct TwoTraces<'a>([Trace<'a>; 2]);

impl<'a> TwoTraces<'a> {
    /// Empty traces from 0 to the two ends.
    pub(crate) fn new(
        model: &Model,
        observables: Option<&'a Observables>,
        (first, last): (f64, f64),
    ) -> Self {
        Self([first, last].map(|end| Trace::new(model, observables, end)))
    }

    /// Takes the states of a step on its side.
    pub(crate) fn follow(&mut self, step: &Step<'_>) {
        let side = usize::from(step.end() > 0.0);
        self.0[side].follow(step, step.end());
    }

    /// The two traces as one, in the order of time.
    pub(crate) fn joined(self) -> Trace<'a> {
        let [before, after] = self.0;
        // Both begin at the start.
        let join =
            |before: Vec<f64>, after: Vec<f64>| before.into_iter().skip(1).rev().chain(after).collect();
        let join_all =
            |before: Vec<_>, after| before.into_iter().zip(after).map(|(b, a)| join(b, a)).collect();
        Trace {
            ends: (before.ends.0, after.ends.1),
            times: join(before.times, after.times),
            values: join_all(before.values, after.values),
            columns: join_all(before.columns, after.columns),
            ..after
        }
    }
}

/// The units of the coordinates, each once.
fn units(model: &Model) -> Vec<&str> {
    let mut units: Vec<&str> = vec![];
    for coordinate in model.coordinates() {
        if !units.contains(&coordinate.unit.as_str()) {
            units.push(&coordinate.unit);
        }
    }
    units
}

/// The factor from a unit to that of its axis.
pub(super) fn scale(unit: &str) -> f64 {
    if unit == "rad" { 1_f64.to_degrees() } else { 1.0 }
}

pub(super) fn label(names: &str, unit: &str) -> String {
    match unit {
        "rad" => format!("{names} / degrees"),
        "" => names.to_owned(),
        unit => format!("{names} / {unit}"),
    }
}
