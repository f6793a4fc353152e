//! Layout of a picture: title, parameters, legends, axes and their labels. All heights follow from the width, because text is broken into lines;
//! the axes share the rest of the height.

use crate::chart::{Axis, Panel, Picture};
use crate::format::{PictureFormat, TooSmall};
use crate::legend::Legend;
use crate::letters::{LINE, width, wrapped};
use crate::scene::Place;
use crate::ticks::{self, Ticks};

/// All lengths below are in units of the letter size. Margin on every side:
pub(crate) const PADDING: f64 = 0.6;
pub(crate) const TITLE: f64 = 1.1;
const UNDER_WORDS: f64 = 0.25;
/// Margin above the axes, for half of the label of a tick at the top.
const TOP: f64 = 0.6;
/// Distance from the axes to the base line of the labels below, and the height of these labels.
pub(crate) const TICK_BASE: f64 = 1.35;
const TICK_LABELS: f64 = 1.6;
/// Margin below axes whose ticks are labelled at the next panel.
const BOTTOM: f64 = 0.35;
/// Gap between the labels of ticks and their axis.
pub(crate) const TICK_GAP: f64 = 0.4;
/// Gap between two adjacent labels of ticks.
const LABELS_APART: f64 = 0.7;
/// Gap between the name of an axis and the labels of its ticks.
pub(crate) const NAME_GAP: f64 = 0.35;
/// Margin right of the last tick's label.
const EDGE: f64 = 0.2;
/// Least margin right of the axes.
const RIGHT: f64 = 0.7;
/// Approximate fraction of the width that the axes take.
const AXES: f64 = 0.85;
/// Least height of axes: shorter ones show nothing.
const SHORTEST: f64 = 6.0;

/// The side of the square of the animation as a fraction of the width, and its least length.
const STAGE: f64 = 0.28;
const SMALLEST_STAGE: f64 = 9.0;
/// Least fraction of the width for the axes if the legend stands next to them; otherwise the legend stands above. In a column of a journal only
/// three ticks would be left.
const BESIDE: f64 = 0.5;

/// A space at which no line is broken.
const TIE: &str = "\u{a0}";

/// The parts of a picture in a format. All lengths and positions are in units of the letter size.
#[derive(Clone, Debug)]
pub(crate) struct Frame {
    pub(crate) width: f64,
    pub(crate) height: f64,
    pub(crate) title: Vec<String>,
    pub(crate) parameters: Vec<String>,
    pub(crate) left: f64,
    pub(crate) right: f64,
    pub(crate) cells: Vec<Cell>,
    /// Stage of the animation.
    pub(crate) stage: Option<Stage>,
}

/// The square of the animation.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Stage {
    pub(crate) side: f64,
    pub(crate) middle: Place,
}

/// The parts of a panel.
#[derive(Clone, Debug)]
pub(crate) struct Cell {
    pub(crate) legend: Legend,
    pub(crate) legend_top: f64,
    pub(crate) top: f64,
    pub(crate) height: f64,
    pub(crate) x_name: Vec<String>,
    pub(crate) y_name: Vec<String>,
    pub(crate) x_ticks: Ticks,
    pub(crate) y_ticks: Ticks,
    pub(crate) has_x_labels: bool,
}

impl Frame {
    /// The position on the canvas for a position in fractions of the axes.
    pub(crate) fn position(&self, cell: &Cell, (x, y): Place, em: f64) -> Place {
        let across = self.left + x * (self.right - self.left);
        (em * across, em * (cell.top + (1.0 - y) * cell.height))
    }

    /// The layout of the picture in the format, if the format can hold it.
    pub(crate) fn new(picture: &Picture, format: &PictureFormat) -> Result<Self, TooSmall> {
        let em = format.text;
        // Sizes are compared with whole units: a rounding error must not make a size too small.
        const SLACK: f64 = 1e-9;
        let least_width = least_width(picture);
        let wide = format.width / em;
        if wide < least_width - SLACK {
            return Err(TooSmall::Width(em * least_width));
        }
        let words = Words::new(picture, wide);
        let least = words.least_height(picture);
        let high = match format.height {
            Some(height) if height / em < least - SLACK => return Err(TooSmall::Height(em * least)),
            Some(height) => height / em,
            // Legend entries make a picture higher; they do not make its axes lower.
            None => least.max(words.fixed() + picture.aspect * AXES * wide),
        };
        Ok(words.laid_out(picture, wide, high))
    }
}

