//! Content of a picture, before anything is drawn: panels, axes, curves and points.

/// A picture: panels one below the other, with a title above.
#[derive(Clone, Debug)]
pub struct Picture {
    /// Title over the whole picture; broken into lines where it is long.
    pub title: String,
    /// Parameters of the picture, such as `g = 9.80665 m/s²`; a line under the title.
    pub parameters: Vec<String>,
    /// The panels from the top.
    pub panels: Vec<Panel>,
    /// The height of all axes as a part of their width, where no height is requested.
    pub aspect: f64,
    /// Animation next to the axes, for pictures that can move.
    pub animation: Option<Animation>,
}

/// Bodies that move next to the axes, and dots that follow curves in them, again and again.
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
    /// Positions at evenly spaced times.
    pub places: Vec<(f64, f64)>,
}

/// One pair of axes with its series.
#[derive(Clone, Debug)]
pub struct Panel {
    /// Across.
    pub x: Axis,
    /// Upwards.
    pub y: Axis,
    /// Series in the order of drawing: the last is in front.
    pub series: Vec<Series>,
    /// The part of the height of all axes it takes, relative to the other panels.
    pub share: f64,
}

/// An axis: its label with the unit, its ends, its scale and where its ticks may be.
#[derive(Clone, Debug)]
pub struct Axis {
    /// The quantity and its unit; empty where the panel below says it.
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
    /// Evenly.
    Linear,
    /// Each power of ten takes as much.
    Logarithmic,
}

/// The units of which the ticks of an axis are multiples.
#[derive(Clone, Debug, PartialEq)]
pub enum Units {
    /// 1, 2 or 5 times a power of ten.
    Decimal,
    /// The same, but nothing below 1.
    Whole,
    /// 15°, 30°, 45°, 90° and turns.
    Degrees,
    /// π/4, π/2, π and so on, where π on the axis is this number.
    HalfTurns(f64),
    /// Words at 1, 2, 3 and so on.
    Names(Vec<String>),
}

/// Points that belong together, with the name the legend gives them; no legend entry when it is empty.
#[derive(Clone, Debug)]
pub struct Series {
    /// The name.
    pub label: String,
    /// Points of the series.
    pub points: Vec<Point>,
    /// Look of the series.
    pub look: Look,
}

/// A place in the coordinates of the data, with uncertainties where they are known.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Point {
    /// Across.
    pub x: f64,
    /// Upwards.
    pub y: f64,
    /// Half the width of a bar across.
    pub x_uncertainty: Option<f64>,
    /// Half the height of a bar upwards.
    pub y_uncertainty: Option<f64>,
}

/// The look of a series. Lengths are in units of which a letter is 16 high.
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
    /// A line with these lengths of dashes and gaps by turns; solid without any.
    Line(&'static [f64]),
    /// A marker at each point, by its number: circle, square, triangle, diamond; with bars for uncertainties.
    Markers(usize),
    /// A filled area within the uncertainty of the points.
    Band,
}

impl Picture {
    /// A picture of the usual shape, about that of a page laid across.
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
}

impl Axis {
    /// An even axis.
    pub fn linear(label: &str, from: f64, to: f64) -> Self {
        Self { label: label.to_owned(), from, to, scale: Scale::Linear, units: Units::Decimal }
    }

    /// An axis of powers of ten; both ends are above zero.
    pub fn logarithmic(label: &str, from: f64, to: f64) -> Self {
        Self { scale: Scale::Logarithmic, ..Self::linear(label, from, to) }
    }

    /// The axis with ticks at multiples of these.
    #[must_use]
    pub fn in_units(self, units: Units) -> Self {
        Self { units, ..self }
    }

    /// The same axis without its name, for a panel above one that says it.
    #[must_use]
    pub fn unlabelled(&self) -> Self {
        Self { label: String::new(), ..self.clone() }
    }

    /// The coordinates of the ends.
    pub fn ends(&self) -> (f64, f64) {
        (self.coordinate(self.from), self.coordinate(self.to))
    }

    /// The position on the axis, in the coordinate in which the axis is evenly divided.
    pub fn coordinate(&self, value: f64) -> f64 {
        match self.scale {
            Scale::Linear => value,
            // Nothing at all is below every axis, but not so far that a line could not lead there.
            Scale::Logarithmic if value == 0.0 => f64::MIN_POSITIVE.log10(),
            Scale::Logarithmic => value.log10(),
        }
    }

    /// The position of a value as a part of the length of the axis.
    pub(crate) fn part(&self, value: f64) -> f64 {
        let (from, to) = self.ends();
        (self.coordinate(value) - from) / (to - from)
    }

    /// Returns `true` if ticks and their labels of one serve the other too.
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
    /// The same curve as a wide pale one, to be drawn beneath what would hide it.
    #[must_use]
    pub fn beneath(self) -> Self {
        Self { width: 3.2 * self.width, opacity: 0.35, mark: Mark::Line(&[]), ..self }
    }
}
