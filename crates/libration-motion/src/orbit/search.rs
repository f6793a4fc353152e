//! Search for an orbit of any kind; the equations determine the method.

use super::acceleration::Acceleration;
use super::closing::Rounds;
use super::error::{Lost, OrbitError, finished};
use super::family::{FamilyCondition, through_start};
use super::near::OrbitGuess;
use super::path::{FAR, sign_change, until};
use super::periodic::Orbit;
use super::released::{MOST_STEPS, why_lost};
use crate::taylor::{Effort, Moment, StateLayout, System};
use libration_numbers::expression::Equation;
use libration_numbers::internals::progress::Watch;
use libration_numbers::progress::Progress;

/// The known properties of an orbit that is searched.
#[derive(Clone, Debug, PartialEq)]
pub struct OrbitSearch {
    /// A state at t = 0 on the orbit, near it, or on a motion that settles to it: coordinates, then velocities.
    pub start: Vec<f64>,
    /// The period of the drive or a multiple of it, or without a drive a guess of the period.
    pub period: Option<f64>,
    /// `true` if the motion conserves an energy, so that orbits form families and the start selects one of them.
    pub conserves_energy: bool,
    /// The coordinate whose initial value selects one of a family near a guess; by default the one farthest from zero.
    pub held: Option<usize>,
}

/// The method by which an orbit was found.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum OrbitKind {
    /// One coordinate released from rest.
    Released,
    /// The limit cycle to which an autonomous motion settles.
    LimitCycle,
    /// An unstable cycle that an autonomous motion passes; no cycle was found to which it settles.
    Passed,
    /// The response to a periodic force.
    Driven,
    /// An orbit of a family, through the start itself.
    Family,
    /// An orbit closed by Newton's method near a guess.
    Near,
}

impl Orbit {
    /// The orbit of a search: the response to a force that depends on the time; the orbit near a guess of the
    /// period if one is given; the motion of one coordinate from rest if energy is conserved or the motion
    /// closes, and from a start that moves, by its turning points, if energy is conserved; otherwise a limit cycle. If all motions near the
    /// start close, it is the one through the start.
    ///
    /// # Errors
    /// The errors of the respective kind of orbit; [`OrbitError::NoPeriod`] if a period
    /// is needed and none is given. [`OrbitError::Interrupted`] if the call is cancelled.
    ///
    /// # Examples
    /// ```
    /// # extern crate libration_motion as libration;
    /// use libration::orbit::{Orbit, OrbitKind, OrbitSearch};
    /// use libration::progress::Quiet;
    /// let search = OrbitSearch { start: vec![0.5, 0.0], period: None, conserves_energy: false, held: None };
    /// let (kind, cycle) = Orbit::search(&"x'' = (1 - x^2) x' - x".parse()?, &search, &Quiet)?;
    /// assert_eq!(kind, OrbitKind::LimitCycle);
    /// assert!((cycle.period() - 6.66328685932313).abs() < 1e-13);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn search(
        equation: &Equation,
        search: &OrbitSearch,
        progress: &dyn Progress,
    ) -> Result<(OrbitKind, Self), OrbitError> {
        let watch = &Watch::new(progress);
        let layout = StateLayout::new(equation);
        if search.start.len() != layout.numbers() {
            return Err(OrbitError::Start { state: search.start.clone(), wanted: layout.numbers() });
        }
        if equation.depends_on_time() {
            let period = search.period.ok_or(OrbitError::NoPeriod)?;
            let orbit = Self::driven(equation, &search.start, period, watch)?;
            return Ok((OrbitKind::Driven, orbit));
        }
        if let Some(period) = search.period {
            return search.near(equation, &layout, period, watch);
        }
        let from_rest = search.is_at_rest(&layout).then(|| Self::released(equation, search.start[0], watch));
        match from_rest {
            Some(Ok(orbit)) => Ok((OrbitKind::Released, orbit)),
            Some(Err(error)) if search.conserves_energy => Err(error),
            _ if search.conserves_energy => {
                search.near(equation, &layout, search.period_by_turns(equation, &layout, watch)?, watch)
            }
            _ => Self::undriven(equation, &search.start, watch),
        }
    }
}

