//! Poincaré sections: the states of a motion once per period of its drive, or whenever it crosses a surface.

use std::f64::consts::{PI, TAU};

use super::drive::drive_period;
use super::surface::Surface;
use crate::taylor::{
    Cause, Direction, Effort, Event, IntegrationError, Moment, MomentErrors, Solution, Start, StateErrors,
    System, integrate_from,
};
use libration_numbers::expression::{Equation, Expression, Symbol, WithoutValue};
use libration_numbers::internals::progress::Watch;
use libration_numbers::progress::{Progress, Stage};

/// The condition under which a state of the motion is recorded.
#[derive(Clone, Debug, PartialEq)]
pub enum Section {
    /// One point in each period of the drive.
    Stroboscope {
        /// The period; if there is none, that of [`drive_period`].
        period: Option<f64>,
        /// The phase of the stroboscope after t = 0, as a fraction of the period, from 0 to 1.
        phase: f64,
    },
    /// A point whenever a formula of coordinates, velocities or rates of change, and time changes its sign, by more than the error of the motion.
    Crossing {
        /// The formula, zero on the surface.
        formula: Expression,
        /// The direction in which the motion crosses the surface.
        direction: Direction,
    },
}

impl Section {
    /// The section with the period of these equations, if it has none and the equations determine one.
    pub(super) fn with_period_of(&self, equation: &Equation) -> Self {
        match self {
            Self::Stroboscope { period: None, phase } => {
                Self::Stroboscope { period: drive_period(equation), phase: *phase }
            }
            other => other.clone(),
        }
    }

    /// The first stroboscopic time after t = 0; `None` for a surface, or without a known period.
    pub(super) fn first_flash(&self, equation: &Equation) -> Option<f64> {
        match self {
            Self::Stroboscope { period, phase } => Some(phase * period.or_else(|| drive_period(equation))?),
            Self::Crossing { .. } => None,
        }
    }
}

/// The numbers of section points that are skipped and then recorded.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Points {
    /// Number of skipped points, the transient.
    pub skipped: usize,
    /// Number of recorded points.
    pub recorded: usize,
}

/// The points of a section, as far as the motion was integrated.
#[derive(Clone, Debug, PartialEq)]
pub struct PoincareSection {
    /// Times and states.
    pub points: Vec<Moment>,
    /// The errors of the points, if they were requested.
    pub errors: Option<SectionErrors>,
    /// The reason why there are fewer points than requested.
    pub stopped: Option<SectionEnding>,
}

/// Estimates of the errors of section points.
#[derive(Clone, Debug, PartialEq)]
pub struct SectionErrors {
    /// The errors of the first points: of all points, or of those up to the time until which the motion is determined. NaN where a crossing has no
    /// known error.
    pub of_points: Vec<MomentErrors>,
    /// The time of the last state that is determined in double precision; `None` if all are. Later points are those of a nearby motion.
    pub determined_until: Option<f64>,
}

/// The reason why a section has fewer points than requested.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum SectionEnding {
    /// The integration stopped, or was interrupted.
    #[error("{0}")]
    Stopped(Cause),
    /// The motion did not cross the surface again within the integration.
    #[error("the motion no longer crosses the surface")]
    NoCrossing,
    /// The motion did not cross the surface at all.
    #[error("the motion does not cross the surface within the integrated time")]
    NeverCrossed,
}

/// The reason why a section cannot be computed.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum SectionError {
    /// A parameter without a value.
    #[error(transparent)]
    WithoutValue(#[from] WithoutValue),
    /// An invalid start or tolerance.
    #[error(transparent)]
    Integration(#[from] IntegrationError),
    /// Equations whose drive has no recognised period.
    #[error(
        "the equations have no drive with a known period: give the period, or a surface that the motion crosses, such as a coordinate or a velocity"
    )]
    NoPeriod,
    /// An invalid period or phase.
    #[error("period {period:?} and phase {phase:?}: give a finite period above zero and a phase from 0 to 1")]
    Stroboscope {
        /// The period.
        period: f64,
        /// The phase.
        phase: f64,
    },
}

/// Computes the section of a motion.
///
/// A cancelled call returns the points so far, with [`Cause::Interrupted`].
///
/// # Accuracy
/// As for [`integrate`](crate::taylor::integrate()); [`compute_section_with_errors`] estimates the error of each point. After about ten periods
/// of a chaotic motion the points are those of a nearby motion.
///
/// # Errors
/// A parameter without a value; a start that does not fit; an unknown period.
///
/// # Examples
/// ```
/// # extern crate libration_motion as libration;
/// use libration::chaos::{Points, Section, compute_section};
/// use libration::progress::Quiet;
/// use libration::taylor::{Effort, Moment};
/// let duffing = "x'' + x'/4 - x + x^3 = 0.2*cos(t)".parse()?;
/// let start = Moment { time: 0.0, state: vec![1.0, 0.0] };
/// let stroboscope = Section::Stroboscope { period: None, phase: 0.0 };
/// let points = Points { skipped: 200, recorded: 2 };
/// let section = compute_section(&duffing, &start, &stroboscope, points, &Effort::to_tolerance(1e-12), &Quiet)?;
/// // The motion has the period of its drive.
/// assert!((section.points[0].state[0] - section.points[1].state[0]).abs() < 1e-9);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn compute_section(
    equation: &Equation,
    start: &Moment,
    section: &Section,
    points: Points,
    effort: &Effort,
    progress: &dyn Progress,
) -> Result<PoincareSection, SectionError> {
    SectionOfMotion { equation, start, points, effort, with_errors: false }.compute(section, progress)
}

