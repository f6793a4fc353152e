//! Options of a response.

use super::order::ResonanceOrder;
use super::space::Rotation;

/// Options of a response.
#[derive(Clone, Debug, PartialEq)]
pub struct ResponseOptions {
    /// The initial guess of a motion at each end of the range; if there is none, zero, or the state about which the equations are symmetric. With a
    /// drive, further motions are searched about its coordinates from estimates by harmonic balance. Without a drive the motion from the guess
    /// has to settle to a limit cycle; a guess at an equilibrium is displaced a little.
    pub start: Option<Vec<f64>>,
    /// The value of the parameter at which a motion is searched and followed in both directions; the
    /// ends of the range if there is none. Closed branches within the range are found only in this way.
    pub at: Option<f64>,
    /// Number of drive periods in the period of the motion: 1, or more for subharmonic responses; 1 without a drive.
    pub drive_periods: u32,
    /// The angle that rotates in this number of drive periods, for rotating solutions; `None` for librating ones.
    pub rotation: Option<Rotation>,
    /// Orders of sub- and superharmonic responses that are searched in addition. The search begins at free oscillations of one coordinate that,
    /// to first order, the drive can maintain against the damping. At sixteen values within the range, drive and damping are then increased from
    /// small values to their actual ones. This finds isolas, which are not connected with other branches.
    pub orders: Vec<ResonanceOrder>,
    /// Maximum depth of secondary branches (symmetry breaking, period doubling).
    pub generations: usize,
    /// Maximum number of points of a branch.
    pub most_points: usize,
}

impl Default for ResponseOptions {
    fn default() -> Self {
        Self {
            start: None,
            at: None,
            drive_periods: 1,
            rotation: None,
            orders: vec![],
            generations: 2,
            most_points: 3000,
        }
    }
}
