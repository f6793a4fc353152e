//! Where the parts of a picture stand: title, panels, legends; and the smallest size that holds them.

use super::chart::{Axis, Panel, Picture, Scale};
use super::{legend, letters};
use crate::output::number;

pub(super) const TITLE_SIZE: u32 = 22;
pub(super) const LABEL_SIZE: u32 = 20;
pub(super) const TICK_SIZE: u32 = 17;

/// Around all panels.
pub(super) const PADDING: f64 = 10.0;
/// Between two panels.
pub(super) const SPACING: f64 = 15.0;
/// What the drawing library gives to a title of this size above the panels.
const TITLE_BAND: f64 = 34.409375;
/// Above and below the axes of a panel; below are the labels of the ticks and of the axis.
pub(super) const TOP_MARGIN: f64 = 10.0;
pub(super) const BOTTOM_MARGIN: f64 = 62.0;
/// The same for all panels, so that their axes stand in line.
const LEFT_MARGIN: f64 = 104.0;
/// The labels of ticks for which that is enough, beside the label of the axis.
const USUAL_LABELS: f64 = 70.0;
/// Room for half of the last tick's label.
const RIGHT_MARGIN: f64 = 24.0;
/// Between the labels of two ticks that stand side by side.
const GAP: f64 = 6.0;
/// Lines of text need so much more than the size of their font.
const LINE: f64 = 1.2;
/// Axes that are smaller show nothing.
const SMALLEST_AXIS: f64 = 60.0;

/// The parts of a picture of a certain size.
#[derive(Clone, Debug)]
pub(super) struct Frame {
    pub(super) width: f64,
    pub(super) height: f64,
    pub(super) left_margin: f64,
    pub(super) right_margin: f64,
    pub(super) legend_width: f64,
    /// The top and the height of each panel.
    pub(super) cells: Vec<(f64, f64)>,
}

impl Frame {
    /// The frame of the picture at its size, or at the smallest that holds it.
    pub(super) fn new(picture: &Picture) -> Self {
        let smallest = Smallest::of(picture);
        let (width, height) = (picture.width.max(smallest.width), picture.height.max(smallest.height));
        let mut top = TITLE_BAND + PADDING;
        let heights = shares(picture).map(|share| share * (height - between(picture)));
        let cells = heights.map(|height| {
            let cell = (top, height);
            top += height + SPACING;
            cell
        });
        Self {
            width,
            height,
            left_margin: left_margin(picture),
            right_margin: right_margin(picture),
            legend_width: legend::width(picture),
            cells: cells.collect(),
        }
    }
}

/// The smallest size that holds a picture, in whole units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Smallest {
    pub(crate) width: f64,
    pub(crate) height: f64,
}

impl Smallest {
    pub(crate) fn of(picture: &Picture) -> Self {
        Self { width: smallest_width(picture).ceil(), height: smallest_height(picture).ceil() }
    }
}

fn smallest_width(picture: &Picture) -> f64 {
    let right = right_margin(picture);
    let across = |panel: &Panel| {
        let ticks = panel.x.divisions() * (widest_tick(&panel.x) + GAP);
        let label = letters::width(&panel.x.label, f64::from(LABEL_SIZE)) - 2.0 * (right + PADDING);
        f64::max(ticks, label)
    };
    let axes = picture.panels.iter().map(across).fold(SMALLEST_AXIS, f64::max);
    let panels = left_margin(picture) + axes + right + 2.0 * PADDING;
    let title = letters::width(&picture.title, f64::from(TITLE_SIZE)) + 2.0 * PADDING;
    legend::width(picture) + f64::max(panels, title)
}

fn smallest_height(picture: &Picture) -> f64 {
    let cell = |panel: &Panel| {
        let ticks = panel.y.divisions() * LINE * f64::from(TICK_SIZE);
        // The label stands at the middle of the axis and may reach as far up as the panel does.
        let label = letters::width(&panel.y.label, f64::from(LABEL_SIZE)) - 2.0 * TOP_MARGIN;
        let axes = TOP_MARGIN + BOTTOM_MARGIN + ticks.max(label).max(SMALLEST_AXIS);
        axes.max(legend::height(panel))
    };
    let needed = picture.panels.iter().zip(shares(picture)).map(|(panel, share)| cell(panel) / share);
    between(picture) + needed.fold(0.0, f64::max)
}

/// The parts of the height that the panels have.
fn shares(picture: &Picture) -> impl Iterator<Item = f64> {
    let all: f64 = picture.panels.iter().map(|panel| panel.share).sum();
    picture.panels.iter().map(move |panel| panel.share / all)
}

/// The height that is no panel's.
fn between(picture: &Picture) -> f64 {
    let gaps: f64 = picture.panels.iter().skip(1).map(|_| SPACING).sum();
    TITLE_BAND + 2.0 * PADDING + gaps
}

fn left_margin(picture: &Picture) -> f64 {
    let widest = picture.panels.iter().map(|panel| widest_tick(&panel.y)).fold(0.0, f64::max);
    LEFT_MARGIN + (widest - USUAL_LABELS).max(0.0)
}

fn right_margin(picture: &Picture) -> f64 {
    let widest = picture.panels.iter().map(|panel| widest_tick(&panel.x)).fold(0.0, f64::max);
    RIGHT_MARGIN.max(0.5 * widest)
}

fn widest_tick(axis: &Axis) -> f64 {
    let ticks = axis.ticks().map(|tick| tick_label(axis.scale, axis.tick_step, tick));
    ticks.map(|label| letters::width(&label, f64::from(TICK_SIZE))).fold(0.0, f64::max)
}

/// Logarithmic axes are drawn as even ones of the exponent: the drawing library's own end at 1e-10.
pub(super) fn tick_label(scale: Scale, step: f64, coordinate: f64) -> String {
    match scale {
        // Next to zero a tick is what rounding has left of it.
        Scale::Linear if coordinate.abs() < 1e-6 * step => "0".to_owned(),
        Scale::Linear => number::short(coordinate, digits(coordinate / step)).replace('-', "−"),
        Scale::Logarithmic => power_of_ten(coordinate),
    }
}

/// So many that ticks next to each other differ, and not more than an `f64` has.
fn digits(steps: f64) -> usize {
    const FEWEST: usize = 6;
    const MOST: usize = 15;
    (FEWEST..MOST)
        .find(|&digits| 10_f64.powi(i32::try_from(digits).unwrap_or(0)) > 100.0 * steps.abs())
        .unwrap_or(MOST)
}

/// 10⁻⁴ for the exponent −4.
fn power_of_ten(exponent: f64) -> String {
    let exponent = format!("{exponent:.0}");
    let raised = exponent.chars().map(|digit| match digit {
        '-' => '⁻',
        '1' => '¹',
        '2' => '²',
        '3' => '³',
        digit => digit.to_digit(10).and_then(|d| char::from_u32(0x2070 + d)).unwrap_or(digit),
    });
    match exponent.as_str() {
        "0" | "-0" => "1".to_owned(),
        _ => format!("10{}", raised.collect::<String>()),
    }
}
