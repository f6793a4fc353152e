//! What is found of a decay: its turning points with both laws beside them, and its cycles.

use super::options::Extent;
use crate::failure::Failure;
use crate::output::number::short;
use libration::decay::{Decay, Ending, Law, TurningPoint};

/// The turning points, the first of which is the release, and why there are no more.
pub(crate) struct Report {
    pub(crate) turns: Vec<Turn>,
    /// `None` where it is followed no further.
    pub(crate) ending: Option<Ending>,
}

/// A turning point, and the amplitude (rad) at its time by averaging and by the law of small amplitudes.
pub(crate) struct Turn {
    pub(crate) point: TurningPoint,
    pub(crate) averaged: f64,
    pub(crate) small: f64,
}

/// The turning points at the end of a cycle and in its middle, with its time and the exact period of the amplitude there.
#[derive(Clone, Copy)]
pub(crate) struct Cycle<'a> {
    pub(crate) middle: &'a Turn,
    pub(crate) end: &'a Turn,
    pub(crate) period: f64,
    pub(crate) exact_period: f64,
}

impl Report {
    pub(super) fn new(decay: &Decay, extent: Extent) -> Result<Self, Failure> {
        let (averaged, small) = (decay.envelope(Law::Averaged), decay.envelope(Law::SmallAmplitude));
        let mut swings = decay.swings();
        let mut turns = vec![];
        while turns.len() <= extent.turns() {
            let Some(point) =
                swings.next().transpose().map_err(|error| Failure::no_answer("decay", error))?
            else {
                break;
            };
            if point.time > extent.last_time() {
                break;
            }
            let [averaged, small] = [averaged, small].map(|envelope| envelope.amplitude_at(point.time));
            turns.push(Turn { point, averaged, small });
        }
        let report = Self { turns, ending: swings.ending() };
        report
            .ending
            .filter(|_| report.turns.len() == 1)
            .map_or(Ok(report), |ending| Err(no_swing(decay, ending)))
    }

    /// The whole cycles.
    pub(crate) fn cycles<'a>(&'a self, decay: &Decay) -> impl Iterator<Item = Cycle<'a>> {
        let pendulum = decay.pendulum();
        self.turns.windows(3).step_by(2).map(move |turns| {
            let [start, middle, end] = [&turns[0], &turns[1], &turns[2]];
            let period = end.point.time - start.point.time;
            Cycle { middle, end, period, exact_period: pendulum.period(&middle.point.amplitude) }
        })
    }

    /// The largest error (rad) of a law at a turning point, with that turning point's number.
    pub(super) fn largest_error(&self, law: impl Fn(&Turn) -> f64) -> (f64, usize) {
        let errors = self.turns.iter().map(|turn| (law(turn) - turn.point.amplitude.radians()).abs());
        errors.zip(0..).fold((0.0, 0), |largest, error| if error.0 > largest.0 { error } else { largest })
    }
}

/// Why a pendulum that was released does not swing.
fn no_swing(decay: &Decay, ending: Ending) -> Failure {
    let reason = if ending == Ending::Sticks {
        let held = short(decay.sticking_amplitude().to_degrees(), 6);
        format!(
            "dry friction holds the pendulum where it is released, as up to {held}° from the bottom and from the top: give another amplitude"
        )
    } else {
        "the damping is too strong for a swing, the pendulum creeps to the bottom: give smaller coefficients"
            .to_owned()
    };
    Failure::no_answer("decay", reason)
}
