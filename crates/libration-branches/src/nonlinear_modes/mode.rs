//! A normal mode continued in amplitude.

use super::belonging::Release;
use super::{LostMode, NonlinearModeError, Reason};
use crate::normal_modes::{Behaviour, Mode, NormalModes};
use libration_motion::orbit::{Orbit, OrbitError, OrbitGuess};
use libration_numbers::algebra::Complex;
use libration_numbers::expression::Equation;
use libration_numbers::internals::progress::Watch;
use libration_numbers::progress::Progress;
use std::f64::consts::TAU;

/// A family of periodic orbits that begins with a mode of small oscillations.
#[derive(Clone, Debug)]
pub struct NonlinearMode {
    /// Orbits at the requested amplitudes, up to the last one reached.
    pub points: Vec<ModePoint>,
    /// Changes of stability along the mode.
    pub changes: Vec<StabilityChange>,
    /// Reason why the mode did not reach the last amplitude.
    pub lost: Option<LostMode>,
}

/// One orbit of the family.
#[derive(Clone, Debug)]
pub struct ModePoint {
    /// The displacement of the chosen coordinate at the start, where its velocity is zero.
    pub amplitude: f64,
    /// The state at the start, coordinates and then velocities.
    pub start: Vec<f64>,
    /// The orbit, with period, its uncertainty, harmonics and Floquet multipliers.
    pub orbit: Orbit,
    /// ω + κa², with a the first harmonic of the leading coordinate; `None` if the mode has no such series.
    pub series_frequency: Option<f64>,
}

/// A change of stability between two amplitudes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StabilityChange {
    /// Amplitudes below and above the change.
    pub between: [f64; 2],
    /// `true` if the mode is stable above the change.
    pub stable_above: bool,
}

/// Amplitude of the first orbit, or this fraction of the least requested amplitude if that is smaller.
const FIRST: f64 = 0.02;
/// Factor by which a step exceeds the previous one.
const GROWTH: f64 = 1.6;
/// The maximum step relative to the last amplitude.
const LONGEST: f64 = 0.25;
/// Largest distance of an orbit from the predicted one, relative to the step.
const NEAR: f64 = 0.5;
/// Largest deviation of the period from the predicted one, relative to it: two repetitions would be off by one, half an orbit by a half.
const SAME_PERIOD: f64 = 0.3;
/// Number of times that a step is halved before the mode counts as lost.
const HALVINGS: u32 = 8;
/// Minimum step, relative to the amplitude, below which the mode counts as lost too: towards a separatrix, steps could fail, be halved and
/// succeed for ever. A pendulum is followed to 179.9999° with steps of 5e-6.
const LEAST: f64 = 1e-6;
/// Width relative to the amplitude to which a change of stability is bisected: closer
/// to it four multipliers are at 1, each accurate only to a fourth root of the errors.
const NARROW: f64 = 2e-3;

impl ModePoint {
    /// Returns `true` if small deviations do not grow.
    #[must_use]
    pub fn is_stable(&self) -> bool {
        self.orbit.floquet().is_some_and(|floquet| floquet.stability.may_last())
    }
}

impl NonlinearMode {
    /// The largest computed amplitude up to which ω + κa² agrees with the frequency to within
    /// this fraction; `None` if the first already disagrees, or there is no such series.
    #[must_use]
    pub fn series_reach(&self, part: f64) -> Option<f64> {
        let fits = |point: &&ModePoint| {
            let frequency = point.orbit.frequency();
            point.series_frequency.is_some_and(|series| (series - frequency).abs() <= part * frequency)
        };
        self.points.iter().take_while(fits).last().map(|point| point.amplitude)
    }

    /// The mode with an index from 0, at ascending amplitudes of a coordinate: the displacements from which the coordinate turns back.
    ///
    /// # Accuracy
    /// Each orbit as [`Orbit::period_uncertainty`] states; changes of stability to 2e-3 of the amplitude.
    ///
    /// # Errors
    /// A mode that does not exist, does not oscillate or shares its frequency;
    /// a coordinate at rest in it; amplitudes that do not ascend. Cancellation.
    pub fn follow(
        equation: &Equation,
        modes: &NormalModes,
        number: usize,
        coordinate: usize,
        amplitudes: &[f64],
        progress: &dyn Progress,
    ) -> Result<Self, NonlinearModeError> {
        let watch = &Watch::new(progress);
        let family = ModeFamily::new(equation, modes, number, coordinate, watch)?;
        let mut last = 0.0;
        for amplitude in amplitudes {
            if !(*amplitude > last && amplitude.is_finite()) {
                return Err(NonlinearModeError::Amplitudes(*amplitude));
            }
            last = *amplitude;
        }
        let mut mode = Self { points: vec![], changes: vec![], lost: None };
        let mut path: Vec<ModePoint> = vec![];
        for amplitude in amplitudes {
            let start = path.len().saturating_sub(1);
            let lost = family.extend(&mut path, *amplitude)?;
            mode.changes.extend(family.changes(&path, start)?);
            let reached = path.last().map_or(0.0, |point| point.amplitude);
            match (path.last(), lost) {
                (Some(point), None) => mode.points.push(point.clone()),
                (_, Some(reason)) => {
                    mode.lost = Some(LostMode { reached, reason });
                    break;
                }
                (None, None) => {}
            }
            path.drain(..path.len().saturating_sub(3));
        }
        Ok(mode)
    }
}

