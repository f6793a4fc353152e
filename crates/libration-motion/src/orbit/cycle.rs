//! Limit cycles, to which motions settle.

use super::closing::Rounds;
use super::drift::{MOST_LEAPS, leap};
use super::error::{Lost, OrbitError, finished};
use super::family::{FamilyCondition, through_start};
use super::near::OrbitGuess;
use super::path::maximum_in;
use super::periodic::Orbit;
use super::relaxation::forgetful;
use super::search::OrbitKind;
use super::shooting::{Unknowns, closed};
use crate::periodic::{Floquet, Stability};
use crate::taylor::{Cause, Effort, IntegrationError, Moment, StateLayout, Step, System, integrate_stepwise};
use libration_numbers::expression::Equation;
use libration_numbers::internals::progress::Watch;
use libration_numbers::progress::Progress;
use std::ops::ControlFlow;

/// Maximum number of maxima of the first coordinate during settling: deviations that
/// shrink by 0.23 % from one to the next, 0.9977³⁰⁰⁰ = 10⁻³, have vanished by then.
const MOST_MAXIMA: usize = 3000;
/// Maximum number of steps after a maximum: a turn of van der Pol's oscillator with
/// the strength 1000 takes 3e5, and the number grows with the square of the strength.
const MOST_STEPS: usize = 500_000;
/// Largest number of maxima between a state and its return: a cycle that has doubled its period three times.
const LONGEST: usize = 8;
/// Swings below this fraction of the whole range count as rest: a thousand tolerances of the search.
const VANISHED: f64 = 1e-9;
/// Distance covered in the elapsed time at the current speed, relative to the range, below which the motion comes to rest. Past a saddle, from
/// which rounding drives it away at 1e-16 of its size, it is never that slow, but past one whose axes are invariant one coordinate may be: a
/// motion whose coordinates all come to rest, each at its time, is followed until all components of its state do so at once.
const FADED: f64 = 1e-30;
/// Difference from an earlier state, relative to the swing, below which the motion has returned; Newton's method does the rest. A motion that
/// passes an unstable cycle, as every chaotic one does again and again, is followed on until it returns more closely: for the last difference,
/// 3000 maxima with eight others each are 2e-5 returns by chance in a chaos of one dimension.
const RETURNED: [f64; 3] = [1e-3, 1e-6, 1e-9];

impl Orbit {
    /// The limit cycle to which the motion from a start settles; it begins at a maximum of the first coordinate that does not come to rest.
    /// Where the motion settles to none within 3000 maxima, it is an unstable one that it passes.
    ///
    /// # Accuracy
    /// As stated by [`period_uncertainty`](Self::period_uncertainty).
    ///
    /// # Errors
    /// The time in the equation; a motion that comes to rest, diverges, or does
    /// not repeat itself. [`OrbitError::Interrupted`] if the call is cancelled.
    ///
    /// # Examples
    /// ```
    /// # extern crate libration_motion as libration;
    /// use libration::orbit::{Orbit, Stability};
    /// use libration::progress::Quiet;
    /// let orbit = Orbit::limit_cycle(&"x'' = (1 - x^2) x' - x".parse()?, &[0.1, 0.0], &Quiet)?;
    /// assert!((orbit.period() - 6.66328685932313).abs() < 1e-13);
    /// assert_eq!(orbit.floquet().ok_or("no multipliers")?.stability, Stability::Attracting);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn limit_cycle(
        equation: &Equation,
        start: &[f64],
        progress: &dyn Progress,
    ) -> Result<Self, OrbitError> {
        if equation.depends_on_time() {
            return Err(OrbitError::DependsOnTime);
        }
        let none_asked = |_: &Rounds<'_>, _: f64| Ok(None);
        Ok(cycle_unless(none_asked, equation, start, &Watch::new(progress))?.1)
    }

    /// The limit cycle to which an autonomous motion settles, or the orbit through the start itself if it is one of a family.
    pub(super) fn undriven(
        equation: &Equation,
        start: &[f64],
        watch: &Watch<'_>,
    ) -> Result<(OrbitKind, Self), OrbitError> {
        let through = |rounds: &Rounds<'_>, period: f64| {
            through_start(
                equation,
                rounds,
                &OrbitGuess { state: start.to_vec(), period },
                FamilyCondition::Asked,
            )
        };
        cycle_unless(through, equation, start, watch)
    }
}

