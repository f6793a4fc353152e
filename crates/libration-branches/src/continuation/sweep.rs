//! A slow change of a parameter, as in an experiment: the motions to which the system settles at consecutive values.
//!
//! # Method
//! A slow sweep uses only integration, from one value to the next until the motion repeats itself.

use super::description::ranges;
use super::error::BranchError;
use super::family::Family;
use super::point::amplitude_of;
use super::response::Response;
use super::space::{Rotation, Space};
use libration_kernels::elementary::count;
use libration_motion::chaos::angles;
use libration_numbers::expression::Equation;
use libration_numbers::internals::progress::Watch;
use libration_numbers::progress::{Progress, Stage};
use std::f64::consts::{PI, TAU};

/// The consecutive motions of a slow sweep of the parameter.
#[derive(Clone, Debug, PartialEq)]
pub struct Sweep {
    /// `true` if the parameter rises.
    pub rising: bool,
    /// Points in their order.
    pub points: Vec<SweepPoint>,
}

/// Motion to which the system settles at one value of the parameter.
#[derive(Clone, Debug, PartialEq)]
pub struct SweepPoint {
    /// The value of the parameter.
    pub parameter: f64,
    /// The state at phase zero of the drive.
    pub state: Vec<f64>,
    /// Number of drive periods after which the motion repeats itself to a millionth; `None` if it has not done so after a thousand periods.
    pub drive_periods: Option<u32>,
    /// The angle that rotates in these periods, for rotating solutions.
    pub rotation: Option<Rotation>,
    /// The least and the greatest value of each coordinate, as for a [`BranchPoint`](super::BranchPoint);
    /// if the motion does not repeat itself, over sixteen periods of the drive.
    pub ranges: Vec<[f64; 2]>,
}

/// The longest period of a response that is recognised, in periods of the drive.
const LONGEST: usize = 8;
/// Number of steps from one value to the next. With four values between 0.7 and 1 rad/s, these steps
/// show both responses of the driven pendulum at 0.8; without them the upper one jumps down after 0.9.
const RAMP: u32 = 16;
/// Longest time of settling, in periods of the drive, in which a transient with a quality factor of 300 falls to 3e-5.
const MOST_PERIODS: usize = 1000;
/// Relative difference after a period below which a motion has settled. Next to a fold, where the decay of a transient may take a thousand
/// periods, the error is then a thousandth, which is invisible in pictures.
const SETTLED: f64 = 1e-6;
/// Smallest difference, relative to its size, between a motion of several periods and itself after
/// fewer; if it is smaller, the motion may be an alternating transient and is followed further.
const DISTINCT: f64 = 1e-3;
/// Number of recorded periods if the motion does not settle.
const LOOKED_AT: u32 = 16;

impl SweepPoint {
    /// Amplitude as defined by [`BranchPoint::amplitude`](super::BranchPoint::amplitude); `None` for an angle that rotates without repeating.
    #[must_use]
    pub fn amplitude(&self, coordinate: usize, is_angle: bool) -> Option<f64> {
        let [low, high] = self.ranges[coordinate];
        let rotates = self.rotation.is_some_and(|rotation| rotation.coordinate == coordinate);
        let goes_on = self.drive_periods.is_none() && is_angle && high - low > TAU + PI;
        (!goes_on).then(|| amplitude_of([low, high], is_angle, rotates))
    }
}

impl Response {
    /// The motions of slow sweeps, upwards from a stable solution at the lower end of the range and downwards from
    /// one at the upper end, by integration alone: from value to value in small steps, and at each of a number of
    /// evenly spaced values until the motion repeats itself. There is no sweep from an end without a stable solution.
    ///
    /// Equation, parameter and range are those of the response. A cancelled call returns the motions computed so far.
    ///
    /// # Errors
    /// As for [`Response::over`]; equations without a drive.
    ///
    /// # Examples
    /// ```
    /// # extern crate libration_branches as libration;
    /// use libration::continuation::{Response, ResponseOptions};
    /// use libration::progress::Progress;
    /// use libration::progress::Quiet;
    /// let (pendulum, range) = ("theta'' = -0.1*theta' - sin(theta) + 0.15*cos(w*t)".parse()?, [0.6, 1.2]);
    /// let response = Response::over(&pendulum, "w", range, &ResponseOptions::default(), &Quiet)?;
    /// let sweeps = response.sweeps(&pendulum, "w", range, 31, &Quiet)?;
    /// // At 0.82 rad/s, between the jumps, the amplitude depends on the direction of the sweep: 27.5° or 101.7°.
    /// let at = |rising: bool| sweeps.iter().find(|it| it.rising == rising)?.points.iter().find(|it| (it.parameter - 0.82).abs() < 1e-9);
    /// let degrees = |rising: bool| Some(at(rising)?.amplitude(0, true)?.to_degrees());
    /// assert!(degrees(true).is_some_and(|it| it < 30.0) && degrees(false).is_some_and(|it| it > 90.0));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn sweeps(
        &self,
        equation: &Equation,
        parameter: &str,
        range: [f64; 2],
        values: usize,
        progress: &dyn Progress,
    ) -> Result<Vec<Sweep>, BranchError> {
        let watch = &Watch::new(progress);
        let [low, high] = [range[0].min(range[1]), range[0].max(range[1])];
        watch.begin(Stage::Whole, Some(2 * values));
        let family = Family::new(equation, &[parameter], &[[low, high]], watch)?;
        let last = count(values.max(2) - 1);
        let part = |number: usize| low + (high - low) * (count(number) / last);
        let evenly: Vec<f64> =
            (0..values).map(|number| if number + 1 == values { high } else { part(number) }).collect();
        let mut sweeps = vec![];
        for rising in [true, false] {
            let ordered: Vec<f64> =
                if rising { evenly.clone() } else { evenly.iter().rev().copied().collect() };
            let Some(start) = ordered.first().and_then(|end| self.stable_at(*end)) else { continue };
            let swept = Sweeping { family: &family, angles: angles(equation), done: sweeps.len() * values };
            sweeps.push(Sweep { rising, points: swept.points(&ordered, start.to_vec()) });
        }
        Ok(sweeps)
    }

    /// The state of a stable response at an end of the range.
    fn stable_at(&self, end: f64) -> Option<&[f64]> {
        let mut points =
            self.branches.iter().flat_map(|branch| [branch.points.first(), branch.points.last()]);
        let start = points.find_map(|point| {
            point.filter(|point| point.is_stable() && point.parameter.to_bits() == end.to_bits())
        });
        start.map(|point| &point.state[..])
    }
}

