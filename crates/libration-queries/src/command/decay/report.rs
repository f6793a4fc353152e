//! Results of a decay: its turning points with both laws for comparison, and its cycles.

use super::options::Extent;
use super::slow_flow::{SlowCycle, SlowTurn};
use crate::interrupt;
use crate::output::number::short;
use crate::output::progress::ProgressLine;
use crate::query_error::QueryError;
use libration::comparison::SlowDecay;
use libration::decay::{Decay, DecayEnding, EnvelopeLaw, TurningPoint};
use std::f64::consts::TAU;

/// The turning points, the first of which is the release, and the reason why the list ends.
pub(crate) struct Report {
    pub(crate) turns: Vec<Turn>,
    /// `None` if the list ends as requested.
    pub(crate) ending: Option<DecayEnding>,
    /// `true` if the run was cancelled.
    pub(crate) interrupted: bool,
    /// Times of the turning points of the slow flow, in seconds, if it is requested.
    slow_turns: Vec<f64>,
}

/// A turning point, and the amplitude (rad) at its time by averaging and by the law of small amplitudes.
pub(crate) struct Turn {
    pub(crate) point: TurningPoint,
    pub(crate) averaged: f64,
    pub(crate) small: f64,
    /// The slow flow, if requested.
    pub(crate) slow: Option<SlowTurn>,
}

/// A turning point with its number in cycles.
pub(crate) struct NumberedTurn<'a> {
    /// 0, 0.5, 1, ….
    pub(crate) cycle: f64,
    pub(crate) turn: &'a Turn,
    /// Cycle that ends there, if a whole one does.
    pub(crate) whole: Option<Cycle>,
}

/// A whole cycle, in seconds.
#[derive(Clone, Copy)]
pub(crate) struct Cycle {
    /// Time of its middle turning point, in seconds.
    pub(crate) middle: f64,
    /// Duration in seconds.
    pub(crate) duration: f64,
    /// The exact period of the amplitude in its middle.
    pub(crate) exact_period: f64,
    /// The slow flow, if requested.
    pub(crate) slow: Option<SlowCycle>,
}

impl Report {
    pub(super) fn new(decay: &Decay, extent: Extent) -> Result<Self, QueryError> {
        let (averaged, small) =
            (decay.envelope(EnvelopeLaw::Averaged), decay.envelope(EnvelopeLaw::SmallAmplitude));
        let mut swings = decay.swings();
        let mut turns: Vec<Turn> = vec![];
        let mut progress = ProgressLine::new();
        let mut interrupted = false;
        while turns.len() <= extent.turns() && !interrupted {
            let Some(point) =
                swings.next().transpose().map_err(|error| QueryError::no_result("decay", error))?
            else {
                break;
            };
            if point.time > extent.last_time() {
                break;
            }
            let [averaged, small] = [averaged, small].map(|envelope| envelope.amplitude_at(point.time));
            progress.show(|| format!("{} cycles, t = {:.6} s", in_cycles(turns.len()), point.time));
            turns.push(Turn { point, averaged, small, slow: None });
            interrupted = interrupt::is_cancelled();
        }
        let report = Self { turns, ending: swings.ending(), interrupted, slow_turns: vec![] };
        report
            .ending
            .filter(|ending| report.turns.len() == 1 && !matches!(ending, DecayEnding::StopsOnTheWay { .. }))
            .map_or(Ok(report), |ending| Err(no_swing(decay, ending)))
    }

    /// Adds the slow flow to each turning point and each cycle.
    pub(super) fn compare_with(&mut self, slow: &SlowDecay) {
        let times: Vec<f64> = self.turns.iter().map(|turn| turn.point.time).collect();
        for ((number, turn), at) in self.turns.iter_mut().enumerate().zip(slow.at_times(&times)) {
            let (amplitude, phase) = (at.amplitude, at.phase);
            turn.slow = Some(SlowTurn {
                amplitude,
                phase,
                amplitude_error: amplitude - turn.point.amplitude.radians(),
                phase_error: phase - TAU * in_cycles(number),
            });
        }
        self.slow_turns = slow.turning_points(times.len()).iter().map(|turn| turn.time).collect();
    }

    /// The largest error of the slow flow at a turning point; NaN if it has no value at one.
    pub(super) fn largest_slow_error(&self, error: impl Fn(&SlowTurn) -> f64) -> f64 {
        let errors = self.turns.iter().filter_map(|turn| Some(error(&turn.slow?).abs()));
        errors.fold(0.0, |largest, error| if error.is_nan() || error > largest { error } else { largest })
    }

    fn slow_cycle(&self, number: usize, duration: f64) -> Option<SlowCycle> {
        self.turns[number].slow?;
        let ends = self.slow_turns.get(number - 2).zip(self.slow_turns.get(number));
        let slow_duration = ends.map_or(f64::NAN, |(begin, end)| end - begin);
        Some(SlowCycle { duration: slow_duration, error: slow_duration - duration })
    }

    /// All turning points.
    pub(crate) fn rows(&self, decay: &Decay) -> impl Iterator<Item = NumberedTurn<'_>> {
        let pendulum = decay.pendulum();
        self.turns.iter().enumerate().map(move |(number, turn)| {
            let whole = (number > 0 && number.is_multiple_of(2)).then(|| {
                let [start, middle] = [&self.turns[number - 2].point, &self.turns[number - 1].point];
                let duration = turn.point.time - start.time;
                let exact_period = pendulum.period(&middle.amplitude);
                Cycle { middle: middle.time, duration, exact_period, slow: self.slow_cycle(number, duration) }
            });
            NumberedTurn { cycle: in_cycles(number), turn, whole }
        })
    }

    /// The time in seconds and the angle in radians at which dry friction stops the pendulum, if it does.
    pub(super) fn rest(&self) -> Option<(f64, f64)> {
        match self.ending? {
            DecayEnding::Sticks => {
                self.turns.last().map(|turn| (turn.point.time, turn.point.amplitude.radians()))
            }
            DecayEnding::StopsOnTheWay { time, angle } => Some((time, angle)),
            _ => None,
        }
    }

    /// The largest error (rad) of a law at a turning point, with that turning point's number.
    pub(super) fn largest_error(&self, law: impl Fn(&Turn) -> f64) -> (f64, usize) {
        let errors = self.turns.iter().map(|turn| (law(turn) - turn.point.amplitude.radians()).abs());
        errors.zip(0..).fold((0.0, 0), |largest, error| if error.0 > largest.0 { error } else { largest })
    }
}

/// The number of a turning point, in cycles.
pub(super) fn in_cycles(number: usize) -> f64 {
    0.5 * u32::try_from(number).map_or(f64::INFINITY, f64::from)
}

/// The reason why a released pendulum does not swing.
fn no_swing(decay: &Decay, ending: DecayEnding) -> QueryError {
    let reason = if ending == DecayEnding::Sticks {
        let held = short(decay.sticking_amplitude().to_degrees(), 6);
        format!(
            "dry friction holds the pendulum where it is released, as it does within {held}° of the bottom and of the top: give another amplitude"
        )
    } else {
        "the damping is too strong for a swing, the pendulum creeps to the bottom: give smaller coefficients"
            .to_owned()
    };
    QueryError::no_result("decay", reason)
}
