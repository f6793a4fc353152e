//! Search for branches: a system over a parameter range, with the options of the response.

use super::branch::{Ending, FIRST, Limits, Origin, Walk, Walked};
use super::corrector::Corrector;
use super::error::BranchError;
use super::family::{Family, Image, TOLERANCES};
use super::node::{Node, Tests};
use super::options::ResponseOptions;
use super::point::BranchPoint;
use super::space::Space;
use super::units::LEAST;
use libration_motion::orbit::{Orbit, OrbitError};
use libration_numbers::algebra::BigFloat;
use libration_numbers::expression::{Equation, Expression};

pub(super) struct Search<'a> {
    pub(super) equation: &'a Equation,
    pub(super) parameter: &'a str,
    pub(super) family: &'a Family<'a>,
    pub(super) range: [f64; 2],
    pub(super) options: &'a ResponseOptions,
}

/// A motion with which a branch begins.
pub(super) struct Start {
    pub(super) unknowns: Vec<f64>,
    pub(super) space: Space,
}

impl Start {
    /// Returns `true` if a cycle without a drive has the period of a point within a relative difference. The number of turns may differ along a
    /// branch, as the first coordinate gains maxima.
    fn has_period(&self, point: &BranchPoint, difference: f64) -> bool {
        let turns = f64::from(self.space.drive_periods());
        let period = self.unknowns.last().map_or(f64::NAN, |turn| turn * turns);
        (point.period - period).abs() <= difference * period
    }
}

