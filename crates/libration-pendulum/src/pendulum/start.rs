//! An initial state, made dimensionless.

use libration_kernels::double_double::DoubleDouble;
use libration_numbers::quantity::Angle;

/// An initial state, made dimensionless.
pub(super) struct Start {
    pub(super) angle: Angle,
    /// sin(θ/2).
    pub(super) sine: DoubleDouble,
    /// cos(θ/2).
    pub(super) cosine: DoubleDouble,
    /// θ′/2ω0.
    pub(super) velocity: DoubleDouble,
}

impl Start {
    /// The angle at the bottom of the turn in which the motion starts.
    pub(super) fn base(&self) -> DoubleDouble {
        #[expect(clippy::cast_precision_loss, reason = "an angle has at most 2⁵³ radians")]
        let turns = self.angle.turns() as f64;
        DoubleDouble::PI.scaled(2.0) * turns
    }
}
