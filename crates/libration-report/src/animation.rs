//! Moving parts: bodies in the square next to the axes or above them, and dots on the curves in the axes.

use crate::chart::{Hanging, Mechanism, MovingDot, Picture};
use crate::frame::Frame;
use crate::scene::{Moving, MovingForm, Place};
use crate::style::{INK, curve};

/// Lengths are in units of the letter size.
const ROD: f64 = 0.14;
const AXLE: f64 = 0.16;
const BODY: f64 = 0.5;
const DOT: f64 = 0.38;
/// Distance from one rail to the next.
const RAIL: f64 = 3.0 * BODY;

/// All moving shapes of a picture, in coordinates of the canvas.
pub(crate) fn moving(picture: &Picture, frame: &Frame, em: f64) -> Vec<Moving> {
    let Some((animation, square)) = picture.animation.as_ref().zip(frame.stage) else { return vec![] };
    let stage = BodyStage { middle: square.middle, reach: 0.5 * square.side - BODY, em };
    let bodies = match &animation.mechanism {
        Mechanism::Plane(bodies) => stage.plane(bodies),
        Mechanism::Rails(places) => stage.rails(places),
    };
    let dots = animation.dots.iter().filter_map(|dot| in_axes(dot, picture, frame, em));
    bodies.into_iter().chain(dots).collect()
}

/// The square in which bodies move.
struct BodyStage {
    middle: Place,
    /// Largest distance of the middle of a body from the middle of the square.
    reach: f64,
    em: f64,
}

impl BodyStage {
    fn position(&self, right: f64, up: f64) -> Place {
        (self.em * (self.middle.0 + right), self.em * (self.middle.1 - up))
    }

    fn line(&self, frames: Vec<Vec<Place>>) -> Moving {
        Moving { form: MovingForm::Line { width: ROD * self.em }, colour: INK, frames }
    }

    fn dot(&self, radius: f64, colour: &'static str, places: impl Iterator<Item = Place>) -> Moving {
        let frames = places.map(|position| vec![position]).collect();
        Moving { form: MovingForm::Dot { radius: radius * self.em }, colour, frames }
    }

    /// Bodies and their rods, the bodies in front, scaled to fill the square.
    fn plane(&self, bodies: &[Hanging]) -> Vec<Moving> {
        let places = || bodies.iter().flat_map(|body| body.places.iter().chain(&body.held));
        let (right, up) = (
            Extent::enclosing(places().map(|position| position.0)),
            Extent::enclosing(places().map(|position| position.1)),
        );
        let scale = right.scale_to(self.reach).min(up.scale_to(self.reach));
        let on_canvas = |(x, y): &Place| self.position(scale * (x - right.middle), scale * (y - up.middle));
        let rods = bodies.iter().map(|body| {
            let ends = body.held.iter().zip(&body.places);
            self.line(ends.map(|(held, position)| vec![on_canvas(held), on_canvas(position)]).collect())
        });
        let ends = bodies.iter().map(|body| self.dot(AXLE, INK, body.held.iter().map(on_canvas)));
        let bodies = bodies
            .iter()
            .enumerate()
            .map(|(number, body)| self.dot(BODY, curve(number).colour, body.places.iter().map(on_canvas)));
        rods.chain(ends).chain(bodies).collect()
    }

    /// Bodies on horizontal rails, all to the same scale.
    fn rails(&self, places: &[Vec<f64>]) -> Vec<Moving> {
        let extent = Extent::enclosing(places.iter().flatten().copied());
        let scale = extent.scale_to(self.reach);
        let above = 0.5 * RAIL * u32::try_from(places.len().saturating_sub(1)).map_or(0.0, f64::from);
        let heights = (0_u32..).map(|number| above - RAIL * f64::from(number));
        let rails = places.iter().zip(heights).enumerate().flat_map(|(number, (places, height))| {
            let ends = vec![self.position(-self.reach, height), self.position(self.reach, height)];
            let body =
                places.iter().map(|coordinate| self.position(scale * (coordinate - extent.middle), height));
            [self.line(vec![ends]), self.dot(BODY, curve(number).colour, body)]
        });
        rails.collect()
    }
}

/// The range of some numbers.
struct Extent {
    middle: f64,
    half: f64,
}

impl Extent {
    fn enclosing(numbers: impl Iterator<Item = f64>) -> Self {
        let ends = numbers.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), number| {
            (low.min(number), high.max(number))
        });
        Self { middle: 0.5 * (ends.0 + ends.1), half: 0.5 * (ends.1 - ends.0) }
    }

    /// The factor that scales half the range to this length.
    fn scale_to(&self, half: f64) -> f64 {
        if self.half > 0.0 { half / self.half } else { f64::MAX.sqrt() }
    }
}

/// A dot on a curve, kept within its axes.
fn in_axes(dot: &MovingDot, picture: &Picture, frame: &Frame, em: f64) -> Option<Moving> {
    let (panel, cell) = (picture.panels.get(dot.panel)?, frame.cells.get(dot.panel)?);
    let part = |(x, y): &Place| (panel.x.part(*x).clamp(0.0, 1.0), panel.y.part(*y).clamp(0.0, 1.0));
    let frames = dot.places.iter().map(|position| vec![frame.position(cell, part(position), em)]).collect();
    Some(Moving { form: MovingForm::Dot { radius: DOT * em }, colour: dot.colour, frames })
}