/// Quantities that are constant along the mode.
struct ModeFamily<'a> {
    equation: &'a Equation,
    mode: &'a Mode,
    rest: &'a [f64],
    coordinate: usize,
    watch: &'a Watch<'a>,
}

impl<'a> ModeFamily<'a> {
    fn new(
        equation: &'a Equation,
        modes: &'a NormalModes,
        number: usize,
        coordinate: usize,
        watch: &'a Watch<'a>,
    ) -> Result<Self, NonlinearModeError> {
        let missing = NonlinearModeError::NoMode { wanted: number + 1, modes: modes.modes.len() };
        let mode = modes.modes.get(number).ok_or(missing)?;
        if mode.behaviour != Behaviour::Oscillating || mode.multiplicity > 1 {
            return Err(NonlinearModeError::NotOscillating(number + 1));
        }
        /// Smallest displacement of a moving coordinate, relative to the largest one.
        const STILL: f64 = 1e-6;
        if mode.shape[coordinate].abs() < STILL {
            return Err(NonlinearModeError::AtRest(modes.variables[coordinate].clone()));
        }
        Ok(Self { equation, mode, rest: &modes.equilibrium, coordinate, watch })
    }

    /// Appends orbits up to an amplitude; returns the reason if it was not reached.
    fn extend(&self, path: &mut Vec<ModePoint>, to: f64) -> Result<Option<Reason>, NonlinearModeError> {
        if path.is_empty() {
            let first = (FIRST * to).min(FIRST);
            match self.orbit(first, self.linear(first))? {
                Ok(point) => path.push(point),
                Err(reason) => return self.reason_at(to, reason).map(Some),
            }
        }
        let (mut halvings, mut telling) = (0, None);
        while let Some(last) = path.last().map(|point| point.amplitude).filter(|last| *last < to) {
            let before = path.len().checked_sub(2).map_or(0.0, |index| path[index].amplitude);
            let step = (GROWTH * (last - before)).min(LONGEST * last.max(4.0 * FIRST))
                * libm::exp2(-f64::from(halvings));
            // The last step is not short.
            let next = if last + 1.2 * step >= to { to } else { last + step };
            let expected = self.expected(path, next);
            let reason = match self.orbit(next, expected.clone())? {
                Ok(point) if is_near(&point, &expected, last, path) => {
                    path.push(point);
                    halvings = (halvings - 1).max(0);
                    continue;
                }
                Ok(_) => Reason::Jump,
                Err(reason) => reason,
            };
            halvings += 1;
            telling = if reason.is_telling() { Some(reason.clone()) } else { telling };
            if halvings > HALVINGS.cast_signed() || step < LEAST * last {
                return self.reason_at(to, telling.unwrap_or(reason)).map(Some);
            }
        }
        Ok(None)
    }

    /// The linear oscillation with this amplitude, from a turning point of the coordinate; with gyroscopic forces the others may be moving there.
    fn linear(&self, amplitude: f64) -> OrbitGuess {
        let scale = Complex::from(amplitude) / self.mode.shape[self.coordinate];
        let parts: Vec<Complex> = self.mode.shape.iter().map(|part| *part * scale).collect();
        let displacements = self.rest.iter().zip(&parts).map(|(rest, part)| rest + part.re);
        let velocities = parts.iter().map(|part| -self.mode.frequency() * part.im);
        OrbitGuess { state: displacements.chain(velocities).collect(), period: TAU / self.mode.frequency() }
    }