impl Search<'_> {
    /// Returns `true` if a cycle without a drive has the period of a point, and the ranges of its coordinates or of their mirror image, within a
    /// relative difference: the turn with which a cycle begins is arbitrary.
    pub(super) fn is_cycle(&self, start: &Start, value: f64, point: &BranchPoint, difference: f64) -> bool {
        let Self { family, .. } = self;
        if !start.has_period(point, difference) {
            return false;
        }
        let Some(ranges) = family.ranges_of(start.space, &start.unknowns, value) else { return true };
        let sizes = ranges.iter().chain(&point.ranges).map(|[low, high]| high - low);
        let far = difference * sizes.fold(0.0, f64::max);
        let is_near = |a: [f64; 2], b: [f64; 2]| a.iter().zip(b).all(|(a, b)| (a - b).abs() <= far);
        let mirrored = |number: usize, [low, high]: [f64; 2]| {
            let [a, b] = [low, high].map(|end| family.mirror.image(number, end));
            [a.min(b), a.max(b)]
        };
        let pairs = || ranges.iter().copied().zip(point.ranges.iter().copied()).enumerate();
        pairs().all(|(_, (range, other))| is_near(range, other))
            || pairs().all(|(number, (range, other))| is_near(mirrored(number, range), other))
    }

    /// The equations at a value of the parameter.
    pub(super) fn at(&self, value: f64) -> Result<Equation, OrbitError> {
        let exact = BigFloat::from_f64(value, 53).map(|fraction| Expression::Number(fraction.to_rational()));
        let put_in = exact.and_then(|exact| self.equation.with(&[(self.parameter, exact)]).ok());
        put_in.ok_or(OrbitError::NoPeriod)
    }

    /// Periodic motions at an end of the range.
    pub(super) fn starts(&self, value: f64) -> Result<Vec<Start>, BranchError> {
        if let Some(rotation) = self.options.rotation {
            return self.rotating(rotation, value);
        }
        match self.start(value) {
            Ok(start) => Ok(vec![start]),
            Err(OrbitError::Interrupted(interrupted)) => Err(interrupted.into()),
            // Neighbouring motions close as well.
            Err(OrbitError::Undetermined(_)) if !self.family.is_driven() => Err(BranchError::Family),
            Err(error) => Err(BranchError::NoStart(error)),
        }
    }

    /// The period of the motion to begin with.
    pub(super) fn period_of(&self, start: &Start, value: f64) -> Option<f64> {
        let periods = f64::from(start.space.drive_periods());
        let period =
            self.family.drive_period(&[value]).or(start.unknowns.get(self.family.layout.numbers()).copied());
        period.map(|period| period.abs() * periods)
    }

    fn start(&self, value: f64) -> Result<Start, OrbitError> {
        let equation = self.at(value)?;
        let state = self.given();
        if !self.family.is_driven() {
            let state = self.family.displaced(state, value);
            let cycle = Orbit::limit_cycle(&equation, &state, self.family.watch)?;
            let turns =
                self.family.turns(&cycle.start(), value, cycle.period()).ok_or(OrbitError::NoPeriod)?;
            let period = cycle.period() / f64::from(turns);
            let unknowns = cycle.start().into_iter().chain([period]).collect();
            return Ok(Start { unknowns, space: Space::of_periods(turns) });
        }
        let duration = self.family.duration(self.space(), &[], &[value]).ok_or(OrbitError::NoPeriod)?;
        let unknowns = match Orbit::driven(&equation, &state, duration, self.family.watch) {
            Ok(orbit) => self.about_the_nearest_bottom(&orbit),
            // The drive amplitude is zero.
            Err(OrbitError::NotDriven) => state,
            Err(error) => return Err(error),
        };
        Ok(Start { unknowns, space: self.space() })
    }

    /// The start of an orbit whose angles made whole turns before it was reached,
    /// with these turns subtracted: its mirror image is then one about zero.
    fn about_the_nearest_bottom(&self, orbit: &Orbit) -> Vec<f64> {
        let mut start = orbit.start();
        self.family.turning.subtract(&mut start, |coordinate| middle(orbit.range(coordinate).into()));
        start
    }

    pub(super) fn space(&self) -> Space {
        Space::of_periods(self.options.drive_periods)
    }

    pub(super) fn width(&self) -> f64 {
        self.range[1] - self.range[0]
    }

    pub(super) fn limits(&self, start: &Node, space: Space) -> Limits {
        /// Multiple of the least period, at which the motion follows the drive through all its superharmonic resonances.
        const SLOW: f64 = 100.0;
        let periods = self.range.map(|value| self.family.drive_period(&[value]));
        let least = periods.into_iter().flatten().fold(f64::INFINITY, f64::min);
        let least = if self.family.is_driven() { least } else { start.point.period };
        let periods = f64::from(space.drive_periods());
        Limits {
            range: self.range,
            most_points: self.options.most_points,
            longest_period: SLOW * periods * least,
            largest_growth: f64::INFINITY,
            initial_step: FIRST,
        }
    }

    pub(super) fn corrector(&self, space: Space) -> Corrector<'_> {
        /// Accuracy of derivatives that suffices for the multipliers of points.
        const STALE: f64 = 1e-12;
        Corrector { family: self.family, space, tolerance: TOLERANCES[0], stale: STALE }
    }

    /// The branch through a motion, in the smallest space that contains it: from an end of the range into it, or in both directions.
    pub(super) fn through(
        &self,
        value: f64,
        start: &Start,
        into: f64,
    ) -> Result<Option<Walked>, BranchError> {
        match self.options.at {
            Some(_) => self.both_ways(value, start),
            None => self.primary(value, start, into),
        }
    }

    pub(super) fn primary(
        &self,
        value: f64,
        start: &Start,
        into: f64,
    ) -> Result<Option<Walked>, BranchError> {
        /// Largest distance of a second multiplier from 1, half the digits, at which an autonomous motion counts as a member of a family.
        const FAMILY: f64 = 1e-6;
        let corrector = self.corrector(self.smallest(start.space, &start.unknowns, value));
        let unknowns: Vec<f64> = start.unknowns.iter().copied().chain([value]).collect();
        if !self.family.is_driven() {
            let tests = corrector.image(&unknowns).and_then(|image| Tests::new(&image, 0.0));
            if tests.is_some_and(|tests| tests.branching.abs() < FAMILY) {
                return Err(BranchError::Family);
            }
        }
        let mut along = vec![0.0; unknowns.len()];
        along[unknowns.len() - 1] = into;
        let node = Node::near(&corrector, &unknowns, [&along, &along], self.width());
        Ok(node.map(|node| {
            let limits = self.limits(&node, start.space);
            Walk::new(corrector, limits, node).walked(Origin::Primary)
        }))
    }

    pub(super) fn smallest(&self, space: Space, state: &[f64], value: f64) -> Space {
        let parameters = [value];
        let mut smaller = self.family.images_within(space, state, &parameters, TOLERANCES[0]);
        match smaller.find(|(_, image)| self.is_closed(image, state, value)) {
            Some((smaller, _)) => self.smallest(smaller, state, value),
            None => space,
        }
    }

    /// Returns `true` if a closed motion is one of a space.
    pub(super) fn belongs_to(&self, space: Space, state: &[f64], value: f64) -> bool {
        let image = self.family.image(space, state, &[value], TOLERANCES[0]);
        image.is_some_and(|image| self.is_closed(&image, state, value))
    }

    fn is_closed(&self, image: &Image, state: &[f64], value: f64) -> bool {
        /// Largest defect relative to the size of the state: a closed motion differs from its mirror image by rounding errors or by far more.
        const SAME: f64 = 1e-9;
        let sizes = self.family.sizes_of(state, value, LEAST);
        // Without a drive the last component of the defect, which has no size here, is the phase condition.
        image.defect.iter().zip(&sizes).all(|(d, size)| d.abs() <= SAME * size)
    }

    /// The branch through a motion at a value, in both directions.
    pub(super) fn both_ways(&self, value: f64, start: &Start) -> Result<Option<Walked>, BranchError> {
        let Some(onward) = self.primary(value, start, 1.0)? else { return Ok(None) };
        if onward.branch.ending == Ending::Closed {
            return Ok(Some(onward));
        }
        Ok(Some(match self.primary(value, start, -1.0)? {
            Some(back) => back.turned_into(&onward),
            None => onward.beginning_lost(),
        }))
    }
}

/// The middle of a range.
pub(super) fn middle([low, high]: [f64; 2]) -> f64 {
    0.5 * (low + high)
}
