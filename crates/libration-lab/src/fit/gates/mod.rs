//! Times of a photogate → periods, T0, and with the width of the bob the amplitudes.
//!
//! A pendulum passes a gate twice in a period. Unless the gate stands exactly at the centre the passages are not evenly spaced, so
//! a period is measured from one passage to the next in the same direction; in the mean over both directions the position of the
//! gate drops out. Double triggers and missed passages are recognised by the pattern and counted.

mod error;
pub(crate) mod passages;
pub(crate) mod directions;
mod swings;
mod scatter;
pub(crate) mod speeds;
mod amplitudes;
mod by_speeds;
mod rows;
pub(crate) mod trend;
mod analysis;
mod warning;
pub(crate) mod width;
mod gravity;

pub use analysis::fit_gates;
pub use error::GatesError;
pub use gravity::{FlagShape, GateGeometry, GateGeometryError};
pub use warning::GatesWarning;

use crate::fit::beta::Beta;
use crate::fit::contradiction::Contradiction;
use crate::fit::uncertain::Uncertain;
use libration::quantity::Quantity;

/// Meaning of the times of a gate without states.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum GateSignals {
    /// The times at which the bob blocks the gate, and frees it.
    Edges,
    /// One time for each passage.
    Passages,
}

/// Known quantities in addition to the times.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct GateOptions {
    /// Meaning of the times; inferred from their pattern where not given.
    pub signals: Option<GateSignals>,
    /// The angle through which the bob moves while it blocks the gate, in radians ([`GateGeometry::width`]): nearly its diameter over the distance
    /// of the gate from the pivot, where that is the length.
    pub width: Option<Quantity>,
    /// The amplitude of the release, or of the turning point before the first passage, in radians; of use where the width is not
    /// known.
    pub amplitude: Option<Quantity>,
}

/// A period.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GateCycle {
    /// Time of its middle, in seconds.
    pub time: f64,
    /// Time from one passage to the next of the same side, in seconds.
    pub period: f64,
    /// The side of its first and last passage: 0 for that of the first passage, otherwise 1.
    pub side: usize,
    /// Amplitude by the speed at the gate, in radians.
    pub amplitude: Option<f64>,
}

/// Source of T0.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum T0Source {
    /// Every period with its amplitude.
    Speeds,
    /// The period at the beginning with the amplitude of the first swing.
    FirstAmplitude,
}

/// The results of a fit to the times of a gate.
#[derive(Clone, Debug, PartialEq)]
pub struct GatesFit {
    /// Passages of the bob.
    pub passages: usize,
    /// `true` if the times are edges, two for each passage.
    pub edges: bool,
    /// Edges without a partner.
    pub unpaired: usize,
    /// Passages too close to others, or between all others: double triggers.
    pub double_triggers: usize,
    /// Passages that were missed.
    pub missed: usize,
    /// Periods in the order of time.
    pub cycles: Vec<GateCycle>,
    /// The fraction of a period from a passage of the first side to one of the other: 1/2 for a gate at the centre.
    pub part_between: f64,
    /// The standard deviation of a time, in seconds: from the scatter of the periods or, if there are few, of the times for which the gate is
    /// blocked; `None` if both are too few.
    pub timing: Option<f64>,
    /// The mean of all periods, in seconds; its uncertainty is by the scatter.
    pub mean_period: Uncertain,
    /// The period at the turning point before the first passage, in seconds; `None` where the passages are too few to extrapolate.
    pub first_period: Option<Uncertain>,
    /// The period of small swings, in seconds; its uncertainty includes the contradiction.
    pub t0: Option<Uncertain>,
    /// T0 under the exact law and with β free, where they contradict each other.
    pub contradiction: Option<Contradiction>,
    /// Source of T0.
    pub t0_source: Option<T0Source>,
    /// The derivative of T0 with respect to the angular width of the bob, in s/rad; `None` where T0 does not come from the width.
    pub t0_by_width: Option<f64>,
    /// The degrees of freedom of the uncertainty of T0.
    pub t0_degrees_of_freedom: f64,
    /// The amplitude whose T/T0 is that of the periods T0 comes from, in radians.
    pub amplitude: Option<f64>,
    /// The coefficient of linear drag by which the amplitudes fall, in 1/s, which lengthens the periods and T0 by b²/8ω0²; `None` where no
    /// amplitudes are known or they do not fall.
    pub drag: Option<f64>,
    /// The test of the exact law, where amplitudes are known.
    pub beta: Option<Beta>,
    /// Warnings about the fit.
    pub warnings: Vec<GatesWarning>,
    /// T0 without the contradiction's contribution to its uncertainty.
    t0_by_times: Option<Uncertain>,
}
