//! Cycles of a measured swing, one by one: time, period and amplitude; with the test of the law of the period and of
//! the damping, about which nothing is assumed beforehand.
//!
//! Passages of the centre and extremes are placed by local fits whose shape is that of a swing without damping, with
//! corrections to it where there are points enough. The noise is estimated from the residuals of the local fits. A cycle reaches from a
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
mod cycle_landmarks;
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

pub use analysis::fit_cycles;
pub use envelope::{Coefficient, Envelope, EnvelopeFit, SEPARATED};
pub use error::CyclesError;
pub use several::beta_of_traces;
pub use unit::{BeyondATurn, beyond_a_turn, mistaken_unit};
pub use warning::CyclesWarning;

use super::{Beta, Uncertain};
use row::CycleRow;

/// Options for the analysis of cycles.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CyclesOptions {
    /// Number of robust standard deviations from the law beyond which cycles are left out.
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
    /// Time of its middle, in seconds.
    pub time: f64,
    /// Time from one passage of the centre to the next in the same direction, in seconds; its uncertainty comes from the noise of the values,
    /// and from the scatter of the cycles beyond that.
    pub period: Uncertain,
    /// The mean of its two extremes, in radians; its uncertainty comes from the noise of the values.
    pub amplitude: Uncertain,
    /// T/T0 by the exact law: the mean of the ratios of the two half swings.
    pub period_ratio: f64,
    /// `true` if its period is so far from the law that the cycle is left out.
    pub outlier: bool,
}

/// Amplitude on one side.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HalfSwing {
    /// Time in seconds; for a trace of angular velocities, when the pendulum is fastest.
    pub time: f64,
    /// Amplitude in radians; its uncertainty comes from the noise of the values.
    pub amplitude: Uncertain,
}

/// The cycles of a trace and their results.
#[derive(Clone, Debug, PartialEq)]
pub struct Cycles {
    /// Cycles in the order of time.
    pub cycles: Vec<Cycle>,
    /// The extremes on both sides, in the order of time.
    pub half_swings: Vec<HalfSwing>,
    /// Centre of the swings: rad, or rad/s.
    pub offset: Uncertain,
    /// Standard deviation of the centres of single swings from the offset, where that is more than the noise
    /// explains (the centres are then followed); otherwise zero.
    pub offset_wander: f64,
    /// The standard deviation of a value by the residuals of the local fits, in rad or rad/s; relative to the uncertainties of the
    /// trace if it has any.
    pub noise: f64,
    /// The period of small swings under the exact law, in seconds; its uncertainty comes from the scatter of the cycles where that is larger than
    /// the noise explains, and from the pivot where it was fitted.
    pub t0: Uncertain,
    /// Degrees of freedom of its uncertainty: of the scatter where it comes from that, and infinite where the noise explains the scatter.
    pub t0_degrees_of_freedom: f64,
    /// χ² per degree of freedom: the scatter about the exact law relative to that which the noise explains.
    pub chi2_per_dof: Option<f64>,
    /// The test of the exact law, or the reason why there is none.
    pub beta: Result<Beta, CyclesError>,
    /// Comparison of damping laws for the falling amplitude, or the reason why there is none.
    pub envelope: Result<Envelope, CyclesError>,
    /// Warnings about the cycles.
    pub warnings: Vec<CyclesWarning>,
    /// Rows of the cycles that count, with the sources of their errors.
    rows: Vec<CycleRow>,
    /// The same rows with the pivot moved by each of its two errors, where it was fitted.
    about_moved_pivot: Vec<Vec<CycleRow>>,
}

impl Cycles {
    /// T/R(A) of each cycle: the period of small swings by this cycle alone, in seconds.
    pub fn small_angle_periods(&self) -> impl Iterator<Item = f64> {
        self.cycles.iter().map(|cycle| cycle.period.value / cycle.period_ratio)
    }
}
