//! Advice for a better measurement of swings.

use std::fmt;

use crate::measurement::Observable;
use libration::quantity::{rounded, short};

/// Advice for a better measurement of swings.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Advice {
    /// No length was given, so that there is no gravity.
    GiveLength,
    /// The length was given without an uncertainty, which causes most of gravity's.
    GiveLengthUncertainty,
    /// The relative uncertainty of the length is more than seven tenths of that of gravity: more than half of its variance.
    MeasureLengthBetter {
        /// The relative uncertainty of the length.
        relative_uncertainty: f64,
        /// The share of the length in the variance of gravity.
        share: f64,
    },
    /// β is in doubt, and a wrong scale of the angles can be why.
    CheckScale {
        /// The quantity that the instrument measures.
        observable: Observable,
    },
    /// The angles are taken as exact, though the test of the exact law would not show a scale that is 1 % wrong, which would change T0 by more than its
    /// uncertainty.
    StateScale {
        /// The relative change of T0 with a relative error of the angles.
        slope: f64,
        /// The standard uncertainty of β, which is twice the resulting one of a scale.
        of_beta: f64,
    },
    /// The data do not separate several kinds of damping.
    RecordLonger {
        /// The largest and the smallest amplitude, in radians.
        amplitudes: [f64; 2],
    },
    /// The residuals are not noise.
    LookAtResiduals,
    /// Outliers are isolated, or fewer than three in a row at an end.
    CorrectOutliers,
    /// At least three rows in a row at an end are outliers.
    LeaveOutEnds {
        /// The ends.
        ends: Vec<EndOfTrace>,
    },
    /// The rounding of the times makes more than a quarter of the scatter, and an even grid of times would remove it.
    WriteMoreDigitsOfTimes {
        /// The step that the times are rounded to, in s.
        resolution: f64,
        /// The fraction of the scatter, at most 1.
        part: f64,
    },
    /// The pendulum hangs at more than a hundredth of a radian, half a degree, on the scale of the instrument: visible to the eye.
    SetZero {
        /// The angle at rest, in radians.
        offset: f64,
    },
    /// There are fewer than fifteen rows in a period; eight are too few to place passages and turning points.
    SampleFaster {
        /// Rows in a period, of the trace with the fewest.
        rows_per_period: f64,
    },
}

/// Rows at an end of a trace that do not follow the motion.
#[derive(Clone, Debug, PartialEq)]
pub enum EndOfTrace {
    /// Rows before a time.
    Before {
        /// The name of the trace.
        trace: String,
        /// Time in seconds.
        time: f64,
    },
    /// Rows after a time.
    After {
        /// The name of the trace.
        trace: String,
        /// Time in seconds.
        time: f64,
    },
}

impl Advice {
    /// A stable name.
    #[must_use]
    pub fn name(&self) -> &'static str {
        match self {
            Self::GiveLength => "give_length",
            Self::GiveLengthUncertainty => "give_length_uncertainty",
            Self::MeasureLengthBetter { .. } => "measure_length_better",
            Self::CheckScale { .. } => "check_scale",
            Self::StateScale { .. } => "state_scale",
            Self::RecordLonger { .. } => "record_longer",
            Self::LookAtResiduals => "look_at_residuals",
            Self::CorrectOutliers => "correct_outliers",
            Self::LeaveOutEnds { .. } => "leave_out_ends",
            Self::WriteMoreDigitsOfTimes { .. } => "write_more_digits_of_times",
            Self::SetZero { .. } => "set_zero",
            Self::SampleFaster { .. } => "sample_faster",
        }
    }
}

/// Definition of a length, for its measurement.
const WHERE: &str = "from the axis of the pivot to the middle of the bob, which is its centre of mass";