pub(super) struct Sweeping<'a> {
    pub(super) family: &'a Family<'a>,
    pub(super) angles: Vec<bool>,
    /// Number of values done before this sweep.
    pub(super) done: usize,
}

impl Sweeping<'_> {
    fn points(&self, values: &[f64], mut state: Vec<f64>) -> Vec<SweepPoint> {
        let mut points: Vec<SweepPoint> = vec![];
        for value in values {
            let from = points.last().map_or(*value, |point| point.parameter);
            let settled = self.ramped(state, [from, *value]).and_then(|state| self.settled(*value, state));
            let Some(point) = settled else { break };
            state =
                point.state.iter().enumerate().map(|(number, x)| x - self.whole_turns(number, *x)).collect();
            points.push(point);
            if self.family.watch.reached(self.done + points.len()).is_err() {
                break;
            }
        }
        points
    }

    /// The state after the parameter has changed from one value to another in small steps of
    /// one drive period each, so that a motion is not lost because the next value is far away.
    fn ramped(&self, state: Vec<f64>, [from, to]: [f64; 2]) -> Option<Vec<f64>> {
        (1..RAMP).try_fold(state, |state, step| {
            let value = from + (to - from) * f64::from(step) / f64::from(RAMP);
            self.family.moved_on(&state, value, [0.0, self.family.drive_period(&[value])?])
        })
    }

    /// The motion at a value, followed until it repeats itself.
    pub(super) fn settled(&self, value: f64, start: Vec<f64>) -> Option<SweepPoint> {
        let period = self.family.drive_period(&[value])?;
        let mut states = vec![start];
        while states.len() <= MOST_PERIODS {
            let next = self.family.moved_on(states.last()?, value, [0.0, period])?;
            let before = || states.iter().rev().take(LONGEST);
            let repeats = (1..).zip(before()).find(|(_, earlier)| self.is_same(&next, earlier, SETTLED));
            let is_transient = |periods: usize| {
                states.len() < MOST_PERIODS
                    && before().take(periods - 1).any(|earlier| self.is_same(&next, earlier, DISTINCT))
            };
            if let Some((periods, earlier)) = repeats.filter(|(periods, _)| !is_transient(*periods)) {
                let turns =
                    |number: &usize| self.whole_turns(*number, next[*number] - earlier[*number]) / TAU;
                let around = (0..self.angles.len()).find(|angle| turns(angle) != 0.0);
                #[expect(clippy::cast_possible_truncation, reason = "whole turns in at most eight periods")]
                let rotation = around
                    .map(|around| Rotation { coordinate: around, turns: libm::rint(turns(&around)) as i32 });
                return self.seen(value, next, u32::try_from(periods).ok(), rotation);
            }
            states.push(next);
        }
        self.seen(value, states.pop()?, None, None)
    }

    /// Description of the motion that begins at a state.
    fn seen(
        &self,
        value: f64,
        state: Vec<f64>,
        drive_periods: Option<u32>,
        rotation: Option<Rotation>,
    ) -> Option<SweepPoint> {
        let space = Space { rotation, ..Space::of_periods(drive_periods.unwrap_or(LOOKED_AT)) };
        let duration = self.family.duration(space, &[], &[value])?;
        let (steps, _) = self.family.motion(&state, &[value], [0.0, duration], SETTLED).ok()?;
        let ranges = ranges(&self.family.layout, &steps, space, duration);
        Some(SweepPoint { parameter: value, state, drive_periods, rotation, ranges })
    }

    /// Returns `true` if two states agree to a fraction of their size.
    fn is_same(&self, a: &[f64], b: &[f64], part: f64) -> bool {
        let size = a.iter().map(|x| x.abs().min(PI)).fold(SETTLED, f64::max);
        let mut apart = a.iter().zip(b).map(|(a, b)| a - b).enumerate();
        apart.all(|(number, far)| (far - self.whole_turns(number, far)).abs() <= part * size)
    }

    /// The whole turns in a component of the state, in radians; zero unless the component is an angle.
    fn whole_turns(&self, number: usize, x: f64) -> f64 {
        if self.angles.get(number).is_some_and(|angle| *angle) { TAU * libm::rint(x / TAU) } else { 0.0 }
    }
}