/// The width below which axes with their labels would show nothing.
fn least_width(picture: &Picture) -> f64 {
    let axes = |panel: &Panel| ticks::least_length(&panel.x, x_extent).max(SHORTEST);
    let axes = picture.panels.iter().map(axes).fold(SHORTEST, f64::max);
    widest_left(picture) + axes + right(picture) + PADDING
}

/// Largest distance between the left edge of the picture and the axes, over all panels.
fn widest_left(picture: &Picture) -> f64 {
    let left = picture.panels.iter().map(|panel| left(panel, shortest(panel), ticks::labels(&panel.y)));
    left.fold(0.0, f64::max)
}

/// The space of the animation.
#[derive(Clone, Copy, Debug)]
enum Room {
    /// No animation.
    None,
    /// A square of this side to the left of the axes.
    Beside(f64),
    /// A square of this side above the axes.
    Above(f64),
}

impl Room {
    fn new(picture: &Picture, wide: f64) -> Self {
        let side = (STAGE * wide).max(SMALLEST_STAGE);
        let axes = wide - side - widest_left(picture) - right(picture) - PADDING;
        match picture.animation {
            None => Self::None,
            Some(_) if axes >= BESIDE * wide => Self::Beside(side),
            Some(_) => Self::Above(side),
        }
    }

    /// The width that the animation takes from the axes.
    fn beside(self) -> f64 {
        if let Self::Beside(side) = self { side } else { 0.0 }
    }

    /// The height that the animation takes from the axes.
    fn above(self) -> f64 {
        if let Self::Above(side) = self { side } else { 0.0 }
    }
}

/// The least height of the axes of a panel: the label next to them takes two or three lines.
fn shortest(panel: &Panel) -> f64 {
    let ticks = ticks::least_length(&panel.y, y_extent);
    ticks.max(SHORTEST).max(0.5 * width(&panel.y.label, 1.0))
}

/// Distance from the left edge of the picture to the axes.
fn left(panel: &Panel, height: f64, labels: impl Iterator<Item = String>) -> f64 {
    let name: f64 = named(&panel.y, height).iter().map(|_| LINE).sum();
    let widest = labels.map(|label| width(&label, 1.0)).fold(0.0, f64::max);
    PADDING + name + NAME_GAP + widest + TICK_GAP
}

/// Distance from the axes to the right edge, without the padding: half of the label of a tick at the end.
fn right(picture: &Picture) -> f64 {
    let labels = picture.panels.iter().flat_map(|panel| ticks::labels(&panel.x));
    labels.map(|label| 0.5 * width(&label, 1.0) + EDGE - PADDING).fold(RIGHT - PADDING, f64::max)
}

fn x_extent(label: &str) -> f64 {
    width(label, 1.0) + LABELS_APART
}

fn y_extent(_: &str) -> f64 {
    LINE + 0.3
}

/// The label of an axis in lines; a unit stays with its slash.
fn named(axis: &Axis, length: f64) -> Vec<String> {
    wrapped(&axis.label.replace("/ ", &format!("/{TIE}")), 1.0, length)
}

/// The texts of a picture in lines, for a given width.
struct Words {
    title: Vec<String>,
    parameters: Vec<String>,
    panels: Vec<Beside>,
    room: Room,
}

/// Texts above and below the axes of a panel.
struct Beside {
    legend: Legend,
    x_name: Vec<String>,
    has_x_labels: bool,
}

impl Words {
    fn new(picture: &Picture, wide: f64) -> Self {
        let across = wide - 2.0 * PADDING;
        let parameters: Vec<String> = picture.parameters.iter().map(|one| one.replace(' ', TIE)).collect();
        let panels = picture.panels.iter().enumerate().map(|(number, panel)| Beside {
            legend: Legend::new(panel, across),
            x_name: named(&panel.x, across),
            has_x_labels: has_x_labels(panel, picture.panels.get(number + 1)),
        });
        Self {
            title: wrapped(&picture.title, TITLE, across),
            parameters: wrapped(&parameters.join(", "), 1.0, across),
            panels: panels.collect(),
            room: Room::new(picture, wide),
        }
    }