impl OrbitSearch {
    /// Returns `true` for one coordinate that starts without a velocity.
    fn is_at_rest(&self, layout: &StateLayout) -> bool {
        layout.coordinates() == 1 && layout.velocity(0).is_some_and(|velocity| self.start[velocity] == 0.0)
    }

    /// The period of one coordinate that starts with a velocity and conserves energy: twice the time between two turning points.
    fn period_by_turns(
        &self,
        equation: &Equation,
        layout: &StateLayout,
        watch: &Watch<'_>,
    ) -> Result<f64, OrbitError> {
        let (1, Some(velocity)) = (layout.coordinates(), layout.velocity(0)) else {
            return Err(OrbitError::NoPeriod);
        };
        let system = System::new(equation)?;
        let effort = Effort { most_steps: MOST_STEPS, ..Effort::to_tolerance(1e-12) };
        let horizons = [self.shortest_time(&Acceleration::new(equation)?), FAR];
        let turn = |from: &Moment| {
            let path = until(&system, from, horizons, &effort, watch, |step| sign_change(step, velocity));
            let path = path.map_err(why_lost).and_then(|path| path.ok_or(Lost::OneWay(FAR)));
            finished(path.map_err(|why| OrbitError::NoReturn { start: self.start[0], why }), watch)
        };
        let first = turn(&Moment { time: 0.0, state: self.start.clone() })?;
        let rest = Moment { time: 0.0, state: vec![first.state_at(first.end_time())[0], 0.0] };
        Ok(2.0 * turn(&rest)?.end_time())
    }

    /// The shorter of the times in which the velocity leads to zero and the acceleration to rest; 1 if there is neither.
    fn shortest_time(&self, acceleration: &Acceleration) -> f64 {
        let [position, velocity] = [self.start[0], self.start[1]].map(f64::abs);
        let times = [position / velocity, velocity / acceleration.at(&self.start).abs()];
        let usable = times.into_iter().filter(|time| time.is_normal());
        usable.reduce(libm::fmin).unwrap_or(1.0)
    }

    /// The orbit through the start if it closes and is one of a family, otherwise the orbit near the guess;
    /// if the equations leave the period of that orbit undetermined, it is one of a family after all.
    fn near(
        &self,
        equation: &Equation,
        layout: &StateLayout,
        period: f64,
        watch: &Watch<'_>,
    ) -> Result<(OrbitKind, Orbit), OrbitError> {
        /// Largest relative uncertainty of the period of an isolated cycle, which
        /// is a few rounding errors; in a family the period is undetermined.
        const OPEN: f64 = 1e-4;
        let guess = OrbitGuess { state: self.start.clone(), period };
        let [start, family] = self.fixed(layout);
        let near = |fixed: &[usize]| {
            let orbit = Orbit::near(equation, &guess, fixed, watch)?;
            Ok((OrbitKind::Near, orbit))
        };
        let through = || {
            let family = if self.conserves_energy { FamilyCondition::Known } else { FamilyCondition::Asked };
            finished(through_start(equation, &Rounds::new(equation, watch)?, &guess, family), watch)
        };
        match through()? {
            Some(orbit) => Ok((OrbitKind::Family, orbit)),
            None if self.conserves_energy => near(&[start, family]),
            None => match near(&[start]) {
                // The period of an isolated cycle is well determined; NaN fails the comparison.
                Ok(candidate) if candidate.1.period_uncertainty() <= OPEN * candidate.1.period() => {
                    Ok(candidate)
                }
                Ok(_) => near(&[start, family]),
                Err(OrbitError::Undetermined(_)) => near(&[start, family]),
                outcome => outcome,
            },
        }
    }

    /// The components that are held fixed. The velocity of the held coordinate, by default the one farthest from zero, selects the start on the
    /// orbit, and the coordinate itself selects one of a family. Without a velocity these are the coordinate and one other component.
    fn fixed(&self, layout: &StateLayout) -> [usize; 2] {
        let size = |coordinate: &usize| self.start[*coordinate].abs();
        let farthest = || (0..layout.coordinates()).max_by(|a, b| size(a).total_cmp(&size(b))).unwrap_or(0);
        let held = self.held.filter(|held| *held < layout.coordinates()).unwrap_or_else(farthest);
        match layout.velocity(held) {
            Some(velocity) => [velocity, held],
            None => [held, usize::from(held == 0)],
        }
    }
}