/// The cycle to which a motion settles, unless there is an orbit of a family with about its period.
fn cycle_unless(
    family: impl Fn(&Rounds<'_>, f64) -> Result<Option<Orbit>, OrbitError>,
    equation: &Equation,
    start: &[f64],
    watch: &Watch<'_>,
) -> Result<(OrbitKind, Orbit), OrbitError> {
    let rounds = Rounds::new(equation, watch)?;
    let system = System::new(equation)?;
    let at_return = |returned: f64| {
        let outcome = cycle_at_return(returned, &family, equation, (&rounds, watch), &system, start);
        finished(outcome, watch)
    };
    let [first, closer @ ..] = RETURNED;
    let outcome = at_return(first)?;
    if outcome.0 != OrbitKind::Passed {
        return Ok(outcome);
    }
    for returned in closer {
        match at_return(returned) {
            Ok((OrbitKind::Passed, _)) => {}
            Err(OrbitError::Interrupted(interrupted)) => return Err(interrupted.into()),
            Err(_) => break,
            settled => return settled,
        }
    }
    Ok(outcome)
}

/// The cycle where the motion first returns within a difference; an unstable cycle is one that it passes.
fn cycle_at_return(
    returned: f64,
    family: impl Fn(&Rounds<'_>, f64) -> Result<Option<Orbit>, OrbitError>,
    equation: &Equation,
    (rounds, watch): (&Rounds<'_>, &Watch<'_>),
    system: &System,
    start: &[f64],
) -> Result<(OrbitKind, Orbit), OrbitError> {
    let (coordinate, guess) = settled((system, rounds), start, returned, watch)?;
    if let Some(orbit) = forgetful(equation, rounds, &guess)? {
        return Ok((OrbitKind::LimitCycle, orbit));
    }
    if let Some(orbit) = family(rounds, guess.period)? {
        return Ok((OrbitKind::Family, orbit));
    }
    let orbit = drifted(equation, rounds, coordinate, &guess)?;
    let is_unstable = orbit.floquet().is_some_and(|floquet| floquet.stability == Stability::Unstable);
    Ok((if is_unstable { OrbitKind::Passed } else { OrbitKind::LimitCycle }, orbit))
}

/// The cycle near a guess, or near the states to which the drift of a turn leads.
fn drifted(
    equation: &Equation,
    rounds: &Rounds<'_>,
    coordinate: usize,
    guess: &OrbitGuess,
) -> Result<Orbit, OrbitError> {
    let at_maximum = |guess: &OrbitGuess| at_maximum(equation, rounds, coordinate, guess);
    let mut outcome = at_maximum(guess);
    let mut at = guess.clone();
    for _ in 0..MOST_LEAPS {
        if !matches!(outcome, Err(OrbitError::NoCycle(Lost::UnstableRest) | OrbitError::NoConvergence { .. }))
        {
            break;
        }
        let Some(next) = leap(rounds, coordinate, &at)? else { break };
        let nearer = at_maximum(&next);
        at = next;
        outcome = if nearer.is_ok() { nearer } else { outcome };
    }
    outcome
}

/// The cycle near a guess that begins at a maximum of a coordinate. Where an attracting cycle is about to double its period, a turn almost
/// reverses deviations: two turns are almost closed wherever they begin, and Newton's method finds the cycle by one.
fn at_maximum(
    equation: &Equation,
    rounds: &Rounds<'_>,
    coordinate: usize,
    guess: &OrbitGuess,
) -> Result<Orbit, OrbitError> {
    let held = rounds.held_at_maximum(coordinate, guess)?;
    let free = (0..rounds.layout().numbers()).filter(|number| *number != held).collect();
    let unknowns = Unknowns { free, period: true };
    let outcome = closed(equation, rounds, guess, &unknowns);
    if !matches!(outcome, Err(OrbitError::NoConvergence { .. })) {
        return outcome;
    }
    let turn = OrbitGuess { period: 0.5 * guess.period, ..guess.clone() };
    match closed(equation, rounds, &turn, &unknowns) {
        Ok(orbit) if orbit.floquet().map(|floquet| floquet.stability) == Some(Stability::Attracting) => {
            Ok(orbit)
        }
        Err(error @ OrbitError::Interrupted(_)) => Err(error),
        _ => outcome,
    }
}

/// The motion followed from maximum to maximum until it repeats itself: the first coordinate that does not come to rest, and a guess of the cycle.
fn settled(
    (system, rounds): (&System, &Rounds<'_>),
    start: &[f64],
    returned: f64,
    watch: &Watch<'_>,
) -> Result<(usize, OrbitGuess), OrbitError> {
    let coordinates = 0..system.layout().coordinates();
    let mut outcome = Err(OrbitError::NoCycle(Lost::Rest));
    for (at_once, coordinate) in
        [false, true].into_iter().flat_map(|at_once| coordinates.clone().map(move |n| (at_once, n)))
    {
        if !matches!(outcome, Err(OrbitError::NoCycle(Lost::Rest))) {
            break;
        }
        let maxima = Maxima { at_once, ..Maxima::new(system.layout(), coordinate, returned) };
        outcome = settled_by(maxima, (system, rounds), start, watch).map(|guess| (coordinate, guess));
    }
    outcome
}

fn settled_by(
    mut maxima: Maxima,
    (system, rounds): (&System, &Rounds<'_>),
    start: &[f64],
    watch: &Watch<'_>,
) -> Result<OrbitGuess, OrbitError> {
    /// A time beyond every motion: the limits of maxima or steps end the search before.
    const FAR: f64 = 1e300;
    let mut guess = None;
    let start = Moment { time: 0.0, state: start.to_vec() };
    let effort = Effort::to_tolerance(1e-12);
    let outcome = integrate_stepwise(system, &start, &[FAR], &effort, |step| {
        guess = maxima.watch(step).filter(|_| !maxima.vanish());
        if guess.is_some() || maxima.are_enough() || maxima.vanish() || maxima.fade() {
            ControlFlow::Break(())
        } else {
            watch.flow()
        }
    });
    match (guess, outcome) {
        (Some(guess), _) => Ok(guess),
        (None, outcome) => Err(match lost(outcome.err(), &maxima) {
            OrbitError::NoCycle(Lost::Rest) if maxima.at_once && repels(rounds, &maxima) => {
                OrbitError::NoCycle(Lost::Saddle)
            }
            lost => lost,
        }),
    }
}

/// Returns `true` if deviations grow where the motion has come to rest, unless it has never moved.
fn repels(rounds: &Rounds<'_>, maxima: &Maxima) -> bool {
    /// The part of the elapsed time in which deviations are followed: to come to rest, a motion shrinks by e⁻⁶⁹.
    const PART: f64 = 0.01;
    /// Relative change of the variations by which a deviation that stays is not taken for one that grows.
    const CHANGE: f64 = 1e-6;
    if !maxima.fade() {
        return false;
    }
    // The end of a step of a motion that has stopped may be at any time.
    let variations = rounds.variations(&maxima.state, [0.0, PART * maxima.moved_until]);
    let units = vec![1.0; maxima.state.len()];
    let floquet =
        variations.ok().and_then(|variations| Floquet::new(&variations.by_start, &units, CHANGE, false));
    floquet.is_some_and(|floquet| floquet.stability == Stability::Unstable)
}

fn lost(error: Option<IntegrationError>, maxima: &Maxima) -> OrbitError {
    let Maxima { time, steps, .. } = *maxima;
    OrbitError::NoCycle(match error {
        Some(IntegrationError::Stopped { cause: Cause::Interrupted | Cause::StepLimit, .. }) => {
            match (maxima.vanish() || maxima.is_still(), steps < MOST_STEPS) {
                (true, _) => Lost::Rest,
                (false, true) => Lost::Irregular(maxima.moments.last().map_or(0.0, |moment| moment.time)),
                (false, false) => maxima.goes_round().unwrap_or(Lost::Slow { time, steps }),
            }
        }
        Some(IntegrationError::Stopped { cause: Cause::NoWayOn, .. }) if maxima.is_still() => Lost::Rest,
        Some(IntegrationError::Stopped { cause: Cause::NoWayOn, solution }) => {
            Lost::Sticks(solution.end.time)
        }
        None if maxima.goes_away() => Lost::OneWay(time),
        None => Lost::Rest,
        Some(error @ IntegrationError::Stopped { .. }) => Lost::Stopped(error),
        Some(error) => return error.into(),
    })
}

/// The maxima of a coordinate so far.
struct Maxima {
    coordinate: usize,
    /// The index of its velocity.
    velocity: Option<usize>,
    /// Difference from an earlier state, relative to the swing, below which the motion has returned.
    returned: f64,
    moments: Vec<Moment>,
    /// Steps since the last maximum.
    steps: usize,
    /// Largest change of each state component since the last maximum.
    moved: Vec<f64>,
    /// Largest change of each state component between the last two maxima.
    swing: Vec<f64>,
    /// The least and the greatest value of the coordinate so far.
    range: (f64, f64),
    /// The elapsed time.
    time: f64,
    /// Speed of the coordinate at that time.
    pace: f64,
    /// The state at that time.
    state: Vec<f64>,
    /// `true` if the motion comes to rest only when all components of its state do so.
    at_once: bool,
    /// The time from which on the motion has faded.
    moved_until: f64,
    /// Number of consecutive steps with almost no motion at their ends.
    faded: usize,
}

impl Maxima {
    fn new(layout: &StateLayout, coordinate: usize, returned: f64) -> Self {
        let none = vec![0.0; layout.numbers()];
        Self {
            coordinate,
            velocity: layout.velocity(coordinate),
            returned,
            moments: vec![],
            steps: 0,
            moved: none.clone(),
            swing: none.clone(),
            range: (f64::INFINITY, f64::NEG_INFINITY),
            time: 0.0,
            pace: 0.0,
            state: none,
            at_once: false,
            moved_until: 0.0,
            faded: 0,
        }
    }

    /// Processes a step; returns a guess of the cycle as soon as the motion repeats itself.
    fn watch(&mut self, step: &Step<'_>) -> Option<OrbitGuess> {
        self.steps += 1;
        self.time = step.end();
        let speeds = step.speeds_at(self.time);
        self.pace = speeds[self.coordinate].abs();
        self.state = step.state_at(self.time);
        for time in [step.start(), step.end()] {
            self.widen(&step.state_at(time));
        }
        let all = || speeds.iter().fold(0.0, |all: f64, speed| all.max(speed.abs()));
        let pace = if self.at_once { all() } else { self.pace };
        // A component that has never moved is at rest as well.
        let is_faded = pace * self.time <= FADED * (self.range.1 - self.range.0);
        if self.faded == 0 {
            self.moved_until = step.start();
        }
        self.faded = if is_faded { self.faded + 1 } else { 0 };
        let time = maximum_in(step, self.coordinate)?;
        let mut state = step.state_at(time);
        if let Some(velocity) = self.velocity {
            // At a maximum a remaining velocity is a rounding error.
            state[velocity] = 0.0;
        }
        self.swing = std::mem::replace(&mut self.moved, vec![0.0; state.len()]);
        let recent = self.moments.iter().rev().take(LONGEST);
        let earlier = recent.clone().find(|earlier| self.is_return(&state, &earlier.state));
        let guess = earlier.map(|earlier| OrbitGuess { state: state.clone(), period: time - earlier.time });
        self.moments.push(Moment { time, state });
        self.steps = 0;
        guess
    }

    fn widen(&mut self, state: &[f64]) {
        let coordinate = state[self.coordinate];
        self.range = (self.range.0.min(coordinate), self.range.1.max(coordinate));
        let Some(last) = self.moments.last() else { return };
        for ((moved, now), then) in self.moved.iter_mut().zip(state).zip(&last.state) {
            *moved = moved.max((now - then).abs());
        }
    }

    fn is_return(&self, state: &[f64], earlier: &[f64]) -> bool {
        let differences = state.iter().zip(earlier).zip(&self.swing);
        differences.into_iter().all(|((now, then), swing)| (now - then).abs() <= self.returned * swing)
    }

    /// Returns `true` if the search has reached its limit of maxima, or of steps since the last one.
    fn are_enough(&self) -> bool {
        self.moments.len() >= MOST_MAXIMA || self.steps >= MOST_STEPS
    }

    /// Returns `true` if the motion has faded at the ends of several steps, one of which may be a turning point.
    fn fade(&self) -> bool {
        self.faded >= 3
    }

    /// Returns `true` if the coordinate is at rest: at its speed it would
    /// take many times the elapsed time for a significant part of its range.
    fn is_still(&self) -> bool {
        self.pace * self.time <= VANISHED * (self.range.1 - self.range.0)
    }

    /// Returns `true` if the coordinate is farther away than any orbit that is searched.
    fn goes_away(&self) -> bool {
        /// Squares of distances must not overflow.
        const FAR: f64 = 1e100;
        self.range.1 - self.range.0 > FAR
    }

    /// The end of a motion that has left the range of its last swing by far since the last maximum.
    fn goes_round(&self) -> Option<Lost> {
        /// A slow motion of a relaxation oscillator stays within its swing.
        const FAR: f64 = 10.0;
        let last = self.moments.last().filter(|_| self.moments.len() > 1)?;
        let gone = (self.state[self.coordinate] - last.state[self.coordinate]).abs();
        (gone > FAR * self.swing[self.coordinate]).then_some(Lost::GoesRound(last.time))
    }

    /// Returns `true` if the last swing is negligible compared with the whole range.
    fn vanish(&self) -> bool {
        self.moments.len() > 1 && self.swing[self.coordinate] < VANISHED * (self.range.1 - self.range.0)
    }
}