/// Computes the section of a motion like [`compute_section`], with an estimate of the error of each point as for [`StateErrors`], in up to three
/// times the time. A state of more than [`StateErrors::MOST_COMPONENTS`] components has no errors.
///
/// # Errors
/// As [`compute_section`].
///
/// # Examples
/// The formula has a triple zero, so that its crossings are known to few digits.
/// ```
/// # extern crate libration_motion as libration;
/// use libration::chaos::{Points, Section, compute_section_with_errors};
/// use libration::progress::Quiet;
/// use libration::taylor::{Direction, Effort, Moment};
/// let start = Moment { time: 0.0, state: vec![1.0, 0.0] };
/// let section = Section::Crossing { formula: "x^3".parse()?, direction: Direction::Rising };
/// let (points, effort) = (Points { skipped: 0, recorded: 4 }, Effort::to_tolerance(1e-12));
/// let section =
///     compute_section_with_errors(&"x'' = -x".parse()?, &start, &section, points, &effort, &Quiet)?;
/// let errors = section.errors.unwrap().of_points;
/// let [error, distance] = [errors[3].time, (section.points[3].time - 7.5 * std::f64::consts::PI).abs()];
/// assert!(distance <= error && error < 1e-4);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn compute_section_with_errors(
    equation: &Equation,
    start: &Moment,
    section: &Section,
    points: Points,
    effort: &Effort,
    progress: &dyn Progress,
) -> Result<PoincareSection, SectionError> {
    let with_errors = start.state.len() <= StateErrors::MOST_COMPONENTS;
    SectionOfMotion { equation, start, points, effort, with_errors }.compute(section, progress)
}

/// A motion with the points of it that are recorded.
struct SectionOfMotion<'a> {
    equation: &'a Equation,
    start: &'a Moment,
    points: Points,
    effort: &'a Effort,
    with_errors: bool,
}

