//! An animated motion next to its curves.

use super::chart::{Animation, Hanging, Mechanism, MovingDot, Picture};
use crate::output::number;
use libration::pendulum::Motion;
use libration::systems::{Bodies, Model};
use libration::taylor::Moment;

/// Frame rate that screens need for a movement without jerks.
const FRAMES_PER_SECOND: f64 = 30.0;
/// Longest duration in seconds; longer motions are shown faster, so that files stay below a few hundred kilobytes.
const LONGEST: f64 = 30.0;
const SHORTEST: f64 = 1.0;

/// The speed at which a stretch of time is played: true to time, or a number of times as fast.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Playing {
    from: f64,
    span: f64,
    /// Seconds of the motion in one second on the screen: 1, 2 or 5 times a power of ten.
    pub speed: f64,
}

impl Playing {
    /// The animation from one time to another, which may be earlier.
    pub fn new(from: f64, to: f64) -> Self {
        let span = to - from;
        let seconds = span.abs();
        let speed = if (SHORTEST..=LONGEST).contains(&seconds) || seconds == 0.0 {
            1.0
        } else if seconds > LONGEST {
            steps(1).find(|speed| seconds / speed <= LONGEST).unwrap_or(f64::INFINITY)
        } else {
            steps(-1).find(|speed| seconds / speed >= SHORTEST).unwrap_or(f64::MIN_POSITIVE)
        };
        Self { from, span, speed }
    }

    fn seconds(&self) -> f64 {
        (self.span.abs() / self.speed).clamp(SHORTEST, LONGEST)
    }

    /// The times that are shown.
    pub fn times(&self) -> Vec<f64> {
        const MOST: u32 = 1000;
        let frames = (1..MOST).find(|frames| f64::from(*frames) >= self.seconds() * FRAMES_PER_SECOND);
        let frames = frames.unwrap_or(MOST);
        (0..=frames).map(|frame| self.from + self.span * f64::from(frame) / f64::from(frames)).collect()
    }

    /// A statement of the speed, if it is not real time.
    fn said(&self) -> Option<String> {
        let said = |factor: f64, how: &str| format!("shown {} times as {how}", number::short(factor, 3));
        match self.speed {
            speed if speed > 1.0 => Some(said(speed, "fast")),
            speed if speed < 1.0 => Some(said(1.0 / speed, "slowly")),
            _ => None,
        }
    }

    fn animated(self, picture: Picture, mechanism: Mechanism, dots: Vec<MovingDot>) -> Picture {
        let parameters = picture.parameters.iter().cloned().chain(self.said()).collect();
        Picture {
            parameters,
            animation: Some(Animation { seconds: self.seconds(), mechanism, dots }),
            ..picture
        }
    }
}

/// 1, 2, 5, 10 and so on, or their inverses.
fn steps(direction: i32) -> impl Iterator<Item = f64> {
    let powers = (0..300).flat_map(|power| [1.0, 2.0, 5.0].map(|first| first * 10_f64.powi(power)));
    powers.map(move |step| if direction > 0 { step } else { 1.0 / step })
}

/// The picture of a pendulum's motion with the pendulum next to it.
pub(crate) fn of_motion(picture: Picture, motion: &Motion, (from, to): (f64, f64)) -> Picture {
    let playing = Playing::new(from, to);
    let times = playing.times();
    let angles: Vec<f64> = times.iter().map(|time| motion.state_at(*time).angle).collect();
    let bodies = Model::by_key("pendulum", &[], &[]).ok().and_then(|model| model.bodies());
    let mechanism = bodies.map(|bodies| in_plane(&bodies, &times, std::slice::from_ref(&angles)));
    let dot = MovingDot {
        panel: 0,
        colour: super::style::curve(0).colour,
        places: times.iter().zip(&angles).map(|(time, angle)| (*time, angle.to_degrees())).collect(),
    };
    match mechanism {
        Some(mechanism) => playing.animated(picture, mechanism, vec![dot]),
        None => picture,
    }
}

/// The coordinates of a motion at some times.
#[derive(Debug)]
pub struct SampledCoordinates<'a> {
    /// The times of the samples.
    pub times: &'a [f64],
    /// One list for each coordinate.
    pub values: &'a [Vec<f64>],
}

impl SampledCoordinates<'_> {
    /// A coordinate between two samples, on a straight line.
    pub fn value(&self, coordinate: usize, time: f64) -> f64 {
        let values = &self.values[coordinate];
        let next = self.times.partition_point(|sample| sample.abs() < time.abs());
        let (Some(first), Some(second)) = (next.checked_sub(1), self.times.get(next)) else {
            return values.get(next).or(values.last()).copied().unwrap_or(0.0);
        };
        let part = (time - self.times[first]) / (second - self.times[first]);
        values[first] + part * (values[next] - values[first])
    }

    /// The picture of the coordinates with the bodies of the system next to it; each dot is to be on the panel and in the
    /// scale that are given for its coordinate.
    pub(crate) fn animated(
        &self,
        picture: Picture,
        model: &Model,
        shown: impl Fn(usize) -> (usize, f64),
    ) -> Picture {
        let ends = self.times.first().zip(self.times.last());
        let Some((from, to)) = ends else { return picture };
        let playing = Playing::new(*from, *to);
        let times = playing.times();
        let coordinates = 0..model.coordinates().len();
        let values: Vec<Vec<f64>> = coordinates
            .clone()
            .map(|coordinate| times.iter().map(|time| self.value(coordinate, *time)).collect())
            .collect();
        let mechanism = match model.bodies() {
            Some(bodies) => in_plane(&bodies, &times, &values),
            None => Mechanism::Rails(values.clone()),
        };
        let dots = coordinates.map(|coordinate| {
            let (panel, scale) = shown(coordinate);
            let points = times.iter().zip(&values[coordinate]);
            MovingDot {
                panel,
                colour: super::style::curve(coordinate).colour,
                places: points.map(|(time, value)| (*time, scale * value)).collect(),
            }
        });
        playing.animated(picture, mechanism, dots.collect())
    }
}

fn in_plane(bodies: &Bodies, times: &[f64], values: &[Vec<f64>]) -> Mechanism {
    let states = times.iter().enumerate().map(|(frame, &time)| {
        let coordinates = values.iter().map(|values| values[frame]);
        // Bodies are where the coordinates say, however fast they are.
        let state = coordinates.clone().chain(coordinates.map(|_| 0.0)).collect();
        bodies.at(&Moment { time, state })
    });
    let frames: Vec<_> = states.collect();
    let body = |number: usize| {
        let places = |position: fn(&libration::systems::Body) -> [f64; 2]| {
            frames.iter().map(|bodies| position(&bodies[number]).into()).collect()
        };
        Hanging { places: places(|body| body.place), held: places(|body| body.pivot) }
    };
    Mechanism::Plane((0..frames.first().map_or(0, Vec::len)).map(body).collect())
}
