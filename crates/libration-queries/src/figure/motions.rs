//! Several motions of a system, with other starts and parameters, in one picture.

use super::chart::{Axis, Panel, Picture, Series, Units};
use super::names::{formula, subject, symbol};
use super::parameters::of_model;
use super::range::around;
use super::section::StateAxis;
use super::simulation::{Trace, label, scale};
use super::style;
use libration::systems::Model;

/// More motions than this are not distinguished.
pub(crate) const MOST_CURVES: usize = 12;

/// Motions with their labels.
pub(crate) struct Motions<'a> {
    /// The model without the parameters in which the motions differ.
    pub(crate) model: &'a Model,
    pub(crate) traces: Vec<(String, &'a Trace<'a>)>,
}

impl Motions<'_> {
    /// A panel for each coordinate and each formula, with a curve for each motion.
    pub(crate) fn in_time(&self) -> Picture {
        let coordinates = self.model.coordinates().iter().enumerate();
        let coordinates = coordinates.map(|(index, coordinate)| {
            let unit = coordinate.unit.as_str();
            let panel =
                self.panel(label(&symbol(&coordinate.name), unit), scale(unit), |trace| &trace.values[index]);
            let marks = self.marks(index, scale(unit));
            let y = if unit == "rad" { panel.y.in_units(Units::Degrees) } else { panel.y };
            Panel { y, series: [panel.series, marks].concat(), ..panel }
        });
        let names = self.traces.first().map_or(&[][..], |(_, trace)| trace.column_names());
        let formulas = names.iter().enumerate();
        let formulas =
            formulas.map(|(index, name)| self.panel(formula(name), 1.0, |trace| &trace.columns[index]));
        let mut panels: Vec<Panel> = coordinates.chain(formulas).collect();
        let last = panels.len().saturating_sub(1);
        panels[..last].iter_mut().for_each(|panel| panel.x.label.clear());
        // One legend tells all.
        panels.iter_mut().skip(1).flat_map(|panel| &mut panel.series).for_each(|series| series.label.clear());
        let title = format!("Motions of {}", subject(self.model));
        Picture::new(&title, panels).with_parameters(of_model(self.model))
    }

    /// One state component against another.
    pub(crate) fn in_plane(&self, [across, up]: &[StateAxis; 2]) -> Picture {
        let values = |trace: &Trace<'_>, shown: &StateAxis| trace.values[shown.component].clone();
        let curve = |(number, (label, trace)): (usize, &(String, &Trace<'_>))| {
            let points = values(trace, across).into_iter().zip(values(trace, up));
            Series::line(label, style::curve(number), points)
        };
        let axis = |shown: &StateAxis| {
            shown.unfolded_axis(self.traces.iter().flat_map(|(_, trace)| values(trace, shown)))
        };
        let series = self.traces.iter().enumerate().map(curve).collect();
        let panel = Panel { x: axis(across), y: axis(up), series, share: 1.0 };
        let title = format!("Motions of {}: {} against {}", subject(self.model), up.name(), across.name());
        Picture { aspect: 0.8, ..Picture::new(&title, vec![panel]).with_parameters(of_model(self.model)) }
    }

    fn panel(&self, label: String, scale: f64, shown: impl for<'t> Fn(&'t Trace<'_>) -> &'t [f64]) -> Panel {
        let (from, to) = self.traces.first().map_or((0.0, 0.0), |(_, trace)| trace.ends);
        let curve = |(number, (label, trace)): (usize, &(String, &Trace<'_>))| {
            let points = trace.times.iter().copied().zip(shown(trace).iter().map(|value| scale * value));
            Series::line(label, style::curve(number), points)
        };
        let series: Vec<Series> = self.traces.iter().enumerate().map(curve).collect();
        let (low, high) = around(series.iter().flat_map(|series| series.points.iter().map(|point| point.y)));
        let x = Axis::linear("time t / s", from, to);
        Panel { x, y: Axis::linear(&label, low, high), series, share: 1.0 }
    }

    /// The events on the curves of a coordinate.
    fn marks(&self, coordinate: usize, scale: f64) -> Vec<Series> {
        let marks = self.traces.iter().enumerate().map(|(number, (_, trace))| {
            let points = trace.marks[coordinate].iter().map(|(time, value)| (*time, scale * value));
            Series::line("", style::marks(number), points)
        });
        marks.collect()
    }
}
