//! What is found of a decay: its turning points with both laws beside them, and its cycles.

use super::options::Extent;
use crate::failure::Failure;
use crate::interrupt;
use crate::output::number::short;
use crate::output::progress::ProgressLine;
use libration::decay::{Decay, DecayEnding, EnvelopeLaw, TurningPoint};

/// The turning points, the first of which is the release, and why there are no more.
pub(crate) struct Report {
    pub(crate) turns: Vec<Turn>,
    /// `None` where it is followed no further.
    pub(crate) ending: Option<DecayEnding>,
    /// Whether somebody has ended the work early.
    pub(crate) interrupted: bool,
}

/// A turning point, and the amplitude (rad) at its time by averaging and by the law of small amplitudes.
pub(crate) struct Turn {
    pub(crate) point: TurningPoint,
    pub(crate) averaged: f64,
    pub(crate) small: f64,
}

/// A turning point with its number in cycles.
pub(crate) struct Row<'a> {
    /// 0, 0.5, 1, ….
    pub(crate) cycle: f64,
    pub(crate) turn: &'a Turn,
    /// What is there at the end of a whole cycle.
    pub(crate) whole: Option<Cycle>,
}

/// A whole cycle, in seconds.
#[derive(Clone, Copy)]
pub(crate) struct Cycle {
    /// When its middle turning point is passed.
    pub(crate) middle: f64,
    /// How long it takes.
    pub(crate) duration: f64,
    /// The exact period of the amplitude in its middle.
    pub(crate) exact_period: f64,
}

impl Report {
    pub(super) fn new(decay: &Decay, extent: Extent) -> Result<Self, Failure> {
        let (averaged, small) =
            (decay.envelope(EnvelopeLaw::Averaged), decay.envelope(EnvelopeLaw::SmallAmplitude));
        let mut swings = decay.swings();
        let mut turns: Vec<Turn> = vec![];
        let mut progress = ProgressLine::new();
        let mut interrupted = false;
        while turns.len() <= extent.turns() && !interrupted {
            let Some(point) =
                swings.next().transpose().map_err(|error| Failure::no_answer("decay", error))?
            else {
                break;
            };
            if point.time > extent.last_time() {
                break;
            }
            let [averaged, small] = [averaged, small].map(|envelope| envelope.amplitude_at(point.time));
            progress.show(|| format!("{} cycles, t = {:.6} s", in_cycles(turns.len()), point.time));
            turns.push(Turn { point, averaged, small });
            interrupted = interrupt::asked();
        }
        let report = Self { turns, ending: swings.ending(), interrupted };
        report
            .ending
            .filter(|_| report.turns.len() == 1)
            .map_or(Ok(report), |ending| Err(no_swing(decay, ending)))
    }

    /// All turning points.
    pub(crate) fn rows(&self, decay: &Decay) -> impl Iterator<Item = Row<'_>> {
        let pendulum = decay.pendulum();
        self.turns.iter().enumerate().map(move |(number, turn)| {
            let whole = (number > 0 && number.is_multiple_of(2)).then(|| {
                let [start, middle] = [&self.turns[number - 2].point, &self.turns[number - 1].point];
                let duration = turn.point.time - start.time;
                Cycle { middle: middle.time, duration, exact_period: pendulum.period(&middle.amplitude) }
            });
            Row { cycle: in_cycles(number), turn, whole }
        })
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

/// Why a pendulum that was released does not swing.
fn no_swing(decay: &Decay, ending: DecayEnding) -> Failure {
    let reason = if ending == DecayEnding::Sticks {
        let held = short(decay.sticking_amplitude().to_degrees(), 6);
        format!(
            "dry friction holds the pendulum where it is released, as it does within {held}° of the bottom and of the top: give another amplitude"
        )
    } else {
        "the damping is too strong for a swing, the pendulum creeps to the bottom: give smaller coefficients"
            .to_owned()
    };
    Failure::no_answer("decay", reason)
}