impl fmt::Display for Advice {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::GiveLength => write!(f, "Give the length, such as 0.57m±0.004m, to obtain gravity: measure it {WHERE}."),
            Self::GiveLengthUncertainty => write!(
                f,
                "The length was given without an uncertainty, so that the uncertainty of gravity is too small: write it as 0.57m±0.004m. Measure \
                 it {WHERE}."
            ),
            Self::MeasureLengthBetter { relative_uncertainty, share } => write!(
                f,
                "The length is known to {} %, which makes {} % of the variance of gravity. Measure the length better, {WHERE}.",
                rounded(100.0 * relative_uncertainty, 2),
                rounded((100.0 * share).min(100.0), 3)
            ),
            Self::CheckScale { observable } => write!(
                f,
                "β is not 1, so look for a wrong scale of the angles: {}. The scale can also be fitted.",
                how_to_check(*observable)
            ),
            Self::StateScale { slope, of_beta } => write!(
                f,
                "The angles are taken as exact. A scale that is 1 % wrong would change T0 by {} %, more than its uncertainty, and β does not show it: it \
                 tells a scale to {} % at these amplitudes. State the uncertainty of the scale, or begin with 30° or more.",
                rounded(*slope, 2),
                rounded(50.0 * of_beta, 2)
            ),
            Self::RecordLonger { amplitudes } => record_longer(f, *amplitudes),
            Self::LookAtResiduals => f.write_str(
                "Look at the picture of the residuals: if they repeat with the swing, suspect the scale or the perspective of the \
                 camera, a pivot that moves, or a string that stretches; if they grow at the beginning, leave out the release.",
            ),
            Self::CorrectOutliers => f.write_str(
                "Some rows are far from all others: correct them in the tracking, or use a robust fit.",
            ),
            Self::LeaveOutEnds { ends } => leave_out_ends(f, ends),
            Self::WriteMoreDigitsOfTimes { resolution, part } => write!(
                f,
                "The times are rounded to {} s, which makes {} % of the scatter: export them with more digits, or treat them as evenly spaced.",
                short(*resolution, 6),
                rounded(100.0 * part, 2)
            ),
            Self::SetZero { offset } => write!(
                f,
                "The pendulum hangs at {}° on the scale of the instrument. That was fitted and does no harm; a plumb line in the \
                 picture would set it right.",
                rounded(offset.to_degrees(), 2)
            ),
            Self::SampleFaster { rows_per_period } => write!(
                f,
                "There are only {} rows in a period: record more frames per second.",
                rounded(*rows_per_period, 2)
            ),
        }
    }
}

/// Ratio of the last to the first amplitude below which a decay already shows how it slows down.
const FAR_ENOUGH: f64 = 0.25;

fn record_longer(f: &mut fmt::Formatter<'_>, amplitudes: [f64; 2]) -> fmt::Result {
    let is_far = amplitudes[1] <= FAR_ENOUGH * amplitudes[0];
    let [largest, smallest] = amplitudes.map(|amplitude| rounded(amplitude.to_degrees(), 3));
    match largest == smallest {
        true => write!(f, "Only an amplitude of {largest}° was measured. ")?,
        false => write!(f, "The amplitude went from {largest}° to {smallest}°. ")?,
    }
    if is_far {
        return f.write_str(
            "The damping models differ in how the decay slows down, which more of this decay would not show better: measure the angles with \
             less noise, or begin with a larger amplitude.",
        );
    }
    f.write_str(
        "The damping models differ in how the decay slows down: record for longer, until the amplitude is a quarter of what it was \
         at first.",
    )
}

fn leave_out_ends(f: &mut fmt::Formatter<'_>, ends: &[EndOfTrace]) -> fmt::Result {
    let ends: Vec<String> = ends.iter().map(ToString::to_string).collect();
    write!(
        f,
        "Rows do not follow the motion {}: if the pendulum was held there or the tracking lost it, leave them out.",
        ends.join(" and ")
    )
}

impl fmt::Display for EndOfTrace {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Before { trace, time } => write!(f, "of {trace} before {} s", rounded(*time, 4)),
            Self::After { trace, time } => write!(f, "of {trace} after {} s", rounded(*time, 4)),
        }
    }
}

fn how_to_check(observable: Observable) -> &'static str {
    match observable {
        Observable::Angle => {
            "film from far away and straight at the plane of the swing, check the pixels for being square, the origin for being on \
             the pivot, and the protractor or encoder for its counts in a turn"
        }
        Observable::AngularVelocity => {
            "check the sensor's sensitivity by turning it through a whole turn, and that its axis is that of the swing"
        }
    }
}
