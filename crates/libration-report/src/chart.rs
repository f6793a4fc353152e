//! Content of a picture, before anything is drawn: panels, axes, curves and points.

/// A picture: panels one below the other, with a title above.
#[derive(Clone, Debug)]
pub struct Picture {
    /// Title above the whole picture, broken into lines if it is long.
    pub title: String,
    /// Parameters of the picture, such as `g = 9.80665 m/s²`; a line under the title.
    pub parameters: Vec<String>,
    /// The panels from the top.
    pub panels: Vec<Panel>,
    /// The common height of all axes as a fraction of their width, where no height is requested.
    pub aspect: f64,
    /// Animation next to the axes, for pictures that can move.
    pub animation: Option<Animation>,
}

/// Bodies that move next to the axes, and dots that follow the curves in the axes; the movement repeats.
#[derive(Clone, Debug)]
pub struct Animation {
    /// Duration of one cycle, in seconds.
    pub seconds: f64,
    /// Mechanism that moves next to the axes.
    pub mechanism: Mechanism,
    /// Dots that move in the axes.
    pub dots: Vec<MovingDot>,
}

/// Bodies at evenly spaced times.
#[derive(Clone, Debug)]
pub enum Mechanism {
    /// Bodies in a plane, on rods: positions to the right and upwards, in one unit of length.
    Plane(Vec<Hanging>),
    /// Bodies on level rails, one above the other: their positions, a list for each body.
    Rails(Vec<Vec<f64>>),
}

/// A body on a rod.
#[derive(Clone, Debug)]
pub struct Hanging {
    /// Positions of the body.
    pub places: Vec<(f64, f64)>,
    /// Positions of the other end of the rod.
    pub held: Vec<(f64, f64)>,
}

/// A dot that moves in the axes.
#[derive(Clone, Debug)]
pub struct MovingDot {
    /// The number of the panel.
    pub panel: usize,
    /// The colour of the curve that the dot follows.
    pub colour: &'static str,
    /// Positions at evenly spaced times, in the coordinates of the data.
    pub places: Vec<(f64, f64)>,
}

/// One pair of axes with its series.
#[derive(Clone, Debug)]
pub struct Panel {
    /// The horizontal axis.
    pub x: Axis,
    /// The vertical axis.
    pub y: Axis,
    /// Series in drawing order: the last one is in front.
    pub series: Vec<Series>,
    /// The height of the panel relative to the other panels.
    pub share: f64,
}

/// An axis: its label with the unit, its ends, its scale and where its ticks may be.
#[derive(Clone, Debug)]
pub struct Axis {
    /// The quantity and its unit; empty if the panel below has the label.
    pub label: String,
    /// The value at the left or lower end.
    pub from: f64,
    /// The value at the right or upper end.
    pub to: f64,
    /// Scale of the values.
    pub scale: Scale,
    /// Units of the ticks.
    pub units: Units,
}

/// The spacing of values along an axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scale {
    /// Linear.
    Linear,
    /// Logarithmic: each power of ten has the same length.
    Logarithmic,
}

/// The units of which the ticks of an axis are multiples.
#[derive(Clone, Debug, PartialEq)]
pub enum Units {
    /// 1, 2 or 5 times a power of ten.
    Decimal,
    /// 1, 2 or 5 times a power of ten that is at least 1.
    Whole,
    /// 15°, 30°, 45°, 90° and turns.
    Degrees,
    /// π/4, π/2, π and so on; the number is the value of π in the units of the axis.
    HalfTurns(f64),
    /// Words at 1, 2, 3 and so on.
    Names(Vec<String>),
}

/// Points that belong together, with their name in the legend; a series with an empty name has no legend entry.
#[derive(Clone, Debug)]
pub struct Series {
    /// The name in the legend.
    pub label: String,
    /// Points of the series.
    pub points: Vec<Point>,
    /// Look of the series.
    pub look: Look,
}

/// A position in the coordinates of the data, with uncertainties where they are known.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Point {
    /// Horizontal coordinate.
    pub x: f64,
    /// Vertical coordinate.
    pub y: f64,
    /// Half the length of the horizontal error bar.
    pub x_uncertainty: Option<f64>,
    /// Half the length of the vertical error bar.
    pub y_uncertainty: Option<f64>,
}