    /// The next orbit, extrapolated by the parabola or the line through the last ones.
    fn expected(&self, path: &[ModePoint], amplitude: f64) -> OrbitGuess {
        let recent = &path[path.len().saturating_sub(3)..];
        if recent.len() < 2 {
            return OrbitGuess { period: recent[0].orbit.period(), ..self.linear(amplitude) };
        }
        let weight = |k: usize| -> f64 {
            let others = (0..recent.len()).filter(|j| *j != k);
            others
                .map(|j| (amplitude - recent[j].amplitude) / (recent[k].amplitude - recent[j].amplitude))
                .product()
        };
        let mean = |of: &dyn Fn(&ModePoint) -> f64| -> f64 {
            recent.iter().enumerate().map(|(k, point)| weight(k) * of(point)).sum()
        };
        let mut state: Vec<f64> = (0..recent[0].start.len()).map(|i| mean(&|point| point.start[i])).collect();
        state[self.coordinate] = self.rest[self.coordinate] + amplitude;
        let last = recent[recent.len() - 1].orbit.period();
        let period = mean(&|point| point.orbit.period());
        // A parabola through periods that grow without bound may extrapolate to any value.
        OrbitGuess { state, period: if (period / last - 1.0).abs() < 1.0 { period } else { last } }
    }

    /// Reason why there is no orbit at an amplitude: for one coordinate from its release, for several the last reason of the search.
    fn reason_at(&self, amplitude: f64, last: Reason) -> Result<Reason, NonlinearModeError> {
        if self.rest.len() > 1 {
            return Ok(last);
        }
        match Orbit::released(self.equation, self.rest[0] + amplitude, &self.watch.part()) {
            Err(OrbitError::Interrupted(interrupted)) => Err(interrupted.into()),
            Err(error) => Ok(error.into()),
            Ok(orbit) => Ok(self.release(amplitude).refusal(&orbit).unwrap_or(last)),
        }
    }

    const fn release(&self, amplitude: f64) -> Release<'_> {
        Release { rest: self.rest, coordinate: self.coordinate, amplitude }
    }

    fn orbit(
        &self,
        amplitude: f64,
        guess: OrbitGuess,
    ) -> Result<Result<ModePoint, Reason>, NonlinearModeError> {
        let fixed = [self.coordinate, self.rest.len() + self.coordinate];
        let mut guess = guess;
        guess.state[fixed[0]] = self.rest[self.coordinate] + amplitude;
        guess.state[fixed[1]] = 0.0;
        match Orbit::near(self.equation, &guess, &fixed, &self.watch.part()) {
            Err(OrbitError::Interrupted(interrupted)) => Err(interrupted.into()),
            Err(error) => Ok(Err(error.into())),
            Ok(orbit) => Ok(match self.release(amplitude).refusal(&orbit) {
                Some(reason) => Err(reason),
                None => Ok(self.point(amplitude, orbit.one_of_a_family())),
            }),
        }
    }

    fn point(&self, amplitude: f64, orbit: Orbit) -> ModePoint {
        let series_frequency = self.mode.shift.as_ref().ok().map(|shift| {
            let terms = orbit.harmonics(self.mode.leading()).terms;
            let first = terms.get(1).map_or(f64::NAN, |term| term.amplitude());
            self.mode.frequency() + shift.coefficient * first * first
        });
        ModePoint { amplitude, start: orbit.start(), orbit, series_frequency }
    }

    /// Changes of stability along a path, beginning at one of its orbits.
    fn changes(&self, path: &[ModePoint], from: usize) -> Result<Vec<StabilityChange>, NonlinearModeError> {
        let mut changes = vec![];
        for (index, pair) in path.windows(2).enumerate().skip(from) {
            let stable_above = pair[1].is_stable();
            if pair[0].is_stable() == stable_above {
                continue;
            }
            let mut between = [pair[0].amplitude, pair[1].amplitude];
            while between[1] - between[0] > NARROW * between[1] {
                let middle = 0.5 * (between[0] + between[1]);
                let guess = self.expected(&path[..=index + 1], middle);
                let Ok(point) = self.orbit(middle, guess)? else { break };
                between[usize::from(point.is_stable() == stable_above)] = middle;
            }
            changes.push(StabilityChange { between, stable_above });
        }
        Ok(changes)
    }
}

/// Returns `true` if an orbit is near the predicted one: within half a step in all components together, and with about the same period.
fn is_near(point: &ModePoint, expected: &OrbitGuess, last: f64, path: &[ModePoint]) -> bool {
    let distance =
        |a: &[f64], b: &[f64]| -> f64 { a.iter().zip(b).map(|(a, b)| (a - b) * (a - b)).sum::<f64>().sqrt() };
    let before = &path[path.len() - 1].start;
    let step = distance(&point.start, before).max(point.amplitude - last);
    let same_period = (point.orbit.period() / expected.period - 1.0).abs() <= SAME_PERIOD;
    same_period && distance(&point.start, &expected.state) <= NEAR * step
}