impl SectionOfMotion<'_> {
    fn compute(&self, section: &Section, progress: &dyn Progress) -> Result<PoincareSection, SectionError> {
        let Self { equation, start, points, effort, .. } = *self;
        let watch = &Watch::new(progress);
        watch.begin(Stage::Whole, Some(points.recorded));
        match section {
            Section::Stroboscope { period, phase } => {
                let period = period.or_else(|| drive_period(equation)).ok_or(SectionError::NoPeriod)?;
                let times = flashes(start.time, period, *phase, points)?;
                self.stroboscopic(&System::new(equation)?, &times, watch)
            }
            Section::Crossing { formula, direction } => {
                let system = System::new(equation)?.with_events(&[Event::zero_of(formula.clone())])?;
                let surface = Surface::new(&system, formula, *direction, effort.relative)?;
                let is_autonomous = !equation.depends_on_time() && !formula.contains(&Symbol::plain("t"));
                self.crossings(&system, surface, is_autonomous, watch)
            }
        }
    }

    /// The errors along the motion, if they were requested.
    fn errors(&self, system: &System) -> Option<StateErrors> {
        self.with_errors.then(|| StateErrors::new(system, self.start, self.effort))
    }

    fn stroboscopic(
        &self,
        system: &System,
        times: &[f64],
        watch: &Watch<'_>,
    ) -> Result<PoincareSection, SectionError> {
        let (mut taken, mut errors, mut of_points) = (0, self.errors(system), vec![]);
        let start = Start::State(self.start.clone());
        let outcome = integrate_from(system, &start, times, self.effort, |accepted| {
            let step = accepted.step();
            let in_step = times[taken..].iter().take_while(|time| **time <= step.end());
            let first = taken;
            taken += in_step.count();
            if let Some(errors) = &mut errors {
                errors.follow(accepted);
                let moments =
                    times[first..taken].iter().map(|&time| Moment { time, state: step.state_at(time) });
                of_points.extend(moments.map_while(|moment| errors.of_sample(accepted, &moment)));
            }
            watch.flow_at(taken)
        });
        let section = PoincareSection::of_samples(outcome)?;
        Ok(PoincareSection { errors: errors.map(|errors| SectionErrors::new(&errors, of_points)), ..section })
    }

    /// Follows consecutive stretches of the motion until there are enough points, or the motion has come to rest.
    fn crossings(
        &self,
        system: &System,
        mut surface: Surface,
        is_autonomous: bool,
        watch: &Watch<'_>,
    ) -> Result<PoincareSection, SectionError> {
        const STEPS: usize = 2000;
        /// Stretches without a crossing after which none is expected, and as many of a formula with a boundary, where a step with a pole takes a
        /// thousand times longer: some ten thousand periods.
        const QUIET: usize = 200;
        const QUIET_WITH_BOUNDARY: usize = 10;
        let Self { start, points, effort, .. } = *self;
        let stretch = Effort { most_steps: STEPS.min(effort.most_steps), ..*effort };
        let most_quiet = if system.has_boundary(0) { QUIET_WITH_BOUNDARY } else { QUIET };
        let mut errors = self.errors(system);
        let (mut at, mut so_far, mut quiet, mut horizon) = (start.clone(), vec![], 0, NEAREST);
        let stopped = loop {
            let taken = so_far.len();
            let begin = Start::State(at.clone());
            let outcome = integrate_from(system, &begin, &[at.time + horizon], &stretch, |step| {
                if let Some(errors) = &mut errors {
                    errors.follow(step);
                }
                so_far.extend(surface.crossings_in(step, errors.as_mut()));
                watch.flow_at(so_far.len().saturating_sub(points.skipped).min(points.recorded))
            });
            let (solution, cause) = as_far_as_it_came(outcome)?;
            quiet = if so_far.len() > taken { 0 } else { quiet + 1 };
            // A motion that is where it was before these steps, bit by bit, is at rest.
            let is_over = is_autonomous && quiet > 0 && solution.end.state == at.state;
            at = solution.end;
            match cause {
                _ if so_far.len() >= points.skipped + points.recorded => break None,
                None if horizon < NEVER => horizon *= FARTHER,
                Some(Cause::StepLimit) if quiet < most_quiet && !is_over => {}
                Some(Cause::StepLimit | Cause::OutOfRange) | None => break Some(no_more(so_far.is_empty())),
                Some(cause) => break Some(SectionEnding::Stopped(cause)),
            }
        };
        let recorded = so_far.into_iter().skip(points.skipped).take(points.recorded);
        let (points, of_points): (Vec<_>, Vec<_>) =
            recorded.map(|crossing| (crossing.moment, crossing.errors)).unzip();
        let of_points = of_points.into_iter().map_while(|errors| errors).collect();
        let errors = errors.map(|errors| SectionErrors::new(&errors, of_points));
        Ok(PoincareSection { points, errors, stopped })
    }
}

impl SectionErrors {
    fn new(errors: &StateErrors, of_points: Vec<MomentErrors>) -> Self {
        Self { of_points, determined_until: errors.determined_until() }
    }
}

/// The times from a start on at which the drive has this phase.
pub(super) fn flashes(start: f64, period: f64, phase: f64, points: Points) -> Result<Vec<f64>, SectionError> {
    if !(period > 0.0 && period.is_finite() && (0.0..=1.0).contains(&phase)) {
        return Err(SectionError::Stroboscope { period, phase });
    }
    let first = (start / period - phase).ceil();
    let number = |n: usize| first + u32::try_from(n).map_or(f64::INFINITY, f64::from);
    Ok((points.skipped..points.skipped + points.recorded).map(|n| (number(n) + phase) * period).collect())
}

impl PoincareSection {
    /// The section whose points are the samples of an integration.
    pub(super) fn of_samples(outcome: Result<Solution, IntegrationError>) -> Result<Self, SectionError> {
        let (solution, stopped) = as_far_as_it_came(outcome)?;
        Ok(Self { points: solution.samples, errors: None, stopped: stopped.map(SectionEnding::Stopped) })
    }
}

fn as_far_as_it_came(
    outcome: Result<Solution, IntegrationError>,
) -> Result<(Solution, Option<Cause>), SectionError> {
    match outcome {
        Ok(solution) => Ok((solution, None)),
        Err(IntegrationError::Stopped { cause, solution }) => Ok((*solution, Some(cause))),
        Err(error) => Err(error.into()),
    }
}

/// The ending if the surface is not crossed again.
const fn no_more(is_first: bool) -> SectionEnding {
    if is_first { SectionEnding::NeverCrossed } else { SectionEnding::NoCrossing }
}

/// The largest duration of the first stretch, the factor from one stretch to the next, and a time that only a motion at rest reaches. A
/// force-free motion takes a single step to any time, in which a crossing must not be too near the beginning.
const NEAREST: f64 = 1e-6;
const FARTHER: f64 = 1e3;
const NEVER: f64 = 1e200;

/// An angle modulo a turn, between −π and π.
#[must_use]
pub fn folded(angle: f64) -> f64 {
    let within = libm::remainder(angle, TAU);
    if within <= -PI { within + TAU } else { within }
}
