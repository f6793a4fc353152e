//! Input of a renderer: lines, dots, areas and text at positions on a canvas.

/// A position on the canvas: distance from the left and from the top.
pub type Place = (f64, f64);

/// A drawing with a description for those who cannot see it.
#[derive(Clone, Debug)]
pub struct Scene {
    /// Width in units of 1/96 inch.
    pub width: f64,
    /// Height in units of 1/96 inch.
    pub height: f64,
    /// Title of the drawing.
    pub title: String,
    /// Description in sentences.
    pub description: String,
    /// Title, parameters and legends.
    pub words: Vec<Shape>,
    /// The panels, each with its axes and everything in and around them.
    pub panels: Vec<Vec<Shape>>,
    /// Moving shapes, in front of everything.
    pub moving: Vec<Moving>,
    /// Duration of one cycle of the movement, in seconds.
    pub seconds: f64,
}

/// A shape that moves.
#[derive(Clone, Debug, PartialEq)]
pub struct Moving {
    /// A line or a dot.
    pub form: MovingForm,
    /// Colour as `#RRGGBB`.
    pub colour: &'static str,
    /// The corners of the line, or the centre of the dot, at evenly spaced times from the first to the last.
    pub frames: Vec<Vec<Place>>,
}

/// The look of a moving shape.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum MovingForm {
    /// An open line.
    Line {
        /// The width of the line.
        width: f64,
    },
    /// A filled circle.
    Dot {
        /// The radius of the circle.
        radius: f64,
    },
}

/// A shape to draw.
#[derive(Clone, Debug, PartialEq)]
pub struct Shape {
    /// Role of the shape.
    pub role: ShapeRole,
    /// Lines, areas, dots or text.
    pub form: Form,
    /// Colour as `#RRGGBB`.
    pub colour: &'static str,
    /// Opacity, from 0 to 1.
    pub opacity: f64,
}

/// The role of a shape.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ShapeRole {
    /// The box of the axes.
    Frame,
    /// The ticks of the axes.
    Tick,
    /// The label of a tick below the axes.
    XTickLabel,
    /// The label of a tick next to the axes.
    YTickLabel,
    /// A name of an axis.
    AxisLabel,
    /// A curve of data.
    Curve,
    /// Markers of data.
    Markers,
    /// Bars of uncertainty.
    Bars,
    /// A filled range.
    Band,
    /// A sample in the legend.
    Sample,
    /// A name in the legend.
    Name,
    /// The title.
    Title,
    /// The parameters under the title.
    Parameters,
}

/// The look of a shape.
#[derive(Clone, Debug, PartialEq)]
pub enum Form {
    /// Open lines with alternating dashes and gaps; solid if there are none.
    Lines {
        /// Each line with its corners.
        pieces: Vec<Vec<Place>>,
        /// The width of the line.
        width: f64,
        /// Lengths of dashes and gaps.
        dashes: Vec<f64>,
    },
    /// Filled polygons.
    Areas(Vec<Vec<Place>>),
    /// Filled circles.
    Dots {
        /// Centres of the circles.
        places: Vec<Place>,
        /// The common radius of the circles.
        radius: f64,
    },
    /// A line of text.
    Text(Text),
}

/// A line of text.
#[derive(Clone, Debug, PartialEq)]
pub struct Text {
    /// The letters.
    pub content: String,
    /// Position of the beginning, the middle or the end of the base line.
    pub at: Place,
    /// The part of the text that is at the position.
    pub anchor: Anchor,
    /// The size of the letters.
    pub size: f64,
    /// `true` if the text reads upwards.
    pub is_turned: bool,
}

/// The part of a text that is at its position.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Anchor {
    /// The beginning.
    Start,
    /// The middle.
    Middle,
    /// The end.
    End,
}

impl Scene {
    /// All shapes in the order in which they are drawn.
    pub fn shapes(&self) -> impl Iterator<Item = &Shape> {
        self.panels.iter().flatten().chain(&self.words)
    }
}