/// The look of a series. The unit of length is a sixteenth of the letter size.
#[derive(Clone, Debug, PartialEq)]
pub struct Look {
    /// Colour as `#RRGGBB`, one of [`style`](crate::style).
    pub colour: &'static str,
    /// The width of a line, or half of a marker.
    pub width: f64,
    /// Opacity, from 0 (invisible) to 1.
    pub opacity: f64,
    /// A line, markers or a band.
    pub mark: Mark,
}

/// The marks at or between points.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Mark {
    /// A line with alternating lengths of dashes and gaps; solid if the list is empty.
    Line(&'static [f64]),
    /// A marker at each point, by the number of its shape (circle, square, triangle, diamond), with error bars.
    Markers(usize),
    /// A filled area between the ends of the uncertainties.
    Band,
}

impl Picture {
    /// A picture of the usual shape, about that of a page in landscape format.
    pub fn new(title: &str, panels: Vec<Panel>) -> Self {
        Self { title: title.to_owned(), parameters: vec![], panels, aspect: 0.6, animation: None }
    }

    /// The picture with its parameters under the title.
    #[must_use]
    pub fn with_parameters(self, parameters: impl IntoIterator<Item = String>) -> Self {
        Self { parameters: parameters.into_iter().collect(), ..self }
    }
}

impl Point {
    /// A point without uncertainties.
    pub fn new(x: f64, y: f64) -> Self {
        Self { x, y, ..Self::default() }
    }

    /// The ends of the vertical error bar.
    pub fn vertical_ends(&self) -> [f64; 2] {
        let half = self.y_uncertainty.unwrap_or(0.0);
        [self.y - half, self.y + half]
    }
}

impl Axis {
    /// A linear axis.
    pub fn linear(label: &str, from: f64, to: f64) -> Self {
        Self { label: label.to_owned(), from, to, scale: Scale::Linear, units: Units::Decimal }
    }

    /// A logarithmic axis; both ends are positive.
    pub fn logarithmic(label: &str, from: f64, to: f64) -> Self {
        Self { scale: Scale::Logarithmic, ..Self::linear(label, from, to) }
    }

    /// The axis with ticks at multiples of these units.
    #[must_use]
    pub fn in_units(self, units: Units) -> Self {
        Self { units, ..self }
    }

    /// The same axis without its label, for a panel above another one that has the label.
    #[must_use]
    pub fn unlabelled(&self) -> Self {
        Self { label: String::new(), ..self.clone() }
    }

    /// The coordinates of the two ends.
    pub fn ends(&self) -> (f64, f64) {
        (self.coordinate(self.from), self.coordinate(self.to))
    }

    /// The coordinate of a value in which the axis is evenly divided.
    pub fn coordinate(&self, value: f64) -> f64 {
        match self.scale {
            Scale::Linear => value,
            // Zero lies below every logarithmic axis, but at a finite distance, so that lines to it can be drawn.
            Scale::Logarithmic if value == 0.0 => f64::MIN_POSITIVE.log10(),
            Scale::Logarithmic => value.log10(),
        }
    }

    /// The position of a value as a fraction of the length of the axis.
    pub(crate) fn part(&self, value: f64) -> f64 {
        let (from, to) = self.ends();
        (self.coordinate(value) - from) / (to - from)
    }

    /// Returns `true` if the ticks and tick labels of one axis also serve the other.
    pub(crate) fn is_in_line_with(&self, other: &Self) -> bool {
        let same = |a: f64, b: f64| a.to_bits() == b.to_bits();
        same(self.from, other.from) && same(self.to, other.to) && self.scale == other.scale
    }
}

impl Series {
    /// A series of points without uncertainties.
    pub fn line(label: &str, look: Look, points: impl IntoIterator<Item = (f64, f64)>) -> Self {
        let points = points.into_iter().map(|(x, y)| Point::new(x, y)).collect();
        Self { label: label.to_owned(), points, look }
    }
}

impl Look {
    /// The same curve, wider and paler, to be drawn beneath a curve that would hide it.
    #[must_use]
    pub fn beneath(self) -> Self {
        Self { width: 3.2 * self.width, opacity: 0.35, mark: Mark::Line(&[]), ..self }
    }
}