    /// Height above all panels and above the animation.
    fn head(&self) -> f64 {
        let title: f64 = self.title.iter().map(|_| TITLE * LINE).sum();
        let parameters: f64 = self.parameters.iter().map(|_| LINE).sum();
        PADDING + title + parameters + UNDER_WORDS
    }

    /// The height of everything except the axes.
    fn fixed(&self) -> f64 {
        let panels = self.panels.iter().map(|panel| panel.above() + panel.below());
        self.head() + self.room.above() + panels.sum::<f64>() + PADDING
    }

    fn least_height(&self, picture: &Picture) -> f64 {
        let all: f64 = picture.panels.iter().map(|panel| panel.share).sum();
        let needed = picture.panels.iter().map(|panel| shortest(panel) * all / panel.share);
        self.fixed() + needed.fold(self.room.beside(), f64::max)
    }

    /// The square of the animation: left of the axes at half their height, or above them at half the width.
    fn stage(&self, width: f64, height: f64) -> Option<Stage> {
        let axes = |panel: Option<&Beside>, beside: &dyn Fn(&Beside) -> f64| panel.map_or(0.0, beside);
        let top = self.head() + axes(self.panels.first(), &Beside::above);
        let bottom = height - PADDING - axes(self.panels.last(), &Beside::below);
        match self.room {
            Room::None => None,
            Room::Beside(side) => {
                Some(Stage { side, middle: (PADDING + 0.5 * side, f64::midpoint(top, bottom)) })
            }
            Room::Above(side) => Some(Stage { side, middle: (0.5 * width, self.head() + 0.5 * side) }),
        }
    }

    fn laid_out(self, picture: &Picture, width: f64, height: f64) -> Frame {
        let free = height - self.fixed();
        let all: f64 = picture.panels.iter().map(|panel| panel.share).sum();
        let heights = picture.panels.iter().map(|panel| free * panel.share / all);
        let y_ticks: Vec<Ticks> = picture
            .panels
            .iter()
            .zip(heights.clone())
            .map(|(panel, height)| ticks::chosen(&panel.y, height, y_extent))
            .collect();
        let beside =
            picture.panels.iter().zip(heights.clone()).zip(&y_ticks).map(|((panel, height), ticks)| {
                left(panel, height, ticks.labelled.iter().map(|(_, label)| label.clone()))
            });
        let left = self.room.beside() + beside.fold(0.0, f64::max);
        let right = width - PADDING - right(picture);
        let mut top = self.head() + self.room.above();
        let stage = self.stage(width, height);
        let mut cells = vec![];
        let Self { title, parameters, panels: besides, .. } = self;
        for (((panel, beside), height), y_ticks) in
            picture.panels.iter().zip(besides).zip(heights).zip(y_ticks)
        {
            let (above, below) = (beside.above(), beside.below());
            cells.push(Cell {
                legend_top: top,
                top: top + above,
                height,
                y_name: named(&panel.y, height),
                x_ticks: ticks::chosen(&panel.x, right - left, x_extent),
                y_ticks,
                legend: beside.legend,
                x_name: beside.x_name,
                has_x_labels: beside.has_x_labels,
            });
            top += above + height + below;
        }
        Frame { width, height, title, parameters, left, right, cells, stage }
    }
}

/// Returns `true` if the ticks of the horizontal axis are labelled at this panel and not below the next one.
fn has_x_labels(panel: &Panel, next: Option<&Panel>) -> bool {
    !(panel.x.label.is_empty() && next.is_some_and(|next| panel.x.is_in_line_with(&next.x)))
}

impl Beside {
    fn above(&self) -> f64 {
        self.legend.height + TOP
    }

    fn below(&self) -> f64 {
        let ticks = if self.has_x_labels { TICK_LABELS } else { BOTTOM };
        ticks + self.x_name.iter().map(|_| LINE).sum::<f64>()
    }
}
