//! What a picture shows, before anything is drawn: panels, axes, curves and points.

use super::frame::TITLE_SIZE;
use super::{letters, range};

/// A picture: panels one below the other, with a title above.
#[derive(Clone, Debug)]
pub(crate) struct Picture {
    pub(crate) title: String,
    pub(crate) width: f64,
    pub(crate) height: f64,
    pub(crate) panels: Vec<Panel>,
}

/// One pair of axes with what is drawn in them.
#[derive(Clone, Debug)]
pub(crate) struct Panel {
    pub(crate) x: Axis,
    pub(crate) y: Axis,
    pub(crate) series: Vec<Series>,
    /// The part of the picture's height it takes, relative to the other panels.
    pub(crate) share: f64,
}

/// An axis: its label with the unit, its ends, its scale and the distance of its ticks.
#[derive(Clone, Debug)]
pub(crate) struct Axis {
    pub(crate) label: String,
    pub(crate) from: f64,
    pub(crate) to: f64,
    pub(crate) scale: Scale,
    /// In values on a linear axis, in powers of ten on a logarithmic one.
    pub(crate) tick_step: f64,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Scale {
    Linear,
    Logarithmic,
}

/// Points that belong together, with the name the legend gives them; no legend entry when it is empty.
#[derive(Clone, Debug)]
pub(crate) struct Series {
    pub(crate) label: String,
    pub(crate) points: Vec<Point>,
    pub(crate) look: Look,
}

#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Point {
    pub(crate) x: f64,
    pub(crate) y: f64,
    pub(crate) x_uncertainty: Option<f64>,
    pub(crate) y_uncertainty: Option<f64>,
}

/// How a series is drawn: colour, a line or markers, and the width of the line or of half a marker.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Look {
    pub(crate) colour: &'static str,
    pub(crate) width: f64,
    pub(crate) mark: Mark,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Mark {
    /// A line with this dash pattern (SVG's `stroke-dasharray`); empty for a solid one.
    Line(&'static str),
    /// A marker at each point, by its number.
    Markers(usize),
}

/// More ticks than an axis is ever given; so many end also where the axis has no end.
const MOST_TICKS: u32 = 1000;
/// A longer title, in units of length, would make the picture wider.
const WIDEST_TITLE: f64 = 760.0;

impl Picture {
    /// A picture of the usual size.
    pub(crate) fn new(title: &str, panels: Vec<Panel>) -> Self {
        let title = letters::shortened(title, f64::from(TITLE_SIZE), WIDEST_TITLE);
        Self { title, width: 1200.0, height: 700.0, panels }
    }
}

impl Point {
    pub(crate) fn new(x: f64, y: f64) -> Self {
        Self { x, y, ..Self::default() }
    }
}

impl Axis {
    pub(crate) fn linear(label: &str, from: f64, to: f64) -> Self {
        let tick_step = range::tick_step(from, to);
        Self { label: label.to_owned(), from, to, scale: Scale::Linear, tick_step }
    }

    pub(crate) fn logarithmic(label: &str, from: f64, to: f64) -> Self {
        let decades = to.log10() - from.log10();
        let tick_step = (decades / 12.0).ceil();
        Self { scale: Scale::Logarithmic, tick_step, ..Self::linear(label, from, to) }
    }

    pub(crate) fn with_tick_step(self, step: f64) -> Self {
        Self { tick_step: step, ..self }
    }

    /// The coordinates of the ends.
    pub(crate) fn ends(&self) -> (f64, f64) {
        (self.coordinate(self.from), self.coordinate(self.to))
    }

    /// Where its ticks are, as coordinates.
    pub(super) fn ticks(&self) -> impl Iterator<Item = f64> {
        let (from, to) = self.ends();
        // Ticks at the ends are drawn whatever the last digit says.
        let slack = 1e-6 * self.tick_step;
        let first = ((from - slack) / self.tick_step).ceil();
        (0..MOST_TICKS)
            .map(move |place| (first + f64::from(place)) * self.tick_step)
            .take_while(move |tick| *tick <= to + slack)
    }

    /// Into how many parts the distance of two ticks divides the axis.
    pub(super) fn divisions(&self) -> f64 {
        let (from, to) = self.ends();
        ((to - from) / self.tick_step).min(f64::from(MOST_TICKS))
    }

    /// The position on the axis, in the coordinate in which the axis is evenly divided.
    pub(crate) fn coordinate(&self, value: f64) -> f64 {
        match self.scale {
            Scale::Linear => value,
            // Nothing at all is below every axis, but not so far that a line could not lead there.
            Scale::Logarithmic if value == 0.0 => f64::MIN_POSITIVE.log10(),
            Scale::Logarithmic => value.log10(),
        }
    }
}

impl Series {
    pub(crate) fn line(label: &str, look: Look, points: impl IntoIterator<Item = (f64, f64)>) -> Self {
        let points = points.into_iter().map(|(x, y)| Point::new(x, y)).collect();
        Self { label: label.to_owned(), points, look }
    }
}
