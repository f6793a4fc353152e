//! Cycles of a measured swing, one by one: when, how long, how far; what they say about the law of the period and about
//! the damping, of which nothing is assumed beforehand.
//!
//! Passages of the centre and extremes are placed by local fits whose shape is that of a swing without damping, with
//! corrections to it where there are points enough. The noise is what the local fits leave. A cycle reaches from a
//! passage to the next but one, so that it begins and ends in one direction and a wrong centre hardly matters; there is one
//! from each passage on, those upwards and those downwards in turn.
//!
//! Damping changes these periods in second order: linear damping b by the part b²/8ω0², dry friction d, which moves the centre
//! by ±d/ω0², by the time (d/ω0³)·ΔA/A² when the amplitude falls by ΔA in a cycle. That, and what the local fits miss, is measured on
//! simulated cycles with the damping that the envelope shows, and removed.
//!
//! The numbers that decide were varied over 24 recordings: twelve measured ones by an encoder, released at up to 180°, and by cameras,
//! and twelve synthetic ones: near the top and over it, angular velocities, coarse, noisy, short, long, small and strongly damped ones.

mod error;

pub(crate) mod shape;

pub(crate) mod local_fit;

pub(crate) mod swings;
pub(crate) mod turning_point;

pub(crate) mod centre;
mod window;

mod passage;

pub(crate) mod even;
mod extreme;

mod landmarks;

mod found;

pub(crate) mod generalised;
pub(super) mod period_law;
pub(super) mod row;

pub(crate) mod decay_rates;
mod envelope;
mod fall;

mod bias;
mod pivot;

mod analysis;

mod several;

mod unit;

mod warning;

pub use analysis::{cycles, cycles_watched};
pub use envelope::{Coefficient, Envelope, EnvelopeFit, SEPARATED};
pub use error::CyclesError;
pub use several::{beta_of_traces, beta_of_traces_watched};
pub use unit::{BeyondATurn, beyond_a_turn, mistaken_unit};
pub use warning::CyclesWarning;

use super::{Beta, Uncertain};
use row::Row;

/// How cycles are analysed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CyclesOptions {
    /// Cycles whose period is further from the law than this many robust standard deviations do not count.
    pub outlier_threshold: f64,
}

impl Default for CyclesOptions {
    fn default() -> Self {
        Self { outlier_threshold: super::DEFAULT_OUTLIER_THRESHOLD }
    }
}

/// A full cycle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cycle {
    /// Of its middle, in seconds.
    pub time: f64,
    /// From one passage of the centre to the next in the same direction, in seconds; uncertain by the noise of the values, and by
    /// what the cycles scatter more than that.
    pub period: Uncertain,
    /// The mean of the two extremes in it, in radians; uncertain by the noise of the values.
    pub amplitude: Uncertain,
    /// T/T0 that the exact law gives: the mean of what it gives for the two half swings.
    pub period_ratio: f64,
    /// Whether its period is so far from the law that it does not count.
    pub outlier: bool,
}

/// How far the pendulum went on one side.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HalfSwing {
    /// In seconds; for a trace of angular velocities, when the pendulum is fastest.
    pub time: f64,
    /// In radians; uncertain by the noise of the values.
    pub amplitude: Uncertain,
}

/// The cycles of a trace and what they say.
#[derive(Clone, Debug, PartialEq)]
pub struct Cycles {
    /// In the order of time.
    pub cycles: Vec<Cycle>,
    /// The extremes on both sides, in the order of time.
    pub half_swings: Vec<HalfSwing>,
    /// About what the values swing: rad, or rad/s.
    pub offset: Uncertain,
    /// How far the centres of single swings are from the offset, as a standard deviation, where that is more than the noise
    /// explains (they are then followed); else zero.
    pub offset_wander: f64,
    /// The standard deviation of a value that the local fits leave: rad, or rad/s. Where the trace has uncertainties of its
    /// own, as a part of these.
    pub noise: f64,
    /// The period of small swings under the exact law, in seconds; uncertain by the scatter of the cycles where that is larger than
    /// the noise explains, and by the pivot where it was fitted.
    pub t0: Uncertain,
    /// How much larger the scatter about the exact law is than the noise explains: χ² per degree of freedom.
    pub chi2_per_dof: Option<f64>,
    /// The test of the exact law, or why there is none.
    pub beta: Result<Beta, CyclesError>,
    /// Which damping the falling amplitude prefers, or why that cannot be said.
    pub envelope: Result<Envelope, CyclesError>,
    /// What a reader should know.
    pub warnings: Vec<CyclesWarning>,
    /// Those that count, with what their errors come from.
    rows: Vec<Row>,
    /// The same with the pivot moved by each of its two errors, where it was fitted.
    about_moved_pivot: Vec<Vec<Row>>,
}

impl Cycles {
    /// T/R(A) of each cycle: what the period of small swings is by this cycle alone, in seconds.
    pub fn small_angle_periods(&self) -> impl Iterator<Item = f64> {
        self.cycles.iter().map(|cycle| cycle.period.value / cycle.period_ratio)
    }
}
